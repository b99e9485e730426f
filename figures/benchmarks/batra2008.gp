# Speed of the basis and methods of Batra and Zhang (2008) against the number of particles; drawn by make bench.
load "figures/style.gp"
if (!exists("table")) table = "data/benchmarks/batra2008.csv"
set terminal svg size 1000,460 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
set logscale xy
set xrange [600:1.6e5]
set format x "10^{%T}"
set xlabel "number of particles"
row(task, method, threads) = strcol("task") eq task && strcol("method") eq method && column("threads") == threads ? column("particles") : NaN
numpy = "linecolor rgb '#c0392b' dashtype (4,4) pointtype 3 pointsize 0.7 linewidth 1.4"

set multiplot
set lmargin at screen 0.08; set rmargin at screen 0.48
set bmargin at screen 0.14; set tmargin at screen 0.90
set title "search and basis (m = 2), one thread"
set ylabel "µs per particle"
set yrange [0.05:200]
set format y "%g"
set key at graph 0.98,0.99 right top Left reverse samplen 3 spacing 1 font ",12"
plot table using (row("basis", "m = 2", 1)):(column("nanoseconds") / 1000) with linespoints linestyle method_style("strong") title "SSPH basis", \
     table using (row("basis", "NumPy m = 2", 1)):(column("nanoseconds") / 1000) with linespoints @numpy title "in NumPy", \
     table using (row("search", "cells", 1)):(column("nanoseconds") / 1000) with linespoints linestyle method_style("weak1") title "search of neighbours", \
     table using (row("search", "SciPy cKDTree", 1)):(column("nanoseconds") / 1000) with linespoints @numpy title "by SciPy's tree"

set lmargin at screen 0.58; set rmargin at screen 0.98
set title "plate, two threads"
set ylabel "seconds"
set yrange [1e-3:1000]
set format y "10^{%T}"
set key at graph 0.02,0.99 left top
plot for [name in "strong weak1 weak2"] table using (row("plate in all", name, 2)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints linestyle method_style(name) title name . ", in all", \
     for [name in "strong weak1 weak2"] table using (row("plate assembly", name, 2)):(column("nanoseconds") * column("particles") * 1e-9) \
         with lines linestyle method_style(name) dashtype (2,4) linewidth 1 title name . ", assembly"
unset multiplot
