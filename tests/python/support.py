"""What the tests of several files share: particles, meshes, and what the programs print beside a table."""

import itertools
import math
import os
import re
import tempfile
import unittest

import numpy
import particle_methods

FORMULATIONS = {  # with the degrees of the polynomials whose first and second derivatives are exact
    "original": (0, 0), "chen_beraun": (1, 1), "rkpm_first_order": (0, 0), "rkpm_second_order": (0, 0),
    "fpm": (1, 1), "modified_fpm": (2, 2), "second_order_fpm": (2, 3), "ssph": (2, 2), "definite_fpm": (2, 3),
}
KERNELS = {  # with a smoothing on which four particles lie in the support of each
    "gaussian": 1, "cubic_spline": 2.5, "quintic_spline": 2, "wendland_c2": 2.5, "wendland_c4": 2.5,
}
SCHEMES = {  # in the plane and in space: the program's name, the keywords, the degrees that are exact
    "definite_fpm": ({"scheme": "fpm"}, (2, 3)),
    "ssph": ({"scheme": "ssph"}, (2, 2)),
    "cubic_ssph": ({"scheme": "ssph", "degree": 3}, (3, 3)),
}
ELASTIC = {"young": 2.5, "poisson": 0.3}
SMOOTH = {  # on clamped(): exp(x) sin(y), which each method finds within its limits
    "equation": "poisson", "value": {"wall": "sin(y)", "rest": "exp(x)*sin(y)"}, "flux": {"tip": "e*sin(y)"},
}


class TestCase(unittest.TestCase):
    def refuses(self, text, kind=ValueError):
        """A context in which `kind` is raised with this text, word by word."""
        return self.assertRaisesRegex(kind, "^" + re.escape(text) + "$")


def line(N, seed=1):
    """N positions between 0 and 1, the inner ones moved by U(-1, 1) a quarter of the spacing."""
    x = numpy.linspace(0, 1, N)
    x[1:-1] += numpy.random.default_rng(seed).uniform(-0.25, 0.25, N - 2) / (N - 1)
    return x


def cloud(n, dim, seed=1):
    """A grid of n particles on a side of the unit square or cube, moved by up to a fifth of the spacing."""
    grid = numpy.array(list(itertools.product(numpy.linspace(0, 1, n), repeat=dim)))
    return grid + numpy.random.default_rng(seed).uniform(-0.2, 0.2, grid.shape) / (n - 1)


def multi_indices(dim, degrees):
    """Those of the derivatives, or monomials, of these degrees."""
    return [a for a in itertools.product(range(max(degrees) + 1), repeat=dim) if sum(a) in degrees]


def monomial(x, a, derivative=None):
    """A derivative of x^a, exactly."""
    value = numpy.ones(len(x))
    for axis, (power, k) in enumerate(zip(a, derivative or [0] * len(a))):
        value = value * (math.perm(power, k) * x[:, axis] ** max(power - k, 0))
    return value


def square(n):
    """A square of side 1: n x n points, and two triangles for each square between them."""
    points = numpy.array([(x, y) for y in numpy.linspace(0, 1, n) for x in numpy.linspace(0, 1, n)])
    first = numpy.arange(n * n).reshape(n, n)[:-1, :-1].ravel()[:, numpy.newaxis]
    return points, numpy.concatenate([first + [0, 1, n + 1], first + [0, n + 1, n]])


def cube(n):
    """A cube of side 1: n^3 points, and six tetrahedra around a diagonal of each cube between them."""
    points = numpy.array(list(itertools.product(numpy.linspace(0, 1, n), repeat=3)))
    step = numpy.array([n * n, n, 1])
    first = numpy.arange(n**3).reshape(n, n, n)[:-1, :-1, :-1].ravel()[:, numpy.newaxis]
    paths = [numpy.cumsum([0, *step[list(order)]]) for order in itertools.permutations(range(3))]
    return points, numpy.concatenate([first + path for path in paths])


def faces(points, cells, **planes):
    """Sides by their names: left=(0, 0) are the facets with x = 0, top=(1, 1) those with y = 1."""
    facets = particle_methods.boundary(points, cells)
    return {name: facets[(points[facets][:, :, axis] == place).all(axis=1)]
            for name, (axis, place) in planes.items()}


def clamped(n=9):
    """A square, its left side a wall and its right side a tip."""
    points, cells = square(n)
    return points, cells, faces(points, cells, wall=(0, 0), tip=(0, 1))


def table_and_comments(program, **options):
    """What table() returns, and the lines above it in the file."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "table.csv")
        rows = particle_methods.table(program, output=path, threads=1, **options)
        with open(path, encoding="utf-8") as file:
            return rows, [text.rstrip() for text in file if text.startswith("#")]


def tolerances(comments):
    """By the name of the column, as assert_allclose takes them."""
    found = (re.fullmatch("# tolerance of (.+): relative (.+), absolute (.+)", text) for text in comments)
    return {each[1]: {"rtol": float(each[2]), "atol": float(each[3])} for each in found if each}
