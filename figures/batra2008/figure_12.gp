# Figure 12 of Batra and Zhang (2008): error norm (4.4) against the distance between particles, ρ = 4. The norm of the
# difference would coincide with these curves.
curve_column = "method"; x_column = "nx"; y_column = "log_error_dn"; signed = 1
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_12.csv"
set title "Error of the plate against the distance between particles"
eval(one_row)
set logscale x
set xlabel "distance between particles in m"
set ylabel "log₁₀ of the error norm E, (4.4)"
if (!user) { x_least = 16; x_most = 91; values = "91 61 31 16"; curves = methods }
set xrange [(user ? 0.8 / (x_most - 1) : 0.009):(user ? 1.25 / (x_least - 1) : 0.085)]
distances = ""
do for [k = 1:words(values)] {
    n = word(values, k) - 1
    distances = distances . sprintf("%s'1/%d' %.17g", k > 1 ? ", " : "", n, 1.0 / n)
}
eval("set xtics (" . distances . ")")
if (user) {
    do for [name in curves] { eval(observe(name, "method('" . name . "') * (column('nx') - 1)", "10**column('log_error_dn')")) }
    set key maxrows 3
    set yrange [floor(y_least - 0.01):ceil(y_most + 0.01)]
} else {
    set object 1 polygon from 0.03,-3.6 to 0.06,-3.6 to 0.06,-2.998 to 0.03,-3.6 fillstyle empty border linecolor rgb "#666666"
    set label 1 "2" at 0.0615,-3.3 textcolor rgb "#666666"
    set label 2 "1" at 0.0424,-3.72 center textcolor rgb "#666666"
}
plot for [name in curves] table using (method(name) / (column("nx") - 1)):"log_error_dn" \
         with linespoints linestyle method_style(name) title method_title(name) . order_of(name)
