"""solve: fields that each method has exactly, the account of errors, and what cannot be trusted."""

import math
import unittest
import warnings

import numpy
from numpy.testing import assert_allclose, assert_array_equal
from particle_methods import solve

from support import ELASTIC, SMOOTH, TestCase, clamped, cube, faces, square, table_and_comments, tolerances

METHODS = "hats", "fpm", "strong", "weak1", "weak2"


def shuffled(points, cells, sides):
    """The same body with its points, cells, facets and their corners in another order."""
    random = numpy.random.default_rng(3)
    order = random.permutation(len(points))
    number = numpy.argsort(order)
    turned = numpy.array([number[random.permutation(cell)] for cell in random.permutation(cells)])
    facets = {name: number[random.permutation(side)][:, ::-1] for name, side in reversed(sides.items())}
    return points[order], turned, facets, order


class ExactFields(TestCase):
    def test_linear_displacements_of_a_square_are_exact(self):
        points, cells, sides = clamped()
        ux, uy = "0.1*x-0.2*y", "0.3*x+0.1*y"
        E, nu = ELASTIC["young"], ELASTIC["poisson"]
        stress = E / (1 - nu**2) * (0.1 + nu * 0.1), E / (2 * (1 + nu)) * 0.1
        for method in METHODS:
            with self.subTest(method=method):
                fields, numbers = solve(points, cells, sides, method=method, **ELASTIC,
                                        displacement={side: (ux, uy) for side in ("wall", "tip", "rest")})
                assert_allclose(fields["u1"], points @ [0.1, -0.2], atol=1e-12)
                assert_allclose(fields["u2"], points @ [0.3, 0.1], atol=1e-12)
                for name, value in zip(("s11", "s22", "s12"), (stress[0], stress[0], stress[1])):
                    assert_allclose(fields[name], value, atol=1e-10)
                self.assertLess(numbers["defect"], 1e-10)

    def test_plane_strain_and_stress_differ_as_their_laws_do(self):
        points, cells, sides = clamped()
        E, nu = ELASTIC["young"], ELASTIC["poisson"]
        factor = {"stress": E / (1 - nu**2), "strain": E * (1 - nu) / (1 + nu) / (1 - 2 * nu)}
        for plane in factor:
            fields, _ = solve(points, cells, displacement={"boundary": ("x", 0)}, plane=plane, **ELASTIC)
            assert_allclose(fields["s11"], factor[plane])

    def test_quadratic_scalars_with_their_source_are_exact(self):
        points, cells = square(7)
        x, y = points.T
        for method in METHODS:
            with self.subTest(method=method):
                fields, _ = solve(points, cells, equation="poisson", conductivity=3, source=-12,
                                  value={"boundary": "x^2+y^2-x*y"}, method=method)
                assert_allclose(fields["u"], x * x + y * y - x * y, atol=1e-11)
                assert_allclose(fields["q1"], -3 * (2 * x - y), atol=1e-9)
                assert_allclose(fields["q2"], -3 * (2 * y - x), atol=1e-9)

    def test_linear_displacements_and_quadratic_scalars_of_a_cube_are_exact(self):
        points, cells = cube(5)
        x, y, z = points.T
        for method in "hats", "fpm", "strong":
            with self.subTest(method=method):
                fields, _ = solve(points, cells, displacement={"boundary": ("0.1*x", "0.2*z", "-0.1*y")},
                                  method=method, **ELASTIC)
                for name, exact in ("u1", 0.1 * x), ("u2", 0.2 * z), ("u3", -0.1 * y):
                    assert_allclose(fields[name], exact, atol=1e-12)
                fields, _ = solve(points, cells, equation="poisson", source=-2, value={"boundary": "x^2+y-z"},
                                  method=method)
                assert_allclose(fields["u"], x * x + y - z, atol=1e-10 if method != "hats" else 0.01)

    def test_a_bar_under_tension_is_longer_and_thinner(self):
        points, cells, sides = clamped()
        sides["floor"] = faces(points, cells, floor=(1, 0))["floor"]
        fields, numbers = solve(points, cells, sides, symmetry=["wall", "floor"], traction={"tip": (0.5, 0)},
                                **ELASTIC)
        assert_allclose(fields["u1"], 0.2 * points[:, 0], atol=1e-10)
        assert_allclose(fields["u2"], -0.06 * points[:, 1], atol=1e-10)
        assert_allclose(fields["von_mises"], 0.5)
        self.assertAlmostEqual(numbers["max_von_mises"], 0.5)

    def test_a_wall_between_two_temperatures_and_one_cooled_by_air(self):
        points, cells, sides = clamped()
        fields, numbers = solve(points, cells, sides, equation="poisson", conductivity=4, value={"wall": 100},
                                convection={"tip": (2, 10)})
        q = (100 - 10) / (1 / 4 + 1 / 2)
        assert_allclose(fields["u"], 100 - q / 4 * points[:, 0], rtol=1e-10)
        assert_allclose(fields["q1"], q, rtol=1e-9)
        assert_allclose(numbers["reaction1:wall"], q, rtol=1e-9)

    def test_the_order_of_points_cells_and_facets_does_not_matter(self):
        for method in "hats", "fpm":
            body = clamped()
            fields, numbers = solve(*body, method=method, **SMOOTH)
            *moved, order = shuffled(*body)
            again, others = solve(*moved, method=method, **SMOOTH)
            for name in fields.dtype.names:
                with self.subTest(method=method, name=name):
                    assert_allclose(again[name], fields[name][order], rtol=1e-9, atol=1e-9)
            self.assertEqual(set(numbers), set(others))
            for name in "max_u", "load1:tip", "reaction1:wall":
                assert_allclose(others[name], numbers[name], rtol=1e-9)

    def test_lengths_of_ones_own_belong_to_the_points_in_their_order(self):
        points, cells, sides = clamped()
        lengths = 0.125 * (1 + 0.1 * points[:, 0] + 0.05 * points[:, 1])
        fields, _ = solve(points, cells, sides, method="fpm", smoothing_from=lengths, **SMOOTH)
        plain, _ = solve(points, cells, sides, method="fpm", smoothing_from=0.125, **SMOOTH)
        self.assertGreater(abs(fields["u"] - plain["u"]).max(), 1e-6)
        *moved, order = shuffled(points, cells, sides)
        again, _ = solve(*moved, method="fpm", smoothing_from=lengths[order], **SMOOTH)
        assert_allclose(again["u"], fields["u"][order], rtol=1e-9)
        with self.refuses("81 points need as many smoothing_from, or one, got 80"):
            solve(points, cells, sides, method="fpm", smoothing_from=lengths[1:], **SMOOTH)

    def test_errors_of_a_smooth_scalar_are_small_and_fall_with_the_square_of_the_distance(self):
        for method in METHODS:
            error = {}
            for n in 9, 17:
                points, cells, sides = clamped(n)
                fields, _ = solve(points, cells, sides, method=method, **SMOOTH)
                error[n] = abs(fields["u"] - numpy.exp(points[:, 0]) * numpy.sin(points[:, 1])).max()
            with self.subTest(method=method):
                self.assertLess(error[9], 0.01)
                self.assertGreater(math.log2(error[9] / error[17]), 1.5)

    def test_shear_stress_of_a_twisted_bar_is_that_of_the_series(self):
        points, cells = square(31)
        series = sum(1 / (k * k * math.cosh(k * math.pi / 2)) for k in range(1, 20, 2))
        exact = 1 - 8 / math.pi**2 * series
        self.assertAlmostEqual(exact, 0.675, places=3)
        for method in "hats", "fpm", "strong":
            with self.subTest(method=method):
                fields, _ = solve(points, cells, equation="poisson", source=2, value={"boundary": 0},
                                  at=[[0.5, 0]], method=method)
                assert_allclose(numpy.hypot(fields["q1"], fields["q2"]), exact, rtol=0.01)


class Account(TestCase):
    def test_reactions_loads_and_volume_are_in_equilibrium(self):
        points, cells, sides = clamped()
        sides["floor"] = faces(points, cells, floor=(1, 0))["floor"]
        _, numbers = solve(points, cells, sides, symmetry=["wall", "floor"], body_force=("x", -1),
                           pressure={"tip": 0.2}, **ELASTIC)
        assert_allclose(numbers["load1:tip"], -0.2, rtol=1e-12)
        assert_allclose([numbers["volume1"], numbers["volume2"]], [0.5, -1], rtol=1e-12)
        for i in "12":
            forces = [value for name, value in numbers.items()
                      if name.startswith((f"load{i}:", f"reaction{i}:", f"volume{i}"))]
            assert_allclose(sum(forces), 0, atol=1e-12)
        self.assertLess(numbers["defect"], 1e-12)

    def test_a_cube_that_hangs_from_its_top_pulls_with_its_weight(self):
        points, cells = cube(4)
        sides = faces(points, cells, top=(2, 1))
        fields, numbers = solve(points, cells, sides, symmetry="top", displacement={"rest": (0, 0, None)},
                                body_force=(0, 0, -2), young=2.5, poisson=0.0)
        assert_allclose(fields["u3"], -2 / 2.5 * (1 - points[:, 2] ** 2) / 2, atol=0.02)
        assert_allclose([numbers["volume3"], numbers["reaction3:top"]], [-2, 2], rtol=1e-9)

    def test_numbers_are_of_python_and_finite(self):
        points, cells, sides = clamped()
        _, numbers = solve(points, cells, sides, symmetry="wall", displacement={"tip": (0.1, 0)}, **ELASTIC)
        self.assertEqual({type(value) for value in numbers.values()}, {float})
        self.assertTrue(all(map(math.isfinite, numbers.values())))
        for name in "max_displacement", "max_von_mises", "quality", "noise", "missed_loads", "defect":
            self.assertIn(name, numbers)

    def test_doubtful_stresses_are_a_warning_in_the_callers_line(self):
        points, cells, sides = clamped()
        with self.assertWarnsRegex(UserWarning, r"^hats: the stresses at the boundary miss the given loads by [0-9.]+ % of the size of stresses, limit 10; do not trust those near the boundary$") as caught:
            solve(points, cells, sides, fix="wall", traction={"tip": (0, -1e-3)}, **ELASTIC)
        self.assertEqual(caught.filename, __file__)

    def test_a_warning_made_an_error_is_raised(self):
        points, cells, sides = clamped()
        with warnings.catch_warnings(), self.assertRaises(UserWarning):
            warnings.simplefilter("error")
            solve(points, cells, sides, fix="wall", traction={"tip": (0, -1e-3)}, **ELASTIC)

    def test_forces_far_from_equilibrium_are_a_failed_computation_whose_remedy_works(self):
        points, cells, sides = clamped()
        problem = {"fix": "wall", "traction": {"tip": (0, -1e-3)}, **ELASTIC}
        with self.assertRaisesRegex(RuntimeError, r'^fpm: loads and reactions leave a defect of [0-9.]+ % of their sizes; loads tip \(0, -0.001\), reactions wall \(.*\), volume \(0, 0\); take method="hats" or a finer mesh$'):
            solve(points, cells, sides, method="fpm", **problem)
        with self.assertWarns(UserWarning):
            _, numbers = solve(points, cells, sides, method="hats", **problem)
        self.assertLess(numbers["defect"], 0.02)

    def test_stiffness_and_loads_in_other_units_give_the_same_displacements(self):
        points, cells, sides = clamped()
        sides = {"wall": sides["wall"]}
        fields, _ = solve(points, cells, sides, symmetry="wall", displacement={"rest": (None, "0")},
                          body_force=(1, 0), **ELASTIC)
        larger, _ = solve(points, cells, sides, symmetry="wall", displacement={"rest": (None, "0")},
                          body_force=(1e9, 0), young=2.5e9, poisson=0.3)
        assert_allclose(larger["u1"], fields["u1"], rtol=1e-9, atol=1e-12)
        assert_allclose(larger["s11"], 1e9 * fields["s11"], rtol=1e-7, atol=1e-2)


class Plate(TestCase):
    """Section 4.1 of Batra and Zhang (2008), in m and Pa: held at the left, sheared at the right."""

    def test_a_plate_given_as_a_body_has_the_displacements_and_stresses_of_the_program(self):
        for method, (nx, ny) in ("weak1", (16, 4)), ("strong", (31, 7)):
            with self.subTest(method=method):
                rows, comments = table_and_comments("plate", particles=f"{nx}x{ny}", method=method,
                                                    states="particles")
                x, y = numpy.meshgrid(numpy.linspace(0, 1, nx), numpy.linspace(0, 0.2, ny), indexing="ij")
                points = numpy.column_stack([x.ravel(), y.ravel()])
                first = numpy.arange(nx * ny).reshape(nx, ny)[:-1, :-1].ravel()[:, numpy.newaxis]
                cells = numpy.concatenate([first + [0, ny, ny + 1], first + [0, ny + 1, 1]])
                sides = faces(points, cells, left=(0, 0), right=(0, 1), bottom=(1, 0), top=(1, 0.2))
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # of coarse particles
                    fields, _ = solve(points, cells, sides, young=226.9e9, poisson=0.33, method=method,
                                      displacement={"left": self.displacement()}, smoothing_from="nearest",
                                      traction={"right": (0, "-6*1e6/0.2*5*y*(5*y-1)")},
                                      corner={"right+top": "right,top", "right+bottom": "right,bottom"})
                assert_array_equal(fields["x"], points[:, 0])
                for name in "u1", "u2":
                    assert_allclose(fields[name], rows[name], **tolerances(comments)[name])
                for name in "s11", "s22", "s12":  # whose round-off is that of the largest
                    assert_allclose(fields[name], rows[name], atol=1e-6 * abs(rows["s11"]).max())

    def displacement(self):
        """(4.2) at the left."""
        y = "(5*y-0.5)"
        return f"-2e6/226.9e9*{y}*2.33*5*y*(5*y-1)", f"2e6/226.9e9*3*0.33*5*{y}^2"


if __name__ == "__main__":
    unittest.main()
