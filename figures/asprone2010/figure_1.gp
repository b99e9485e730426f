# Figure 1 of Asprone et al. (2010): infinity norm of the error of the second derivative of exp against the number of
# particles. Beyond the print: FPM applied twice (end of Section 3.4), the SSPH basis
# of Batra and Zhang (2008), and the small panel, in which the error over δ² shows
# how far the random particles scatter: it is level where the order is two.
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/figure_1.csv"
curves = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm"
uniform(name) = of(name) * (column("perturbation") == 0 ? 1 : NaN)
moved(name) = of(name) * (column("perturbation") > 0 ? 1 : NaN)
set logscale x
set xrange [9:3000]
set xtics (10, "" 20, 40, "" 80, 160, "" 320, 640, "" 1280, 2560)
set xlabel "number of particles N"
set multiplot

set title "Derivative test: error of D²B for B = exp on [0, 1]"
set lmargin at screen 0.10; set tmargin at screen 0.92; set bmargin at screen 0.12
set key at screen 0.68,0.92 left top
set logscale y
set yrange [1e-7:1e4]
set format y "10^{%T}"
set ylabel "max |D²B − e^x|"
eval(triangle(1, 400, 8e-4, 2.5, 1))
eval(triangle(2, 400, 1.5e-6, 2.5, 2))
plot for [name in curves] table using (uniform(name) * column("particles")):"error_second" \
         with linespoints linestyle style(name) pointinterval 4 title title(name), \
     table using (moved("second_order_fpm") * column("particles")):"error_second" every 2 \
         with points linecolor rgb "#005a3c" pointtype 6 pointsize 1.1 title "the same, perturbed (median)"

unset object; unset label; unset logscale y; unset ylabel
set title "second-order FPM, δ/4: error / δ²" font ",12"
set lmargin at screen 0.72; set rmargin at screen 0.975; set tmargin at screen 0.42
set key at graph 0.98,0.04 right bottom width -3 font ",11" samplen 2
set format y "%g"
set yrange [0:4]
set ytics 1
set xtics (10, 160, 2560) font ",12"
unset xlabel
scaled(name) = column(name) / column("spacing")**2
plot table using (moved("second_order_fpm") * column("particles")):(scaled("error_second_lower")):(scaled("error_second_upper")) \
         with filledcurves fillcolor rgb "#7fc8a9" fillstyle transparent solid 0.6 noborder title "quartiles, 51 seeds", \
     table using (moved("second_order_fpm") * column("particles")):(scaled("error_second")) \
         with lines linecolor rgb "#005a3c" dashtype (3,3) title "median", \
     table using (uniform("second_order_fpm") * column("particles")):(scaled("error_second")) \
         with lines linestyle style("second_order_fpm") title "uniform"
unset multiplot
