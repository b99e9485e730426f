# Figure 7 of Batra and Zhang (2008): displacement u2 of the bottom edge for ν = 0.499999, in plane stress as printed (left). Plane
# stress lets the plate change its thickness and constrains no volume; in plane strain (right, beyond the print) it is constrained.
load "figures/style.gp"
if (!exists("left")) left = "data/batra2008/figure_7.csv"
if (!exists("right")) right = "data/batra2008/figure_7_strain.csv"
eval(picture(720, 480))
set xlabel "x₁ in m"
stats right using (method("weak2") * 1000 * column("u2")) nooutput name "weak2"
set multiplot title "Displacement of the bottom edge, ν = 0.499999, 16 × 4 particles" . beyond("plane strain")
set bmargin at screen 0.27; set tmargin at screen 0.81
set lmargin at screen 0.11; set rmargin at screen 0.50
set title "plane stress"
set ylabel "u₂ in mm"
set key at screen 0.5,0.07 center center maxrows 1 width -1
plot left using (method("weak1") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 34 title "exact", \
     for [name in methods] left using (method(name) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10 title name
set lmargin at screen 0.58; set rmargin at screen 0.98
set title "plane strain"
unset ylabel; unset key
set yrange [-2:4]
set label sprintf("weak2 falls to −%.3g mm", -weak2_min) at 0.06,-1.6 textcolor rgb "#444444" font ",12"
plot right using (method("weak1") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 34, \
     for [name in methods] right using (method(name) * column("x1")):(1000 * column("u2")) \
         with linespoints linestyle method_style(name) pointinterval 10
unset multiplot
