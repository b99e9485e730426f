"""operators: errors of the programs' tables, exactness, symmetry, and what the matrices are."""

import tempfile
import unittest

import numpy
import scipy.sparse
import scipy.spatial
from numpy.testing import assert_allclose, assert_array_equal
from particle_methods import operators, table

from support import FORMULATIONS, KERNELS, SCHEMES, TestCase, cloud, line, monomial, multi_indices
from support import table_and_comments, tolerances


class OnALine(TestCase):
    def test_derivatives_at_each_particle_are_those_of_derivative_test(self):
        x = line(20)
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            numpy.savetxt(file, x, "%.17g")
            file.flush()
            for kernel, smoothing in KERNELS.items():
                how = {"kernel": kernel, "smoothing": smoothing}
                options = {"positions": file.name, "formulation": list(FORMULATIONS), "states": True, **how}
                rows, comments = table_and_comments("derivative_test", **options)
                within = tolerances(comments)
                for formulation in FORMULATIONS:
                    with self.subTest(kernel=kernel, formulation=formulation):
                        states = rows[rows["formulation"] == formulation]
                        D, D2 = operators(formulation, x, **how)
                        assert_allclose(D @ numpy.exp(x), states["DB"], **within["DB"])
                        assert_allclose(D2 @ numpy.exp(x), states["D2B"], **within["D2B"])

    def test_largest_errors_are_those_of_derivative_test(self):
        how = {"volumes": "partition", "smoothing_from": "local", "smoothing": 1.1}
        options = {"particles": [20, 40], "perturb": 0.25, **how}
        states = table("derivative_test", formulation="fpm", states=True, **options)
        errors, comments = table_and_comments("derivative_test", formulation=list(FORMULATIONS), **options)
        within = tolerances(comments)
        for row in errors:
            with self.subTest(formulation=row["formulation"], particles=row["particles"]):
                x = states["x"][states["particles"] == row["particles"]]
                D, D2 = operators(row["formulation"], x, **how)
                assert_allclose(abs(D @ numpy.exp(x) - numpy.exp(x)).max(), row["error_first"],
                                **within["error_first"])
                assert_allclose(abs(D2 @ numpy.exp(x) - numpy.exp(x)).max(), row["error_second"],
                                **within["error_second"])

    def test_polynomials_are_exact_up_to_the_degree_of_each_formulation_and_no_further(self):
        x = line(30)
        for kernel, smoothing in KERNELS.items():
            for formulation, exact in FORMULATIONS.items():
                with self.subTest(kernel=kernel, formulation=formulation):
                    both = operators(formulation, x, kernel=kernel, smoothing=smoothing)
                    for k, (D, degree) in enumerate(zip(both, exact), start=1):
                        error = [abs(D @ x**p - monomial(x[:, numpy.newaxis], (p,), (k,))).max()
                                 for p in range(degree + 2)]
                        assert_allclose(error[:-1], 0, atol=1e-9)
                        self.assertGreater(error[-1], 1e-6)

    def test_rows_of_any_formulation_sum_to_zero_up_to_round_off(self):
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                for D in operators(formulation, line(50)):
                    sums = abs(D.sum(axis=1)).max()
                    self.assertLessEqual(sums, 4 * numpy.finfo(float).eps * abs(D).sum(axis=1).max())

    def test_a_mirrored_line_has_mirrored_operators(self):
        x = line(30)
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                D, D2 = (matrix.toarray() for matrix in operators(formulation, x))
                M, M2 = (matrix.toarray() for matrix in operators(formulation, 1 - x[::-1]))
                assert_allclose(M, -D[::-1, ::-1], rtol=1e-9, atol=1e-9 * abs(D).max())
                assert_allclose(M2, D2[::-1, ::-1], rtol=1e-9, atol=1e-9 * abs(D2).max())

    def test_a_longer_line_elsewhere_has_the_same_operators_in_its_units(self):
        x = line(30)
        for formulation in FORMULATIONS:
            with self.subTest(formulation=formulation):
                longer = operators(formulation, 8 * x - 3)
                for k, (here, there) in enumerate(zip(operators(formulation, x), longer), start=1):
                    assert_allclose(8**k * there.toarray(), here.toarray(),
                                    rtol=1e-9, atol=1e-9 * abs(here).max())

    def test_orders_of_the_second_order_fpm_are_two_on_the_particles_of_the_paper(self):
        error = []
        for N in 160, 320:
            x = numpy.linspace(0, 1, N + 1)
            D, D2 = operators("second_order_fpm", x)
            error.append([abs(A @ numpy.exp(x) - numpy.exp(x)).max() for A in (D, D2)])
        assert_allclose(numpy.log2(numpy.divide(*error)), 2, atol=0.05)

    def test_the_spacing_is_a_name_a_length_or_a_length_for_each_particle(self):
        x = line(30)
        gaps = numpy.diff(x)
        farther = numpy.maximum(numpy.append(gaps, 0), numpy.append(0, gaps))
        nearer = numpy.minimum(numpy.append(gaps, 1), numpy.append(1, gaps))
        spacings = {"mean": 1 / 29, "largest": gaps.max(), "local": farther, "nearest": nearer}
        for name, lengths in spacings.items():
            with self.subTest(name=name):
                for asked, given in zip(operators("fpm", x, smoothing=1.5, smoothing_from=name),
                                        operators("fpm", x, smoothing=1.5, smoothing_from=lengths)):
                    assert_allclose(given.toarray(), asked.toarray(),
                                    rtol=1e-12, atol=1e-12 * abs(asked).max())

    def test_one_length_for_all_is_an_array_of_equal_ones(self):
        x = line(30)
        for one, each in zip(operators("fpm", x, smoothing_from=0.04),
                             operators("fpm", x, smoothing_from=numpy.full(30, 0.04))):
            assert_array_equal(each.toarray(), one.toarray())

    def test_the_keywords_have_an_effect(self):
        x = line(30)
        plain = operators("original", x)[0].toarray()
        for keyword in ({"kernel": "quintic_spline"}, {"smoothing": 1.5}, {"smoothing_from": "largest"},
                        {"volumes": "partition"}):
            with self.subTest(**keyword):
                self.assertGreater(abs(operators("original", x, **keyword)[0] - plain).max(), 1e-3)

    def test_operators_of_a_reversed_line_are_refused_with_its_particle(self):
        with self.refuses("particle 1 lies before its predecessor; sort the positions (x = 0.909091)"):
            operators("fpm", numpy.linspace(0, 1, 12)[::-1])

    def test_coincident_particles_are_refused_with_their_place(self):
        with self.refuses("particle 2 coincides with the particle before it (x = 0.5)"):
            operators("fpm", [0, 0.5, 0.5, 1])

    def test_positions_that_are_not_finite_are_refused(self):
        for bad in numpy.nan, numpy.inf, -numpy.inf:
            with self.subTest(bad=bad), self.refuses("particle 2 is not at a finite position"):
                operators("fpm", [0, 0.5, bad, 1])

    def test_a_line_needs_two_particles(self):
        for x in [], [0.5]:
            with self.subTest(x=x), self.refuses(f"a line needs at least 2 particles, got {len(x)}"):
                operators("fpm", x)

    def test_names_that_nothing_has_are_refused_with_those_there_are(self):
        x = line(12)
        with self.refuses("there is no formulation 'spline'; choose one of " + ", ".join(FORMULATIONS)):
            operators("spline", x)
        for keywords, text in (
            ({"kernel": "box"}, "there is no kernel 'box'; choose one of " + ", ".join(KERNELS)),
            ({"volumes": "none"}, "there is no volume convention 'none'; choose one of equal, partition"),
            ({"smoothing_from": "farthest"}, "there is no spacing 'farthest'; choose one of mean, largest, local, nearest, or K-nearest with a number K, such as 6-nearest"),
        ):
            with self.subTest(**keywords), self.refuses(text):
                operators("fpm", x, **keywords)

    def test_arguments_have_the_names_of_the_text(self):
        x, points = line(12), cloud(6, 2)
        assert_array_equal(operators(formulation="fpm", x=x)[0].toarray(), operators("fpm", x)[0].toarray())
        assert_array_equal(operators(points=points)[1, 0].toarray(), operators(points)[1, 0].toarray())

    def test_a_smoothing_length_is_positive_and_finite(self):
        x = line(12)
        for bad in 0, -1, numpy.nan, numpy.inf:
            with self.subTest(smoothing=bad), self.refuses(
                    f"smoothing, the smoothing length over the spacing, must be positive and finite, got {bad}"):
                operators("fpm", x, smoothing=bad)
            with self.subTest(smoothing_from=bad), self.refuses(
                    f"smoothing_from must be positive and finite, got {bad}"):
                operators("fpm", x, smoothing_from=bad)

    def test_lengths_of_other_particles_are_refused_with_both_numbers(self):
        with self.refuses("12 particles need as many spacings, or one, got 11"):
            operators("fpm", line(12), smoothing_from=numpy.full(11, 0.1))

    def test_too_few_neighbours_are_a_failed_computation_whose_remedy_works(self):
        x = numpy.linspace(0, 1, 12)
        with self.refuses("fpm: particle 0 (x = 0) has 1 neighbour within 2h, needs 2; try smoothing=0.51",
                          RuntimeError):
            operators("fpm", x, kernel="cubic_spline", smoothing=0.1)
        D, _ = operators("fpm", x, kernel="cubic_spline", smoothing=0.51)
        assert_allclose(D @ x, 1)

    def test_no_matrix_holds_a_number_that_is_not_finite(self):
        for formulation in FORMULATIONS:
            for delta in 1e-300, 1e-160, 1e160:
                with self.subTest(formulation=formulation, delta=delta):
                    try:
                        matrices = operators(formulation, delta * numpy.arange(12))
                    except (ValueError, RuntimeError):
                        continue
                    for D in matrices:
                        self.assertTrue(numpy.isfinite(D.data).all())


class InThePlaneAndInSpace(TestCase):
    def test_errors_and_keys_are_those_of_derivative_test_in_space(self):
        def plane(x, a):
            return 0.5 ** a[1] * numpy.exp(x @ [1, 0.5]) + 2 ** a[1] * wave(x @ [1, 2], sum(a))

        def space(x, a):
            return (0.5 ** a[1] * (-0.3) ** a[2] * numpy.exp(x @ [1, 0.5, -0.3])
                    + 2 ** a[1] * 1.5 ** a[2] * wave(x @ [1, 2, 1.5], sum(a)))

        def wave(phase, k):
            return (numpy.sin, numpy.cos, lambda x: -numpy.sin(x))[k](phase)

        for dim, side, B in (2, 12, plane), (3, 6, space):
            for kernel in {}, {"kernel": "quintic_spline", "smoothing": 1.6}:
                rows, comments = table_and_comments("derivative_test_in_space", dimension=dim, particles=side,
                                                    perturb=0.2, states=True, formulation=list(SCHEMES), **kernel)
                within = tolerances(comments)
                for name, (scheme, _) in SCHEMES.items():
                    with self.subTest(dim=dim, kernel=kernel, name=name):
                        states = rows[rows["formulation"] == name]
                        x = numpy.column_stack([states[axis] for axis in "xyz"[:dim]])
                        D = operators(x, smoothing_from="mean", **scheme, **kernel)
                        self.assertEqual(set(D), set(multi_indices(dim, (1, 2))))
                        error = {a: abs(D[a] @ B(x, [0] * dim) - B(x, a)) for a in D}
                        for k, column in (1, "error_first"), (2, "error_second"):
                            largest = numpy.max([error[a] for a in multi_indices(dim, [k])], axis=0)
                            assert_allclose(largest, states[column], **within[column])

    def test_polynomials_are_exact_up_to_the_degree_of_each_scheme_and_no_further(self):
        for dim, side in (2, 10), (3, 6):
            x = cloud(side, dim)
            for scheme, exact in SCHEMES.values():
                with self.subTest(dim=dim, **scheme):
                    for a, D in operators(x, **scheme).items():
                        degree = exact[sum(a) - 1]
                        for b in multi_indices(dim, range(degree + 1)):
                            assert_allclose(D @ monomial(x, b), monomial(x, b, a), atol=1e-8)
                        self.assertGreater(max(abs(D @ monomial(x, b) - monomial(x, b, a)).max()
                                               for b in multi_indices(dim, [degree + 1])), 1e-4)

    def test_the_order_of_the_points_does_not_matter(self):
        for dim, side in (2, 10), (3, 5):
            x = cloud(side, dim)
            order = numpy.random.default_rng(2).permutation(len(x))
            for scheme, _ in SCHEMES.values():
                with self.subTest(dim=dim, **scheme):
                    D, shuffled = operators(x, **scheme), operators(x[order], **scheme)
                    for a in D:
                        assert_allclose(shuffled[a].toarray(), D[a][order][:, order].toarray(),
                                        rtol=1e-9, atol=1e-9 * abs(D[a]).max())

    def test_points_moved_together_have_the_same_operators_and_larger_ones_those_of_their_units(self):
        x = cloud(8, 2)
        D, moved, larger = operators(x), operators(x + [3, -5]), operators(1000 * x)
        for a in D:
            close = {"rtol": 1e-8, "atol": 1e-8 * abs(D[a]).max()}
            assert_allclose(moved[a].toarray(), D[a].toarray(), **close)
            assert_allclose(1000 ** sum(a) * larger[a].toarray(), D[a].toarray(), **close)

    def test_rows_sum_to_zero_up_to_round_off(self):
        for a, D in operators(cloud(12, 2)).items():
            with self.subTest(derivative=a):
                self.assertLessEqual(abs(D.sum(axis=1)).max(),
                                     4 * numpy.finfo(float).eps * abs(D).sum(axis=1).max())

    def test_lengths_of_ones_own_are_those_of_the_name(self):
        for dim, side in (2, 10), (3, 6):
            x = cloud(side, dim)
            distances = scipy.spatial.cKDTree(x).query(x, 10)[0]
            for name, neighbour in ("nearest", 1), ("local", 2 * dim), ("9-nearest", 9):
                with self.subTest(dim=dim, name=name):
                    asked = operators(x, smoothing=1.5, smoothing_from=name)
                    given = operators(x, smoothing=1.5, smoothing_from=distances[:, neighbour])
                    for a in asked:
                        assert_allclose(given[a].toarray(), asked[a].toarray(),
                                        rtol=1e-9, atol=1e-9 * abs(asked[a]).max())

    def test_without_keywords_the_scheme_is_fpm_and_the_spacing_local(self):
        x = cloud(8, 2)
        asked = operators(x, scheme="fpm", kernel=None, smoothing=1.2, smoothing_from="local")
        for a, D in operators(x).items():
            assert_array_equal(D.toarray(), asked[a].toarray())

    def test_ssph_has_degree_2_unless_another_is_asked_for(self):
        x = cloud(8, 2)
        two, three = operators(x, scheme="ssph", degree=2), operators(x, scheme="ssph", degree=3)
        for a, D in operators(x, scheme="ssph").items():
            assert_array_equal(D.toarray(), two[a].toarray())
            self.assertGreater(abs(D - three[a]).max(), 1e-3)

    def test_points_without_meaning_are_refused_with_the_particle(self):
        x = cloud(6, 2)
        for points, text in (
            (numpy.vstack([x, x[3]]), "particles 3 and 36 coincide at ({:.6g}, {:.6g})".format(*x[3])),
            (numpy.vstack([x, [numpy.nan, 0]]), "particle 36 is not at a finite position"),
            (numpy.vstack([x, [0, numpy.inf]]), "particle 36 is not at a finite position"),
            (numpy.empty((0, 2)), "a cloud needs at least 2 particles, got 0"),
            (x[:1], "a cloud needs at least 2 particles, got 1"),
        ):
            with self.subTest(text=text), self.refuses(text):
                operators(points)

    def test_keywords_without_meaning_are_refused(self):
        x = cloud(6, 2)
        for keywords, text in (
            ({"scheme": "rkpm"}, "there is no scheme 'rkpm'; choose one of fpm, second_order_fpm, ssph"),
            ({"degree": 2}, "degree belongs to the scheme ssph; fpm takes the monomials up to degree 3"),
            ({"scheme": "ssph", "degree": 4}, "degree must be 2 or 3, got 4"),
            ({"scheme": "ssph", "degree": 2.5}, "degree must be an integer, got 2.5"),
            ({"scheme": 2}, "scheme must be a text, got 2"),
            ({"kernel": 2}, "kernel must be a text, got 2"),
            ({"smoothing": "1.2"}, "smoothing must be a number, got '1.2'"),
            ({"smoothing": -1},
             "smoothing, the smoothing length over the spacing, must be positive and finite, got -1"),
            ({"smoothing_from": numpy.full(35, 0.2)}, "36 particles need as many spacings, or one, got 35"),
            ({"smoothing_from": "36-nearest"},
             "the 36 nearest of 36 particles are not determined; take a number from 1 to 35"),
        ):
            with self.subTest(**keywords), self.refuses(text):
                operators(x, **keywords)

    def test_keywords_of_a_line_do_not_belong_to_points(self):
        for keyword in "formulation", "volumes", "colour":
            with self.subTest(keyword=keyword), self.assertRaises(TypeError):
                operators(cloud(6, 2), **{keyword: "fpm"})

    def test_too_few_neighbours_are_a_failed_computation_with_a_remedy_that_works(self):
        grid = numpy.array([(x, y) for x in numpy.linspace(0, 1, 8) for y in numpy.linspace(0, 1, 8)])
        with self.assertRaises(RuntimeError) as failure:
            operators(grid, smoothing=0.4)
        found = numpy.array(str(failure.exception).split("; try smoothing=")[1], dtype=float)
        self.assertRegex(str(failure.exception), r"^fpm: particle 0 \(x = \(0, 0\)\) has \d+ neighbours within 3\.5h, needs 10; try smoothing=[0-9.]+$")
        self.assertEqual(len(operators(grid, smoothing=found)), 5)

    def test_points_on_a_line_do_not_determine_derivatives_in_the_plane(self):
        x = numpy.linspace(0, 1, 12)
        with self.assertRaisesRegex(RuntimeError, "the monomials of degree 1 to 3 are not independent on them"):
            operators(numpy.column_stack([x, x]))


class Matrices(TestCase):
    def test_they_are_scipys_with_sorted_columns_of_32_bits(self):
        for D in (*operators("second_order_fpm", line(30)), *operators(cloud(8, 2)).values()):
            self.assertIsInstance(D, scipy.sparse.csr_matrix)
            self.assertEqual((D.data.dtype, D.indices.dtype, D.indptr.dtype), ("float64", "int32", "int32"))
            self.assertEqual(len(D.data), D.indptr[-1])
            self.assertEqual(len(D.indptr), D.shape[0] + 1)
            for i in range(D.shape[0]):
                self.assertTrue((numpy.diff(D.indices[D.indptr[i]:D.indptr[i + 1]]) > 0).all())

    def test_they_are_square_with_a_row_for_each_particle(self):
        self.assertEqual([D.shape for D in operators("fpm", line(30))], [(30, 30)] * 2)
        self.assertEqual([D.shape for D in operators(cloud(5, 3)).values()], [(125, 125)] * 9)

    def test_far_particles_have_no_weight(self):
        D, D2 = operators("modified_fpm", line(200))
        self.assertLess(D.nnz, 200 * 15)
        self.assertLess(D2.nnz, 200 * 15)

    def test_scipy_solves_with_them(self):
        x = line(80)
        D, D2 = operators("second_order_fpm", x)
        A = D2.tolil()
        A[0], A[-1] = numpy.eye(1, 80, 0), D[-1]
        u = scipy.sparse.linalg.spsolve(A.tocsr(), numpy.r_[1, numpy.exp(x[1:-1]), numpy.e])
        assert_allclose(u, numpy.exp(x), atol=1e-3)


if __name__ == "__main__":
    unittest.main()
