# The plate and the hole of the second paper by collocation: SSPH of degree 2 and 3, and the second-order FPM. Left: the plate's error
# on grids. Right: the stress concentration over draws of the layout around the hole, medians and quartiles.
load "figures/style.gp"
eval(picture(720, 500))
plate = "data/fpm_in_space/plate.csv"
kind(name, degree) = strcol("method") eq name && strcol("degree") eq degree ? 1 : NaN
array curve_name[3] = ["strong", "strong", "fpm"]
array curve_degree[3] = ["2", "3", ""]
array formulation[3] = ["ssph", "cubic_ssph", "definite_fpm"]
# Medians and quartiles of |σ11/σ0 − 3| over the draws of a layout.
counts = "188 686 2600"
file(k, N) = k == 2 ? "hole_cubic" : N > 188 ? "hole" : k == 1 ? "layouts" : "hole_fpm_coarse"
of_layout(k, N) = kind(curve_name[k], curve_degree[k]) * (column("particles") == N ? 1 : NaN)
set print $errors
print "curve,particles,lower,median,upper"
do for [k = 1:3] {
    do for [N in counts] {
        stats "data/fpm_in_space/" . file(k, N + 0) . ".csv" using (of_layout(k, N + 0) * abs(column("stress_concentration") - 3)) nooutput
        print sprintf("%d,%s,%.9g,%.9g,%.9g", k, N, STATS_lo_quartile, STATS_median, STATS_up_quartile)
    }
}
unset print

set multiplot
set tmargin at screen 0.9; set bmargin at screen 0.3
set logscale xy
set format y "10^{%T}"
set lmargin at screen 0.115; set rmargin at screen 0.5
set title "plate, grids" font ",13"
set xlabel "particles"
set ylabel "error of displacements"
set xrange [45:2500]; set xtics (64, 217, 793, 1729)
set yrange [1e-12:1]
unset key
plot for [k = 1:3] plate using (kind(curve_name[k], curve_degree[k]) * column("particles")):(10**column("log_error_nd")) \
    with linespoints linestyle style(formulation[k])

set lmargin at screen 0.61; set rmargin at screen 0.98
set title "hole: medians and quartiles of draws" font ",13"
set xrange [140:3500]; set xtics (188, 686, 2600)
set yrange [0.002:10]
set ylabel "error of σ₁₁ / σ₀ at the hole, median"
shifted(k, N) = N * 1.08**(k - 2)
set key at screen 0.5,0.09 center center vertical maxrows 2 Left reverse samplen 3 width 0
plot for [k = 1:3] $errors using (column("curve") == k ? shifted(k, column("particles")) : NaN):"median":"lower":"upper" \
         with yerrorbars linestyle style(formulation[k]) notitle, \
     for [k = 1:3] $errors using (column("curve") == k ? shifted(k, column("particles")) : NaN):"median" \
         with linespoints linestyle style(formulation[k]) title title(formulation[k])
unset multiplot
