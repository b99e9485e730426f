# Beyond the print: time and largest memory against the number of particles, plate of Batra and Zhang (2008), ρ = 4. The seconds
# are those of one machine (make timings measures them anew).
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/seconds.csv"
eval(picture(720, 540))
set logscale xy
set xrange [50:2e5]
set format x "10^{%T}"; set format y "10^{%T}"
set xlabel "number of particles"

set multiplot title "Cost of the three methods, m = 2, two threads" . beyond("the whole figure")
set key at screen 0.03,0.20 left top maxrows 3 width -3
set lmargin at screen 0.11; set rmargin at screen 0.50
set bmargin at screen 0.36; set tmargin at screen 0.84
set yrange [1e-3:100]
set ylabel "seconds"
plot for [name in methods] table using (method(name) * column("particles")): \
         (column("seconds_assembly") + column("seconds_solution")) with linespoints linestyle method_style(name) title name . ", in all", \
     for [name in methods] table using (method(name) * column("particles")):"seconds_assembly" \
         with lines linestyle method_style(name) linewidth 0.8 title name . ", assembly", \
     keyentry with lines linestyle 34 title "25 kB a particle"

set lmargin at screen 0.60; set rmargin at screen 0.99
set yrange [1:1e4]
set ylabel "memory in MB"
unset key
share(particles) = particles < 1000 || particles > 1e5 ? NaN : 0.025 * particles
plot share(x) with lines linestyle 34, \
     for [name in methods] table using (method(name) * column("particles")):"megabytes" with linespoints linestyle method_style(name)
unset multiplot
