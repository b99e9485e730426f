# Figure 4 of Batra and Zhang (2008): the plate as it deforms, displacements a hundred times enlarged, exact and by three
# methods with 16 × 4 particles. In colour beyond the print: the axial stress on the left, the displacement u2 on the right.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_4.csv"
eval(picture(720, 820))
# A block for each column of the grid, as surfaces need: columns x1, x2, u1, u2, s11.
first = system("awk -F, '!/^#/ { for (k = 1; k <= NF; ++k) if ($k == \"x1\") { print k; exit } }' " . table)
states(name) = sprintf("< awk -F, -v c=%s -v m=%s '/^#/ || !n++ { next } $1 == (m == \"exact\" ? \"weak1\" : m) \
    { if (p != \"\" && p != $c) print \"\"; p = $c; e = m == \"exact\" ? 5 : 0; \
      print $c \",\" $(c + 1) \",\" $(c + 2 + e) \",\" $(c + 3 + e) \",\" $(c + 4 + e) }' %s", first, name, table)
unset datafile columnheaders
set view map
set size ratio -1
unset border; unset tics; unset grid; unset key
set xrange [-0.02:1.08]
set yrange [-0.02:0.52]
eval(sequential)
names = "exact strong weak1 weak2"
set multiplot title "The plate, displacements enlarged a hundred times; 16 × 4 particles" . beyond("the colours")
do for [k = 1:4] {
    name = word(names, k)
    top = 0.87 - 0.20 * (k - 1)
    set tmargin at screen top; set bmargin at screen top - 0.19
    set label 1 name at graph 0.02,0.85 front
    set lmargin at screen 0.01; set rmargin at screen 0.49
    set cbrange [-30:30]
    eval(diverging)
    if (k == 1) { set label 2 "axial stress σ₁₁ L₂ / F₀" at graph 0.5,1.08 center front } else { unset label 2 }
    if (k == 4) { set colorbox user origin 0.07,0.045 size 0.34,0.018 horizontal; set cbtics 15 } else { unset colorbox }
    splot states(name) using ($1 + 100 * $3):($2 + 100 * $4):($5 * 0.2 / 1e6) with pm3d
    set lmargin at screen 0.51; set rmargin at screen 0.99
    set cbrange [0:3]
    eval(sequential)
    if (k == 1) { set label 2 "displacement u₂ in mm" at graph 0.5,1.08 center front }
    if (k == 4) { set colorbox user origin 0.57,0.045 size 0.34,0.018 horizontal; set cbtics 1 }
    splot states(name) using ($1 + 100 * $3):($2 + 100 * $4):($4 * 1000) with pm3d
    unset label 1
}
unset multiplot
