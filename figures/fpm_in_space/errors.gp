# Largest errors of second derivatives, of the Laplacian or of the values of a solution, and of first derivatives against the number of particles along a side: a column for each
# perturbation, a colour for each formulation, a dash and a symbol for each place. For figure_plane, figure_space, and
# derivative_test_in_space --plot and static_test_in_space --plot.
if (!exists("table")) { exit error "this figure is of a table of your own: derivative_test_in_space --plot FILE.svg" }
with_triangles = exists("ours")
of_values = system("grep -c '^formulation.*,error_value,' '" . table . "'") + 0 > 0
of_laplacian = system("grep -c '^formulation.*,error_laplacian,' '" . table . "'") + 0 > 0
curve_column = "formulation"; x_column = "particles"
y_column = of_values ? "error_value" : of_laplacian ? "error_laplacian" : "error_second"
load "figures/style.gp"
# A case that failed has a row without a place.
key(name, place, p) = name . "/" . place . "/" . p
places = ""; present = ""; layout = ""; conditions = ""; several = 0
first_of(known, name) = (several = several || (known ne "" && name ne known), known eq "" ? name : known)
note_place(place) = (places = with_word(places, place), \
    present = with_word(present, key(strcol("formulation"), place, strcol("perturbation"))), \
    layout = first_of(layout, strcol("layout")), \
    conditions = of_values ? first_of(conditions, strcol("conditions")) : "", 0)
stats table using (strcol("place") eq "" ? 0 : note_place(strcol("place"))) nooutput
if (several) { exit error "this figure is of one layout" . (of_values ? " under one of the conditions" : "") }
about = (of_values ? "Poisson's equation, " . conditions . ": largest" : "Largest") . " errors by place" . \
        (layout eq "grid" ? "" : " on " . layout) . " for B = " . comment(" for B = ")
stats table using (column("error_first") > 0 ? column("error_first") : NaN) nooutput
first_least = STATS_min; first_most = STATS_max

colour(name) = word("#c0392b #00695c #7b4fa3 #3a9bdc #b35900 #888888", style(name) < 10 ? 1 : style(name) - 9)
number(place) = place eq "inside" ? 1 : place eq "face" ? 2 : place eq "edge" ? 3 : 4
at_place(name, place) = 100 + 4 * style(name) + number(place)
place_style(tag, colour, place) = sprintf("set style line %d linecolor rgb '%s' dashtype %s pointtype %s pointsize 0.7 linewidth 1.4", \
    tag, colour, word("1 (12,4) (6,3) (2,2)", number(place)), word("6 12 8 7", number(place)))
do for [place in places] {
    eval(place_style(90 + number(place), "#222222", place))
    do for [name in curves] { eval(place_style(at_place(name, place), colour(name), place)) }
}
at(name, place, p) = strcol("formulation") eq name && strcol("place") eq place && strcol("perturbation") eq p ? 1 : NaN
# The second-order FPM is drawn last: it covers what coincides with it.
if (with_word(curves, "definite_fpm") eq curves) {
    others = ""
    do for [name in curves] { others = name eq "definite_fpm" ? others : others . " " . name }
    curves = others . " definite_fpm"
}

panels = words(perturbations)
of_median = strstrt("," . columns . ",", ",seeds,") > 0 ? ", median" : ""
eval(picture(720, 900))
set multiplot
set logscale xy
set xrange [0.85 * x_least : 1.18 * x_most]
set xtics () font ",12"
do for [n in values] { eval("set xtics add (" . n . ")") }
unset key
set label 1 about at screen 0.5,0.987 center font (strlen(about) > 90 ? ",11" : ",13") noenhanced
set label 2 "kernel " . comment("# kernel ") at screen 0.5,0.966 center font ",11" noenhanced
do for [second = 0:1] {
    set tmargin at screen 0.535 + 0.375 * second; set bmargin at screen 0.215 + 0.375 * second
    if (second) { set yrange [decade_below(y_least) : decade_above(y_most)] }
    else { set yrange [decade_below(first_least) : decade_above(first_most)] }
    shown = second ? y_column : "error_first"
    set xlabel (second ? "" : "particles along a side")
    if (second && with_triangles) {
        before = 1.0 * word(values, words(values) - 2); factor = x_most / before
        eval(triangle(1, before, 0.6 * y_least, factor, 2))
        eval(triangle(2, before, 1.6 * y_most * x_least / before, factor, 1))
    }
    do for [k = 1:panels] {
        p = word(perturbations, k)
        set lmargin at screen 0.12 + 0.44 * (k - 1); set rmargin at screen (k == panels ? 0.98 : 0.53)
        set format y (k == 1 ? "10^{%T}" : "")
        set ylabel (k > 1 ? "" : second ? "error of " . (of_values ? "values" : of_laplacian ? "the Laplacian" : "second derivatives") : "error of first derivatives")
        set title (!second ? "" : p eq "0" ? (layout eq "grid" ? "uniform" : "not perturbed") : "perturbed by " . p . " δ" . of_median) font ",13"
        drawn = ""
        do for [name in curves] { do for [place in places] {
            if (with_word(present, key(name, place, p)) eq present) {
                drawn = drawn . (drawn eq "" ? "plot " : ", ") . sprintf("table using (at('%s', '%s', p) * column('particles')):(column(shown)) \
                    with linespoints linestyle %d", name, place, at_place(name, place))
            }
        } }
        eval(drawn)
        unset label; unset object
    }
}
# The key, in plots of its own.
set tmargin at screen 0.16; set bmargin at screen 0; set lmargin at screen 0.05; set rmargin at screen 0.95
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset grid
set yrange [1:10]
set key at screen 0.08,0.135 left top vertical Left reverse maxrows 6 width 0 samplen 4 spacing (words(curves) > 5 ? 0.9 : 1.1) font ",13"
plot for [name in curves] NaN with lines linewidth 3 linecolor rgb colour(name) \
     title title(name) . (name eq "definite_fpm" && words(curves) > 1 ? " (on top)" : "")
set key at screen 0.6,0.135
plot for [place in places] NaN with linespoints linestyle 90 + number(place) title place
unset multiplot
