# %% [markdown]
# # Figure 1 of Asprone et al. (2010), in fifteen lines
#
# The largest error of the second derivative of B = exp on [0, 1] against the number of particles N, by the
# formulations of the paper's figure. Particles are uniform, both ends carry one, and h = δ, their spacing.
#
#     make setup python
#     PYTHONPATH=$PWD/build/python /usr/bin/python3 examples/figure_1.py [PICTURE]
#
# Without an argument the picture is figure_1.png in the current folder.

# %%
from sys import argv, modules

import matplotlib.pyplot as plt
import numpy as np
from particle_methods import operators

# %% [markdown]
# `operators` returns two sparse matrices: `D @ B` is the first derivative at all particles, `D2 @ B` the
# second. B = exp is its own second derivative: for another B, write that after the minus. The legend has the
# order of the last doubling of N. Four of the six errors do not fall: they are largest at the boundary, as
# Section 5.1 of the paper says, and doc/exercises.md begins with one of them. With more than 5000 particles
# the error of the second-order FPM rises again, by round-off.

# %%
N = 10 * 2 ** np.arange(9)
names = "original rkpm_first_order rkpm_second_order chen_beraun modified_fpm second_order_fpm".split()
for name, style in zip(names, ["s-", "o:", "v-.", "^--", "d--", "ko-"]):
    errors = []
    for x in (np.linspace(0, 1, n) for n in N):
        D, D2 = operators(name, x)
        errors.append(abs(D2 @ np.exp(x) - np.exp(x)).max())
    plt.loglog(N, errors, style, label=f"{name}: order ${round(np.log2(errors[-2] / errors[-1]), 1) + 0}$")
plt.gca().set(xlabel="number of particles N", ylabel="max |D²B − eˣ|")
plt.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)
# A notebook has arguments of its own.
plt.savefig(argv[1] if argv[1:] and "ipykernel" not in modules else "figure_1.png", bbox_inches="tight")
