"""Particle methods of two papers, from Python.

Two papers on particle (meshless) methods, reproduced in C++: Asprone et al. (2010), on a line, and Batra and
Zhang (2008), in the plane and in space. Arrays go in; matrices of scipy and structured arrays come out.

operators   first and second derivatives as sparse matrices, on a line, in the plane and in space
weights     those of one particle, with their moments and the bound of their error
solve       a boundary-value problem on a body of your own; boundary helps to name its sides
table       what a program of the package prints, as a structured array; read_table reads one of its files

An array may be a list, of any real type, contiguous or not, writable or not; it is never changed. Invalid
input raises ValueError, a failed computation RuntimeError; the message names a remedy. While C++ computes,
other threads of Python run. OMP_NUM_THREADS sets the number of C++'s threads.
"""

import csv
import os
import pathlib
import subprocess
import warnings

import numpy

from . import core
from .core import Weights

__all__ = ["Weights", "boundary", "operators", "read_table", "solve", "table", "weights"]


def operators(*arguments, **keywords):
    """First and second derivatives as sparse matrices. Row i holds the weights of particle i.

    operators(formulation, x, *, kernel="gaussian", smoothing=1.0, smoothing_from="mean", volumes="equal")

    On a line, by a formulation of Asprone et al. (2010).
      formulation     original, chen_beraun, rkpm_first_order, rkpm_second_order, fpm, modified_fpm,
                      second_order_fpm; or ssph, of Batra and Zhang (2008), or definite_fpm, our own
      x               positions in increasing order, shape (N,) [length]
      kernel          gaussian, cubic_spline, quintic_spline, wendland_c2 or wendland_c4; those after the first need a
                      larger smoothing, such as 1.6
      smoothing       smoothing length h over the spacing
      smoothing_from  the spacing: mean, largest (between neighbours), local (each particle's, to the farther of its
                      two neighbours), nearest, K-nearest (to the farthest of the K nearest, such as 6-nearest),
                      a length, or N lengths
      volumes         of the particles: equal, or partition (their cells)
    Returns (D, D2), scipy.sparse.csr_matrix of shape (N, N) [1/length, 1/length^2].

    operators(points, *, scheme="fpm", degree=None, kernel=None, smoothing=1.2, smoothing_from="local")

    In the plane or in space.
      points          positions in any order, shape (N, 2) or (N, 3) [length]
      scheme          fpm or second_order_fpm, the second-order FPM; or ssph, the SSPH basis of Batra and Zhang
      degree          of the monomials of ssph: 2 (default) or 3
      kernel          as on a line; by default a Gaussian that is lowered to zero at 3.5 h, in space at 3 h
      smoothing_from  local is each particle's distance to the farthest of its 4 nearest, in space 6; mean, the
                      distance on a grid of as many points, suits points that lie equally close everywhere
    Returns a dict from the multi-index of a derivative to its csr_matrix: with the values B at the points,
    D[1, 0] @ B is dB/dx [1/length] and D[1, 1] @ B is d2B/dxdy [1/length^2].

    >>> x = numpy.linspace(0, 1, 41)
    >>> D, D2 = operators("second_order_fpm", x)
    >>> abs(D2 @ numpy.exp(x) - numpy.exp(x)).max()    # 1.5e-3, and a quarter of it on 81 particles

    >>> D = operators(numpy.random.default_rng(1).random((1000, 2)))
    >>> laplacian = D[2, 0] + D[0, 2]
    """
    return _chosen(_operators_on_a_line, _operators_in_space, arguments, keywords)


def _chosen(on_a_line, in_space, arguments, keywords):
    """Calls one of two functions: arguments for a line begin with the name of a formulation."""
    line = "formulation" in keywords or isinstance((*arguments, None)[0], str)
    return (on_a_line if line else in_space)(*arguments, **keywords)


def _operators_on_a_line(formulation, x, *, kernel="gaussian", smoothing=1.0, smoothing_from="mean", volumes="equal"):
    return core.operators_on_a_line(formulation, x, kernel, smoothing, smoothing_from, volumes)


def _operators_in_space(points, *, scheme="fpm", degree=None, kernel=None, smoothing=1.2, smoothing_from="local"):
    return core.operators_in_space(points, scheme, degree, kernel, smoothing, smoothing_from)


def weights(*arguments, **keywords):
    """One particle's weights for all derivatives, and what they are worth: see Weights.

    weights(formulation, x, number, *, ...)    on a line; derivatives have the keys 1 and 2
    weights(points, number, *, ...)            in the plane or in space; their keys are multi-indices

    The number of the particle counts from 0; all other arguments are those of operators.

    >>> row = weights("modified_fpm", numpy.linspace(0, 1, 41), 0)
    >>> row.moments[2][3]    # what the second derivative gets wrong: 1.01 spacings times the third
    """
    return _chosen(_weights_on_a_line, _weights_in_space, arguments, keywords)


def _weights_on_a_line(
    formulation, x, number, *, kernel="gaussian", smoothing=1.0, smoothing_from="mean", volumes="equal"
):
    return core.weights_on_a_line(formulation, x, number, kernel, smoothing, smoothing_from, volumes)


def _weights_in_space(points, number, *, scheme="fpm", degree=None, kernel=None, smoothing=1.2, smoothing_from="local"):
    return core.weights_in_space(points, number, scheme, degree, kernel, smoothing, smoothing_from)


def boundary(points, cells):
    """The facets on the boundary of a mesh: those of one cell only.

    points  positions, shape (N, 2) or (N, 3) [length]
    cells   triangles or tetrahedra, the numbers of their corners, shape (n, 3) or (n, 4)

    Returns the numbers of their points, shape (m, 2) or (m, 3). Seen from outside, the corners of a triangle run
    counter-clockwise; a segment has the body to its left.

    >>> facets = boundary(points, cells)
    >>> middles = points[facets].mean(axis=1)
    >>> sides = {"wall": facets[middles[:, 0] == 0], "tip": facets[middles[:, 0] == 1]}
    """
    return core.boundary(points, cells)


def solve(points, cells, sides=None, *, at=None, smoothing_from="local", **problem):
    """The solution of a boundary-value problem on a body, with an account of its errors.

    points   positions, shape (N, 2) or (N, 3) [length]
    cells    triangles or tetrahedra, the numbers of their corners, shape (n, 3) or (n, 4)
    sides    a dict from the name of a side to its facets, shape (m, 2) or (m, 3), see boundary; facets of the
             boundary in no side are the side "rest". By default all of it is the side "boundary"
    at       places where the solution is wanted, shape (M, 2) or (M, 3); by default the points
    problem  keywords with the names of the options of the program body, in the units of points and loads:
             numbers, or functions of the place as a text such as "-1e6*(1-x)"; None leaves a component free

      equation="elasticity"  young=, poisson=, plane="stress" or "strain", body_force=(bx, by),
                             fix="wall" or ["wall", "foot"], symmetry=, displacement={"wall": (0, None)},
                             traction={"tip": (0, -1e6)}, pressure={"bore": 5e6}
      equation="poisson"     -div(k grad u) + c u = f: conductivity=, source=, reaction=,
                             value={"wall": 0}, flux={"base": 1e4}, convection={"fins": (50, 293)}
      method="hats"          or "fpm", "strong", "weak1", "weak2". Of all but fpm: degree=2 (3 for hats in the
                             plane), scaling=3; of weak1, weak2: gauss=10, penalty=1; of fpm: smoothing=1.2.
                             smoothing_from is a name, a length, or N lengths

    A positive flux enters the body, a positive pressure pushes on it, and convection=(a, u0) is the flux
    a (u0 - u). A side without conditions is free of loads, or insulated. Texts know x, y, z, pi, e,
    + - * / ^ ( ), sqrt, exp, log, abs, min, max, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, atan2
    and hypot.

    Returns (fields, numbers). fields is a structured array, a row for each place: x, y(, z), then u1, u2(, u3),
    s11, s22, ... and von_mises, or u and the flux of heat q1, q2(, q3). numbers is a dict: max_displacement and
    max_von_mises, or max_u and min_u; the forces load1:SIDE, reaction1:SIDE and volume1 (of the body force or
    source); and the error measures quality, noise, missed_loads and defect. One above its limit is a warning,
    too; a defect above 10 % is a RuntimeError.
    """
    return core.solve(points, cells, sides, at, smoothing_from, problem)


def table(program, **options):
    """What a program of the package prints, as a structured array: a test, an example problem, a stencil.

    Its options are keywords: --smoothing-from local is smoothing_from="local", and a list is particles=[20, 40].
    A flag is quality=True. table("derivative_test", help=True) prints all of them. Where some cases fail, a warning
    says so, and the last column of their rows why.

    >>> errors = table("derivative_test", formulation="second_order_fpm", particles=[20, 40, 80])
    >>> errors["error_second"]
    """
    programs = pathlib.Path(__file__).parent / "bin"
    known = sorted(file.name for file in programs.iterdir())
    if program not in known:
        raise ValueError(f"there is no program {program!r}; choose one of {', '.join(known)}")
    arguments = [text for name, value in options.items() for text in _arguments(name, value)]
    done = subprocess.run([programs / program, *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        said = core.in_python(done.stderr.strip().replace(f"see {program} --help", f'see table("{program}", help=True)'))
        if done.returncode < 0:
            said = f"{program} was ended by signal {-done.returncode}"
        if done.returncode < 0 or not done.stdout:
            raise (ValueError if done.returncode == 2 else RuntimeError)(said)
        warnings.warn(said, stacklevel=2)
    if options.get("help") or options.get("version"):
        return print(done.stdout)
    if options.get("output") is not None:
        return read_table(options["output"])
    return _structured(program, done.stdout.splitlines(keepends=True))


def read_table(path):
    """A table of the package, such as data/asprone2010/figure_1.csv: a structured array, empty cells nan."""
    with open(path, encoding="utf-8-sig", newline="") as file:
        return _structured(path, file)


def _arguments(name, value):
    """An option of a program from a keyword."""
    option = "--" + name.replace("_", "-")
    if value is None or isinstance(value, (bool, numpy.bool_)):
        return [option] if value else []
    if isinstance(value, bytes):
        value = os.fsdecode(value)
    if numpy.iterable(value) and not isinstance(value, str):
        value = ",".join(map(str, value))
    return [f"{option}={value}"]


def _structured(source, lines):
    """The rows of a CSV below its comments; an error names the source and the row."""
    rows = list(csv.reader(line for line in lines if line.strip() and not line.startswith("#")))
    if not rows:
        raise ValueError(f"{source} holds no table")
    if "" in rows[0] or len(set(rows[0])) < len(rows[0]):
        raise ValueError(f"{source}: two columns have one name, or one has none")
    for number, row in enumerate(rows):
        if len(row) != len(rows[0]):
            raise ValueError(f"{source}: row {number} has {len(row)} cells, and the head has {len(rows[0])}")
    columns = {name: _column([row[k] for row in rows[1:]]) for k, name in enumerate(rows[0])}
    table = numpy.empty(len(rows) - 1, [(name, column.dtype) for name, column in columns.items()])
    for name, column in columns.items():
        table[name] = column
    return table


def _column(texts):
    """Integers, numbers (nan where a cell is empty) or texts, whatever all of them are."""
    for read, kind in (int, "i8"), (lambda text: float(text or "nan"), "f8"), (str, "U"):
        try:
            return numpy.array([read(text) for text in texts], kind)
        except (ValueError, OverflowError):
            pass
