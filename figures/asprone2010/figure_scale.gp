# Beyond the print: error of the displacement on long lines, second-order FPM in double precision, by one solution of (45) and by
# a solution that is corrected for its residual.
load "figures/style.gp"
set logscale xy
set xrange [70:1.5e6]
set format x "10^{%T}"
set format y "10^{%T}"
set yrange [1e-13:1e-3]
set xlabel "number of particles N"
set ylabel "max |u − exact|"
set title "Static test of the second-order FPM in double precision" . beyond("the whole figure")
plot "data/asprone2010/scale_uncorrected.csv" using "particles":"error_displacement" with linespoints linestyle style("original") \
         title "one solution of (45)", \
     "data/asprone2010/scale.csv" using "particles":"error_displacement" with linespoints linestyle style("second_order_fpm") \
         title "corrected for its residual", \
     [100:1.5e6] 0.1645 / x**2 with lines linecolor rgb "#666666" dashtype (4,4) title "discretisation: 0.1645 δ²"
