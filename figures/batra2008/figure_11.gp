# Figure 11 of Batra and Zhang (2008): displacement u2 of the bottom edge on four grids, by each method, ρ = 4. Beyond the print the
# lower row: the error, where the curves above fall together.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_11.csv"
set terminal svg size 1180,700 font "Helvetica,13" background rgb "white" linewidth 1.1 dashlength 0.7
grids = "16 31 61 91"
grid_name(nx) = nx eq "16" ? "16 × 4" : nx eq "31" ? "31 × 7" : nx eq "61" ? "61 × 13" : "91 × 19"
grid(nx) = column("nx") == int(nx) ? 1 : NaN
array colours[4] = ["#bf7772", "#e0a000", "#3a9bdc", "#12507b"]
shade(k) = colours[k]
left(k) = 0.07 + 0.275 * (k - 1)
set multiplot title "Displacement of the bottom edge on four grids"
do for [k = 1:3] {
    name = word(methods, k)
    set lmargin at screen left(k); set rmargin at screen left(k) + 0.235
    set tmargin at screen 0.88; set bmargin at screen 0.56
    set title name
    unset xlabel; set format x ""
    set ylabel (k == 1 ? "u_2 in mm" : "")
    unset logscale y; set format y "%g"; set yrange [0:3]
    unset key
    if (k == 3) { set key at screen 0.875,0.72 left center Left reverse samplen 2.5 }
    plot for [n = 1:4] table using (method(name) * grid(word(grids, n)) * column("x1")):(1000 * column("u2")) \
             with lines linecolor rgb shade(n) linewidth 1.6 dashtype n title grid_name(word(grids, n)), \
         table using (method(name) * grid("16") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 14 title "exact"
    set tmargin at screen 0.48; set bmargin at screen 0.10
    unset title; unset key
    set xlabel "x_1 in m"; set format x "%g"
    set ylabel (k == 1 ? "|u_2 − exact| in mm" : "")
    set logscale y; set format y "10^{%T}"; set yrange [1e-5:1]
    plot for [n = 1:4] table using (method(name) * grid(word(grids, n)) * column("x1")):(1000 * abs(column("u2") - column("u2_exact"))) \
             with lines linecolor rgb shade(n) linewidth 1.6 dashtype n notitle
}
unset multiplot
