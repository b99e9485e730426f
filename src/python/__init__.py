"""Particle methods of two papers, from Python.

Two papers on particle (meshless) methods, reproduced in C++: Asprone et al. (2010), on a line, and Batra and
Zhang (2008), in the plane and in space. Arrays go in, matrices of scipy and structured arrays come out.

operators   first and second derivatives as sparse matrices, on a line, in the plane and in space
weights     those of one particle, with their moments and the bound of their error
solve       a boundary-value problem on a body of your own; boundary helps to name its sides
table       what a program of the package prints, as a structured array

What a message calls a keyword is that of the function, and an option of the program with the same name.
"""

import csv
import pathlib
import subprocess

import numpy

from .core import Weights, boundary, in_python, operators, solve, weights

__all__ = ["Weights", "boundary", "operators", "read_table", "solve", "table", "weights"]

_programs = pathlib.Path(__file__).parent / "bin"


def _column(texts):
    """Integers, numbers (nan where a cell is empty) or texts, whatever all of them are."""
    for read in (int, lambda text: float(text or "nan"), str):
        try:
            return numpy.array([read(text) for text in texts])
        except (ValueError, OverflowError):
            pass


def _structured(lines):
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    columns = {name: _column([row[k] for row in rows[1:]]) for k, name in enumerate(rows[0])}
    table = numpy.empty(len(rows) - 1, [(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        table[name] = column
    return table


def read_table(path):
    """A table of the package, such as data/asprone2010/figure_1.csv: a structured array, empty cells nan."""
    with open(path, encoding="utf-8", newline="") as file:
        return _structured(file)


def table(program, **options):
    """What a program of the package prints, as a structured array: a test, an example problem, a stencil.

    Its options are keywords: --smoothing-from local is smoothing_from="local", and a list is particles=[20, 40].
    A flag is quality=True. `build/bin/derivative_test --help` lists those of a program; table("derivative_test",
    help=True) prints them.

    Raises ValueError for a program or options without meaning, RuntimeError for a computation that fails.

    >>> errors = table("derivative_test", formulation="second_order_fpm", particles=[20, 40, 80])
    >>> errors["error_second"]
    """
    arguments = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if isinstance(value, (list, tuple, numpy.ndarray)):
            value = ",".join(map(str, value))
        arguments += [option] if value is True else [] if value in (False, None) else [f"{option}={value}"]
    path = _programs / program
    if not path.is_file():
        known = ", ".join(sorted(file.name for file in _programs.glob("*")))
        raise ValueError(f"there is no program '{program}'; choose one of {known or 'none: make build makes them'}")
    done = subprocess.run([path, *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        kind = ValueError if done.returncode == 2 else RuntimeError
        raise kind(in_python(done.stderr.strip().replace(f"see {program} --help", f'see table("{program}", help=True)')))
    if options.get("help"):
        print(done.stdout)
        return None
    return _structured(done.stdout.splitlines(keepends=True))
