# The error at each particle along one line, for a table of --states; states_1.gp and states_2.gp say of what.
# The paper has no such figure, but says that the largest error lies on the boundary.
if (!exists("table")) { exit error "this figure is of a table of your own: derivative_test --states --plot FILE.svg" }
curve_column = "formulation"; x_column = "x"; signed = 1
load "figures/style.gp"
size(name) = abs(column(name)) > 0 ? abs(column(name)) : NaN  # zero has no place on a logarithmic axis
stats table using (size(y_column)) nooutput
set logscale y
set yrange [decade_below(STATS_min):decade_above(STATS_max)]
set format y "10^{%T}"
set xrange [-0.01:1.01]
set xlabel "x"
set ylabel y_label
set title heading(comment(mark)) . parameters_below noenhanced font ",12"
plot for [name in curves] table using (of(name) * column("x")):(size(y_column)) \
         with linespoints linestyle style(name) title title(name)
