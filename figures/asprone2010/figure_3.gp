# Figure 3 of Asprone et al. (2010): frequencies over exact frequencies for 100 particles. Beyond the print: FPM applied twice,
# the SSPH basis of Batra and Zhang (2008), the consistent mass matrix of the finite
# elements, and in grey the theory: the symbol of each D² on an infinite lattice.
curve_column = "formulation"; x_column = "particles"; y_column = "ratio"
load "figures/style.gp"
if (user) {
    set title "Vibration test: normalised spectrum, " . values . " particles" . parameters_below noenhanced font ",12"
} else {
    table = "data/asprone2010/figure_3.csv"
    set title "Vibration test: normalised spectrum, 100 particles" . \
        beyond("FPM applied twice, SSPH, the consistent mass, the symbols")
    set label "Curves that lie on each other: Chen–Beraun, modified FPM, second-order FPM;\noriginal SPH, RKPM of first order, FPM." \
        at 0.02,0.18 textcolor rgb "#444444" font ",12"
}
eval(picture(640, 640)); set key maxrows 6
set xrange [0:1]
set yrange [0:(user && y_most > 1.25 ? 1.05 * y_most : 1.3)]
set xlabel "mode n / number of particles N"
set ylabel "ωₙ / (π n)"
if (!user) { curves = "fem_consistent fem_lumped chen_beraun modified_fpm second_order_fpm rkpm_second_order original rkpm_first_order fpm ssph" }
every_mode = user && x_most < 50  # or a symbol at every sixteenth
# The theory knows the formulations on a lattice; a table of your own may have none.
on_lattice = ""; lattice = !user
if (user) { stats table using (lattice = lattice || column("ratio_symbol") >= 0, 0) nooutput }
do for [name in curves] { if (lattice && name[1:4] ne "fem_") { on_lattice = on_lattice . " " . name } }
theory = on_lattice eq "" ? "" : 'for [name in on_lattice] table using (of(name) * column("mode") / column("particles")):"ratio_symbol" with lines linecolor rgb "#d5d5d5" linewidth 5 notitle,'
theory_key = on_lattice eq "" ? "" : ', keyentry with lines linecolor rgb "#d5d5d5" linewidth 5 title "symbol of D², infinite lattice"'
plot @theory \
     for [name in curves] table using (of(name) * column("mode") / column("particles")):"ratio" \
         with lines linestyle style(name) notitle, \
     for [name in curves] table using (of(name) * marked(name, column("mode"), every_mode ? 1 : 16) * column("mode") / column("particles")):"ratio" \
         with points linestyle style(name) notitle, \
     for [name in curves] keyentry with linespoints linestyle style(name) title title(name) @theory_key
