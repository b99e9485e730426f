# %% [markdown]
# # Heat in a star, on points of your own
#
#     u_t = u_xx + u_yy + f,    u given on the left half of the rim, its flux ∂u/∂n on the right half,
#
# marched with the second-order FPM in the plane: its operators stand for the derivatives, and Crank and
# Nicolson's rule takes steps of the points' distance d. Source, values and flux are those of
# u = e^-t sin(2x) cos(2y), with which the result is compared at t = 1.
#
#     make setup python
#     PYTHONPATH=$PWD/build/python /usr/bin/python3 examples/heat_in_the_plane.py [PICTURE]
#
# Without an argument the picture is heat_in_the_plane.png in the current folder.
# The exit code is 0 if no mode grows and the error falls with the second power of d.

# %%
import sys

import matplotlib.pyplot as plt
import matplotlib.tri
import numpy as np
import scipy.sparse
import scipy.spatial
from particle_methods import operators
from scipy.sparse.linalg import LinearOperator, eigs, splu

# %% [markdown]
# ## Points
# On the rim, at equal distances; inside, those of a grid, each moved by up to d/4, and none nearer to a point
# of the rim than 0.6 d. The method is not stable on all points: an eigenvalue can have a positive real part,
# and its mode grows without bound. `growth` below shows it. A larger smoothing length helps. On a disc and on
# the star with d = 0.06, 0.05 and 0.04, six draws each, a mode grew with the default, `smoothing=1.2`, on one
# draw of the disc, by a third in a step, and on one of the star, elevenfold; with 1.5 on none. Errors are
# then 1.5 times as large. The distance must be small against the shape, too: with d = 0.08 and 1.5 a mode grew
# on one of six draws of the star, and on four with arms of 0.4 instead of 0.2. With d = 0.04 none did.


# %%
def radius(angle):
    return 1 + 0.2 * np.cos(5 * angle)


def rim(angle):
    return np.stack([radius(angle) * np.cos(angle), radius(angle) * np.sin(angle)], axis=-1)


def star(d):
    """The points, those of the rim first, and the rim's outer normals."""
    angle = np.linspace(0, 2 * np.pi, 20001)
    length = np.append(0, np.cumsum(np.linalg.norm(np.diff(rim(angle), axis=0), axis=1)))
    n = round(length[-1] / d)
    angle = np.interp(np.arange(n) * length[-1] / n, length, angle)
    tangent = (rim(angle + 1e-6) - rim(angle - 1e-6)) / 2e-6
    normal = np.stack([tangent[:, 1], -tangent[:, 0]], axis=-1) / np.linalg.norm(tangent, axis=1)[:, None]

    axis = np.arange(-1.3, 1.3, d)
    inside = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2)
    inside += np.random.default_rng(1).uniform(-d / 4, d / 4, inside.shape)
    distance, _ = scipy.spatial.cKDTree(rim(angle)).query(inside)
    return np.concatenate([rim(angle), inside[within(inside) & (distance > 0.6 * d)]]), normal


def within(points):
    return np.linalg.norm(points, axis=1) < radius(np.arctan2(points[:, 1], points[:, 0]))


# %% [markdown]
# ## The exact solution


# %%
def temperature(points, t):
    x, y = points.T
    return np.exp(-t) * np.sin(2 * x) * np.cos(2 * y)


def source(points, t):
    """u_t - u_xx - u_yy = -u + 4u + 4u."""
    return 7 * temperature(points, t)


def flux(points, normal, t):
    (x, y), (nx, ny) = points.T, normal.T
    return 2 * np.exp(-t) * (nx * np.cos(2 * x) * np.cos(2 * y) - ny * np.sin(2 * x) * np.sin(2 * y))


# %% [markdown]
# ## Operators and steps
# Each point has one equation: the heat equation inside, its value or its flux on the rim. One smoothing
# length for all points, `smoothing_from="mean"`, makes errors of neighbours alike. With lengths of their own,
# the default, orders are as good with values on all of the rim, but scatter with fluxes. `scheme="ssph"` is
# not for this script: its Laplacian is of first order on these points, and on the star modes grow.


# %%
def rows(chosen, A):
    """The rows of A at the chosen points, the others zero."""
    return scipy.sparse.diags(chosen.astype(float)) @ A


def march(d):
    """Points, temperatures at t = 1, and the largest factor by which a step multiplies a mode."""
    points, normal = star(d)
    N, on_rim = len(points), len(normal)
    inside = np.arange(N) >= on_rim
    given = ~inside & (points[:, 0] < 0)
    flowing = ~inside & ~given

    D = operators(points, smoothing=1.5, smoothing_from="mean")
    laplacian = D[2, 0] + D[0, 2]
    nx, ny = np.pad(normal, [(0, N - on_rim), (0, 0)]).T
    across = scipy.sparse.diags(nx) @ D[1, 0] + scipy.sparse.diags(ny) @ D[0, 1]

    steps = round(1 / d)
    dt = 1 / steps
    I = scipy.sparse.identity(N)
    before = rows(inside, I + dt / 2 * laplacian)
    after = splu((rows(inside, I - dt / 2 * laplacian) + rows(given, I) + rows(flowing, across)).tocsc())
    u = temperature(points, 0)
    for step in range(steps):
        t = step * dt
        b = before @ u + dt * inside * source(points, t + dt / 2)
        b[given] = temperature(points[given], t + dt)
        b[flowing] = flux(points[flowing], normal[flowing[:on_rim]], t + dt)
        u = after.solve(b)
    # The largest eigenvalues of a step, by Arnoldi iteration from noise, which has a share of every mode.
    one_step = LinearOperator((N, N), matvec=lambda u: after.solve(before @ u))
    noise = np.random.default_rng(1).random(N)
    growth = abs(eigs(one_step, k=4, v0=noise, tol=0.01, return_eigenvectors=False)).max()
    return points, u, growth


# %% [markdown]
# ## Errors, orders and a picture
# As d² goes with 1/N, the order in d is twice that in 1/N.

# %%
print("    N      error  order  growth in a step")
coarser = order = None
for d in (0.06, 0.04, 0.02):
    points, u, growth = march(d)
    N, error = len(points), abs(u - temperature(points, 1)).max()
    if coarser:
        order = 2 * np.log(coarser[1] / error) / np.log(N / coarser[0])
    coarser = N, error
    print(f"{N:5d}  {error:9.3e}  {f'{order:.2f}' if order else '':5}  {growth:.4f}")
    if growth >= 1:
        break

# %% [markdown]
# The picture comes before the checks, so that it shows the points where a mode grows. Its levels avoid 0: u
# vanishes on lines that cross, and a level there would draw their noise.

# %%
triangles = matplotlib.tri.Triangulation(*points.T)
triangles.set_mask(~within(points[triangles.triangles].mean(axis=1)))  # those between the star's arms
largest = abs(u).max()
figure, axes = plt.subplots(figsize=(6.4, 5.2), layout="constrained")
contours = axes.tricontourf(triangles, u, levels=np.linspace(-largest, largest, 18))
figure.colorbar(contours, label="u", ticks=plt.MaxNLocator(9))
axes.set(aspect="equal", xlabel="x", ylabel="y", title=f"temperature at t = 1, {N} points")
# A notebook has arguments of its own.
plt.savefig(sys.argv[1] if sys.argv[1:] and "ipykernel" not in sys.modules else "heat_in_the_plane.png")
assert growth < 1, f"a mode grows with d = {d}: take a larger smoothing, a smaller d, or other points"
assert order > 1.7, f"the order should be 2, but is {order:.2f}"
