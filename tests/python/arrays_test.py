"""What comes in: any array of real numbers gives the bytes of doubles in C's order; others are refused."""

import unittest

import numpy
from numpy.testing import assert_array_equal
from particle_methods import boundary, operators, solve, weights

from support import TestCase, cloud, faces, line, square


def forms(array):
    """The same numbers in other arrays, by what is special about them."""
    wide = numpy.full([2 * n for n in array.shape], numpy.nan)
    wide[tuple(slice(None, None, 2) for _ in array.shape)] = array
    read_only = array.copy()
    read_only.flags.writeable = False
    backwards = tuple(slice(None, None, -1) for _ in array.shape)
    unaligned = numpy.zeros(array.size * 8 + 1, numpy.uint8)[1:].view(float).reshape(array.shape)
    unaligned[...] = array
    return {
        "list": array.tolist(),
        "tuple": tuple(array.tolist()),
        "list of numbers of numpy": [*array],
        "big-endian": array.astype(">f8"),
        "long double": array.astype(numpy.longdouble),
        "Fortran's order": numpy.asfortranarray(array),
        "every other": wide[tuple(slice(None, None, 2) for _ in array.shape)],
        "reversed twice": array[backwards].copy()[backwards],
        "read-only": read_only,
        "unaligned": unaligned,
        "of a subclass": array.view(type("Subclass", (numpy.ndarray,), {})),
        "of a memory view": memoryview(array),
    }


def same_bytes(these, those):
    return all(a.tobytes() == b.tobytes() for D, E in zip(these, those)
               for a, b in ((D.data, E.data), (D.indices, E.indices), (D.indptr, E.indptr)))


class RealNumbers(TestCase):
    def test_positions_of_any_form_have_the_operators_of_contiguous_doubles(self):
        for x, compute in ((line(20), lambda x: operators("second_order_fpm", x)),
                           (cloud(6, 2), lambda x: operators(x).values()),
                           (cloud(5, 3), lambda x: operators(x, scheme="ssph").values())):
            plain = compute(x)
            for name, form in forms(x).items():
                with self.subTest(form=name, shape=x.shape):
                    self.assertTrue(same_bytes(compute(form), plain))

    def test_numbers_that_a_smaller_type_holds_are_the_same_in_it(self):
        x = numpy.array([0, 1, 3, 4, 6, 8, 9, 11, 12, 15], dtype=float)
        plain = operators("second_order_fpm", x)
        for kind in "i1", "u1", ">i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", ">f4":
            with self.subTest(kind=kind):
                self.assertTrue(same_bytes(operators("second_order_fpm", x.astype(kind)), plain))
        self.assertTrue(same_bytes(operators("second_order_fpm", range(0, 40, 4)),
                                   operators("second_order_fpm", numpy.arange(0.0, 40, 4))))

    def test_single_precision_is_that_of_the_numbers_it_holds(self):
        x = line(20).astype("f4")
        self.assertTrue(same_bytes(operators("fpm", x), operators("fpm", x.astype(float))))

    def test_lengths_of_any_form_are_the_same(self):
        x, lengths = line(20), numpy.linspace(0.05, 0.08, 20)
        plain = operators("fpm", x, smoothing_from=lengths)
        for name, form in forms(lengths).items():
            with self.subTest(form=name):
                self.assertTrue(same_bytes(operators("fpm", x, smoothing_from=form), plain))

    def test_one_length_is_a_number_of_python_or_numpy(self):
        x = line(20)
        plain = operators("fpm", x, smoothing_from=0.0625)
        for kind in numpy.float64, numpy.float32, numpy.float16, numpy.array, numpy.longdouble:
            with self.subTest(kind=kind):
                self.assertTrue(same_bytes(operators("fpm", x, smoothing_from=kind(0.0625)), plain))
        for kind in int, numpy.int64, numpy.uint8:
            with self.subTest(kind=kind):
                self.assertTrue(same_bytes(operators("fpm", 10 * x, smoothing_from=kind(1)),
                                           operators("fpm", 10 * x, smoothing_from=1.0)))

    def test_points_and_cells_of_any_form_have_the_same_solution(self):
        points, cells = square(4)
        problem = {"equation": "poisson", "value": {"boundary": 0}, "source": 1}
        plain = solve(points, cells, **problem)
        for name, form in forms(points).items():
            with self.subTest(points=name):
                assert_array_equal(solve(form, cells, **problem)[0], plain[0])
        for kind in "i1", "u1", ">i2", "u4", "i8", "u8":
            with self.subTest(cells=kind):
                assert_array_equal(solve(points, cells.astype(kind), **problem)[0], plain[0])
                assert_array_equal(boundary(points, cells.astype(kind)), boundary(points, cells))
        for form in cells.tolist(), numpy.asfortranarray(cells), numpy.repeat(cells, 2, axis=0)[::2]:
            assert_array_equal(solve(points, form, **problem)[0], plain[0])

    def test_facets_and_places_of_any_form_have_the_same_solution(self):
        points, cells = square(4)
        at, left = numpy.array([[0.3, 0.4], [0.5, 0.2]]), faces(points, cells, left=(0, 0))["left"]
        problem = {"equation": "poisson", "value": {"left": 0}, "source": 1}
        plain = solve(points, cells, {"left": left}, at=at, **problem)
        for name, form in forms(at).items():
            with self.subTest(at=name):
                assert_array_equal(solve(points, cells, {"left": left}, at=form, **problem)[0], plain[0])
        for form in left.tolist(), left.astype("u1"), left.astype(">i8"), left[:, ::-1]:
            assert_array_equal(solve(points, cells, {"left": form}, at=at, **problem)[0], plain[0])

    def test_nothing_that_comes_in_is_changed(self):
        x, points, lengths = line(20), cloud(6, 2), numpy.full(20, 0.06)
        corners, cells = square(5)
        at, left = numpy.array([[0.3, 0.4]]), faces(corners, cells, left=(0, 0))["left"]
        given = x, points, lengths, corners, cells, at, left
        before = [array.copy() for array in given]
        operators("fpm", x, smoothing_from=lengths)
        operators(points)
        weights(points, 3)
        sides = {"left": left}
        solve(corners, cells, sides, at=at, equation="poisson", value={"left": 0}, source=1)
        for now, then in zip(given, before):
            assert_array_equal(now, then)
        self.assertEqual(list(sides), ["left"])


class Refusals(TestCase):
    def test_numbers_that_are_not_real_are_refused_with_their_type(self):
        x = line(5)
        for bad, kind in (
            (x + 0j, "complex128"), (x > 0.5, "bool"), (x.astype("m8[s]"), "timedelta64[s]"),
            (["0", "1"], "<U1"), ([b"0", b"1"], "|S1"), ("fpm", "<U3"),
            (x.astype(object), "object"), ({0: 1}, "object"), (iter(x), "object"), (None, "object"),
        ):
            with self.subTest(kind=kind), self.refuses(f"x must hold real numbers, got the type {kind}"):
                operators("fpm", bad)

    def test_structured_arrays_are_refused(self):
        with self.assertRaisesRegex(ValueError, r"^x must hold real numbers, got the type \[\('x', '<f8'\)\]$"):
            operators("fpm", numpy.zeros(5, [("x", float)]))

    def test_rows_of_different_lengths_are_no_array(self):
        with self.refuses("points is no array, but of type list"):
            operators([[0, 0], [1]])

    def test_a_mask_is_refused_with_what_keeps_it(self):
        for compute, name, array in (
            (lambda x: operators("fpm", x), "x", line(12)),
            (operators, "points", cloud(6, 2)),
            (lambda h: operators("fpm", line(12), smoothing_from=h), "smoothing_from", numpy.ones(12)),
            (lambda points: solve(points, square(4)[1]), "points", square(4)[0]),
            (lambda cells: solve(square(4)[0], cells, young=1, poisson=0), "cells", square(4)[1]),
            (lambda at: solve(*square(4), young=1, poisson=0, at=at), "at", square(4)[0]),
        ):
            with self.subTest(name=name), self.refuses(
                    f"{name} has a mask, which would be lost; pass what it leaves, such as {name}.compressed()"):
                compute(numpy.ma.masked_array(array))

    def test_wrong_shapes_are_refused_with_the_right_ones(self):
        rows = "(N, 2) or (N, 3), a row for each particle"
        for compute, name, right, shapes in (
            (lambda x: operators("fpm", x), "x", "(N,)", [(), (3, 2), (1, 12), (12, 1), (2, 2, 2)]),
            (lambda x: weights("fpm", x, 0), "x", "(N,)", [(), (3, 2)]),
            (operators, "points", rows, [(), (12,), (2, 12), (12, 1), (12, 4), (4, 3, 2), (0,)]),
            (lambda x: weights(x, 0), "points", rows, [(), (12,), (2, 12)]),
            (lambda h: operators("fpm", line(12), smoothing_from=h), "smoothing_from", "(N,)", [(12, 1)]),
            (lambda x: solve(x, square(4)[1]), "points", rows, [(), (16,), (2, 16)]),
            (lambda x: boundary(x, square(4)[1]), "points", rows, [(), (16,), (2, 16)]),
            (lambda x: solve(*square(4), at=x, young=1, poisson=0), "at", rows, [(2,), (1, 4), (1, 1, 2)]),
        ):
            for shape in shapes:
                with self.subTest(name=name, shape=shape), self.refuses(
                        f"{name} must have the shape {right}, got {shape}"):
                    compute(numpy.zeros(shape))

    def test_cells_and_facets_are_integers_of_their_shape(self):
        points, cells = square(4)
        for bad, text in (
            (cells.astype(float), "cells must hold integers, the numbers of points, got the type float64"),
            (cells.astype(bool), "cells must hold integers, the numbers of points, got the type bool"),
            (cells[:, :2], "cells must have the shape (n, 3), got (18, 2)"),
            (cells[0], "cells must have the shape (n, 3), got (3,)"),
            (cells + 1, "cells[8, 2] is 16, but the points have numbers from 0 to 15"),
            (-cells, "cells[0, 1] is -1, but the points have numbers from 0 to 15"),
            (numpy.where(cells == 5, 2**40, cells),
             "cells[0, 2] is 1099511627776, but the points have numbers from 0 to 15"),
        ):
            with self.subTest(text=text):
                with self.refuses(text):
                    boundary(points, bad)
                with self.refuses(text):
                    solve(points, bad, young=1, poisson=0)
        with self.refuses("sides['left'] must have the shape (n, 2), got (2,)"):
            solve(points, cells, {"left": [0, 1]}, young=1, poisson=0)
        with self.refuses("sides['left'] must hold integers, the numbers of points, got the type float64"):
            solve(points, cells, {"left": [[0.0, 1.0]]}, young=1, poisson=0)
        with self.refuses("sides['left'][0, 1] is 16, but the points have numbers from 0 to 15"):
            solve(points, cells, {"left": [[0, 16]]}, young=1, poisson=0)

    def test_a_number_of_64_bits_without_sign_is_not_taken_for_another(self):
        points, cells = square(4)
        cells = cells.astype("u8")
        cells[0, 0] = 2**64 - 1
        with self.assertRaisesRegex(ValueError, r"^cells\[0, 0\] is .*, but the points have numbers from 0 to 15$"):
            boundary(points, cells)

    def test_points_that_are_not_finite_are_refused(self):
        points, cells = square(4)
        for bad in numpy.nan, numpy.inf:
            broken = points.copy()
            broken[5, 1] = bad
            for compute in boundary, lambda points, cells: solve(points, cells, young=1, poisson=0):
                with self.subTest(bad=bad), self.assertRaisesRegex(ValueError, "finite"):
                    compute(broken, cells)

    def test_a_boolean_is_no_length(self):
        with self.assertRaisesRegex(ValueError, "smoothing_from"):
            operators("fpm", line(12), smoothing_from=True)

    def test_the_number_of_a_particle_is_an_integer_from_0(self):
        for compute, N in ((lambda number: weights("fpm", line(12), number), 12),
                           (lambda number: weights(cloud(5, 2), number), 25)):
            for bad in -1, N:
                with self.subTest(number=bad), self.refuses(f"there is no particle {bad}; choose 0 to {N - 1}"):
                    compute(bad)
            for bad in 1.5, "1", None, True, [1]:
                with self.subTest(number=bad), self.refuses(f"number must be an integer, got {bad!r}"):
                    compute(bad)
            for number in 3, numpy.int8(3), numpy.uint64(3):
                assert_array_equal(compute(number).particles, compute(3).particles)


if __name__ == "__main__":
    unittest.main()
