# Frequencies of waves on an infinite lattice in the plane, by the Laplacian, over the exact ones: along an axis and along the
# diagonal for three smoothing lengths, and for h = δ in the plane of phases. SSPH of second and of third degree have the same.
load "figures/style.gp"
if (!exists("table")) table = "data/fpm_in_space/symbol.csv"
eval(picture(720, 800))
both = "definite_fpm cubic_ssph"
title_cubic_ssph = "SSPH"
lengths = "1 1.5 2"
style_of(name, k) = 40 + 3 * (name eq "cubic_ssph") + k
do for [k = 1:3] { do for [name in both] {
    eval(sprintf("set style line %d linecolor rgb '%s' dashtype %s linewidth 1.6", style_of(name, k), \
                 name eq "definite_fpm" ? "#00695c" : "#7b4fa3", word("1 (8,4) (2,3)", k)))
} }
chosen(name, h) = strcol("formulation") eq name && column("smoothing") == h
frequency(x) = sqrt(column("ratio"))
on_axis(name, h) = chosen(name, h) && column("theta2") == 0 ? column("theta1") / pi : NaN
on_diagonal(name, h) = chosen(name, h) && column("theta1") == column("theta2") ? column("theta1") / pi : NaN
set multiplot title "Frequencies of waves on a lattice, over the exact ones"
set xrange [0:1]; set yrange [0:1.05]
set xtics 0.25; set ytics 0.25
set tmargin at screen 0.91; set bmargin at screen 0.635
unset key
do for [diagonal = 0:1] {
    set lmargin at screen 0.12 + 0.455 * diagonal; set rmargin at screen 0.515 + 0.455 * diagonal
    set title (diagonal ? "along the diagonal" : "along an axis") font ",13" offset 0,-0.5
    set xlabel (diagonal ? "θ₁/π = θ₂/π" : "θ₁/π, θ₂ = 0") offset 0,0.3
    set ylabel (diagonal ? "" : "√(−λ) / |θ|")
    set format y (diagonal ? "" : "%g")
    if (diagonal) { set key at screen 0.55,0.51 center center maxrows 3 width 0 samplen 3 font ",12" }
    plot for [name in both] for [k = 1:3] table using (diagonal ? on_diagonal(name, word(lengths, k)) : on_axis(name, word(lengths, k))):(frequency(0)) \
         smooth csplines with lines linestyle style_of(name, k) title title(name) . ", h = " . (k == 1 ? "δ" : word(lengths, k) . " δ")
}
unset key
eval(sequential)
set palette maxcolors 10
set cbrange [0:1]
set style fill solid 1 noborder
set xrange [-1.0 / 24:25.0 / 24]; set yrange [-1.0 / 24:25.0 / 24]
unset grid
set tmargin at screen 0.4; set bmargin at screen 0.09
set colorbox user origin screen 0.9,0.09 size screen 0.02,0.31
set cbtics 0.2
do for [k = 1:2] {
    name = word(both, k)
    set lmargin at screen 0.12 + 0.4 * (k - 1); set rmargin at screen 0.47 + 0.4 * (k - 1)
    set title title(name) . ", h = δ" font ",13"
    set xlabel "θ₁/π"; set ylabel (k == 1 ? "θ₂/π" : "")
    set format y (k == 1 ? "%g" : "")
    plot table using (chosen(name, 1) ? column("theta1") / pi : NaN):(column("theta2") / pi):(1.0 / 24):(1.0 / 24):(frequency(0)) \
         with boxxyerror linecolor palette
}
unset multiplot
