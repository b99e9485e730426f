"""The same calculations in plain NumPy and SciPy: what a reader would write in an afternoon, and so what speed is measured by.

Prints rows of the benchmarks' tables. Usage: arrays.py asprone2010|batra2008 MOST_PARTICLES
"""

import sys
import time

try:
    import numpy as np
    import scipy.linalg
    import scipy.sparse
    import scipy.sparse.linalg
    import scipy.spatial
except ImportError as missing:
    print(f"arrays.py: {missing.name} is not installed (python3-numpy, python3-scipy); these rows are left out", file=sys.stderr)
    sys.exit(0)


def report(task, method, particles, work):
    """Prints a row: the least time of three, or of one where that is long."""
    seconds = []
    while len(seconds) < 3 and sum(seconds) < 20:
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    print(f"{task},{method},{particles},1,{min(seconds) / particles * 1e9:.4g},,,", flush=True)
    print(f"{task + '/' + method + '/' + str(particles):50s} {min(seconds) / particles * 1e9:12.2f} ns per particle",
          file=sys.stderr)


def line(N, half=6):
    """Perturbed particles, and a window of neighbours for each; where it leaves the line, volumes are zero."""
    random = np.random.default_rng(1)
    x = np.linspace(0, 1, N)
    x[1:-1] += random.uniform(-0.25, 0.25, N - 2) / (N - 1)
    near = np.arange(N)[:, None] + np.arange(-half, half + 1)
    V = np.where((near >= 0) & (near < N), 1 / (N - 1), 0)
    return x, np.clip(near, 0, N - 1), V


def modified_fpm(x, near, V):
    """Weights of D and D2 on differences, equation (36)."""
    h = 1 / (len(x) - 1)
    r = (x[near] - x[:, None]) / h
    W = np.exp(-r * r) / np.sqrt(np.pi) * (V / h)
    DW = -2 * r * W
    A11, A12 = (r * W).sum(1), (r * r * W).sum(1) / 2
    A21, A22 = (r * DW).sum(1), (r * r * DW).sum(1) / 2
    determinant = A11 * A22 - A12 * A21
    D = (A22 / determinant)[:, None] * W - (A12 / determinant)[:, None] * DW
    D2 = (A11 / determinant)[:, None] * DW - (A21 / determinant)[:, None] * W
    return D / h, D2 / h**2


def matrix(weights, near, V):
    """A sparse operator whose rows sum to zero."""
    N, size = weights.shape
    weights = np.where(V > 0, weights, 0)
    weights[:, size // 2] = 0
    weights[:, size // 2] = -weights.sum(1)
    operator = scipy.sparse.csr_matrix((weights.ravel(), near.ravel(), np.arange(0, N * size + 1, size)), (N, N))
    operator.sum_duplicates()
    return operator


def static_test(N):
    x, near, V = line(N)
    D, D2 = (matrix(weights, near, V) for weights in modified_fpm(x, near, V))
    A = scipy.sparse.vstack([scipy.sparse.eye(1, N), -D2[1:-1], D[-1]]).todia()
    half = 12
    bands = np.zeros((2 * half + 1, N))
    for offset, diagonal in zip(A.offsets, A.data):
        bands[half - offset] = diagonal
    f = np.exp(x)
    f[0] = f[-1] = 0
    return scipy.linalg.solve_banded((half, half), bands, f)


def lowest_ten(N):
    x, near, V = line(N)
    K = matrix(modified_fpm(x, near, V)[1], near, V)[1:-1, 1:-1].tocsc()
    return scipy.sparse.linalg.eigs(K, 10, sigma=0, return_eigenvectors=False)


def cloud(N):
    ny = round((N / 5) ** 0.5)
    grid = np.meshgrid(np.linspace(0, 1, 5 * ny - 4), np.linspace(0, 0.2, ny), indexing="ij")
    return np.stack(grid, -1).reshape(-1, 2), 0.2 / (ny - 1)


def basis(x, near, h, degree=2):
    """The SSPH basis (2.11) for all particles, each with as many nearest neighbours."""
    s = (x[near] - x[:, None]) / h
    powers = [(0, 0), (1, 0), (0, 1), (2, 0), (0, 2), (1, 1)]
    H = np.stack([s[..., 0] ** a * s[..., 1] ** b for a, b in powers], -1)
    W = np.exp(-(s * s).sum(-1))
    D = H * W[..., None]
    return np.linalg.solve(np.einsum("jka,jkb->jab", D, H), D.transpose(0, 2, 1))


def asprone2010(most):
    N = 1000
    while N <= most:
        x, near, V = line(N)
        report("assembly", "NumPy modified_fpm", N, lambda: modified_fpm(x, near, V))
        D2 = matrix(modified_fpm(x, near, V)[1], near, V)
        report("application", "SciPy modified_fpm", N, lambda: D2 @ x)
        report("static", "SciPy modified_fpm", N, lambda: static_test(N))
        if N <= 100000:
            report("modes", "SciPy lowest ten", N, lambda: lowest_ten(N))
        N *= 10


def batra2008(most):
    N = 1000
    while N <= most:
        x, spacing = cloud(N)
        tree = scipy.spatial.cKDTree(x)
        report("search", "SciPy cKDTree", len(x), lambda: scipy.spatial.cKDTree(x).query_ball_point(x, 3 * spacing * 0.999))
        _, near = tree.query(x, 28)
        report("basis", "NumPy m = 2", len(x), lambda: basis(x, near, spacing))
        N *= 10


if __name__ == "__main__":
    {"asprone2010": asprone2010, "batra2008": batra2008}[sys.argv[1]](int(sys.argv[2]))
