# Map of orders: formulations, in each the kernels, against h/δ; on particles at equal distances and on perturbed ones.
# A digit, the rounded order, holds up to the next one on its right. Crosses: too few neighbours, or a singular system.
# Lightness falls as the order grows.
curve_column = "formulation"; x_column = "smoothing"; y_column = "order_second"; signed = 1
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/orders.csv"
eval(picture(720, 1560))
shown = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm"
kernels = "gaussian cubic_spline quintic_spline wendland_c2 wendland_c4"
letters = "Gauss B3 B5 W2 W4"
place(list, name) = words(substr(list, 1, strstrt(list . " ", name . " ")))
row(f, k) = 7 * (place(shown, f) - 1) + place(kernels, k)
bounded(order) = order < -1.5 ? -1.5 : order > 3 ? 3 : order
set palette defined (-1.5 "#fbf3c4", -1 "#f6dd96", 0 "#ee9d6e", 1 "#b8496f", 2 "#57256f", 3 "#14102e")
set cbrange [-1.5:3]
unset grid
set border 0
if (!user) { x_least = 0.6; x_most = 4 }
step = words(values) > 1 ? word(values, 2) - word(values, 1) : 0.2
set xrange [x_least - 0.75 * step:x_most + 0.75 * step]; set yrange [0.3:56.5]
if (user) { set xtics autofreq scale 0 } else { set xtics 1, 1, 4 scale 0 }
unset key
unset colorbox
set ytics scale 0
set style fill solid 1 noborder

quantities = "order_first order_second order_displacement"
titles = "DB D²B u"
rounded(order) = order < -1.5 ? "<" : order > 3.5 ? ">" : order < -0.5 ? "−1" : sprintf("%.0f", abs(order))
ink(order) = order > 0.7 ? 0xffffff : 0x333333
height(any) = row(strcol("formulation"), strcol("kernel"))
known(q) = strlen(strcol(word(quantities, q))) > 0
# The place of a digit; NaN where its left neighbour has the same.
cell(q) = strcol("formulation") . strcol("kernel") . strcol("perturbation") . (known(q) ? rounded(column(word(quantities, q))) : "×")
last = ""
at_change(p, q) = (before = last, last = cell(q), known(q) && before ne last) ? at_smoothing(p) : NaN
at_smoothing(p) = column("perturbation") == (p - 1) * 0.25 ? column("smoothing") : NaN
set multiplot title "Orders of the errors of DB, D²B and u, by kernel and smoothing length h" . (user ? "" : beyond("the whole figure"))
do for [p = 1:2] {
    do for [q = 1:3] {
        set lmargin at screen 0.04 + 0.30 * (q - 1); set rmargin at screen 0.32 + 0.30 * (q - 1)
        set tmargin at screen 0.945 - 0.45 * (p - 1); set bmargin at screen 0.545 - 0.45 * (p - 1)
        set title word(titles, q) . (p == 1 ? ", equal distances" : ", perturbed by δ/4") offset 0,-0.4
        set xlabel (p == 2 ? "h/δ" : "") offset 0,0.6
        unset ytics
        unset label
        if (q == 1) { do for [f = 1:words(shown)] { set label title(word(shown, f)) at graph 0, first 7 * f - 0.9 left font ",12" } }
        if (q == 3) {
            do for [f = 1:words(shown)] { do for [k = 1:words(letters)] {
                set label word(letters, k) at graph 1.02, first 7 * (f - 1) + k left font ",9" textcolor rgb "#444444" } }
        }
        if (q == 3 && p == 2) {
            set colorbox user origin 0.10,0.022 size 0.80,0.008 horizontal
            set label "Digit: the order, rounded, up to the next digit; <: below −1.5; >: above 3.5." at screen 0.04,0.057 font ",12"
            set label "×: too few neighbours, or a singular system." at screen 0.04,0.047 font ",12"
            set label "Kernels: Gauss; B3, B5: splines of degree 3 and 5; W2, W4: Wendland's C² and C⁴." at screen 0.04,0.037 font ",12"
            set cbtics ("≤ −1.5" -1.5, "−1" -1, "0" 0, "1" 1, "2" 2, "≥ 3" 3) scale 0
        }
        plot table using (at_smoothing(p)):(height(0)):(0.5 * step):(0.5): \
                         (bounded(column(word(quantities, q)))) with boxxyerror linecolor palette, \
             table using (at_change(p, q)):(height(0)):(rounded(column(word(quantities, q)))):(ink(column(word(quantities, q)))) \
                         with labels font ",9" textcolor rgb variable, \
             table using (known(q) ? NaN : at_smoothing(p)):(height(0)) with points pointtype 2 pointsize 0.4 linecolor rgb "#555555"
    }
}
unset multiplot
