# Speed of the operators and tests of Asprone et al. (2010) against the number of particles; drawn by make bench.
load "figures/style.gp"
if (!exists("table")) table = "data/benchmarks/asprone2010.csv"
eval(picture(720, 1200))
set logscale xy
set xrange [350:1.6e7]
set format x "10^{%T}"
set format y "%g"
row(task, method, threads) = strcol("task") eq task && strcol("method") eq method && column("threads") == threads ? column("particles") : NaN
numpy = "linecolor rgb '#c0392b' dashtype (4,4) pointtype 3 pointsize 0.7 linewidth 1.4"
limit = "linecolor rgb '#888888' dashtype (2,3) linewidth 2"

top(k) = 0.96 - 0.24 * (k - 1)
place(k) = sprintf("set tmargin at screen %g; set bmargin at screen %g; set key at screen 0.60,%g left top", top(k), top(k) - 0.17, top(k))
set key maxrows 8 width 0 samplen 3 spacing 1.05 height 0
set lmargin at screen 0.12; set rmargin at screen 0.58
set multiplot
eval(place(1))
set title "assembly of D and D², one thread"
set ylabel "ns per particle"
set yrange [15:2000]
plot for [name in "original chen_beraun rkpm_second_order modified_fpm second_order_fpm"] table \
         using (row("assembly", name, 1)):"nanoseconds" with linespoints linestyle style(name) title title(name), \
     table using (row("assembly", "NumPy modified_fpm", 1)):"nanoseconds" with linespoints @numpy title "modified FPM in NumPy", \
     table using (row("assembly", "second_order_fpm", 2)):"nanoseconds" with lines linestyle style("second_order_fpm") dashtype (3,3) \
         title "second-order, two threads", \
     table using (row("assembly", "second_order_fpm", 1)):(column("limit_bandwidth") + column("limit_exp")) with lines @limit \
         title "limit: bytes, exponentials"

eval(place(2))
set title "application of D² of the second-order FPM"
set yrange [1:100]
plot table using (row("application", "second_order_fpm", 1)):"nanoseconds" with linespoints linestyle style("second_order_fpm") title "one thread", \
     table using (row("application", "second_order_fpm", 2)):"nanoseconds" with lines linestyle style("second_order_fpm") dashtype (3,3) title "two threads", \
     table using (row("application", "SciPy modified_fpm", 1)):"nanoseconds" with linespoints @numpy title "SciPy", \
     table using (row("application", "second_order_fpm", 1)):"limit_bandwidth" with lines @limit title "limit: bytes"

eval(place(3))
set title "static test in all, one thread"
set yrange [300:1e4]
plot table using (row("static", "corrected", 1)):"nanoseconds" with linespoints linestyle style("second_order_fpm") title "corrected for its residual", \
     table using (row("static", "uncorrected", 1)):"nanoseconds" with linespoints linestyle style("original") title "one solution", \
     table using (row("static", "corrected", 2)):"nanoseconds" with lines linestyle style("second_order_fpm") dashtype (3,3) title "corrected, two threads", \
     table using (row("static", "SciPy modified_fpm", 1)):"nanoseconds" with linespoints @numpy title "modified FPM in SciPy"

eval(place(4))
set xlabel "number of particles"
set title "vibration test"
set ylabel "seconds"
set yrange [1e-3:10]
set format y "10^{%T}"
plot table using (row("modes", "lowest ten", 2)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints linestyle style("second_order_fpm") title "lowest ten modes", \
     table using (row("modes", "all", 1)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints linestyle style("original") title "all modes", \
     table using (row("modes", "SciPy lowest ten", 1)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints @numpy title "lowest ten by SciPy"
unset multiplot
