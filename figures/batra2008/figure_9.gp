# Figure 9 of Batra and Zhang (2008): error norm (4.4) against the scaling factor of the kernel of the SSPH basis.
curve_column = "method"; x_column = "scaling"; y_column = "log_error_dn"; signed = 1
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_9.csv"
set title "Error against the scaling factor, 16 × 4 particles"
set xlabel "scaling factor ρ"
set ylabel "log₁₀ of the error norm E, (4.4)"
eval(one_row)
if (!user || (x_least < 3.5 && x_most > 3.5)) {
    set arrow from 3.5, graph 0 to 3.5, graph 1 nohead linecolor rgb "#888888" dashtype (4,4)
    set label "stable from here on, says the print" at 3.55, graph 0.96 textcolor rgb "#444444" font ",12"
}
draw = 'plot for [name in curves] table using (method(name) * column("scaling")):"log_error_dn" \
        with linespoints linestyle method_style(name) title name'
if (user) {
    set title "Error of the plate against the scaling factor"
    set key maxrows 2
    set offsets 0, 0, graph 0.1, 0
    # FPM has no scaling factor: its error is a level line.
    all = curves; curves = ""
    do for [name in all] {
        if (name ne "fpm") { curves = with_word(curves, name) } else {
            draw = draw . ', table using (x_least):(method("fpm") * column("log_error_dn")):(x_most - x_least):(0) \
                with vectors nohead linestyle method_style("fpm") title method_title("fpm")'
        }
    }
} else { curves = methods }
eval(draw)
