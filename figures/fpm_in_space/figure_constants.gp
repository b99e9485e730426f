# Leading errors on lattices, by place and derivative: the sum of the absolute constants, from the stencils (bars) and as
# exponentials show it (circles). Pale bars are of another power than δ²:
# δ for second derivatives by SSPH of second degree, δ³ and inside δ⁴ for first ones by that of third degree.
load "figures/style.gp"
if (!exists("table")) table = "data/fpm_in_space/constants.csv"
eval(picture(720, 860))
shown = "definite_fpm ssph cubic_ssph literal_second_order_fpm"
# The bars from left to right, place by place.
bars_2_first = "inside1 edge1 edge2 corner1"
bars_2_second = "inside11 inside12 edge11 edge22 edge12 corner11 corner12"
bars_3_first = "inside1 face1 face2 edge1 edge3 corner1"
bars_3_second = "inside11 inside12 face11 face22 face12 face23 edge11 edge33 edge12 edge13 corner11 corner12"
places_2 = "inside edge corner"; places_3 = "inside face edge corner"
place_of(bar) = bar[1:1] eq "i" ? "inside" : bar[1:1] eq "f" ? "face" : bar[1:1] eq "e" ? "edge" : "corner"
number(list, w) = words(substr(" " . list . " ", 1, strstrt(" " . list . " ", " " . w . " "))) + 1
known(list, w) = strstrt(" " . list . " ", " " . w . " ") > 0
at(bar) = known(bars, bar) ? number(bars, bar) + 0.7 * number(places, place_of(bar)) : NaN
bar(name, d) = strcol("formulation") eq name && column("dimension") == d ? \
               at(strcol("place") . strcol("derivative")) + 0.2 * (number(shown, name) - 2.5) : NaN
of_order_two(name, d) = column("exponent") == 2 ? bar(name, d) : NaN
of_another(name, d) = column("exponent") == 2 ? NaN : bar(name, d)
low(i) = word("₁ ₂ ₃", int(i))
label(bar) = "∂" . low(bar[strlen(place_of(bar)) + 1:strlen(place_of(bar)) + 1]) . \
             (strlen(bar) > strlen(place_of(bar)) + 1 ? low(bar[strlen(bar):strlen(bar)]) : "")
set style line 20 linecolor rgb '#000000' pointtype 6 pointsize 0.5 linewidth 1
set multiplot title "Constants of the leading errors on lattices, h = δ: Σ |C| by place and derivative"
set logscale y
set yrange [0.03:2e4]
set mytics 1
set boxwidth 0.18
set border 3
set xtics scale 0
unset grid
set grid ytics linecolor rgb "#dddddd" linewidth 0.6 dashtype 1
unset key
do for [d = 2:3] { do for [second = 0:1] {
    bars = value(sprintf("bars_%d_%s", d, second ? "second" : "first")); places = value(sprintf("places_%d", d))
    middle = d == 2 ? 0.435 : 0.44
    set lmargin at screen (second ? middle + 0.015 : 0.105); set rmargin at screen (second ? 0.985 : middle)
    set tmargin at screen (d == 2 ? 0.905 : 0.5); set bmargin at screen (d == 2 ? 0.605 : 0.2)
    set xrange [1.1 : words(bars) + 0.7 * words(places) + 0.6]
    set format y (second ? "" : "10^{%T}")
    set ylabel (second ? "" : d == 2 ? "in the plane" : "in space")
    set title (second ? "second derivatives" : "first derivatives") font ",13" offset 0,-0.5
    set xtics ()
    unset label
    do for [b in bars] { eval(sprintf("set xtics add ('%s' %g)", label(b), at(b))) }
    do for [p in places] {
        sum = 0.0; count = 0
        do for [b in bars] { if (place_of(b) eq p) { sum = sum + at(b); count = count + 1 } }
        set label p at sum / count, graph -0.17 center font ",12"
    }
    if (second && d == 3) { set key at screen 0.53,0.065 center center maxrows 3 width -3 samplen 2 font ',13' }
    pale = second ? "ssph" : "cubic_ssph"
    solid = second ? shown : "definite_fpm ssph literal_second_order_fpm"
    plot for [name in solid] table using (of_order_two(name, d)):(abs(column("constant"))) smooth frequency \
             with boxes fillstyle solid 0.8 noborder linestyle style(name) notitle, \
         for [name in pale] table using (of_another(name, d)):(abs(column("constant"))) smooth frequency \
             with boxes fillstyle solid 0.2 border linestyle style(name) dashtype 1 linewidth 0.8 notitle, \
         for [name in shown] table using (bar(name, d)):(abs(column("measured"))) smooth frequency \
             with points linestyle 20 notitle, \
         for [name in shown] keyentry with boxes fillstyle solid 0.8 noborder linestyle style(name) title title(name), \
         keyentry with boxes fillstyle solid 0.2 border rgb "#555555" linecolor rgb "#555555" title "another power: δ, δ³ or δ⁴", \
         keyentry with points linestyle 20 title "as exponentials show it"
} }
unset multiplot
