# Figure 8 of Batra and Zhang (2008): error norm (4.4) against the number of Gauss points along a radius, weak forms. The norm of the
# difference would coincide with these curves. With 3 points weak1 lies low by accident.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_8.csv"
set title "Error against the number of Gauss points, 16 × 4 particles"
set xlabel "Gauss points along a radius, n_G"
set ylabel "log₁₀ of the error norm E, (4.4)"
set yrange [-2.8:-1.4]
eval(one_row)
plot for [name in "weak1 weak2"] table using (method(name) * column("gauss")):"log_error_dn" \
         with linespoints linestyle method_style(name) title name
