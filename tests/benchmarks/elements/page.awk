# Writes the table of a page: the seconds in which each method reaches an error, interpolated between its grids in logarithms.
# Use: awk -v table=TABLE -f page.awk PAGE
function reached(problem, name, measure, level,    k, e, t, before, seconds) {
    for (k = 1; k <= count[problem, name]; ++k) {
        e = log(error[measure, problem, name, k])
        t = log(cost[problem, name, k])
        if (e <= log(level)) {
            seconds = k == 1 ? exp(t) : exp(time + (t - time) * (before - log(level)) / (before - e))
            return (k == 1 ? "≤ " : "") sprintf("%.2g", seconds)
        }
        before = e
        time = t
    }
    return count[problem, name] == 0 ? "" : "—"
}
function line(name, title,    cells, k) {
    cells = "| " title " |"
    for (k = 1; k <= columns; ++k) cells = cells " " reached(problem[k], name, measure[k], level[k]) " |"
    print cells
}
function column(what, which, how, limit) {
    problem[++columns] = which
    measure[columns] = how
    level[columns] = limit
    head = head " " what " |"
    rule = rule " --- |"
}
BEGIN {
    FS = ","
    while ((getline < table) > 0) {
        if (/^(#|problem)/) continue
        k = ++count[$1, $2 $3]
        error["L2", $1, $2 $3, k] = 10 ^ $6
        error["local", $1, $2 $3, k] = $7
        cost[$1, $2 $3, k] = $8
    }
    head = "| seconds for an error of |"
    rule = "| --- |"
    column("plate, 10⁻²", "plate", "L2", 1e-2)
    column("10⁻³", "plate", "L2", 1e-3)
    column("hole, 10⁻³", "hole", "L2", 1e-3)
    column("10⁻⁴", "hole", "L2", 1e-4)
    column("stress, 1 %", "hole", "local", 1e-2)
    column("0.1 %", "hole", "local", 1e-3)
    column("Poisson, 10⁻⁴", "poisson", "L2", 1e-4)
    column("10⁻⁵", "poisson", "L2", 1e-5)
    column("flux, 0.1 %", "poisson", "local", 1e-3)
}
/the table of elements is written by make elements/ {
    print
    print head
    print rule
    line("elements1", "linear triangles")
    line("elements2", "quadratic triangles")
    line("hats2", "`hats`, m = 2")
    line("hats3", "`hats`, m = 3")
    line("strong2", "`strong`, m = 2")
    line("strong3", "`strong`, m = 3")
    line("weak12", "`weak1`, m = 2")
    line("weak22", "`weak2`, m = 2")
    line("fpm", "second-order FPM, `fpm`")
    inside = 1
}
/end of the table of elements/ { inside = 0 }
!inside
