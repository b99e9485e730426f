# Figure 5 of Batra and Zhang (2008): displacement u2 of the bottom edge, 16 × 4 particles, ρ = 3.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_5.csv"
set title "Displacement of the bottom edge, 16 × 4 particles"
set xlabel "x₁ in m"
set ylabel "u₂ in mm"
eval(one_row)
plot table using (method("weak1") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 34 title "exact", \
     for [name in methods] table using (method(name) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10 title name
