# Speed of the basis and methods of Batra and Zhang (2008) against the number of particles; drawn by make bench.
load "figures/style.gp"
if (!exists("table")) table = "data/benchmarks/batra2008.csv"
eval(picture(720, 620))
set logscale xy
set xrange [600:1.6e5]
set format x "10^{%T}"
row(task, method, threads) = strcol("task") eq task && strcol("method") eq method && column("threads") == threads ? column("particles") : NaN
set key maxrows 6 width 0 samplen 3 spacing 1.25 height 0
set lmargin at screen 0.12; set rmargin at screen 0.62
tree = "linecolor rgb '#7a1f14' dashtype (8,3) pointtype 2 pointsize 0.8 linewidth 1.4"
numpy = "linecolor rgb '#c0392b' dashtype (4,4) pointtype 3 pointsize 0.7 linewidth 1.4"

set multiplot
set bmargin at screen 0.58; set tmargin at screen 0.92
set title "search and basis (m = 2), one thread"
set ylabel "µs per particle"
set yrange [0.05:20]
set format y "%g"
set key at screen 0.65,0.92 left top
plot table using (row("basis", "m = 2", 1)):(column("nanoseconds") / 1000) with linespoints linestyle method_style("strong") title "SSPH basis", \
     table using (row("basis", "NumPy m = 2", 1)):(column("nanoseconds") / 1000) with linespoints @numpy title "SSPH basis in NumPy", \
     table using (row("search", "cells", 1)):(column("nanoseconds") / 1000) with linespoints linestyle method_style("weak1") title "search of neighbours", \
     table using (row("search", "SciPy cKDTree", 1)):(column("nanoseconds") / 1000) with linespoints @tree title "search by SciPy's tree"

set bmargin at screen 0.11; set tmargin at screen 0.46
set title "plate, two threads"
set xlabel "number of particles"
set ylabel "seconds"
set yrange [1e-3:1000]
set format y "10^{%T}"
set key at screen 0.65,0.46 left top
plot for [name in methods] table using (row("plate in all", name, 2)):(column("nanoseconds") * column("particles") * 1e-9) \
         with linespoints linestyle method_style(name) title name . ", in all", \
     for [name in methods] table using (row("plate assembly", name, 2)):(column("nanoseconds") * column("particles") * 1e-9) \
         with lines linestyle method_style(name) linewidth 0.8 title name . ", assembly"
unset multiplot
