# Figure 10 of Batra and Zhang (2008): displacement u2 of the bottom edge with monomials of degree 1 and 2, ρ = 4.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_10.csv"
if (!exists("strong")) strong = "data/batra2008/figure_11.csv"
set title "Displacement of the bottom edge, monomials of degree m, 16 × 4 particles"
set xlabel "x_1 in m"
set ylabel "u_2 in mm"
degree(m) = column("degree") == m ? 1 : NaN
plot strong using (method("strong") * (column("nx") == 16 ? 1 : NaN) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle 11 pointinterval 10 title "strong, m = 2", \
     for [name in "weak1 weak2"] table using (method(name) * degree(2) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10 title name . ", m = 2", \
     for [name in "weak1 weak2"] table using (method(name) * degree(1) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) linewidth 1 pointinterval 14 pointsize 1.3 title name . ", m = 1", \
     table using (method("weak1") * degree(2) * column("x1")):(1000 * column("u2_exact")) with lines linestyle 14 title "exact"
