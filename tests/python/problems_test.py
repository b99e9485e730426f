"""solve's keywords: which problem, which method, and where the solution is wanted."""

import decimal
import fractions
import unittest
import warnings

import numpy
from numpy.testing import assert_allclose, assert_array_equal
from particle_methods import solve

from support import ELASTIC, SMOOTH, TestCase, clamped, cube, square


class Places(TestCase):
    def test_fields_have_a_row_for_each_point_in_their_order(self):
        points, cells = square(7)
        fields, _ = solve(points, cells, displacement={"boundary": ("0.1*x*y", 0)}, **ELASTIC)
        self.assertEqual(fields.dtype.names, ("x", "y", "u1", "u2", "s11", "s22", "s12", "von_mises"))
        self.assertEqual({fields.dtype[name] for name in fields.dtype.names}, {numpy.dtype("f8")})
        assert_array_equal(numpy.column_stack([fields["x"], fields["y"]]), points)

    def test_names_of_fields_are_those_of_the_dimension_and_the_equation(self):
        points, cells = cube(4)
        elastic, _ = solve(points, cells, displacement={"boundary": ("x", 0, 0)}, **ELASTIC)
        self.assertEqual(elastic.dtype.names[:6], ("x", "y", "z", "u1", "u2", "u3"))
        self.assertEqual(set(elastic.dtype.names[6:]),
                         {"s11", "s22", "s33", "s12", "s23", "s13", "von_mises"})
        scalar, _ = solve(points, cells, equation="poisson", value={"boundary": "x"})
        self.assertEqual(scalar.dtype.names, ("x", "y", "z", "u", "q1", "q2", "q3"))

    def test_places_are_by_default_the_points(self):
        points, cells, sides = clamped()
        for method in "hats", "fpm":
            with self.subTest(method=method):
                default, numbers = solve(points, cells, sides, method=method, **SMOOTH)
                asked, same = solve(points, cells, sides, at=points, method=method, **SMOOTH)
                self.assertEqual(numbers, same)
                for name in default.dtype.names:
                    assert_allclose(asked[name], default[name], rtol=1e-9, atol=1e-9)

    def test_places_between_the_points_come_in_the_order_asked(self):
        points, cells = square(7)
        at = numpy.random.default_rng(1).random((20, 2))
        fields, _ = solve(points, cells, at=at, equation="poisson", value={"boundary": "x-2*y"})
        assert_array_equal(numpy.column_stack([fields["x"], fields["y"]]), at)
        assert_allclose(fields["u"], at @ [1, -2], atol=1e-12)

    def test_no_places_have_no_rows(self):
        nowhere = numpy.empty((0, 2))
        fields, numbers = solve(*square(5), at=nowhere, equation="poisson", value={"boundary": "x"})
        self.assertEqual(fields.shape, (0,))
        self.assertEqual(fields.dtype.names, ("x", "y", "u", "q1", "q2"))
        self.assertAlmostEqual(numbers["max_u"], 1)

    def test_places_outside_of_the_body_are_refused_with_the_distance(self):
        points, cells = square(5)
        for bad, text in (([2, 2], r"\(2, 2\) .*outside.*the nearest particle is \(1, 1\), 1\.41421 away"),
                          ([numpy.nan, 0], "nan"), ([0.5, -1e-3], "outside")):
            with self.subTest(place=bad), self.assertRaisesRegex(ValueError, text):
                solve(points, cells, at=[[0.5, 0.5], bad], equation="poisson", value={"boundary": 0})
        with self.refuses("at has 3 columns, and points have 2"):
            solve(points, cells, at=[[0, 0, 0]], equation="poisson", value={"boundary": 0})


class Keywords(TestCase):
    def test_numbers_texts_tuples_and_arrays_give_the_same_load(self):
        points, cells, sides = clamped()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            plain, _ = solve(points, cells, sides, fix="wall", traction={"tip": (0, -1)}, **ELASTIC)
            for force in [0, -1], "0, -1", ("0", "-x"), numpy.array([0, -1]), numpy.array([0.0, -1]):
                with self.subTest(force=force):
                    again, _ = solve(points, cells, sides, fix="wall", traction={"tip": force}, **ELASTIC)
                    assert_allclose(again["u2"], plain["u2"], rtol=1e-12)

    def test_a_number_arrives_with_all_of_its_digits(self):
        points, cells = square(5)
        for number in 1 / 3, 1e-7 / 3, numpy.float64(2) / 3, 10**10 + 1, 10**20:
            fields, _ = solve(points, cells, equation="poisson", value={"boundary": number})
            assert_allclose(fields["u"], float(number), rtol=1e-14)

    def test_numbers_of_numpy_are_numbers(self):
        body = clamped()
        plain, _ = solve(*body, method="weak2", degree=2, scaling=3.0, gauss=8, **SMOOTH)
        again, _ = solve(*body, method="weak2", degree=numpy.int64(2), scaling=numpy.float32(3),
                         gauss=numpy.uint8(8), **SMOOTH)
        assert_array_equal(again, plain)

    def test_lengths_of_the_spacing_are_names_numbers_or_one_for_each_point(self):
        body = clamped()
        named, _ = solve(*body, method="fpm", smoothing_from="nearest", **SMOOTH)
        for lengths in 1 / 8, numpy.full(81, 1 / 8), [1 / 8] * 81:
            with self.subTest(lengths=type(lengths)):
                given, _ = solve(*body, method="fpm", smoothing_from=lengths, **SMOOTH)
                assert_allclose(given["u"], named["u"], rtol=1e-9, atol=1e-12)

    def test_what_is_asked_has_an_effect(self):
        body = clamped()
        for method, keywords in (
            ("strong", {"degree": 3}), ("strong", {"scaling": 2.8}),
            ("fpm", {"smoothing": 1.4}), ("fpm", {"smoothing_from": "5-nearest"}),
            ("weak2", {"gauss": 6}), ("weak2", {"penalty": 10}),
            ("hats", {"degree": 2}), ("hats", {"conductivity": "1+x/10"}),
            ("hats", {"source": 0.1}), ("hats", {"reaction": 0.1}),
        ):
            with self.subTest(method=method, **keywords):
                plain, _ = solve(*body, method=method, **SMOOTH)
                other, _ = solve(*body, method=method, **SMOOTH, **keywords)
                self.assertGreater(abs(other["q1"] - plain["q1"]).max(), 1e-8)

    def test_the_method_is_hats_unless_another_is_asked_for(self):
        body = clamped()
        assert_array_equal(solve(*body, **SMOOTH)[0], solve(*body, method="hats", **SMOOTH)[0])

    def test_keywords_without_meaning_are_refused_with_a_remedy(self):
        points, cells, sides = clamped(4)
        for keywords, text in (
            ({}, "an elastic body needs young; for steel, in SI units: young=210e9, poisson=0.3"),
            ({"young": 1}, "an elastic body needs poisson; for steel, in SI units: young=210e9, poisson=0.3"),
            ({"young": -1, "poisson": 0.3}, "Young's modulus must be positive and finite, got -1"),
            ({"plane": "shell", **ELASTIC}, "plane: there is no 'shell'; choose one of stress, strain"),
            ({"equation": "heat"}, "equation: there is no 'heat'; choose one of elasticity, poisson"),
            ({"equation": "poisson", "fix": "wall"},
             'fix belongs to equation="elasticity"; for a scalar write value={"NAME": 0}'),
            ({"fix": "wall", "colour": 1, **ELASTIC}, "there is no option 'colour'; see help(solve)"),
            ({"equation": "poisson", "value": {"wall": 0}, "degree": 7}, "degree must lie between 2 and 3, got 7"),
            ({"equation": "poisson", "value": {"wall": 0}, "gauss": 2.5}, "gauss: '2.5' is no whole number up to 1e15"),
            ({"equation": "poisson", "value": {"wall": 0}, "source": "sin(x"},
             "source: 'sin(x' : ')' expected at character 6"),
            ({"equation": "poisson", "value": {"wall": 0}, "source": "1/x"},
             "source: '1/x' is not finite at the particle (0, 0); write it so that it is, for instance with max"),
            ({"equation": "poisson", "value": {"wall": 0}, "conductivity": 0},
             "conductivity must be positive, it is 0 at the particle (0, 0)"),
            ({"equation": "poisson", "value": {"wall": 0}, "method": "all"}, "solve takes one method; call it for each"),
            ({"equation": "poisson", "value": {"wall": 0}, "method": ["hats", "fpm"]},
             "solve takes one method; call it for each"),
            ({"fix": "wall", "smoothing-from": "nearest", **ELASTIC},
             "there is no option 'smoothing-from'; see help(solve)"),
        ):
            with self.subTest(**keywords), self.refuses(text):
                solve(points, cells, sides, **keywords)

    def test_functions_of_python_are_refused_with_how_to_write_one(self):
        with self.assertRaisesRegex(ValueError, r'^value: <function .*> is no number and no function; write functions as a text, such as "1 \+ x\^2"$'):
            solve(*square(4), equation="poisson", value={"boundary": lambda x: x})

    def test_numbers_that_are_not_finite_are_refused(self):
        for bad in numpy.nan, numpy.inf, -numpy.inf:
            for keywords in {"source": bad}, {"conductivity": bad}, {"reaction": bad}:
                with self.subTest(**keywords), self.assertRaises(ValueError):
                    solve(*square(4), equation="poisson", value={"boundary": 0}, **keywords)

        with self.refuses("source must be finite, got nan"):
            solve(*square(4), equation="poisson", value={"boundary": 0}, source=numpy.nan)

    def test_numbers_of_any_kind_are_numbers(self):
        expected, _ = solve(*square(4), equation="poisson", value={"boundary": 0.5})
        for half in fractions.Fraction(1, 2), decimal.Decimal("0.5"), numpy.float32(0.5), numpy.array(0.5), "1/2":
            with self.subTest(half=half):
                assert_array_equal(solve(*square(4), equation="poisson", value={"boundary": half})[0], expected)

    def test_a_power_may_be_written_as_python_does(self):
        power, _ = solve(*square(4), equation="poisson", value={"boundary": "x^2-y^2"})
        assert_array_equal(solve(*square(4), equation="poisson", value={"boundary": "x**2-y**2"})[0], power)

    def test_names_of_sides_come_in_any_collection(self):
        points, cells, sides = clamped(9)
        expected, _ = solve(points, cells, sides, fix=["wall", "tip"], body_force=("x", 0), **ELASTIC)
        for names in ("wall", "tip"), numpy.array(["wall", "tip"]), {"wall": 0, "tip": 0}.keys():
            with self.subTest(names=names):
                found, _ = solve(points, cells, sides, fix=names, body_force=("x", 0), **ELASTIC)
                assert_array_equal(found, expected)

    def test_empty_texts_are_refused(self):
        for keywords in {"source": ""}, {"conductivity": "1\0"}:
            with self.subTest(**keywords), self.assertRaisesRegex(ValueError, "has an empty text, or one with a zero byte$"):
                solve(*square(4), equation="poisson", value={"boundary": 0}, **keywords)

    def test_a_body_of_one_temperature_or_one_that_only_turns_has_no_warning(self):
        points, cells, sides = clamped(9)
        for method in "hats", "fpm", "strong", "weak1", "weak2":
            with self.subTest(method=method):
                warm, _ = solve(points, cells, sides, equation="poisson", value={"wall": 293.15}, method=method)
                assert_allclose(warm["u"], 293.15, rtol=1e-6)
                turned, _ = solve(points, cells, sides, displacement={"wall": ("-0.01*y", "0.01*x")}, young=210e9,
                                  poisson=0.3, method=method)
                assert_allclose(turned["u2"], 0.01 * points[:, 0], atol=1e-6)

    def test_options_of_the_program_alone_are_none_of_solve(self):
        for name, value in ("help", True), ("version", True), ("threads", 2), ("mesh", "a.geo"), ("output", "a.csv"):
            with self.subTest(name=name), self.refuses(f"there is no option '{name}'; see help(solve)"):
                solve(*square(4), equation="poisson", value={"boundary": 0}, **{name: value})

    def test_a_body_that_moves_freely_is_refused(self):
        points, cells, sides = clamped(4)
        for keywords in {"traction": {"tip": (1, 0)}, **ELASTIC}, {"equation": "poisson", "flux": {"tip": 1}}:
            with self.subTest(**keywords), self.assertRaises(ValueError):
                solve(points, cells, sides, **keywords)


if __name__ == "__main__":
    unittest.main()
