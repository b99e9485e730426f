"""Writes the table of a page, doc/speed.md: targets beside what the benchmarks measured.

Usage: targets.py DATA_FOLDER PAGE
"""

import csv
import pathlib
import re
import sys


def rows(path):
    with open(path, encoding="utf-8") as lines:
        yield from csv.DictReader(line for line in lines if not line.startswith("#"))


def number(row, column):
    return float(row[column]) if row.get(column) else None


folder, page = map(pathlib.Path, sys.argv[1:])
measured = {}
for table in ("asprone2010", "batra2008", "fpm_in_space"):
    for row in rows(folder / f"{table}.csv"):
        measured[row["task"], row["method"], int(row["particles"]), int(row["threads"])] = row


def find(task, method, particles, threads):
    """The row with this number of particles, or a number within a tenth of it, since plates have grids."""
    near = [key for key in measured if (key[0], key[1], key[3]) == (task, method, threads) and abs(key[2] / particles - 1) < 0.1]
    return measured[near[0]] if near else None


lines = ["| on so many particles, threads | aim | reached | limit | reached / limit | NumPy, SciPy |", "| --- | --- | --- | --- | --- | --- |"]


def line(label, aim, task, method, particles, threads, scale=1.0, unit="ns", other=None):
    row = find(task, method, particles, threads)
    if row is None:
        return
    total = float(row["particles"]) if unit == "s" else 1
    value = number(row, "nanoseconds") * total * scale
    limits = [number(row, "limit_bandwidth"), number(row, "limit_exp")]
    limit = sum(part for part in limits if part) * scale
    peer = find(task, other, particles, 1) if other else None
    lines.append(f"| {label} | {aim} | {value:.3g} {unit} | " + (f"{limit:.3g} {unit} | {value / limit:.2g}" if limit else " | ") + " | "
                 + (f"{number(peer, 'nanoseconds') * total * scale:.3g} {unit}" if peer else "") + " |")


formulations = "second_order_fpm modified_fpm chen_beraun original rkpm_first_order rkpm_second_order fpm"
for formulation in formulations.split():
    line(f"assembly of D and D², `{formulation}`, 10⁶, 1", "100 ns", "assembly", formulation, 10**6, 1,
         other="NumPy modified_fpm" if formulation == "modified_fpm" else None)
line("`second_order_fpm` again, in the memory of its operators, 10⁶, 1", "5 × limit", "again", "second_order_fpm", 10**6, 1)
line("assembly of `second_order_fpm`, 10⁷, 1", "as 10⁶", "assembly", "second_order_fpm", 10**7, 1)
line("the same, 10⁶, 2", "1.8 times faster", "assembly", "second_order_fpm", 10**6, 2)
line("application of D², 10⁶, 1", "1.1 × SciPy", "application", "second_order_fpm", 10**6, 1, other="SciPy modified_fpm")
for threads in (1, 2):
    line(f"static test in all, corrected, 10⁶, {threads}", "0.5 s", "static", "corrected", 10**6, threads, 1e-9, "s", "SciPy modified_fpm")
line("the same, one solution, 10⁶, 1", "0.5 s", "static", "uncorrected", 10**6, 1, 1e-9, "s")
line("the same, corrected, 10⁷, 1", "as 10⁶", "static", "corrected", 10**7, 1, 1e-9, "s")
line("all modes, 2000, 1", "20 s", "modes", "all", 2000, 1, 1e-9, "s")
line("lowest ten modes, 10⁶, 2", "5 s", "modes", "lowest ten", 10**6, 2, 1e-9, "s")
line("SSPH basis, m = 2, 2D, 10⁵, 1", "0.35 µs", "basis", "m = 2", 10**5, 1, 1e-3, "µs", "NumPy m = 2")
line("search of neighbours, 2D, 10⁵, 1", "0.4 µs", "search", "cells", 10**5, 1, 1e-3, "µs", "SciPy cKDTree")
line("plate in all, strong, 10⁴, 2", "0.3 s", "plate in all", "strong", 10**4, 2, 1e-9, "s")
line("plate in all, strong, 10⁵, 2", "5 s", "plate in all", "strong", 10**5, 2, 1e-9, "s")
for weak in ("weak1", "weak2"):
    line(f"plate in all, {weak}, 10⁵, 2", "", "plate in all", weak, 10**5, 2, 1e-9, "s")

operations = ["| weights of a particle, one thread | time | over SSPH, m = 3 | over SSPH, m = 2 | operations | over SSPH, m = 3 | over SSPH, m = 2 |",
              "| --- | --- | --- | --- | --- | --- | --- |"]
for task in ("weights in the plane", "weights in space"):
    of = {key[1]: row for key, row in measured.items() if key[0] == task}
    for method in ("definite_fpm", "cubic_ssph", "ssph"):
        cells = []
        for column, scale, unit in (("nanoseconds", 1e-3, " µs"), ("operations", 1, "")):
            value = number(of[method], column)
            cells.append(f"{value * scale:.3g}{unit}" if unit else f"{value:.0f}")
            cells += [f"{value / number(of[other], column):.2f}" for other in ("cubic_ssph", "ssph")]
        operations.append(f"| {task[len('weights '):]}, `{method}` | " + " | ".join(cells) + " |")

begin, end = "<!-- the table of speed is written by make bench -->\n", "<!-- end of the table of speed -->"
text = page.read_text(encoding="utf-8")
for begin, lines, end in ((begin, lines, end), ("<!-- the table of operations is written by make bench -->\n", operations, "<!-- end of the table of operations -->")):
    table = begin + "\n".join(lines) + "\n" + end
    text = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: table, text, flags=re.S)
page.write_text(text, encoding="utf-8")
