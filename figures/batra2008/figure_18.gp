# Figure 18 of Batra and Zhang (2008): the 686 particles that we take, 21 of them on the hole. On the right the part near the hole.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_18.csv"
set terminal svg size 1000,480 font "Helvetica,14" background rgb "white" linewidth 1.2
set size ratio -1
set key off
set parametric
set trange [0:pi / 2]
b = 0.3
set xlabel "x_1 in m"; set ylabel "x_2 in m" offset 1,0
set multiplot title "686 particles, of which 21 lie on the hole"
set bmargin at screen 0.12; set tmargin at screen 0.90
set lmargin at screen 0.06; set rmargin at screen 0.48
set xrange [-0.1:3.1]; set yrange [-0.1:3.1]
plot b * cos(t), b * sin(t) with lines linecolor rgb "#888888", \
     table using "x1":"x2" with points pointtype 7 pointsize 0.3 linecolor rgb "#12507b"
set lmargin at screen 0.55; set rmargin at screen 0.97
set xrange [-0.03:1]; set yrange [-0.03:1]
unset ylabel
plot b * cos(t), b * sin(t) with lines linecolor rgb "#888888", \
     table using "x1":"x2" with points pointtype 7 pointsize 0.45 linecolor rgb "#12507b"
unset multiplot
