# Figure 16 of Batra and Zhang (2008): displacement u2 along the x2-axis of the quarter plate, 188 particles.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_16.csv"
set title "Displacement along the x₂-axis, 188 particles around the hole"
set xlabel "x₂ in m"
set ylabel "u₂ in mm"
set xrange [0.3:3]
eval(one_row)
plot table using (method("weak1") * column("x2")):(1000 * column("u2_exact")) with lines linestyle 34 title "exact", \
     for [name in methods] table using (method(name) * column("x2")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10 title name
