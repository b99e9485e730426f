# One look for every figure: the same formulation has the same colour, dash and symbol wherever it appears. Colours keep
# apart in grey; dashes and symbols do without colour.
# A figure's script loads this file, and is given the file to write as `output`. Indices are letters of their own, as in x₁:
# some programs drop a blank behind a lowered letter.
if (!exists("output")) output = "figure.svg"
# Pages show a picture as narrow as 400: letters of 14 on one of 640 to 720 are legible there.
picture(width, height) = sprintf("set terminal svg size %d,%d font 'Helvetica,14' background rgb 'white' \
    linewidth 1.2 dashlength 0.7", width, height)
eval(picture(640, 520))
set output output
set datafile separator comma
set datafile columnheaders
set datafile missing NaN
set encoding utf8
set minussign

set border 3 linecolor rgb "#444444"
set tics nomirror textcolor rgb "#222222"
set grid linecolor rgb "#dddddd" linewidth 0.6 dashtype 1
set key below center vertical Left reverse maxrows 4 width -4 height 1 samplen 3.5 spacing 1.25
# Below a title: what the print does not show.
beyond(text) = "\n{/=12 Not in the print: " . text . ".}"

names = "original chen_beraun rkpm_first_order rkpm_second_order fpm modified_fpm second_order_fpm fem_lumped fem_consistent ssph definite_fpm cubic_ssph literal_modified_fpm literal_second_order_fpm literal_fpm_by_derivatives"
title_original          = "original SPH"
title_chen_beraun       = "Chen–Beraun"
title_rkpm_first_order  = "RKPM, first order"
title_rkpm_second_order = "RKPM, second order"
title_fpm               = "FPM, applied twice"
title_modified_fpm      = "modified FPM"
title_second_order_fpm  = "second-order FPM"
title_fem_lumped        = "linear FEM, lumped mass"
title_fem_consistent    = "linear FEM, consistent mass"
title_ssph              = "SSPH, second degree"
title_definite_fpm      = "second-order FPM, definite"
title_cubic_ssph        = "SSPH, third degree"
title_literal_modified_fpm     = "modified FPM, word by word"
title_literal_fpm_by_derivatives = "modified FPM by derivatives of W"
title_literal_second_order_fpm = "second-order FPM, word by word"
# A name without a title stands for itself.
plain(name) = strstrt(name, "_") == 0 ? name : name[1:strstrt(name, "_") - 1] . "\\_" . plain(name[strstrt(name, "_") + 1:*])
title(name) = exists("title_" . name) ? value("title_" . name) : plain(name)

# The style of a formulation is its place in the list; a name that is not there has the style behind the last.
listed(name) = strstrt(" " . names . " ", " " . name . " ")
style(name) = listed(name) == 0 ? words(names) + 1 : words(substr(" " . names . " ", 1, listed(name))) + 1
set style line 1 linecolor rgb "#000000" dashtype 1       pointtype 4  pointsize 0.7 linewidth 1.3
set style line 2 linecolor rgb "#b35900" dashtype (8,3)   pointtype 8  pointsize 0.8 linewidth 1.3
set style line 3 linecolor rgb "#b8669f" dashtype (2,2)   pointtype 6  pointsize 0.7 linewidth 1.6
set style line 4 linecolor rgb "#cf9400" dashtype (8,3,2,3) pointtype 10 pointsize 0.8 linewidth 1.6
set style line 5 linecolor rgb "#7a6fb0" dashtype (3,2)   pointtype 1  pointsize 0.8 linewidth 1.3
set style line 6 linecolor rgb "#3a9bdc" dashtype (12,4)  pointtype 12 pointsize 0.9 linewidth 1.6
set style line 7 linecolor rgb "#005a3c" dashtype 1       pointtype 7  pointsize 0.6 linewidth 2.0
set style line 8 linecolor rgb "#555555" dashtype 1       pointtype 2  pointsize 0.7 linewidth 1.3
set style line 9 linecolor rgb "#888888" dashtype (6,3)   pointtype 3  pointsize 0.7 linewidth 1.2
set style line 10 linecolor rgb "#c0392b" dashtype (10,3,2,3,2,3) pointtype 14 pointsize 0.8 linewidth 1.5
set style line 11 linecolor rgb "#00695c" dashtype (9,3)   pointtype 9  pointsize 0.8 linewidth 2.0
set style line 12 linecolor rgb "#7b4fa3" dashtype (4,3)   pointtype 5  pointsize 0.7 linewidth 1.5
set style line 13 linecolor rgb "#3a9bdc" dashtype (12,4)  pointtype 12 pointsize 0.9 linewidth 1.5
set style line 14 linecolor rgb "#b35900" dashtype (8,3,2,3) pointtype 8 pointsize 0.9 linewidth 1.5
set style line 15 linecolor rgb "#888888" dashtype (3,2)   pointtype 10 pointsize 0.9 linewidth 1.5

# Rows of one formulation; others are passed over. Curves that overlap carry their symbols at different rows, so that each
# shows: marked(name, row, every) picks them.
of(name) = strcol("formulation") eq name ? 1 : NaN
marked(name, row, every) = row == row && (int(row) + 3 * style(name)) % every == 0 ? 1 : NaN

# A triangle of slope −order in logarithmic axes, its right angle at the lower left of (N, e).
# Use: eval(triangle(tag, N, e, factor, order))
triangle(tag, N, e, factor, order) = sprintf("\
set object %d polygon from %g,%g to %g,%g to %g,%g to %g,%g fillstyle empty border linecolor rgb '#666666' linewidth 1; \
set label %d '%d' at %g,%g right offset -0.4,0 textcolor rgb '#666666'; \
set label %d '1' at %g,%g center offset 0,-0.7 textcolor rgb '#666666'", \
    tag, N, e, N, e * factor**order, N * factor, e, N, e, \
    tag, order, N, e * factor**(order / 2.0), \
    100 + tag, N * sqrt(factor), e)

# The methods of Batra and Zhang (2008), and the exact solution. Formulations have the numbers up to 20.
methods = "strong weak1 weak2"
set style line 31 linecolor rgb "#c8501e" dashtype (8,3)  pointtype 4  pointsize 0.8 linewidth 1.5
set style line 32 linecolor rgb "#12507b" dashtype 1      pointtype 7  pointsize 0.7 linewidth 1.8
set style line 33 linecolor rgb "#3aa078" dashtype (3,2)  pointtype 8  pointsize 0.9 linewidth 1.6
set style line 35 linecolor rgb "#6b2f8a" dashtype (10,3,2,3) pointtype 5 pointsize 0.7 linewidth 1.6
set style line 34 linecolor rgb "#c4c4c4" dashtype 1      linewidth 5  # a band on which the curves lie
# The formulation fpm of the first paper is another.
method_title(name) = name eq "fpm" ? "second-order FPM" : name
method_style(name) = name eq "strong" ? 31 : name eq "weak1" ? 32 : name eq "weak2" ? 33 : name eq "fpm" ? 35 : 34
method(name) = strcol("method") eq name ? 1 : NaN
one_row = "set key maxrows 1 width -1 samplen 3"

# Colours for a quantity that grows, and for one that has two signs: in both, lightness says as much as colour.
sequential = "set palette defined (0 '#fdf3d8', 0.25 '#e5b58a', 0.5 '#bf7772', 0.75 '#7d4273', 1 '#2a1e4f')"
diverging = "set palette defined (-1 '#0b2545', -0.5 '#35608f', 0 '#8f8f8b', 0.5 '#dcb46e', 1 '#fff6d5')"

# A table of your own: gnuplot -e "table='FILE'; output='FILE'" figures/asprone2010/figure_1.gp. Without `table`
# a script draws the paper's. A script that can draw more than the paper's case names the columns of its curves,
# x and y before it loads this file. Here they are read from the table: curves, values of x and perturbations in
# the order of their rows, and the ranges x_least to x_most, y_least to y_most. Where y is logarithmic, only
# positive ones count.
user = exists("table")
if (!exists("signed")) signed = 0
curves = ""; values = ""; perturbations = ""; comments = ""; columns = ""
x_least = 1e300; x_most = -1e300; y_least = 1e300; y_most = -1e300
with_word(list, w) = strstrt(" " . list . " ", " " . w . " ") > 0 ? list : list eq "" ? w : list . " " . w
# Of an a that is no number, b.
least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b
note_line(line) = line[1:1] eq "#" ? (comments = comments . line . "\n", 0) \
                                   : (columns = columns eq "" ? line : columns, 0)
note(x, y) = (y > 0 || (signed && y <= 0)) && \
    (curves = with_word(curves, strcol(curve_column)), \
     values = strlen(values) < 9999 ? with_word(values, strcol(x_column)) : values, \
     x_least = least(x, x_least), x_most = most(x, x_most), \
     y_least = least(y, y_least), y_most = most(y, y_most), \
     perturbations = has("perturbation") ? with_word(perturbations, strcol("perturbation")) : "", 0)
has(name) = !user || strstrt("," . columns . ",", "," . name . ",") > 0
# The rest of the line behind a mark in the table's comments; empty without the mark.
rest_of_line(text) = text[1:strstrt(text, "\n") - 1]
comment(mark) = strstrt(comments, mark) > 0 ? \
                rest_of_line(comments[strstrt(comments, mark) + strlen(mark):*]) : ""
if (user && exists("y_column")) {
    set datafile separator "\n"; set datafile commentschars ""; unset datafile columnheaders
    stats table using (note_line(strcol(1))) nooutput
    set datafile separator comma; set datafile commentschars; set datafile columnheaders
    stats table using (note(column(x_column), column(y_column))) nooutput
    if (columns eq "") { exit error "cannot draw " . table . ": it cannot be read, or has no row of column names" }
    if (curves eq "") {
        exit error "there is nothing to draw: no " . y_column . (signed ? " is a number" : " is positive")
    }
}
# The parameters of the numerical tests, where they are not the paper's.
parameters = comment("# kernel ")
if (parameters eq "gaussian, h/delta 1, volumes equal") parameters = ""
parameters_below = parameters eq "" ? "" : "\nkernel " . parameters
# In the key of a user's table: the order of each curve, the slope by least squares of log(e) against log(δ), as the
# tables have it. A triangle could lie on another curve.
# Use: eval(observe(name, "1/δ", "e")), 1/δ and e columns' expressions, before axes have ranges; then titled(name).
add(x, y) = x == x && y > 0 ? \
    (n = n + 1, sx = sx + x, sy = sy + log(y), sxx = sxx + x * x, sxy = sxy + x * log(y), 0) : 0
spread(n, sx, sxx) = n * sxx - sx * sx
order(o) = ": order " . (o < -0.005 ? "−" : "") . sprintf("%.2f", abs(o))
observe(name, N, e) = sprintf("n = 0; sx = 0.0; sy = 0.0; sxx = 0.0; sxy = 0.0; \
    stats table using (add(log(%s), %s)) nooutput; \
    order_%s = spread(n, sx, sxx) > 1e-6 * sxx ? order((sx * sy - n * sxy) / spread(n, sx, sxx)) : ''", N, e, name)
order_of(name) = exists("order_" . name) ? value("order_" . name) : ""
titled(name) = title(name) . order_of(name)
decade_below(y) = 10**floor(log10(y) - 1e-9)
decade_above(y) = 10**ceil(log10(y) + 1e-9)
# Rows of a formulation with one perturbation; of particles from a file no perturbation is known.
row(name, p) = of(name) * (p eq "" || strcol("perturbation") eq p ? 1 : NaN)
moved_by(p) = p eq "" ? "particles of a file" : p eq "0" ? "uniform particles" : "particles perturbed by " . p . " δ"
# A symbol at each of a few numbers of particles, at every fourth of many.
symbols = user && words(values) < 13 ? 1 : 4
# The numbers of particles N on an axis: all of a few, else the paper's and on in doublings.
set_N = "set xrange [9:3000]; set xtics (10, '' 20, 40, '' 80, 160, '' 320, 640, '' 1280, 2560)"
if (user) {
    set_N = sprintf("set xrange [%g:%g]; set xtics (", 0.9 * x_least, 1.1719 * x_most)
    if (words(values) < 9) { do for [k = 1:words(values)] { set_N = set_N . (k > 1 ? ", " : "") . word(values, k) } }
    else { do for [k = 0:14] { set_N = set_N . (k > 0 ? ", " : "") . sprintf(k % 2 ? "'' %d" : "%d", 10 * 2**k) } }
    set_N = set_N . ")"
}
