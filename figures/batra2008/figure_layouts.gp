# Beyond Section 4.2 of Batra and Zhang (2008), whose particles are lost: the printed numbers (bars) beside those of
# layouts with about 188 and about 686 particles: graded (circles) and polar (squares).
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/layouts.csv"
eval(picture(640, 1240))
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
outside(more_than, at_most) = system("awk -F, '/^method/ { for (k = 1; k <= NF; ++k) { if ($k == \"stress_concentration\") c = k; if ($k == \"particles\") p = k } next } \
    !/^#/ && $p > " . more_than . " && $p <= " . at_most . " && ($c < 2.5 || $c > 3.8)' " . table . " | wc -l")
# How many layouts there are: those that one method was solved on.
count(particles) = strcol("method") eq "weak1" ? (particles > 400 ? (more = more + 1) : (fewer = fewer + 1)) : 0
fewer = 0; more = 0
stats table using (count(column("particles"))) nooutput
set xrange [0.3:7.3]
set xtics ("strong" 1, "weak1" 2, "weak2" 3, "strong" 4.6, "weak1" 5.6, "weak2" 6.6)
set arrow 1 from 3.8, graph 0 to 3.8, graph 1 nohead linecolor rgb "#bbbbbb"
columns = "log_error_dn stress_concentration deviation_u1_mm deviation_u2_mm"
array names[4] = ["log₁₀ E, (4.4)", "σ₁₁ / σ₀ at the hole", "largest |u₁ − exact| in mm", "largest |u₂ − exact| in mm"]
set lmargin at screen 0.14; set rmargin at screen 0.98
set multiplot title "The printed numbers among those of our layouts around the hole" . beyond("the layouts")
set label 1 sprintf("%d layouts of about 188 particles", fewer) at 2, graph 1.06 center font ",12"
set label 2 sprintf("%d layouts of about 686 particles", more) at 5.6, graph 1.06 center font ",12"
do for [k = 1:4] {
    set tmargin at screen 0.925 - 0.228 * (k - 1); set bmargin at screen 0.755 - 0.228 * (k - 1)
    set ylabel names[k]
    unset logscale y; set format y "%g"; unset label 3; unset label 4
    if (k == 1) { set yrange [-5.8:-0.4]; set ytics 1 } else { set ytics autofreq }
    if (k == 2) { set yrange [2.5:3.8]; set label 3 (outside(0, 400) . " lie outside") at 3.7, graph 0.95 right font ",12" textcolor rgb "#444444"; set label 4 (outside(400, 10000) . " lie outside") at graph 0.98,0.95 right font ",12" textcolor rgb "#444444" }
    if (k > 2) { set logscale y; set yrange [1e-3:50] }
    unset key
    if (k == 4) { set key at screen 0.5,0.016 center center maxrows 1 samplen 1.5 width 0 }
    plot $printed using (place(strcol("method"), column("finer"))):(column(word(columns, k))):(0.42) with xerrorbars pointtype 0 linewidth 3 linecolor rgb "#000000" title "printed", \
         table using (kind("grade") * (here(column("particles")) + shift($0))):(column(word(columns, k))) with points pointtype 6 pointsize 0.7 linecolor rgb "#12507b" title "graded", \
         table using (kind("polar") * (here(column("particles")) + shift($0))):(column(word(columns, k))) with points pointtype 5 pointsize 0.6 linecolor rgb "#c8501e" title "polar"
}
unset multiplot
