# Distribution of the errors over 1000 draws of perturbed particles.
curve_column = "formulation"; x_column = "percentile"; y_column = "error_second"
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/draws.csv"
draws = user ? comment(" over seeds 1 to ") : "1000"
if (!user) { curves = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm" }
eval(picture(720, 600))
if (user) { set multiplot title "Errors over " . draws . " draws: " . comment(draws . "\n# ") noenhanced font ",12" }
else { set multiplot title "Errors over 1000 draws of 160 particles, perturbed by δ/4" . beyond("the whole figure") }
set logscale x
set format x "10^{%T}"
set yrange [0:100]
set xtics 100
set ylabel "percent of " . draws . " draws with a smaller error"
set title "derivative test"
set xlabel "max |D²B − eˣ|"
set lmargin at screen 0.11; set rmargin at screen 0.52
set bmargin at screen 0.34; set tmargin at screen 0.85
set key at screen 0.5,0.21 center top
plot for [name in curves] table using (of(name) * column("error_second")):"percentile" with lines linestyle style(name) title title(name)
set title "static test"
set xlabel "max |u − exact|"
set lmargin at screen 0.56; set rmargin at screen 0.97
unset key; unset ylabel; set format y ""
plot for [name in curves] table using (of(name) * column("error_displacement")):"percentile" with lines linestyle style(name)
unset multiplot
