# Beyond Figure 7 of Batra and Zhang (2008): largest error of u2 at the bottom edge as ν approaches 1/2 in plane strain.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/locking.csv"
set title "Volumetric locking: the plate in plane strain, 16 × 4 particles" . beyond("the whole figure")
set logscale xy
set xrange [0.3:5e-7]
set format x "10^{%T}"
set xlabel "1/2 − ν"
eval(one_row)
set ylabel "largest error of u₂ in percent"
plot for [name in methods] table using (method(name) * (0.5 - column("poisson"))):"max_error_u2_percent" \
         with linespoints linestyle method_style(name) title name
