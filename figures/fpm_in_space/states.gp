# The error of the second derivatives, of the Laplacian or of the value of a solution, at each particle, as a colour: derivative_test_in_space and
# static_test_in_space --states --plot. In space, what
# lies in front covers what lies behind.
if (!exists("table")) { exit error "this figure is of a table of your own: derivative_test_in_space --states --plot FILE.svg" }
of_values = system("grep -c '^formulation.*,error_value,' '" . table . "'") + 0 > 0
of_laplacian = system("grep -c '^formulation.*,error_laplacian,' '" . table . "'") + 0 > 0
curve_column = "formulation"; x_column = "particle"
y_column = of_values ? "error_value" : of_laplacian ? "error_laplacian" : "error_second"
load "figures/style.gp"
in_space = strstrt("," . columns . ",", ",z,") > 0
eval(picture(720, 640))
conditions = ""
if (of_values) { stats table using (conditions = strcol("conditions"), 0) nooutput }
set title (of_values ? "Poisson's equation, " . conditions . ": error" : "Error") . " at each particle by " . title(word(curves, 1)) . \
    (of_values ? "\n" : ", ") . "B = " . comment(" for B = ") . "\nkernel " . comment("# kernel ") noenhanced font ",12"
eval(sequential)
set logscale cb
set cbrange [y_least == y_most ? 0.5 * y_least : y_least : y_most]
set format cb "10^{%T}"
set cblabel "error of " . (of_values ? "the value" : of_laplacian ? "the Laplacian" : "second derivatives")
unset key
# The fewer the particles, the larger the symbols.
set pointsize strlen(values) < 9999 ? most(0.5, least(2.5, 40.0 / words(values)**0.6)) : 0.3
set xlabel "x"; set ylabel "y"
if (in_space) {
    set view equal xyz
    set view 65,30,0.8
    set xyplane relative 0
    set zlabel "z"
    set xtics 0.5; set ytics 0.5; set ztics 0.5
    splot table using "x":"y":"z":(column(y_column) > 0 ? column(y_column) : y_least) with points pointtype 7 linecolor palette
} else {
    set size ratio -1
    plot table using "x":"y":(column(y_column) > 0 ? column(y_column) : y_least) with points pointtype 7 linecolor palette
}
