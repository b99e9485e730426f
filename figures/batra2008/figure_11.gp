# Figure 11 of Batra and Zhang (2008): displacement u2 of the bottom edge on four grids, by each method, ρ = 4. Beyond the print the
# lower row: the error, where the curves above coincide.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_11.csv"
eval(picture(720, 640))
grids = "16 31 61 91"
grid_name(nx) = nx eq "16" ? "16 × 4" : nx eq "31" ? "31 × 7" : nx eq "61" ? "61 × 13" : "91 × 19"
grid(nx) = column("nx") == int(nx) ? 1 : NaN
set style line 21 linecolor rgb "#c77a5a" dashtype 1         linewidth 1.6
set style line 22 linecolor rgb "#b8860b" dashtype (2,2)     linewidth 1.8
set style line 23 linecolor rgb "#3a86c8" dashtype (8,3)     linewidth 1.6
set style line 24 linecolor rgb "#12305b" dashtype (8,3,2,3) linewidth 1.8
left(k) = 0.125 + 0.295 * (k - 1)
set multiplot title "Displacement of the bottom edge on four grids" . beyond("the lower row")
do for [k = 1:3] {
    name = word(methods, k)
    set lmargin at screen left(k); set rmargin at screen left(k) + 0.265
    set tmargin at screen 0.86; set bmargin at screen 0.53
    set title name offset 0,-0.5
    unset xlabel; set format x ""
    set ylabel (k == 1 ? "u₂ in mm" : "")
    unset logscale y; set format y (k == 1 ? "%g" : ""); set yrange [0:3]; set xtics 0.25
    unset key
    if (k == 1) { set key at screen 0.5,0.05 center center maxrows 1 width -1 samplen 2.5 }
    plot table using (method(name) * grid("16") * column("x1")):(1000 * column("u2_exact")) with lines linestyle 34 title "exact", \
         for [n = 1:4] table using (method(name) * grid(word(grids, n)) * column("x1")):(1000 * column("u2")) \
             with lines linestyle 20 + n title grid_name(word(grids, n))
    set tmargin at screen 0.50; set bmargin at screen 0.17
    unset title; unset key
    set xlabel "x₁ in m"; set format x "%g"; set xtics 0.5
    set ylabel (k == 1 ? "|u₂ − exact| in mm" : "")
    set logscale y; set format y (k == 1 ? "10^{%T}" : ""); set yrange [1e-5:1]
    plot for [n = 1:4] table using (method(name) * grid(word(grids, n)) * column("x1")):(1000 * abs(column("u2") - column("u2_exact"))) \
             with lines linestyle 20 + n
}
unset multiplot
