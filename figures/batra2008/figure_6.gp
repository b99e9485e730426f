# Figure 6 of Batra and Zhang (2008): axial stress along the top edge, 16 × 4 particles, ρ = 3.
load "figures/style.gp"
if (!exists("table")) table = "data/batra2008/figure_6.csv"
set title "Axial stress along the top edge, 16 × 4 particles"
set xlabel "x₁ in m"
set ylabel "σ₁₁ L₂ / F₀"
eval(one_row)
plot table using (method("weak1") * column("x1")):(column("s11_exact") * 0.2 / 1e6) with lines linestyle 34 title "exact", \
     for [name in methods] table using (method(name) * column("x1")):(column("s11") * 0.2 / 1e6) \
         with linespoints linestyle method_style(name) pointinterval 10 title name
