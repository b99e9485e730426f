# Figure 10 of Batra and Zhang (2008): displacement u2 of the bottom edge with monomials of degree 1 and 2, ρ = 4.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_10.csv"
if (!exists("strong")) strong = "data/batra2008/figure_11.csv"
set title "Displacement of the bottom edge, monomials of degree m, 16 × 4 particles"
set xlabel "x₁ in m"
set ylabel "u₂ in mm"
degree(m) = column("degree") == m ? 1 : NaN
set key maxrows 2 width -1
plot table using (method("weak1") * degree(2) * column("x1")):(1000 * column("u2_exact")) with lines linestyle 34 title "exact", \
     strong using (method("strong") * (column("nx") == 16 ? 1 : NaN) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle 31 pointinterval 10 title "strong, m = 2", \
     for [m = 2:1:-1] for [name in "weak1 weak2"] table using (method(name) * degree(m) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) dashtype 3 - m pointtype ((m == 2 ? 7 : 6) + (name eq "weak2" ? 2 : 0)) \
         pointinterval (m == 2 ? 10 : 14) pointsize (m == 2 ? 0.8 : 1.4) title sprintf("%s, m = %d", name, m)
