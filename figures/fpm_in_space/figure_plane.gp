# Errors of the derivatives in the plane, by place: medians of 25 draws on the right. SSPH of third degree has the same second
# derivatives, and better first ones.
if (!exists("table")) { ours = 1; table = "data/fpm_in_space/plane.csv" }
load "figures/fpm_in_space/errors.gp"
