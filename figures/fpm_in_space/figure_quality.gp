# Does R, a number without a solution, predict the error? Left: at each particle of layouts around the hole, the error of second
# derivatives of ln r against the bound that R gives. Right: the error of displacements by collocation on 25 layouts, against the
# largest R of each.
load "figures/style.gp"
rows = "data/fpm_in_space/rows.csv"; layouts = "data/fpm_in_space/layouts.csv"
eval(picture(720, 520))
set multiplot
set logscale xy
set format xy "10^{%T}"
set tmargin at screen 0.88; set bmargin at screen 0.33
set lmargin at screen 0.115; set rmargin at screen 0.525
set title "derivatives of ln r, at each particle" font ",13"
set xlabel "R δ² 6/r⁴  (second degree: R δ 2/r³)"
set ylabel "error of second derivatives"
set xrange [1e-3:100]; set yrange [1e-5:100]
set key at screen 0.03,0.18 left top vertical Left reverse maxrows 3 width 0 samplen 2 font ",12"
# The remainder of ln r: δ² 6/r⁴ behind third degree, δ 2/r³ behind second.
r = "sqrt(column('x')**2 + column('y')**2)"
cubic(x) = column("quality") * column("spacing")**2 * 6 / (column("x")**2 + column("y")**2)**2
square(x) = column("quality") * column("spacing") * 2 / (column("x")**2 + column("y")**2)**1.5
plot x with lines linecolor rgb "#888888" linewidth 1 title "the bound, with the derivatives at the particle", \
     rows using (of("ssph") * square(0)):"error_second" with points pointtype 14 pointsize 0.5 linecolor rgb "#c0392b" title title("ssph"), \
     rows using (of("definite_fpm") * cubic(0)):"error_second" with points pointtype 7 pointsize 0.4 linecolor rgb "#00695c" title title("definite_fpm")
set lmargin at screen 0.635; set rmargin at screen 0.88
set title "solutions by collocation, 25 layouts" font ",13"
set xlabel "largest R of the layout (SSPH, powers of h)"
set ylabel "error of displacements"
unset logscale x
set format x "%g"
set xrange [2.2:3.5]; set xtics 0.4
set yrange [1e-3:1]
eval(sequential)
set logscale cb; set format cb "10^{%T}"
set label 1 "noise" at screen 0.92,0.91 center font ",12"
set colorbox user origin screen 0.9,0.33 size screen 0.02,0.55
unset key
plot layouts using "quality":(10**column("log_error_nd")):"noise" with points pointtype 7 pointsize 0.9 linecolor palette
unset multiplot
