# Poisson's equation, mixed: fluxes on half of the sides, values on the others. The largest errors of the values (left) and of
# the first derivatives (right) against the number of particles along a side, in the plane (above) and in space (below).
load "figures/style.gp"
eval(picture(720, 880))
file(dim, kind) = "data/fpm_in_space/poisson" . (dim == 3 ? "_in_space" : "") . (kind eq "" ? "" : "_" . kind) . ".csv"
# Curves: formulation, layout, and the table.
array formulation[5] = ["ssph", "cubic_ssph", "definite_fpm", "definite_fpm", "definite_fpm"]
array layout[5] = ["grid", "grid", "grid", "grid", "stretched-10"]
array words_of[5] = [title("ssph") . ", grid", title("cubic_ssph") . ", grid", "second-order FPM, grid", \
                     "second-order FPM, perturbed by δ/4, median", "second-order FPM, stretched tenfold and perturbed, median"]
table_of(dim, k) = k < 4 ? file(dim, "") : k == 4 || dim == 2 ? file(dim, "draws") : file(dim, "stretched")
here(k, n) = strcol("formulation") eq formulation[k] && strcol("layout") eq layout[k] && strcol("conditions") eq "mixed" && \
             column("particles") == n ? 1 : NaN
set style line 41 linecolor rgb "#c0392b" dashtype (10,3,2,3,2,3) pointtype 14 pointsize 0.8 linewidth 1.5
set style line 42 linecolor rgb "#7b4fa3" dashtype (4,3) pointtype 5 pointsize 0.7 linewidth 1.5
set style line 43 linecolor rgb "#00695c" dashtype 1 pointtype 7 pointsize 0.7 linewidth 2
set style line 44 linecolor rgb "#00695c" dashtype (6,3) pointtype 6 pointsize 0.9 linewidth 1.6
set style line 45 linecolor rgb "#5aa897" dashtype (2,2) pointtype 4 pointsize 0.8 linewidth 1.6
set print $errors
print "dim,curve,particles,value,first"
do for [dim = 2:3] {
    do for [k = 1:5] {
        do for [n in (dim == 2 ? (k < 4 ? "16 31 61 121" : "31 121") : (k < 4 ? "9 12 17" : "9 17"))] {
            stats table_of(dim, k) using (here(k, n + 0) * column("error_value")) nooutput
            value_most = STATS_max
            stats table_of(dim, k) using (here(k, n + 0) * column("error_first")) nooutput
            print sprintf("%d,%d,%s,%.9g,%.9g", dim, k, n, value_most, STATS_max)
        }
    }
}
unset print
set multiplot
set logscale xy
set format y "10^{%T}"
unset key
set label 10 "Poisson's equation: fluxes on x = 1, y = 1, z = 1, values on the other sides" at screen 0.5,0.985 center font ",13"
do for [dim = 2:3] {
    set tmargin at screen (dim == 2 ? 0.925 : 0.545); set bmargin at screen (dim == 2 ? 0.635 : 0.255)
    if (dim == 2) { set xrange [13:150]; set xtics (16, 31, 61, 121) } else { set xrange [8:19.5]; set xtics (9, 12, 17) }
    set xlabel (dim == 3 ? "particles along a side" : "")
    do for [first = 0:1] {
        set lmargin at screen (first ? 0.6 : 0.11); set rmargin at screen (first ? 0.98 : 0.49)
        set title (dim == 2 ? "plane, " : "space, ") . (first ? "first derivatives" : "values") font ",13"
        set ylabel (first ? "" : "largest error")
        if (dim == 2) { set yrange [1e-4:0.1] } else { set yrange [(first ? 0.01 : 0.003):(first ? 10 : 3)] }
        if (dim == 2) { eval(triangle(1, 60, first ? 0.013 : 0.013, 2, 2)) }
        plot for [k = 1:5] $errors using (column("dim") == dim && column("curve") == k ? column("particles") : NaN):(first ? column("first") : column("value")) \
             with linespoints linestyle 40 + k
        unset object; unset label
    }
}
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset grid
set tmargin at screen 0.18; set bmargin at screen 0; set lmargin at screen 0.05; set rmargin at screen 0.95
set yrange [1:10]
set key at screen 0.11,0.175 left top vertical Left reverse maxrows 5 width 0 samplen 4 font ",13"
plot for [k = 1:5] NaN with linespoints linestyle 40 + k title words_of[k]
unset multiplot
