# Figure 2 of Asprone et al. (2010): infinity norm of the displacement's error against the number of particles, on uniform
# (left) and perturbed (right) particles. The right panel shows the medians and quartiles over seeds.
curve_column = "formulation"; x_column = "particles"; y_column = "error_displacement"
load "figures/style.gp"
eval(picture(720, 620))
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
if (user) {
    do for [name in curves] {
        eval(observe(name, "row('" . name . "', first) / column('spacing')", "column('error_displacement')"))
    }
}
set logscale xy
eval(set_N)
set yrange [decade_below(y_least):decade_above(y_most)]
set format y "10^{%T}"
set xlabel "number of particles N"

displacement = comment(" with u = ")
heading = "Static test: error of the displacement, " . (displacement eq "" ? "−u″ = exp, u(0) = u′(1) = 0" : "u = " . displacement)
if (user) { set multiplot title heading . parameters_below noenhanced font ",12" }
else { set multiplot title heading . beyond("FPM applied twice, SSPH") }
set lmargin at screen 0.12; set rmargin at screen (both ? 0.53 : 0.97)
set bmargin at screen 0.38; set tmargin at screen 0.85
set key at screen 0.5,0.25 center top maxrows 5
set title (!user ? "uniform particles, all" : moved_by(first) . (both ? ", with orders" : ""))
set ylabel "max |u − exact|"
if (!user) {
    eval(triangle(1, 30, 3e-3, 2.5, 1))
    eval(triangle(2, 30, 4e-6, 2.5, 2))
}
bands = both && has("error_displacement_lower") && strstrt(curves, "second_order_fpm") > 0
# gnuplot runs an empty loop once; so the parts of the plot that may be missing are macros.
band_key = !bands ? "" : ", keyentry with filledcurves fillcolor rgb '#7fc8a9' fillstyle transparent solid 0.5 noborder \
    title user ? 'quartiles' : 'quartiles, 51 seeds'"
plot for [name in curves] left using (row(name, first) * column("particles")):"error_displacement" \
         with linespoints linestyle style(name) pointinterval symbols title titled(name) @band_key

unset object; unset label; unset ylabel; unset key
quartiles = !bands ? "" : "right using (row('second_order_fpm', second) * column('particles')): \
    'error_displacement_lower':'error_displacement_upper' with filledcurves \
    fillcolor rgb '#7fc8a9' fillstyle transparent solid 0.5 noborder, "
if (both) {
    set lmargin at screen 0.57; set rmargin at screen 0.97
    set format y ""
    set title (user ? moved_by(second) : "second-order FPM, perturbed by δ/4")
    if (!user) { eval(triangle(2, 30, 4e-6, 2.5, 2)) }
    plot @quartiles for [name in (user ? curves : "second_order_fpm")] \
         right using (row(name, second) * column("particles")):"error_displacement" \
             with linespoints linestyle style(name) pointinterval symbols
}
unset multiplot
