# Figure 2 of Asprone et al. (2010): infinity norm of the displacement's error against the number of particles, on uniform
# (left) and perturbed (right) particles. The right panel shows the medians and quartiles over seeds.
curve_column = "formulation"; x_column = "particles"; y_column = "error_displacement"
load "figures/style.gp"
set terminal svg size 1120,540 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
# A user's table holds the rows of both panels; where its particles are of one kind, there is one panel.
if (user) {
    left = table
    right = table
} else {
    left = "data/asprone2010/figure_2_left.csv"
    right = "data/asprone2010/figure_2_right.csv"
    curves = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm"
    perturbations = "0 0.25"
    y_least = 2e-8; y_most = 0.9
}
first = word(perturbations, 1)
second = word(perturbations, 2)
both = words(perturbations) > 1
set logscale xy
eval(set_N)
set yrange [decade_below(y_least):decade_above(y_most)]
set format y "10^{%T}"
set xlabel "number of particles N"

displacement = comment(" with u = ")
heading = "Static test: error of the displacement, " . (displacement eq "" ? "−u″ = exp, u(0) = u′(1) = 0" : "u = " . displacement)
if (user) { set multiplot title heading . parameters_below noenhanced font ",12" } else { set multiplot title heading }
set key off
set lmargin at screen 0.085; set rmargin at screen (both ? 0.43 : 0.79)
set bmargin at screen 0.13; set tmargin at screen (parameters_below eq "" ? 0.86 : 0.82)
set title moved_by(first)
set ylabel "max |u − u_{exact}|"
if (holds(30, 3e-3, 2.5, 1)) { eval(triangle(1, 30, 3e-3, 2.5, 1)) }
if (holds(30, 5e-6, 2.5, 2)) { eval(triangle(2, 30, 5e-6, 2.5, 2)) }
if (!both) { set key at screen 0.80,0.5 left center Left reverse samplen 3 spacing 1.35 }
plot for [name in curves] left using (row(name, first) * column("particles")):"error_displacement" \
         with linespoints linestyle style(name) pointinterval 4 title both ? "" : title(name)

unset object; unset label; unset ylabel
bands = has("error_displacement_lower") && strstrt(curves, "second_order_fpm") > 0
# An empty loop would draw once: what may be missing is a text.
quartiles = !bands ? "" : "right using (row('second_order_fpm', second) * column('particles')): \
    'error_displacement_lower':'error_displacement_upper' with filledcurves \
    fillcolor rgb '#7fc8a9' fillstyle transparent solid 0.5 noborder title user ? 'quartiles' : 'quartiles, 51 seeds', "
if (both) {
    set lmargin at screen 0.47; set rmargin at screen 0.79
    set format y ""
    set title user ? moved_by(second) : "second-order FPM, perturbed by δ/4"
    set key at screen 0.80,0.5 left center Left reverse samplen 3 spacing 1.35
    if (holds(30, 5e-6, 2.5, 2)) { eval(triangle(2, 30, 5e-6, 2.5, 2)) }
    plot @quartiles \
         for [name in (user ? curves : "second_order_fpm")] right using (row(name, second) * column("particles")):"error_displacement" \
             with linespoints linestyle style(name) pointinterval 4 notitle, \
         for [name in curves] keyentry with linespoints linestyle style(name) title title(name)
}
unset multiplot
