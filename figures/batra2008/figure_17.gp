# Figure 17 of Batra and Zhang (2008): stress along the x2-axis of the quarter plate, 188 particles. The right panel shows the part next
# to the hole, where the exact concentration is 3.
curve_column = "method"; x_column = "x2"; y_column = "s11"; signed = 1
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_17.csv"
set terminal svg size 1120,480 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
set xlabel "x_2 in m"
if (!user) { curves = methods; x_least = 0.3; x_most = 3; y_most = 0 }
set multiplot title (user ? "Stress along the x_2-axis" : "Stress along the x_2-axis, 188 particles around the hole")
set bmargin at screen 0.14; set tmargin at screen 0.88
set lmargin at screen 0.07; set rmargin at screen 0.41
set xrange [x_least:x_most]
set yrange [0.8:(y_most > 3.5e9 ? 1.05e-9 * y_most : 3.5)]
set ylabel "σ_{11} / σ_0"
set key off
plot for [name in curves] table using (method(name) * column("x2")):(column("s11") / 1e9) \
         with linespoints linestyle method_style(name) pointinterval 10 title name, \
     table using (method(word(curves, words(curves) > 1 ? 2 : 1)) * column("x2")):(column("s11_exact") / 1e9) with lines linestyle 14 title "exact"
set lmargin at screen 0.49; set rmargin at screen 0.84
set xrange [x_least:2 * x_least]
unset ylabel
set key at screen 0.86,0.5 left center Left reverse samplen 3
plot for [name in curves] table using (method(name) * column("x2")):(column("s11") / 1e9) \
         with linespoints linestyle method_style(name) pointinterval 2 title name, \
     table using (method(word(curves, words(curves) > 1 ? 2 : 1)) * column("x2")):(column("s11_exact") / 1e9) with lines linestyle 14 title "exact"
unset multiplot
