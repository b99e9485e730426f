// Figures 1 to 3 of Asprone et al. (2010), of whatever formulation, kernel, smoothing length and function. The curves with the paper's
// settings stay behind in grey.
const grey = { color: "#c9c9c9", width: 4, dash: "" };

// Rows of one formulation as points of a curve.
const points = (rows, name, x, y) => rows.filter((row) => row.formulation === name).map((row) => [x(row), y(row)]);
const names = (rows) => [...new Set(rows.map((row) => row.formulation))];
const extremes = (curves, k, log) => {
    const all = curves.flatMap((curve) => curve.points.map((point) => point[k])).filter((value) => Number.isFinite(value) && (!log || value > 0));
    return all.length > 0 ? all.reduce(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [Infinity, -Infinity]) : [log ? 0.1 : 0, 1];
};
const decades = ([least, most]) => ({ least: 10 ** Math.floor(Math.log10(least)), most: 10 ** Math.ceil(Math.log10(most)) });

// The rows of a table that most changes leave as it is: computed once.
const remembered = {};
async function known(answer, words) {
    const key = words.join("\n");
    return (remembered[key] ||= read((await answer(words)).table).rows);
}
// The table with the paper's options but for some.
const paper = (page, answer, same) => known(answer, page.words(Object.keys(page.made).filter((key) => !same.includes(key))));

// Errors against the number of particles. \param column of the error, and of its order
function errors(heading, column, label) {
    return async (page, answer) => {
        const words = page.words(), answered = await answer(words), { rows } = read(answered.table);
        const printed = words.join() === page.words(["smoothing", "kernel", "volumes", "perturb", "seed", "function"]).join() ? rows : await paper(page, answer, ["formulation", "particles"]);
        const error = column(page), order = error.replace("error", "order");
        const of = (table, name) => points(table, name, (row) => number(row.particles), (row) => number(row[error]));
        const curves = [
            ...names(printed).map((name) => ({ style: grey, back: true, points: of(printed, name) })),
            ...names(rows).map((name) => ({ style: styles[name], points: of(rows, name) })),
        ];
        const [fewest, most] = extremes(curves, 0, true), N = [...new Set(rows.map((row) => number(row.particles)))];
        page.show(words, {}, answered);
        for (const [name, note] of Object.entries(page.made.formulation.notes)) {
            const last = rows.filter((row) => row.formulation === name && row[order]).pop();
            note.textContent = last ? last[order].replace("-", "−") : "";
        }
        draw(page.figure, heading(page), { label: "number of particles N", log: true, least: 0.9 * fewest, most: 1.1 * most, marks: N.length > 0 && N.length < 9 ? N : undefined },
            { label: label(page), log: true, ...decades(extremes(curves, 1, true)) }, curves);
    };
}

const N = { option: "--particles", label: "numbers of particles N", kind: "text", size: 26, standard: "10,20,40,80,160,320,640", usual: "" };
const pages = {
    figure_1: {
        program: "derivative_test",
        options: {
            ...onALine, particles: N,
            function: { option: "--function", label: "function B(x)", kind: "text", size: 20, example: "exp(x)", standard: "" },
            derivative: { label: "error of", kind: "choice", values: ["second", "first"], names: { second: "D²B", first: "DB" }, standard: "second" },
        },
        redraw: errors((page) => `Derivative test, B = ${page.value("function") || "eˣ"}`, (page) => "error_" + page.value("derivative"),
            (page) => (page.value("derivative") === "second" ? "max |D²B − B″|" : "max |DB − B′|")),
    },
    figure_2: {
        program: "static_test",
        options: {
            ...onALine, particles: N,
            function: { option: "--displacement", label: "exact displacement u(x)", kind: "text", size: 20, example: "-exp(x)+e*x+1", standard: "" },
        },
        redraw: errors((page) => `Static test, ${page.value("function") ? "u = " + page.value("function") : "load eˣ"}`, () => "error_displacement", () => "max |u − exact u|"),
    },
    figure_3: {
        program: "vibration_test",
        options: {
            ...onALine, formulation: { option: "--formulation", label: "formulations", kind: "several", values: [...formulations, "fem_lumped", "fem_consistent", "definite_fpm"],
                standard: [...formulations, "fem_lumped", "fem_consistent"].join() },
            particles: { option: "--particles", label: "number of particles N", kind: "range", least: 5, most: 300, step: 1, standard: "100" },
            symbol: { label: "grey bands", kind: "choice", values: ["paper", "symbol"], names: { paper: "the paper's settings", symbol: "symbol of D² on an infinite lattice" }, standard: "paper" },
        },
        redraw: async (page, answer) => {
            const words = page.words(), answered = await answer(words), { rows: all, comments } = read(answered.table);
            // Of several numbers of particles, the last.
            const rows = all.filter((row) => row.particles === all[all.length - 1].particles);
            const theory = page.value("symbol") === "symbol", changed = words.join() !== page.words(["smoothing", "kernel", "volumes", "perturb", "seed", "particles"]).join();
            const behind = theory || !changed ? rows : await paper(page, answer, ["formulation"]);
            const place = (row) => number(row.mode) / number(row.particles);
            const curves = [
                ...names(behind).map((name) => ({ style: grey, back: true, points: points(behind, name, place, (row) => number(theory ? row.ratio_symbol : row.ratio)) })),
                ...names(rows).map((name) => ({ style: styles[name], every: 8, points: points(rows, name, place, (row) => number(row.ratio)) })),
            ];
            page.show(words, {}, answered);
            const complex = comments.find((comment) => comment.startsWith("frequencies that are not real")) || "";
            page.note.textContent = complex.replace(/(\w+), \d+ particles(?:, seed \d+)? (\d+ of \d+)/g, (all, name, count) => `${titled(name)} ${count}`) +
                (theory && !rows.some((row) => row.ratio_symbol) ? " Particles that do not lie on a lattice have no symbol." : "");
            const [, most] = extremes(curves, 1, false);
            draw(page.figure, `Vibration test, ${rows.length > 0 ? rows[0].particles : "no"} particles`, { label: "mode n / number of particles N", least: 0, most: 1 },
                { label: "ωₙ / (π n)", least: 0, most: Math.min(3, Math.max(1.3, 1.05 * most)) }, curves);
        },
    },
};
