# Measured errors of D²B in three precisions, and what the stencil at the end predicts: truncation falls, round-off grows.
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/precision.csv"
precisions = "double long quad"
names_of = "'double, 53 bits' 'long double, 64 bits' 'quad, 113 bits'"
epsilons = "2.220446e-16 1.084202e-19 1.925930e-34"
# Symbols that show within each other where errors agree.
set style line 21 linecolor rgb "#c0392b" dashtype (2,3) pointtype 7 pointsize 0.5
set style line 22 linecolor rgb "#cf9400" dashtype (6,3) pointtype 6 pointsize 1.0 linewidth 1.5
set style line 23 linecolor rgb "#4a3f9f" dashtype (10,3,2,3) pointtype 4 pointsize 1.6
rows(f, p) = (strcol("formulation") eq f && strcol("precision") eq p ? 1 : NaN)
# The prediction's constants are read from the table: truncation over δ^p, round-off times δ² over epsilon.
stats table using (rows("second_order_fpm", "double") * column("predicted_truncation") / column("spacing")**2) nooutput name "second"
stats table using (rows("modified_fpm", "double") * column("predicted_truncation") / column("spacing")) nooutput name "modified"
stats table using (rows("second_order_fpm", "double") * column("predicted_roundoff") * column("spacing")**2 / 2.220446e-16) nooutput name "grown"
eval(picture(640, 640))
set title "The floor of each precision: error of D²B for B = exp" . (user ? "" : beyond("the whole figure"))
set logscale xy
set xrange [8:2e9]; set yrange [1e-18:10]
set format x "10^{%T}"; set format y "10^{%T}"
set xlabel "number of particles N"
set ylabel "max |D²B − eˣ|"
set samples 400
set label "modified FPM" at 1e8, 12 * modified_mean / 1e8 center rotate by -22 textcolor rgb "#3a9bdc" front
set label "second-order FPM" at 4e6, 12 * second_mean / 16e12 center rotate by -39 textcolor rgb "#005a3c" front
plot second_mean / x**2 with lines linestyle 7 linewidth 0.8 notitle, \
     modified_mean / x with lines linestyle 6 linewidth 0.8 notitle, \
     for [k = 3:1:-1] grown_mean * word(epsilons, k) * x**2 with lines linestyle 20 + k linewidth 1 notitle, \
     for [f in "modified_fpm second_order_fpm"] for [k = 3:1:-1] table \
         using (rows(f, word(precisions, k)) * column("particles")):"error_second" with points linestyle 20 + k notitle, \
     for [k = 1:3] keyentry with points linestyle 20 + k title word(names_of, k) . ": measured", \
     keyentry with lines linestyle 7 linewidth 0.8 title "truncation, predicted", \
     for [k = 1:3] keyentry with lines linestyle 20 + k linewidth 1 title "round-off at most, " . word("double long quad", k) . (k == 2 ? " double" : "")
