# Beyond Section 4.2 of Batra and Zhang (2008), whose particles are lost: the printed numbers (bars) beside those of 25 layouts
# each with about 188 and about 686 particles, five radii of the hole: graded (circles, 20) and polar (squares, 5).
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/layouts.csv"
set terminal svg size 1120,820 font "Helvetica,13" background rgb "white" linewidth 1.1
$printed << EOD
method,finer,log_error_dn,stress_concentration,deviation_u1_mm,deviation_u2_mm
strong,0,-1.926,3.173,0.183,0.405
weak1,0,-3.149,3.002,0.065,0.047
weak2,0,-2.293,3.148,0.088,0.075
strong,1,-2.243,3.084,NaN,NaN
weak1,1,-3.260,2.996,NaN,NaN
weak2,1,-2.691,3.037,NaN,NaN
EOD
place(name, finer) = (name eq "strong" ? 1 : name eq "weak1" ? 2 : 3) + (finer > 0.5 ? 3.6 : 0)
here(particles) = place(strcol("method"), particles > 400)
kind(name) = strcol("layout")[1:5] eq name ? 1 : NaN
shift(row) = 0.12 * (int(row) % 5 - 2)
# How many concentrations lie outside the range that is drawn.
outside = system("awk -F, '/^method/ { for (k = 1; k <= NF; ++k) if ($k == \"stress_concentration\") c = k; next } \
    !/^#/ && ($c < 2.5 || $c > 3.8)' " . table . " | wc -l")
set xrange [0.3:7.3]
set xtics ("strong" 1, "weak1" 2, "weak2" 3, "strong" 4.6, "weak1" 5.6, "weak2" 6.6)
set arrow 1 from 3.8, graph 0 to 3.8, graph 1 nohead linecolor rgb "#bbbbbb"
set label 1 "about 188 particles" at 2, graph 1.05 center
set label 2 "about 686 particles" at 5.6, graph 1.05 center
columns = "log_error_dn stress_concentration deviation_u1_mm deviation_u2_mm"
array names[4] = ["log_{10} E", "σ_{11}/σ_0 at the hole", "largest deviation of u_1 in mm", "largest deviation of u_2 in mm"]
set multiplot title "The printed numbers among 25 layouts of particles around the hole"
do for [k = 1:4] {
    set lmargin at screen (k % 2 ? 0.08 : 0.58); set rmargin at screen (k % 2 ? 0.48 : 0.98)
    set tmargin at screen (k < 3 ? 0.88 : 0.42); set bmargin at screen (k < 3 ? 0.56 : 0.10)
    set ylabel names[k]
    unset logscale y; set format y "%g"
    if (k == 1) { set yrange [-4.6:-0.4] }
    if (k == 2) { set yrange [2.5:3.8]; set label 3 (outside . " lie outside, most of strong") at graph 0.5,0.04 center font ",10" textcolor rgb "#666666" }
    if (k > 2) { unset label 3; set logscale y; set yrange [1e-3:50] }
    unset key
    if (k == 4) { set key at screen 0.5,0.012 center bottom horizontal samplen 1.5 width 2 }
    plot table using (kind("grade") * (here(column("particles")) + shift($0))):(column(word(columns, k))) with points pointtype 6 pointsize 0.6 linecolor rgb "#12507b" title "graded", \
         table using (kind("polar") * (here(column("particles")) + shift($0))):(column(word(columns, k))) with points pointtype 4 pointsize 0.7 linecolor rgb "#c8501e" title "polar", \
         $printed using (place(strcol("method"), column("finer"))):(column(word(columns, k))):(0.42) with xerrorbars pointtype 0 linewidth 2.5 linecolor rgb "#000000" title "printed"
}
unset multiplot
