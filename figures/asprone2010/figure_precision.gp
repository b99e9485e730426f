# Measured errors of D²B in three precisions, and what the stencil at the end predicts: truncation falls, round-off grows.
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/precision.csv"
precisions = "double long quad"
names_of = "'double, 53 bits' 'long double, 64 bits' 'quad, 113 bits'"
epsilons = "2.220446e-16 1.084202e-19 1.925930e-34"
rows(f, p) = (strcol("formulation") eq f && strcol("precision") eq p ? 1 : NaN)
# The prediction's constants are read from the table: truncation over δ^p, round-off times δ² over epsilon.
stats table using (rows("second_order_fpm", "double") * column("predicted_truncation") / column("spacing")**2) nooutput name "second"
stats table using (rows("modified_fpm", "double") * column("predicted_truncation") / column("spacing")) nooutput name "modified"
stats table using (rows("second_order_fpm", "double") * column("predicted_roundoff") * column("spacing")**2 / 2.220446e-16) nooutput name "grown"
set title "The floor of each precision: error of D²B for B = exp"
set logscale xy
set xrange [8:2e9]; set yrange [1e-18:10]
set format x "10^{%T}"; set format y "10^{%T}"
set xlabel "number of particles N"
set ylabel "max |D²B − e^x|"
set samples 400
plot for [k = 1:3] grown_mean * word(epsilons, k) * x**2 with lines linecolor rgb word("#c0392b #e0a000 #7a6fb0", k) dashtype (2,3) notitle, \
     second_mean / x**2 with lines linestyle 7 linewidth 0.8 notitle, \
     modified_mean / x with lines linestyle 6 linewidth 0.8 notitle, \
     for [f in "modified_fpm second_order_fpm"] for [k = 3:1:-1] table \
         using (rows(f, word(precisions, k)) * column("particles")):"error_second" \
         with points linecolor rgb word("#c0392b #e0a000 #7a6fb0", k) pointtype (f eq "modified_fpm" ? 12 : 7) notitle, \
     for [k = 1:3] keyentry with points linecolor rgb word("#c0392b #e0a000 #7a6fb0", k) pointtype 7 title word(names_of, k), \
     keyentry with linespoints linestyle 6 linewidth 0.8 title "modified FPM, predicted", \
     keyentry with linespoints linestyle 7 linewidth 0.8 title "second-order FPM, predicted", \
     keyentry with lines linecolor rgb "#888888" dashtype (2,3) title "round-off, at most"
