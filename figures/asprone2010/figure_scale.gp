# Beyond the print: error of the displacement on long lines, second-order FPM in double precision, by one solution of (45) and by
# a solution that is corrected for its residual.
load "figures/style.gp"
set logscale xy
set xrange [70:1.5e6]
set format x "10^{%T}"
set format y "10^{%T}"
set yrange [1e-13:1e-3]
set xlabel "number of particles N"
set ylabel "max |u − u_{exact}|"
set title "Static test in double precision"
set key at screen 0.67,0.52
plot "data/asprone2010/scale_uncorrected.csv" using "particles":"error_displacement" with linespoints linestyle style("original") \
         title "one solution", \
     "data/asprone2010/scale.csv" using "particles":"error_displacement" with linespoints linestyle style("second_order_fpm") \
         title "corrected", \
     [100:1.5e6] 0.1645 / x**2 with lines linecolor rgb "#888888" dashtype (4,4) title "0.1645 δ²: the discretisation"
