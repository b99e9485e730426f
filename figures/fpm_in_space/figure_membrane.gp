# Frequencies of a membrane over the exact ones, in order, on a grid and on perturbed particles; in grey the theory, the symbols
# on an infinite lattice. With the numbers of complex pairs. Figure 3 of Asprone et al. (2010) with one more coordinate.
curve_column = "formulation"; x_column = "particles"; y_column = "ratio"
load "figures/style.gp"
if (!user) {
    table = "data/fpm_in_space/membrane.csv"; perturbations = "0 0.25"
    curves = "original ssph cubic_ssph fem_consistent fem_lumped definite_fpm"
}
panels = words(perturbations)
at(name, p) = strcol("formulation") eq name && strcol("perturbation") eq p ? 1 : NaN
all = 0.0  # modes of one curve
stats table using (side = column("particles"), all = all + (at(word(curves, 1), word(perturbations, 1)) == 1), 0) nooutput
# Of a complex pair, the frequency with a positive imaginary part; those without a real part are no pair.
pair(name, p) = at(name, p) == 1 && column("frequency_imaginary") > 0 && column("frequency") > 0
count(name, p) = sprintf("pairs = 0; stats table using (pairs = pairs + pair('%s', '%s'), 0) nooutput", name, p)
do for [name in curves] {
    counts = ""
    do for [p in perturbations] { eval(count(name, p)); counts = counts . (counts eq "" ? "" : ", ") . pairs }
    eval("pairs_" . name . " = counts")
}
titled(name) = title(name) . ": " . value("pairs_" . name)
step = all < 100 ? 1 : int(all / 8)
# Finite elements have no symbol here, and perturbed particles none at all.
on_lattice = ""
do for [name in curves] { if (name[1:4] ne "fem_") { on_lattice = on_lattice . " " . name } }
shows_theory = on_lattice ne "" && with_word(perturbations, "0") eq perturbations ? "yes" : ""
place(name, p) = at(name, p) * column("mode") / all
theory = 'for [name in on_lattice] table using (place(name, p)):"ratio_symbol" with lines linestyle 40'
measured = 'for [name in curves] table using (place(name, p)):"ratio" with lines linestyle style(name), \
    for [name in curves] table using (place(name, p) * marked(name, column("mode"), step)):"ratio" with points linestyle style(name)'
set style line 40 linecolor rgb "#d0d0d0" linewidth 5
eval(picture(720, 570))
set multiplot title sprintf("Frequencies%s on %d particles along a side, over the exact ones", user ? "" : " of a membrane", side) . \
    (user ? "\n{/=12 kernel " . comment("# kernel ") . "}" : "")
set xrange [0:1]; set xtics 0.25
set yrange [0:(user && y_most > 1.25 ? 1.05 * y_most : 1.4)]
set xlabel "mode / number of modes"
set tmargin at screen (user ? 0.84 : 0.87); set bmargin at screen 0.34
unset key
do for [k = 1:panels] {
    p = word(perturbations, k)
    set lmargin at screen 0.1 + 0.45 * (k - 1); set rmargin at screen (k == panels ? 0.97 : 0.52)
    set title (p eq "0" ? "grid" : moved_by(p)) font ",13" offset 0,-0.5
    set ylabel (k == 1 ? "ω / exact ω" : "")
    set format y (k == 1 ? "%g" : "")
    eval("plot " . (p eq "0" && on_lattice ne "" ? theory . ", " : "") . measured)
}
# The key, in a plot of its own.
set tmargin at screen 0.2; set bmargin at screen 0; set lmargin at screen 0.05; set rmargin at screen 0.95
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset grid; unset label
set yrange [1:10]
set label 1 (panels > 1 ? "Numbers of complex pairs, left and right:" : "Numbers of complex pairs:") at screen 0.06,0.212 font ",13"
set key at screen 0.05,0.195 left top vertical Left reverse maxrows 4 width 1 samplen 3.5 spacing 1.15 font ",13"
plot for [name in curves] NaN with linespoints linestyle style(name) title titled(name), \
     for [name in shows_theory] NaN with lines linestyle 40 title "symbol, infinite lattice"
unset multiplot
