"""Threads: those of Python run while C++ computes, and any number of them gives the same bytes."""

import hashlib
import os
import select
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy
from particle_methods import operators, solve, weights

from support import cloud, line, square


class OfPython(unittest.TestCase):
    def ticks_during(self, compute):
        """How often another thread runs meanwhile, where the interpreter takes its lock from no one."""
        ticks, done = 0, False

        def tick():
            nonlocal ticks
            while not done:
                ticks += 1
                time.sleep(1e-4)  # which hands the lock back

        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000)
        other = threading.Thread(target=tick)
        try:
            other.start()
            time.sleep(1e-3)
            before = ticks
            compute()
            return ticks - before
        finally:
            done = True
            sys.setswitchinterval(interval)
            other.join()

    def test_a_computation_that_keeps_the_lock_stops_them(self):
        self.assertEqual(self.ticks_during(lambda: sum(range(3_000_000))), 0)

    def test_they_run_while_operators_are_computed(self):
        x, points = numpy.linspace(0, 1, 200_000), cloud(60, 2)
        self.assertGreater(self.ticks_during(lambda: operators("second_order_fpm", x)), 0)
        self.assertGreater(self.ticks_during(lambda: operators(points)), 0)

    def test_they_run_while_a_body_is_solved(self):
        body = square(25)
        self.assertGreater(self.ticks_during(
            lambda: solve(*body, equation="poisson", value={"boundary": 0}, source=1)), 0)

    def test_they_get_the_bytes_of_one_call_after_the_other(self):
        points, cells = square(6)
        calls = [lambda: operators("second_order_fpm", line(3000))[1].data,
                 lambda: operators("fpm", line(3000, seed=2))[0].data,
                 lambda: operators(cloud(30, 2))[1, 1].data,
                 lambda: weights(cloud(20, 2), 17).weights[2, 0],
                 lambda: solve(points, cells, equation="poisson", value={"boundary": 0}, source=1)[0]]
        alone = [call().tobytes() for call in calls]
        found, together = {}, threading.Barrier(2 * len(calls))

        def run(k):
            together.wait()
            found[k] = calls[k % len(calls)]().tobytes()

        threads = [threading.Thread(target=run, args=[k]) for k in range(2 * len(calls))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([found.get(k) for k in range(2 * len(calls))], 2 * alone)

    def test_a_refusal_in_one_does_not_disturb_another(self):
        x = line(2000)
        alone, refusals = operators("fpm", x)[0].data.tobytes(), []

        def refused():
            for _ in range(50):
                try:
                    operators("fpm", x, smoothing=1e-3)
                except RuntimeError as error:
                    refusals.append(str(error))

        other = threading.Thread(target=refused)
        other.start()
        while other.is_alive():
            self.assertEqual(operators("fpm", x)[0].data.tobytes(), alone)
        other.join()
        self.assertEqual((len(refusals), len(set(refusals))), (50, 1))


class OfOpenMp(unittest.TestCase):
    SCRIPT = """
import hashlib
from particle_methods import operators, solve, weights
from support import cloud, line, square
points, cells = square(8)
problem = dict(equation="poisson", value=dict(boundary="x^2*y"), source="-2*y")
sums = [hashlib.sha256(bytes) for bytes in (
    *(D.data.tobytes() + D.indices.tobytes() for D in operators("second_order_fpm", line(3000))),
    *(D.data.tobytes() + D.indices.tobytes() for D in operators(cloud(30, 2)).values()),
    *(D.data.tobytes() for D in operators(cloud(8, 3), scheme="ssph").values()),
    solve(points, cells, **problem)[0].tobytes(),
    solve(points, cells, method="weak1", **problem)[0].tobytes(),
    solve(points, cells, method="fpm", **problem)[0].tobytes())]
print(*(each.hexdigest() for each in sums))
"""

    def run_on(self, threads):
        path = os.pathsep.join([os.path.dirname(__file__), os.environ.get("PYTHONPATH", "")])
        return subprocess.run([sys.executable, "-c", self.SCRIPT], capture_output=True, text=True,
                              env={**os.environ, "OMP_NUM_THREADS": threads, "PYTHONPATH": path})

    def test_one_and_two_give_the_same_bytes(self):
        alone = self.run_on("1")
        self.assertEqual((alone.returncode, alone.stderr, len(alone.stdout.split())), (0, "", 19))
        self.assertEqual(self.run_on("2").stdout, alone.stdout)

    def test_a_forked_process_computes_as_its_parent(self):
        x = line(2000)
        parent = hashlib.sha256(operators("fpm", x)[0].data).digest()
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            os.write(write, hashlib.sha256(operators("fpm", x)[0].data).digest())
            os._exit(0)
        ready, _, _ = select.select([read], [], [], 10)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        self.assertTrue(ready)
        self.assertEqual(os.read(read, 100), parent)
        os.close(read)
        os.close(write)


if __name__ == "__main__":
    unittest.main()
