# Figure 4 of Batra and Zhang (2008): the plate as it deforms, displacements a hundred times enlarged, exact and by three
# methods with 16 × 4 particles. In colour beyond the print: the axial stress on the left, the displacement u2 on the right.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_4.csv"
set terminal svg size 1120,1060 font "Helvetica,13" background rgb "white" linewidth 1.0
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
set multiplot title "The plate, displacements enlarged a hundred times; 16 × 4 particles"
do for [k = 1:4] {
    name = word(names, k)
    top = 0.93 - 0.215 * (k - 1)
    set tmargin at screen top; set bmargin at screen top - 0.205
    set label 1 name at graph 0.02,0.85 font ",15" front
    set lmargin at screen 0.02; set rmargin at screen 0.44
    set cbrange [-30:30]
    eval(diverging)
    if (k == 1) { set label 2 "axial stress σ_{11} L_2 / F_0" at graph 0.30,1.06 front } else { unset label 2 }
    if (k == 4) { set colorbox user origin 0.06,0.045 size 0.34,0.018 horizontal; set cbtics 15 } else { unset colorbox }
    splot states(name) using ($1 + 100 * $3):($2 + 100 * $4):($5 * 0.2 / 1e6) with pm3d
    set lmargin at screen 0.52; set rmargin at screen 0.94
    set cbrange [0:3]
    eval(sequential)
    if (k == 1) { set label 2 "displacement u_2 in mm" at graph 0.30,1.06 front }
    if (k == 4) { set colorbox user origin 0.56,0.045 size 0.34,0.018 horizontal; set cbtics 1 }
    splot states(name) using ($1 + 100 * $3):($2 + 100 * $4):($4 * 1000) with pm3d
    unset label 1
}
unset multiplot
