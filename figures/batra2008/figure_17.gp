# Figure 17 of Batra and Zhang (2008): stress along the x2-axis of the quarter plate, 188 particles. The right panel shows the part next
# to the hole, where the exact concentration is 3.
curve_column = "method"; x_column = "x2"; y_column = "s11"; signed = 1
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_17.csv"
eval(picture(720, 460))
set xlabel "x₂ in m"
if (!user) { curves = methods; x_least = 0.3; x_most = 3; y_least = 0; y_most = 0 }
set multiplot title (user ? "Stress along the x₂-axis" : "Stress along the x₂-axis, 188 particles around the hole")
set bmargin at screen 0.27; set tmargin at screen 0.90
set lmargin at screen 0.11; set rmargin at screen 0.52
set xrange [x_least:x_most]
set yrange [(y_least < 0 ? 1.05e-9 * y_least : 0):(y_most > 3.5e9 ? 1.05e-9 * y_most : 3.5)]
set ylabel "σ₁₁ / σ₀"
set key at screen 0.5,0.07 center center maxrows (user ? 2 : 1) width -1
plot table using (method(word(curves, words(curves) > 1 ? 2 : 1)) * column("x2")):(column("s11_exact") / 1e9) with lines linestyle 34 title "exact", \
     for [name in curves] table using (method(name) * column("x2")):(column("s11") / 1e9) \
         with linespoints linestyle method_style(name) pointinterval 10 title method_title(name)
set lmargin at screen 0.57; set rmargin at screen 0.97
set xrange [x_least:2 * x_least]
unset ylabel; unset key; set format y ""
plot table using (method(word(curves, words(curves) > 1 ? 2 : 1)) * column("x2")):(column("s11_exact") / 1e9) with lines linestyle 34, \
     for [name in curves] table using (method(name) * column("x2")):(column("s11") / 1e9) \
         with linespoints linestyle method_style(name) pointinterval 2
unset multiplot
