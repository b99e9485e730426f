# Beyond the print: time and largest memory against the number of particles, plate of Batra and Zhang (2008), ρ = 4. The seconds
# are those of one machine (make timings measures them anew).
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/seconds.csv"
set terminal svg size 1000,460 font "Helvetica,14" background rgb "white" linewidth 1.2 dashlength 0.7
set logscale xy
set xrange [50:2e5]
set format x "10^{%T}"
set xlabel "number of particles"

set multiplot title "Cost of the three methods, m = 2, two threads"
set key at graph 0.02,0.99 left top Left reverse samplen 3 spacing 1.1
set lmargin at screen 0.085; set rmargin at screen 0.52
set bmargin at screen 0.14; set tmargin at screen 0.88
set yrange [1e-4:100]
set format y "10^{%T}"
set ylabel "seconds"
plot for [name in "strong weak1 weak2"] table using (method(name) * column("particles")): \
         (column("seconds_assembly") + column("seconds_solution")) with linespoints linestyle method_style(name) title name . ", in all", \
     for [name in "strong weak1 weak2"] table using (method(name) * column("particles")):"seconds_assembly" \
         with lines linestyle method_style(name) dashtype (2,4) linewidth 1 title name . ", assembly"

set lmargin at screen 0.62; set rmargin at screen 0.98
set yrange [1:1e4]
set ylabel "memory in MB"
plot for [name in "strong weak1"] table using (method(name) * column("particles")):"megabytes" \
         with linespoints linestyle method_style(name) title name, \
     [1000:1e5] 0.025 * x with lines linecolor rgb "#888888" dashtype (4,4) title "25 kB for each particle"
unset multiplot
