# Figure 18 of Batra and Zhang (2008): the 686 particles that we take, 21 of them on the hole. On the right the part near the hole.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_18.csv"
eval(picture(720, 440))
set size ratio -1
set key off
set parametric
set trange [0:pi / 2]
b = 0.3
set xlabel "x₁ in m"; set ylabel "x₂ in m" offset 1,0
set multiplot title "The 686 particles that we take, of which 21 lie on the hole"
set bmargin at screen 0.17; set tmargin at screen 0.90
set lmargin at screen 0.10; set rmargin at screen 0.50
set xrange [-0.1:3.1]; set yrange [-0.1:3.1]
plot b * cos(t), b * sin(t) with lines linecolor rgb "#888888", \
     table using "x1":"x2" with points pointtype 7 pointsize 0.3 linecolor rgb "#12507b"
set lmargin at screen 0.58; set rmargin at screen 0.98
set xrange [-0.03:1]; set yrange [-0.03:1]
unset ylabel
plot b * cos(t), b * sin(t) with lines linecolor rgb "#888888", \
     table using "x1":"x2" with points pointtype 7 pointsize 0.45 linecolor rgb "#12507b"
unset multiplot
