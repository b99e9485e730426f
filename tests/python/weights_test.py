"""weights: the row of an operator, what it makes of monomials, and the bound of its error."""

import itertools
import math
import re
import unittest

import numpy
from numpy.testing import assert_allclose, assert_array_equal
from particle_methods import Weights, operators, table, weights

from support import FORMULATIONS, SCHEMES, TestCase, cloud, line, monomial, multi_indices, table_and_comments
from support import tolerances


class OnALine(TestCase):
    def test_they_are_the_row_of_each_operator(self):
        x = line(20)
        for formulation in FORMULATIONS:
            both = operators(formulation, x)
            for number in 0, 1, 10, 19:
                with self.subTest(formulation=formulation, number=number):
                    row = weights(formulation, x, number)
                    assert_array_equal(row.offsets, x[row.particles] - x[number])
                    for k, D in enumerate(both, start=1):
                        whole = numpy.zeros(20)
                        whole[row.particles] = row.weights[k]
                        assert_array_equal(whole, D[number].toarray().ravel())

    def test_the_particle_is_among_its_neighbours_which_are_in_order(self):
        for formulation in FORMULATIONS:
            row = weights(formulation, line(20), 7)
            self.assertIn(7, row.particles)
            self.assertEqual(row.offsets[list(row.particles).index(7)], 0)
            self.assertTrue((numpy.diff(row.particles) > 0).all())

    def test_the_arguments_are_those_of_operators(self):
        x = line(20)
        how = {"kernel": "quintic_spline", "smoothing": 1.5, "smoothing_from": "local",
               "volumes": "partition"}
        D, _ = operators("chen_beraun", x, **how)
        row = weights("chen_beraun", x, 3, **how)
        assert_array_equal(row.weights[1], D[3].toarray().ravel()[row.particles])

    def test_they_and_what_they_leave_are_those_of_stencil(self):
        case = {"particles": 20, "perturb": 0.25, "seed": 7}
        x = table("derivative_test", formulation="fpm", states=True, **case)["x"]
        for formulation, number in itertools.product(FORMULATIONS, (0, 10)):
            with self.subTest(formulation=formulation, number=number):
                rows, comments = table_and_comments("stencil", formulation=formulation, particle=number,
                                                    **case)
                found, delta = weights(formulation, x, number), 1 / 19
                assert_array_equal(found.particles, rows["particle"])
                # The table of positions has ten digits.
                assert_allclose(found.offsets / delta, rows["offset"], rtol=1e-7, atol=1e-8)
                assert_allclose(found.weights[1] * delta, rows["weight_first"], rtol=1e-6, atol=1e-7)
                assert_allclose(found.weights[2] * delta**2, rows["weight_second"], rtol=1e-6, atol=1e-7)
                self.compare(found, delta, "\n".join(comments))

    def compare(self, found, delta, comments):
        """Moments and R of a comment such as '# D2, moment 3 / 3!: 0.25' and '# D, quality R = 0.27'."""
        moments = re.findall(r"# D(2?), moment (\d) / \d!: ([^,:\n]+)", comments)
        self.assertEqual(len(moments), 14)
        for second, power, printed in moments:
            k, power = 2 if second else 1, int(power)
            scaled = found.moments[k][power] * delta ** (k - power)
            assert_allclose(scaled, float(printed), rtol=1e-5, atol=2e-6)
        bounds = re.findall(r"# D(2?), quality R = ([^:,\n]+)", comments)
        for second, printed in bounds:
            assert_allclose(found.quality[2 if second else 1], float(printed), rtol=1e-5)
        self.assertEqual(len(bounds), 2)

    def test_moments_are_what_the_weights_make_of_monomials(self):
        x = line(20)
        for formulation in FORMULATIONS:
            row = weights(formulation, x, 4)
            for k in 1, 2:
                self.assertEqual(set(row.moments[k]), set(range(7)))
                for power, moment in row.moments[k].items():
                    terms = row.weights[k] * row.offsets**power / math.factorial(power)
                    assert_allclose(moment, math.fsum(terms), rtol=1e-12, atol=1e-14 * abs(terms).sum())

    def test_moments_up_to_the_degree_of_exactness_are_0_and_that_of_the_derivative_is_1(self):
        for formulation, exact in FORMULATIONS.items():
            row = weights(formulation, line(20), 4)
            for k, degree in enumerate(exact, start=1):
                for power in range(degree + 1):
                    assert_allclose(row.moments[k][power], power == k, atol=1e-11)

    def test_the_error_of_a_row_is_at_most_its_bound(self):
        x = line(40)
        for formulation, exact in FORMULATIONS.items():
            for number in 0, 1, 20:
                row = weights(formulation, x, number)
                for k, m in enumerate(exact, start=1):
                    error = abs(row.weights[k] @ numpy.exp(x[row.particles]) - numpy.exp(x[number]))
                    bound = row.quality[k] * (1 / 39) ** (m + 1 - k) * numpy.exp(x[row.particles].max())
                    if m < k:  # where R bounds the sum alone
                        bound += numpy.exp(x[number])
                    with self.subTest(formulation=formulation, number=number, k=k):
                        self.assertLessEqual(error, bound)

    def test_the_bound_is_the_sum_of_absolute_terms_in_units_of_the_particles_own_spacing(self):
        x = line(30)
        gaps = numpy.diff(x)
        for number in 0, 9, 29:
            delta = gaps[max(number - 1, 0):number + 1].max()
            row = weights("second_order_fpm", x, number, smoothing_from="local")
            for k, m in (1, 2), (2, 3):
                w, r = abs(row.weights[k]) * delta**k, abs(row.offsets) / delta
                assert_allclose(row.quality[k], sum(w * r ** (m + 1)) / math.factorial(m + 1), rtol=1e-12)

    def test_quality_in_a_table_is_that_of_its_worst_row(self):
        case = {"particles": 12, "perturb": 0.25}
        x = table("derivative_test", formulation="fpm", states=True, **case)["x"]
        for row in table("derivative_test", formulation=["modified_fpm", "ssph"], quality=True, **case):
            worst = max(R for i in range(12) for R in weights(row["formulation"], x, i).quality.values())
            assert_allclose(worst, row["quality"], rtol=1e-6)


class InThePlaneAndInSpace(TestCase):
    def test_they_are_the_row_of_each_operator(self):
        for (dim, side), (scheme, _) in itertools.product([(2, 8), (3, 6)], SCHEMES.values()):
            x = cloud(side, dim)
            D = operators(x, **scheme)
            for number in 0, 33:
                with self.subTest(dim=dim, number=number, **scheme):
                    row = weights(x, number, **scheme)
                    assert_array_equal(row.offsets, x[row.particles] - x[number])
                    self.assertEqual(set(row.weights), set(D))
                    for a in D:
                        whole = D[a][number].toarray().ravel()
                        assert_array_equal(row.weights[a], whole[row.particles])
                        self.assertEqual(abs(numpy.delete(whole, row.particles)).sum(), 0)

    def test_the_arguments_are_those_of_operators(self):
        x = cloud(8, 2)
        for how in ({"kernel": "quintic_spline", "smoothing": 1.6, "smoothing_from": "mean"},
                    {"smoothing_from": numpy.linspace(0.2, 0.25, 64)}, {"smoothing_from": 0.22}):
            row = weights(x, 5, **how)
            for a, D in operators(x, **how).items():
                assert_array_equal(row.weights[a], D[5].toarray().ravel()[row.particles])

    def test_moments_are_what_the_weights_make_of_monomials_up_to_degree_4(self):
        for dim, side in (2, 8), (3, 6):
            row = weights(cloud(side, dim), 20)
            for a in row.weights:
                self.assertEqual(set(row.moments[a]), set(multi_indices(dim, range(5))))
                for b, moment in row.moments[a].items():
                    terms = row.weights[a] * monomial(row.offsets, b) / math.prod(map(math.factorial, b))
                    assert_allclose(moment, math.fsum(terms), rtol=1e-11, atol=1e-13 * abs(terms).sum())

    def test_moments_up_to_the_degree_of_exactness_are_0_and_that_of_the_derivative_is_1(self):
        for (dim, side), (scheme, exact) in itertools.product([(2, 8), (3, 6)], SCHEMES.values()):
            for a, moments in weights(cloud(side, dim), 20, **scheme).moments.items():
                for b in multi_indices(dim, range(exact[sum(a) - 1] + 1)):
                    assert_allclose(moments[b], a == b, atol=1e-10)

    def test_quality_is_that_of_derivative_test_in_space(self):
        for dim, side in (2, 8), (3, 5):
            rows, comments = table_and_comments("derivative_test_in_space", dimension=dim, particles=side,
                                                perturb=0.1, states=True, formulation=list(SCHEMES))
            within = tolerances(comments)["quality"]
            for name, (scheme, _) in SCHEMES.items():
                states = rows[rows["formulation"] == name]
                x = numpy.column_stack([states[axis] for axis in "xyz"[:dim]])
                for number in 0, len(x) // 2, len(x) - 1:
                    with self.subTest(dim=dim, name=name, number=number):
                        R = weights(x, number, smoothing_from="mean", **scheme).quality
                        worst = max(R[a] for a in multi_indices(dim, [2]))
                        assert_allclose(worst, states["quality"][number], **within)

    def test_the_error_of_a_row_is_at_most_its_bound(self):
        x = cloud(10, 2)
        B = numpy.exp(x.sum(axis=1))
        for scheme, exact in SCHEMES.values():
            for number in 0, 5, 55:
                row = weights(x, number, smoothing_from=1 / 9, **scheme)
                for a, w in row.weights.items():
                    k, m = sum(a), exact[sum(a) - 1]
                    # The derivative of exp(x + y) along a direction is largest along the diagonal.
                    largest = math.sqrt(2) ** (m + 1) * B[row.particles].max()
                    self.assertLessEqual(abs(w @ B[row.particles] - B[number]),
                                         row.quality[a] * (1 / 9) ** (m + 1 - k) * largest)


class TheClass(TestCase):
    def test_shapes_and_types_are_those_of_the_neighbours(self):
        for row, shape in (weights("fpm", line(20), 9), ()), (weights(cloud(8, 2), 9), (2,)):
            n = len(row.particles)
            self.assertIsInstance(row, Weights)
            self.assertEqual(row.particles.dtype, numpy.int32)
            self.assertEqual((row.offsets.shape, row.offsets.dtype), ((n, *shape), float))
            self.assertEqual({w.shape for w in row.weights.values()}, {(n,)})
            self.assertEqual({type(R) for R in row.quality.values()}, {float})

    def test_keys_are_orders_on_a_line_and_multi_indices_elsewhere(self):
        for row, keys in ((weights("fpm", line(20), 9), {1, 2}),
                          (weights(cloud(8, 2), 9), {(1, 0), (0, 1), (2, 0), (1, 1), (0, 2)})):
            for numbers in row.weights, row.moments, row.quality:
                self.assertEqual(set(numbers), keys)

    def test_it_cannot_be_made_or_assigned_by_hand(self):
        with self.assertRaises(TypeError):
            Weights()
        with self.assertRaises(AttributeError):
            weights("fpm", line(20), 9).weights = {}

    def test_singular_neighbourhoods_are_those_of_operators(self):
        for compute in (lambda: operators("fpm", [0, 1, 2.0], kernel="cubic_spline", smoothing=0.1),
                        lambda: weights("fpm", [0, 1, 2.0], 0, kernel="cubic_spline", smoothing=0.1)):
            with self.refuses("fpm: particle 0 (x = 0) has 1 neighbour within 2h, needs 2; try smoothing=0.51",
                              RuntimeError):
                compute()


if __name__ == "__main__":
    unittest.main()
