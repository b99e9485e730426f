# Figure 20 of Batra and Zhang (2008): stress along the x2-axis of the quarter plate, 686 particles. The right panel shows the part next
# to the hole, where the exact concentration is 3.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_20.csv"
eval(picture(720, 460))
set xlabel "x₂ in m"
set multiplot title "Stress along the x₂-axis, 686 particles around the hole"
set bmargin at screen 0.27; set tmargin at screen 0.90
set lmargin at screen 0.11; set rmargin at screen 0.52
set xrange [0.3:3]
set yrange [0:3.5]
set ylabel "σ₁₁ / σ₀"
set key at screen 0.5,0.07 center center maxrows 1 width -1
plot table using (method("weak1") * column("x2")):(column("s11_exact") / 1e9) with lines linestyle 34 title "exact", \
     for [name in methods] table using (method(name) * column("x2")):(column("s11") / 1e9) \
         with linespoints linestyle method_style(name) pointinterval 10 title name
set lmargin at screen 0.57; set rmargin at screen 0.97
set xrange [0.3:0.6]
unset ylabel; unset key; set format y ""
plot table using (method("weak1") * column("x2")):(column("s11_exact") / 1e9) with lines linestyle 34, \
     for [name in methods] table using (method(name) * column("x2")):(column("s11") / 1e9) \
         with linespoints linestyle method_style(name) pointinterval 2
unset multiplot
