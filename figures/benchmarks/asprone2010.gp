# Speed of the operators and tests of Asprone et al. (2010) against the number of particles; drawn by make bench.
load "figures/style.gp"
if (!exists("table")) table = "data/benchmarks/asprone2010.csv"
set terminal svg size 1000,860 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
set logscale xy
set xrange [600:1.6e7]
set format x "10^{%T}"
set format y "%g"
row(task, method, threads) = strcol("task") eq task && strcol("method") eq method && column("threads") == threads ? column("particles") : NaN
numpy = "linecolor rgb '#c0392b' dashtype (4,4) pointtype 3 pointsize 0.7 linewidth 1.4"
limit = "linecolor rgb '#888888' dashtype (2,3) linewidth 1.4"

set multiplot
set lmargin at screen 0.08; set rmargin at screen 0.48
set bmargin at screen 0.57; set tmargin at screen 0.95
set title "assembly of D and D², one thread"
set ylabel "ns per particle"
set yrange [15:100000]
set key at graph 0.98,0.99 right top Left reverse samplen 3 spacing 1 font ",11"
plot for [name in "original chen_beraun rkpm_second_order modified_fpm second_order_fpm"] table \
         using (row("assembly", name, 1)):"nanoseconds" with linespoints linestyle style(name) title title(name), \
     table using (row("assembly", "NumPy modified_fpm", 1)):"nanoseconds" with linespoints @numpy title "modified FPM in NumPy", \
     table using (row("assembly", "second_order_fpm", 2)):"nanoseconds" with lines linestyle style("second_order_fpm") dashtype (3,3) \
         title "second-order FPM, two threads", \
     table using (row("assembly", "second_order_fpm", 1)):(column("limit_bandwidth") + column("limit_exp")) with lines @limit \
         title "limit of it: bytes and exponentials"

set lmargin at screen 0.58; set rmargin at screen 0.98
set title "application of D²"
set yrange [1:200]
plot table using (row("application", "second_order_fpm", 1)):"nanoseconds" with linespoints linestyle style("second_order_fpm") title "one thread", \
     table using (row("application", "second_order_fpm", 2)):"nanoseconds" with lines linestyle style("second_order_fpm") dashtype (3,3) title "two threads", \
     table using (row("application", "SciPy modified_fpm", 1)):"nanoseconds" with linespoints @numpy title "SciPy", \
     table using (row("application", "second_order_fpm", 1)):"limit_bandwidth" with lines @limit title "limit: bytes"

set lmargin at screen 0.08; set rmargin at screen 0.48
set bmargin at screen 0.08; set tmargin at screen 0.46
set title "static test in all, one thread"
set xlabel "number of particles"
set yrange [100:1e5]
plot table using (row("static", "corrected", 1)):"nanoseconds" with linespoints linestyle style("second_order_fpm") title "corrected until exact", \
     table using (row("static", "uncorrected", 1)):"nanoseconds" with linespoints linestyle style("original") title "one solution", \
     table using (row("static", "corrected", 2)):"nanoseconds" with lines linestyle style("second_order_fpm") dashtype (3,3) title "corrected, two threads", \
     table using (row("static", "SciPy modified_fpm", 1)):"nanoseconds" with linespoints @numpy title "SciPy, modified FPM, one solution"

set lmargin at screen 0.58; set rmargin at screen 0.98
set title "vibration test"
set ylabel "seconds"
set yrange [1e-3:100]
set format y "10^{%T}"
plot table using (row("modes", "lowest ten", 2)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints linestyle style("second_order_fpm") title "lowest ten modes", \
     table using (row("modes", "all", 1)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints linestyle style("original") title "all modes", \
     table using (row("modes", "SciPy lowest ten", 1)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints @numpy title "lowest ten by SciPy"
unset multiplot
