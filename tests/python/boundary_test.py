"""boundary, and the sides of a body by their names."""

import unittest

import numpy
import scipy.spatial
from numpy.testing import assert_allclose, assert_array_equal
from particle_methods import boundary, solve

from support import ELASTIC, TestCase, clamped, cube, square


class Boundary(TestCase):
    def test_it_has_the_sides_of_a_square_with_the_body_to_the_left(self):
        points, cells = square(4)
        facets = boundary(points, cells)
        self.assertEqual((facets.shape, facets.dtype), ((12, 2), numpy.int32))
        a, b = points[facets[:, 0]], points[facets[:, 1]]
        area = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2
        self.assertAlmostEqual(area, 1)

    def test_it_has_the_faces_of_a_cube_counter_clockwise_from_outside(self):
        points, cells = cube(3)
        facets = boundary(points, cells)
        self.assertEqual((facets.shape, facets.dtype), ((6 * 8, 3), numpy.int32))
        self.assertAlmostEqual(numpy.linalg.det(points[facets] + 1e-30).sum() / 6, 1)

    def test_the_corners_of_a_cell_come_in_any_order(self):
        for points, cells in square(4), cube(3):
            for turned in cells[:, ::-1], numpy.roll(cells, 1, axis=1):
                found, again = (numpy.unique(boundary(points, those), axis=0) for those in (cells, turned))
                assert_array_equal(numpy.sort(found, axis=1), numpy.sort(again, axis=1))
                signed = points[boundary(points, turned)]
                self.assertGreater(numpy.linalg.det(signed[:, :, :]).sum() if points.shape[1] == 3 else
                                   numpy.linalg.det(signed).sum(), 0)

    def test_a_hole_has_its_boundary_too(self):
        points, cells = square(4)
        holed = cells[abs(points[cells].mean(axis=1) - 0.5).max(axis=1) > 1 / 6]
        self.assertEqual(len(boundary(points, holed)), 12 + 4)

    def test_a_point_in_no_cell_is_refused_with_a_remedy_that_works(self):
        points, cells = square(4)
        some = cells[:4]
        with self.refuses("point 8 is in no cell; keep those that are: used = numpy.unique(cells); points = points[used]; cells = numpy.searchsorted(used, cells), and sides alike"):
            boundary(points, some)
        used = numpy.unique(some)
        self.assertEqual(len(boundary(points[used], numpy.searchsorted(used, some))), 12)

    def test_cells_that_are_there_twice_are_refused_with_the_place(self):
        points, cells = square(4)
        with self.assertRaisesRegex(ValueError, r"^cells overlap beside the facet at \(.*\); remove duplicate cells, or draw the union of the parts$"):
            boundary(points, numpy.concatenate([cells, cells[:1]]))

    def test_tetrahedra_that_do_not_fit_together_are_refused(self):
        points, _ = cube(4)
        cells = scipy.spatial.Delaunay(points).simplices
        volumes = abs(numpy.linalg.det(points[cells[:, 1:]] - points[cells[:, :1]]))
        with self.assertRaisesRegex(
            ValueError, r"^behind the facet at \(.*\) lies a cell that does not share it: cells must fit together; remesh the body$"
        ):
            boundary(points, cells[volumes > 1e-9])

    def test_cells_of_another_dimension_are_refused(self):
        with self.refuses("cells are triangles, and points are in space; for a body in the plane take points[:, :2]"):
            boundary(cube(3)[0], square(4)[1])


class Sides(TestCase):
    def test_without_sides_all_of_the_boundary_is_one(self):
        points, cells = square(5)
        _, numbers = solve(points, cells, equation="poisson", value={"boundary": 1}, source=1)
        self.assertIn("reaction1:boundary", numbers)

    def test_facets_in_no_side_are_the_side_rest(self):
        points, cells, sides = clamped()
        _, numbers = solve(points, cells, sides, equation="poisson", value={"wall": "y^2"}, source=-2,
                           flux={"rest": "2*y"})
        assert_allclose([numbers["load1:rest"], numbers["reaction1:wall"]], [2, 0], atol=1e-9)

    def test_a_side_of_ones_own_that_is_named_rest_is_refused_where_other_facets_have_no_name(self):
        points, cells, sides = clamped()
        with self.refuses("the side 'rest' has the facets that are in no other, and 16 are; take another name than 'rest'"):
            solve(points, cells, {"rest": sides["wall"], "tip": sides["tip"]}, fix="tip", **ELASTIC)
        every = {"rest": boundary(points, cells)}
        _, numbers = solve(points, cells, every, equation="poisson", value={"rest": 0}, source=1)
        assert_allclose(numbers["reaction1:rest"], -1, rtol=1e-9)

    def test_facets_with_two_names_or_inside_are_refused_with_their_points(self):
        points, cells, sides = clamped(4)
        wall = sides["wall"][0]
        which = f"the facet of the points {wall[0]} and {wall[1]}"
        with self.refuses(f"sides['tip'][0], {which}, is in the side 'wall', too"):
            solve(points, cells, {"wall": sides["wall"], "tip": [wall]}, fix="wall", **ELASTIC)
        with self.refuses("sides['inside'][0], the facet of the points 0 and 5, is not on the boundary; boundary(points, cells) has those that are"):
            solve(points, cells, {"inside": [[0, 5]]}, fix="inside", **ELASTIC)
        with self.refuses("a side needs a name"):
            solve(points, cells, {"": sides["wall"]}, fix="wall", **ELASTIC)
        with self.refuses("sides must be a dict from names to facets, such as boundary() gives"):
            solve(points, cells, [sides["wall"]], fix="wall", **ELASTIC)

    def test_a_facet_named_twice_alike_counts_once(self):
        points, cells, sides = clamped()
        doubled = {name: numpy.concatenate([side, side[:, ::-1]]) for name, side in sides.items()}
        problem = {"equation": "poisson", "value": {"wall": 0}, "flux": {"tip": 1}}
        _, twice = solve(points, cells, doubled, **problem)
        self.assertEqual(twice, solve(points, cells, sides, **problem)[1])

    def test_a_side_that_the_body_has_not_is_refused_with_those_it_has(self):
        points, cells, sides = clamped()
        for option, value in ("fix", "foot"), ("traction", {"foot": (0, 1)}), ("pressure", {"foot": 1}):
            with self.subTest(option=option), self.refuses(
                    f"{option}: the body has no side 'foot'; its sides are rest, tip, wall"):
                solve(points, cells, sides, symmetry="wall", **{option: value}, **ELASTIC)


if __name__ == "__main__":
    unittest.main()
