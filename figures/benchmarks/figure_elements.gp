# Finite elements beside particles, a column for each problem: errors against the seconds of one thread, then against unknowns. The
# seconds are those of one machine (make elements measures them anew).
load "figures/style.gp"
if (!exists("table")) table = "data/benchmarks/elements.csv"
eval(picture(720, 900))
curves = "elements1 elements2 hats2 hats3 strong2 strong3 weak12 weak22 fpm"
titles = "'linear triangles' 'quadratic triangles' 'hats, m = 2' 'hats, m = 3' 'strong, m = 2' 'strong, m = 3' 'weak1, m = 2' 'weak2, m = 2' 'second-order FPM'"
set style line 1 linecolor rgb "#000000" dashtype (8,3) pointtype 8 pointsize 0.7 linewidth 1.6
set style line 2 linecolor rgb "#000000" dashtype 1     pointtype 9 pointsize 0.7 linewidth 1.6
set style line 3 linecolor rgb "#7b4fa3" dashtype (8,3) pointtype 4 pointsize 0.6 linewidth 1.5
set style line 4 linecolor rgb "#7b4fa3" dashtype 1     pointtype 5 pointsize 0.6 linewidth 1.8
set style line 5 linecolor rgb "#c8501e" dashtype (8,3) pointtype 6 pointsize 0.6 linewidth 1.5
set style line 6 linecolor rgb "#c8501e" dashtype 1     pointtype 7 pointsize 0.5 linewidth 1.5
set style line 7 linecolor rgb "#3a9bdc" dashtype 1     pointtype 12 pointsize 0.8 linewidth 1.5
set style line 8 linecolor rgb "#3aa078" dashtype (3,2) pointtype 10 pointsize 0.7 linewidth 1.6
set style line 9 linecolor rgb "#00695c" dashtype (2,2) pointtype 2 pointsize 0.7 linewidth 1.6
# What each problem has been solved by. On the plate, whose displacement is a cubic, strong with m = 3 has the error of round-off.
problems = "plate hole poisson"
curves_plate = ""; curves_hole = ""; curves_poisson = ""
note_curve(problem, curve) = problem . curve eq "platestrong3" ? 0 : \
    problem eq "plate" ? (curves_plate = with_word(curves_plate, curve), 0) : \
    problem eq "hole" ? (curves_hole = with_word(curves_hole, curve), 0) : (curves_poisson = with_word(curves_poisson, curve), 0)
stats table using (note_curve(strcol("problem"), strcol("method") . strcol("degree"))) nooutput
number(curve) = words(substr(" " . curves . " ", 1, strstrt(" " . curves . " ", " " . curve . " "))) + 1
row(problem, curve) = strcol("problem") eq problem && strcol("method") . strcol("degree") eq curve ? 1 : NaN
stats table using (row("plate", "strong3") * most(column("local_error"), 10**column("log_error"))) nooutput
round_off = sprintf("strong, m = 3:\nbelow 10^{−%.0f}", -log10(decade_above(STATS_max)))

headings = "'plate' 'quarter with a hole' 'Poisson’s equation'"
local_errors = "'of u₂ at the lower edge' 'of stress at the hole' 'of flux at (0, ½)'"
set multiplot
set logscale xy
set format x "10^{%T}"
set yrange [2e-9:1]; set ytics (1, 1e-2, 1e-4, 1e-6, 1e-8, '' 1e-1 1, '' 1e-3 1, '' 1e-5 1, '' 1e-7 1)
unset key
do for [k = 1:3] {
    problem = word(problems, k); here = value("curves_" . problem)
    set lmargin at screen 0.115 + 0.3 * (k - 1); set rmargin at screen 0.38 + 0.3 * (k - 1)
    set format y (k == 1 ? "10^{%T}" : "")
    do for [part = 0:2] {
        set tmargin at screen 0.965 - 0.285 * part - 0.02 * (part == 2); set bmargin at screen 0.765 - 0.285 * part - 0.02 * (part == 2)
        set title (part == 0 ? word(headings, k) : part == 2 ? word(local_errors, k) : "") font ",13" offset 0,-0.6
        set ylabel (k > 1 ? "" : part == 2 ? "local error" : "L₂ error")
        set xlabel (part == 1 ? "unknowns" : "seconds") offset 0,0.5
        if (part == 1) { set xrange [60:1.5e5]; set xtics (1e2, 1e3, 1e4, 1e5) } else { set xrange [1e-3:12]; set xtics (1e-3, 1e-2, 1e-1, 1, '' 10) }
        if (problem eq "plate") { set label 1 round_off at graph 0.05,0.22 font ",12" textcolor rgb "#c8501e" } else { unset label 1 }
        plot for [c in here] table using (row(problem, c) * (part == 1 ? column("unknowns") : column("seconds"))): \
             (part == 2 ? column("local_error") : 10**column("log_error")) with linespoints linestyle number(c)
    }
}
# The key, in a plot of its own.
set tmargin at screen 0.1; set bmargin at screen 0; set lmargin at screen 0; set rmargin at screen 1
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset grid
set key at screen 0.06,0.1 left top vertical Left reverse maxrows 3 width 0 samplen 4 spacing 1.1 font ",13"
set yrange [1:10]
plot for [c = 1:words(curves)] NaN with linespoints linestyle c title word(titles, c)
unset multiplot
