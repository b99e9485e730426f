# Distribution of the errors over 1000 draws of perturbed particles.
curve_column = "formulation"; x_column = "percentile"; y_column = "error_second"
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/draws.csv"
draws = user ? comment(" over seeds 1 to ") : "1000"
if (!user) { curves = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm" }
set multiplot
set logscale x
set format x "10^{%T}"
set yrange [0:100]
set ylabel "percent of " . draws . " draws with a smaller error"
set title "Derivative test: max |D²B − e^x|" font ",13"
set lmargin at screen 0.10; set rmargin at screen 0.38
unset key
set xtics 100
plot for [name in curves] table using (of(name) * column("error_second")):"percentile" with lines linestyle style(name)
set title "Static test: max |u − exact|" font ",13"
set lmargin at screen 0.44; set rmargin at screen 0.72
set key at screen 0.74,0.52 left center
unset ylabel
plot for [name in curves] table using (of(name) * column("error_displacement")):"percentile" with lines linestyle style(name) title title(name)
unset multiplot
