# Figure 1 of Asprone et al. (2010): infinity norm of the error of the second derivative of exp against the number of
# particles. Beyond the print: FPM applied twice (end of Section 3.4), the SSPH basis
# of Batra and Zhang (2008), and the small panel, in which the error over δ² shows
# how far the random particles scatter: it is level where the order is two.
curve_column = "formulation"; x_column = "particles"; y_column = "error_second"
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/figure_1.csv"
if (!user) {
    curves = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm"
    perturbations = "0 0.25"
    y_least = 2e-8; y_most = 9e3
}
function = comment(" for B = ")
if (function eq "") function = "exp"
second = strstrt(curves, "second_order_fpm") > 0
uniform(name) = row(name, word(perturbations, 1))
moved(name) = row(name, word(perturbations, 2))
if (user) {
    do for [name in curves] { eval(observe(name, "uniform('" . name . "') / column('spacing')", "column('error_second')")) }
}
eval(picture(640, 740))
set logscale x
eval(set_N)
set xlabel "number of particles N"
set multiplot

heading = "Derivative test: error of D²B for B = " . function . " on [0, 1]"
if (user) { set title heading . parameters_below noenhanced font ",12" }
else { set title heading . beyond("FPM applied twice, SSPH, the small panel") }
set lmargin at screen 0.14; set rmargin at screen 0.97; set tmargin at screen 0.91; set bmargin at screen 0.42
set key at screen 0.03,0.335 left top maxrows 11 width 0 height 0
set logscale y
set yrange [decade_below(y_least):decade_above(y_most)]
set format y "10^{%T}"
set ylabel (function eq "exp" ? "max |D²B − eˣ|" : "max |D²B − B″|")
if (!user) {
    eval(triangle(1, 400, 6e-4, 2.5, 1))
    eval(triangle(2, 400, 8e-7, 2.5, 2))
}
moved_curves = second ? "second_order_fpm" : curves
# gnuplot runs an empty loop once; so the parts of the plot that may be missing are macros.
and_moved = words(perturbations) < 2 ? "" : ", for [name in moved_curves] \
    table using (moved(name) * column('particles')):'error_second' every (user ? 1 : 2) \
    with points linecolor rgb (second ? '#005a3c' : '#222222') pointtype 6 pointsize 1.1 \
    title user ? 'perturbed by ' . word(perturbations, 2) . ' δ' : 'the same, perturbed (median)'"
plot for [name in curves] table using (uniform(name) * column("particles")):"error_second" \
         with linespoints linestyle style(name) pointinterval symbols title titled(name) @and_moved

unset object; unset label; unset logscale y; unset ylabel
set lmargin at screen 0.62; set tmargin at screen 0.28; set bmargin at screen 0.09
set key at graph 0.98,0.04 right bottom maxrows 3 width -2 height 0 font ",12" samplen 2 spacing 1.05
set format y "%g"
scaled(name) = column(name) / column("spacing")**2
last(name) = row(name, word(perturbations, words(perturbations)))
if (user) {
    set title "second-order FPM: error / δ²" font ",12"
    set yrange [0:*]
    set xtics (x_least, x_most)
} else {
    set title "second-order FPM, δ/4: error / δ²" font ",12"
    set yrange [0:4]
    set ytics 1
    set xtics (10, 160, 2560)
}
kind = user ? "linespoints" : "lines"  # a single N has no line
quartiles = !has("error_second_lower") ? "" : "table using (last('second_order_fpm') * column('particles')): \
    (scaled('error_second_lower')):(scaled('error_second_upper')) with filledcurves \
    fillcolor rgb '#7fc8a9' fillstyle transparent solid 0.6 noborder title user ? 'quartiles' : 'quartiles, 51 seeds', \
    table using (last('second_order_fpm') * column('particles')):(scaled('error_second')) \
    with lines linecolor rgb '#005a3c' dashtype (3,3) title 'median', "
if (second) {
    plot @quartiles table using (uniform("second_order_fpm") * column("particles")):(scaled("error_second")) \
             with @kind linestyle style("second_order_fpm") title user ? moved_by(word(perturbations, 1)) : "uniform"
}
unset multiplot
