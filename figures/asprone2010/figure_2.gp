# Figure 2 of Asprone et al. (2010): infinity norm of the displacement's error against the number of particles, on uniform
# (left) and perturbed (right) particles. The right panel shows the medians and quartiles over seeds.
load "figures/style.gp"
set terminal svg size 1120,540 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
if (!exists("left")) left = "data/asprone2010/figure_2_left.csv"
if (!exists("right")) right = "data/asprone2010/figure_2_right.csv"
set logscale xy
set xrange [9:3000]
set yrange [1e-8:1]
set format y "10^{%T}"
set xtics (10, "" 20, 40, "" 80, 160, "" 320, 640, "" 1280, 2560)
set xlabel "number of particles N"

set multiplot title "Static test: error of the displacement, −u″ = exp, u(0) = u′(1) = 0"
set key off
set lmargin at screen 0.085; set rmargin at screen 0.43
set bmargin at screen 0.13; set tmargin at screen 0.86
set title "uniform particles"
set ylabel "max |u − u_{exact}|"
eval(triangle(1, 30, 3e-3, 2.5, 1))
eval(triangle(2, 30, 5e-6, 2.5, 2))
curves = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm"
plot for [name in curves] left using (of(name) * column("particles")):"error_displacement" \
         with linespoints linestyle style(name) pointinterval 4 notitle

unset object; unset label; unset ylabel
set lmargin at screen 0.47; set rmargin at screen 0.79
set format y ""
set title "second-order FPM, perturbed by δ/4"
set key at screen 0.80,0.5 left center Left reverse samplen 3 spacing 1.35
eval(triangle(2, 30, 5e-6, 2.5, 2))
plot right using (of("second_order_fpm") * column("particles")):"error_displacement_lower":"error_displacement_upper" \
         with filledcurves fillcolor rgb "#7fc8a9" fillstyle transparent solid 0.5 noborder title "quartiles, 51 seeds", \
     right using (of("second_order_fpm") * column("particles")):"error_displacement" \
         with linespoints linestyle style("second_order_fpm") pointinterval 4 notitle, \
     for [name in curves] keyentry with linespoints linestyle style(name) title title(name)
unset multiplot
