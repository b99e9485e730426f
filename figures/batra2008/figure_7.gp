# Figure 7 of Batra and Zhang (2008): displacement u2 of the bottom edge for ν = 0.499999, in plane stress as printed (left). Plane
# stress lets the plate change its thickness and constrains no volume; in plane strain (right, beyond the print) it is constrained.
load "figures/style.gp"
if (!exists("left")) left = "data/batra2008/figure_7.csv"
if (!exists("right")) right = "data/batra2008/figure_7_strain.csv"
set terminal svg size 1120,480 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
set xlabel "x_1 in m"
set multiplot title "Displacement of the bottom edge, ν = 0.499999, 16 × 4 particles"
set key off
set bmargin at screen 0.14; set tmargin at screen 0.84
set lmargin at screen 0.07; set rmargin at screen 0.41
set title "plane stress, as printed"
set ylabel "u_2 in mm"
plot for [name in methods] left using (method(name) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10 title name, \
     left using (method("weak1") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 14 title "exact"
set lmargin at screen 0.50; set rmargin at screen 0.84
set title "plane strain"
unset ylabel
set yrange [-2:4]
set key at screen 0.86,0.5 left center Left reverse samplen 3
plot for [name in methods] right using (method(name) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10 title name, \
     right using (method("weak1") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 14 title "exact"
unset multiplot
