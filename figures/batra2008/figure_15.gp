# Figure 15 of Batra and Zhang (2008): the exact displacements of the quarter plate (top), and the deviations of the three methods from them
# with 188 particles. Each row has its own colours, between minus and plus its largest deviation.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_15.csv"
eval(picture(720, 1260))
first = system("awk -F, '!/^#/ { for (k = 1; k <= NF; ++k) if ($k == \"x1\") { print k; exit } }' " . table)
# A block for each ray: x1, x2, and computed minus exact displacements in mm, or the exact ones. A ray ends where the radius falls.
states(name) = sprintf("< awk -F, -v c=%s -v m=%s '/^#/ || !n++ { next } $1 == (m == \"exact\" ? \"weak1\" : m) \
    { r = $c * $c + $(c + 1) * $(c + 1); if (r < last) print \"\"; last = r; e = m == \"exact\" ? 0 : 1; \
      print $c \",\" $(c + 1) \",\" 1000 * (e ? $(c + 2) - $(c + 7) : $(c + 7)) \",\" 1000 * (e ? $(c + 3) - $(c + 8) : $(c + 8)) }' %s", first, name, table)
unset datafile columnheaders
set view map
set size ratio -1
unset border; unset tics; unset grid; unset key
rows = "exact strong weak1 weak2"
set multiplot title "Quarter plate with a hole, 188 particles: displacements in mm"
do for [k = 1:4] {
    name = word(rows, k)
    top = 0.945 - 0.235 * (k - 1)
    set tmargin at screen top; set bmargin at screen top - 0.205
    do for [component = 1:2] {
        index = component == 1 ? "₁" : "₂"
        set xrange [*:*]; set yrange [*:*]
        stats states(name) using (column(2 + component)) nooutput
        set xrange [-0.05:3.05]; set yrange [-0.05:3.05]
        largest = abs(STATS_min) > STATS_max ? abs(STATS_min) : STATS_max
        if (name eq "exact") {
            eval(sequential); set cbrange [STATS_min:STATS_max]
            set title sprintf("exact u%s", index) offset 0,-0.7
        } else {
            eval(diverging); set cbrange [-largest:largest]
            set title sprintf("%s: u%s − exact, up to %.3f", name, index, largest) offset 0,-0.7
        }
        set lmargin at screen 0.03 + 0.49 * (component - 1); set rmargin at screen 0.38 + 0.49 * (component - 1)
        set colorbox user origin 0.40 + 0.49 * (component - 1), top - 0.195 size 0.018,0.185
        set cbtics format "%.3g"
        splot states(name) using 1:2:(column(2 + component)) with pm3d
    }
}
unset multiplot
