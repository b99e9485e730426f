"""Who owns memory, and for how long: matrices outlive what they come from, and nothing leaks."""

import gc
import os
import subprocess
import sys
import unittest
import weakref

import numpy
from numpy.testing import assert_array_equal
from particle_methods import boundary, operators, solve, weights

from support import cloud, line, square


def arrays(D):
    return D.data, D.indices, D.indptr


class Lifetimes(unittest.TestCase):
    def test_a_matrix_outlives_its_line_its_sibling_and_the_collection_of_garbage(self):
        x = line(400)
        before = [array.copy() for array in arrays(operators("second_order_fpm", x)[1])]
        D, D2 = operators("second_order_fpm", x)
        del D, x
        gc.collect()
        others = [operators("fpm", line(400, seed)) for seed in range(5)]  # which would take its memory
        for now, then in zip(arrays(D2), before):
            assert_array_equal(now, then)
        self.assertEqual(len(others), 5)

    def test_an_array_outlives_its_matrix(self):
        D, _ = operators("second_order_fpm", line(400))
        kept = arrays(D)
        copies = [array.copy() for array in kept]
        del D
        gc.collect()
        others = [operators("fpm", line(400, seed)) for seed in range(5)]
        for now, then in zip(kept, copies):
            assert_array_equal(now, then)
        self.assertEqual(len(others), 5)

    def test_a_derivative_in_the_plane_outlives_the_dict_and_its_points(self):
        x = cloud(20, 2)
        before = operators(x)[1, 1].toarray()
        mixed = operators(x).pop((1, 1))
        del x
        gc.collect()
        others = [operators(cloud(20, 2, seed)) for seed in range(5)]
        assert_array_equal(mixed.toarray(), before)
        self.assertEqual(len(others), 5)

    def test_weights_outlive_their_object(self):
        row = weights(cloud(10, 2), 5)
        kept = row.weights[2, 0], row.offsets, row.particles
        copies = [array.copy() for array in kept]
        del row
        gc.collect()
        others = [weights(cloud(10, 2), k) for k in range(10)]
        for now, then in zip(kept, copies):
            assert_array_equal(now, then)
        self.assertEqual(len(others), 10)

    def test_nothing_holds_what_came_in(self):
        class Array(numpy.ndarray):
            pass

        points, cells = square(5)
        poisson = {"equation": "poisson", "value": {"boundary": 0}}
        for given, compute in (
            (line(20), lambda x: operators("fpm", x)),
            (cloud(6, 2), operators),
            (cloud(6, 2), lambda x: weights(x, 3)),
            (points, lambda x: boundary(x, cells)),
            (points, lambda x: solve(x, cells, **poisson)),
        ):
            given = given.view(Array)
            gone = weakref.ref(given)
            result = compute(given)
            del given
            gc.collect()
            self.assertIsNone(gone())
            del result

    def test_a_matrix_views_the_memory_that_was_assembled_and_can_be_written(self):
        for D in (*operators("fpm", line(30)), *operators(cloud(6, 2)).values()):
            for array in arrays(D):
                self.assertFalse(array.flags.owndata)
                self.assertIsNotNone(array.base)
                self.assertTrue(array.flags.writeable and array.flags.c_contiguous and array.flags.aligned)

    def test_matrices_share_no_memory(self):
        for matrices in operators("fpm", line(30)), list(operators(cloud(6, 2)).values()):
            all_arrays = [array for D in matrices for array in arrays(D)]
            for k, array in enumerate(all_arrays):
                self.assertFalse(any(numpy.shares_memory(array, other) for other in all_arrays[:k]))

    def test_writing_into_a_matrix_changes_it_alone(self):
        x = line(30)
        D, D2 = operators("second_order_fpm", x)
        first, second = D.toarray(), D2.toarray()
        D.data *= 2
        assert_array_equal(D.toarray(), 2 * first)
        assert_array_equal(D2.toarray(), second)
        assert_array_equal(operators("second_order_fpm", x)[0].toarray(), first)

    def test_a_matrix_can_be_changed_in_its_shape_and_zeros(self):
        D, _ = operators("second_order_fpm", line(30))
        plain = D.toarray()
        D.data[D.data < 0] = 0
        D.eliminate_zeros()
        assert_array_equal(D.toarray(), numpy.maximum(plain, 0))
        D.resize(20, 25)
        assert_array_equal(D.toarray(), numpy.maximum(plain, 0)[:20, :25])


class Leaks(unittest.TestCase):
    # One thread: waking others takes longer than the computation.
    SCRIPT = """
import sys
import numpy
from particle_methods import boundary, operators, solve, weights
from support import cloud, line, square

def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * {page}

def refused(compute):
    try:
        compute()
    except (ValueError, RuntimeError):
        return
    sys.exit("not refused")

x, points = line(12), cloud(5, 2)
corners, cells = square(4)
poisson = dict(equation="poisson", value=dict(boundary=0), source=1)
refusals = [
    lambda: operators("fpm", x[::-1]),
    lambda: operators("fpm", x, smoothing=0.01),
    lambda: operators(corners, smoothing=0.2),
    lambda: boundary(corners, x),
    lambda: solve(corners, cells, fix="nobody", young=1, poisson=0),
]
compute = lambda: {compute}
for _ in range({calls} // 10):
    compute()
before = resident()
for _ in range({calls}):
    compute()
print(resident() - before)
"""

    def check(self, compute, calls):
        script = self.SCRIPT.format(compute=compute, calls=calls, page=os.sysconf("SC_PAGE_SIZE"))
        path = os.pathsep.join([os.path.dirname(__file__), os.environ.get("PYTHONPATH", "")])
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True,
                              env={**os.environ, "OMP_NUM_THREADS": "1", "PYTHONPATH": path})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        # 200 bytes for each of 10 000 calls, where a matrix of twelve particles has 1400. Measured: 0.1 MB.
        self.assertLess(int(done.stdout), 2e6)

    def test_operators_leak_nothing_in_ten_thousand_calls(self):
        self.check("operators('second_order_fpm', x)", 10_000)

    def test_operators_in_the_plane_leak_nothing_in_a_thousand_calls(self):
        self.check("operators(points)", 1000)

    def test_weights_leak_nothing_in_ten_thousand_calls(self):
        self.check("(weights('second_order_fpm', x, 3), weights(points, 3))", 10_000)

    def test_solutions_leak_nothing_in_a_thousand_calls(self):
        self.check("(boundary(corners, cells), solve(corners, cells, **poisson))", 1000)

    def test_refusals_leak_nothing_in_ten_thousand_calls(self):
        self.check("[refused(refusal) for refusal in refusals]", 2000)


if __name__ == "__main__":
    unittest.main()
