# Figure 12 of Batra and Zhang (2008): error norm (4.4) against the distance between particles, ρ = 4. The norm of the
# difference would fall upon these curves.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_12.csv"
set title "Convergence, plate"
set logscale x
set xlabel "distance between particles in m"
set ylabel "log_{10} E"
set xrange [0.009:0.085]
set xtics ("1/90" 1.0/90, "1/60" 1.0/60, "1/30" 1.0/30, "1/15" 1.0/15)
set object 1 polygon from 0.03,-3.6 to 0.06,-3.6 to 0.06,-2.998 to 0.03,-3.6 fillstyle empty border linecolor rgb "#666666"
set label 1 "2" at 0.0615,-3.3 textcolor rgb "#666666"
set label 2 "1" at 0.0424,-3.72 center textcolor rgb "#666666"
plot for [name in methods] table using (method(name) / (column("nx") - 1)):"log_error_dn" \
         with linespoints linestyle method_style(name) title name
