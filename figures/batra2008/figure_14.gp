# Figure 14 of Batra and Zhang (2008): the quarter of the plate with its boundaries (left), and the 188 particles that we take (right).
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_14.csv"
eval(picture(720, 430))
set size ratio -1
set key off
set xrange [-0.2:3.3]
set yrange [-0.2:3.3]
set parametric
b = 0.3
set multiplot title "A quarter of a plate with a hole: boundaries, and the 188 particles that we take"
set bmargin at screen 0.15; set tmargin at screen 0.90
set lmargin at screen 0.01; set rmargin at screen 0.47
unset border; unset tics; unset grid
set trange [0:pi / 2]
set arrow 1 from b,0 to 3,0 nohead; set arrow 2 from 3,0 to 3,3 nohead
set arrow 3 from 3,3 to 0,3 nohead; set arrow 4 from 0,3 to 0,b nohead
set arrow 5 from 3.05,0.5 to 3.3,0.5 linecolor rgb "#888888"; set arrow 6 from 3.05,1.5 to 3.3,1.5 linecolor rgb "#888888"
set arrow 7 from 3.05,2.5 to 3.3,2.5 linecolor rgb "#888888"
set label 1 "1" at -0.13,1.6; set label 2 "2" at 0.27,0.33; set label 3 "3" at 1.6,-0.12
set label 4 "4" at 2.8,1.2; set label 5 "5" at 1.6,2.87
set label 6 "u₁ = 0, t₂ = 0" at 0.1,1.6 textcolor rgb "#666666" font ",12"
set label 7 "t = 0" at 0.45,0.4 textcolor rgb "#666666" font ",12"
set label 8 "t₁ = 0, u₂ = 0" at 1.4,0.17 textcolor rgb "#666666" font ",12"
set label 9 "exact tractions t on 4 and 5" at 0.35,2.55 textcolor rgb "#666666" font ",12"
set label 10 "σ₀" at 3.12,2.65 textcolor rgb "#666666"
plot b * cos(t), b * sin(t) with lines linecolor rgb "#000000"
unset arrow; unset label
set lmargin at screen 0.57; set rmargin at screen 0.98
set border 3 linecolor rgb "#444444"; set xtics nomirror; set ytics nomirror
set xlabel "x₁ in m"; set ylabel "x₂ in m" offset 1,0
plot b * cos(t), b * sin(t) with lines linecolor rgb "#888888", \
     table using "x1":"x2" with points pointtype 7 pointsize 0.35 linecolor rgb "#12507b"
unset multiplot
