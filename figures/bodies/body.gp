# The field of a body as colours on its triangles, or on those of its surface: body --plot. What lies in front covers what
# lies behind. Without triangles each particle is a dot.
if (!exists("table")) { exit error "this figure is of a body of your own: body --plot FILE.svg" }
load "figures/style.gp"
eval(picture(720, 560))
eval(sequential)
unset datafile columnheaders
what = system("awk '/^#/ { sub(/^# */, \"\"); print; exit }' " . table)
corners = int(system("awk -F, '!/^#/ { print NF / 4; exit }' " . table))
# A triangle is a quadrangle of pm3d, two of whose corners coincide.
body = sprintf("< awk -F, -v OFS=, '/^#/ || !n++ { next } \
    NF == 4 { print; next } \
    { v = ($4 + $8 + $12) / 3; \
      print $1, $2, $3, v; print $5, $6, $7, v; print \"\"; print $9, $10, $11, v; print $9, $10, $11, v; print \"\\n\" }' '%s'", table)
# As many tics at the same distances along each axis as leave room for their numbers.
extent = 0
do for [axis = 1:3] {
    stats body using axis nooutput
    extent = most(extent, STATS_max - STATS_min)
    flat = STATS_min == STATS_max
}
power = 10**floor(log10(extent / 4))
step = power * (extent / 4 > 3.5 * power ? 5 : extent / 4 > 1.5 * power ? 2 : 1)
set xtics step; set ytics step; set ztics step
stats body using 4 nooutput
set cbrange [STATS_min == STATS_max ? STATS_min - 0.5 : STATS_min : STATS_min == STATS_max ? STATS_max + 0.5 : STATS_max]
set format cb "%.6g"
set title what
unset key; unset grid
set xlabel "x"; set ylabel "y"; set zlabel "z"
set pm3d depthorder noborder
set autoscale fix; unset border; set tics out
if (flat) { set view map; set size ratio -1; set zrange [-1:1] } else { set view 60,30; set view equal xyz; set xyplane relative 0; set xtics offset 0,-0.6; set ytics offset 0.8,-0.3 }
if (corners == 3) { splot body using 1:2:3:4 with pm3d } else { splot body using 1:2:3:4 with points pointtype 7 pointsize 0.6 linecolor palette }
