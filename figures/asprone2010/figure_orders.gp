# Map of orders: formulations, in each the five kernels, against h/δ; on particles at equal distances and on perturbed ones.
# White squares: too few neighbours, or a singular system.
curve_column = "formulation"; x_column = "smoothing"; y_column = "order_second"; signed = 1
load "figures/style.gp"
if (!exists("table")) table = "data/asprone2010/orders.csv"
set terminal svg size 1000,1180 font "Helvetica,13" background rgb "white" linewidth 1
shown = "original rkpm_first_order rkpm_second_order chen_beraun fpm modified_fpm ssph second_order_fpm"
kernels = "gaussian cubic_spline quintic_spline wendland_c2 wendland_c4"
letters = "Gauss B3 B5 W2 W4"
place(list, name) = words(substr(list, 1, strstrt(list . " ", name . " ")))
row(f, k) = 6 * (place(shown, f) - 1) + place(kernels, k)
bounded(order) = order < -1.5 ? -1.5 : order > 3 ? 3 : order
set palette defined (-1.5 "#5e2750", -1 "#8c3f5d", 0 "#e08e6d", 0.5 "#f3d9b1", 1 "#9ccfd8", 2 "#0b6e4f", 3 "#04402d")
set cbrange [-1.5:3]
unset grid
set border 0
if (!user) { x_least = 0.6; x_most = 4 }
step = words(values) > 1 ? word(values, 2) - word(values, 1) : 0.2
set xrange [x_least - 0.75 * step:x_most + 0.75 * step]; set yrange [0:48.6]
if (user) { set xtics autofreq scale 0 } else { set xtics 1, 1, 4 scale 0 }
unset key
unset colorbox
set ytics scale 0
set style fill solid 1 noborder

set multiplot
quantities = "order_first order_second order_displacement"
titles = "'order of DB' 'order of D²B' 'order of u'"
do for [p = 1:2] {
    do for [q = 1:3] {
        set lmargin at screen 0.19 + 0.265 * (q - 1); set rmargin at screen 0.43 + 0.265 * (q - 1)
        set tmargin at screen 0.965 - 0.465 * (p - 1); set bmargin at screen 0.565 - 0.465 * (p - 1)
        set title word(titles, q) . (p == 1 ? ", equal distances" : ", perturbed by δ/4") offset 0,-0.6
        set xlabel (p == 2 ? "h/δ" : "") offset 0,0.6
        unset ytics; unset label
        if (q == 1) {
            do for [f = 1:words(shown)] { set label title(word(shown, f)) at graph -0.05, first 6 * (f - 1) + 3 right }
        }
        if (q == 3) {
            do for [f = 1:words(shown)] { do for [k = 1:5] {
                set label word(letters, k) at graph 1.02, first 6 * (f - 1) + k left font ",8" textcolor rgb "#666666" } }
        }
        if (q == 3 && p == 2) {
            set colorbox user origin 0.19,0.035 size 0.77,0.010 horizontal
            set cbtics ("≤ −1.5" -1.5, "−1" -1, "0" 0, "1" 1, "2" 2, "≥ 3" 3) scale 0
        }
        plot table using (column("perturbation") == (p - 1) * 0.25 ? column("smoothing") : NaN): \
                         (row(strcol("formulation"), strcol("kernel"))):(0.5 * step):(0.5): \
                         (bounded(column(word(quantities, q)))) with boxxyerror linecolor palette
    }
}
unset multiplot
