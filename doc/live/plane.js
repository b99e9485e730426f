// A cloud of particles in the plane that can be moved: the error at each of them, or its quality number, by two formulations.
const numbers = { second: "error_second", laplacian: "error_laplacian", first: "error_first", quality: "quality" };
const inThePlane = ["definite_fpm", "ssph", "cubic_ssph", "literal_modified_fpm", "literal_fpm_by_derivatives", "literal_second_order_fpm"];

pages.plane = {
    program: "derivative_test_in_space",
    always: ["--states"],
    moves: ["particles", "perturb", "seed"],
    options: {
        formulation: { option: "--formulation", label: "formulations", kind: "several", values: inThePlane, standard: "definite_fpm,ssph" },
        show: { label: "colour", kind: "choice", values: Object.keys(numbers), names: { laplacian: "error of the Laplacian", second: "largest error of all second derivatives", first: "largest error of the first derivatives", quality: "quality number R" }, standard: "laplacian" },
        smoothing: { ...onALine.smoothing, least: 0.6, standard: "1.2" },
        from: { option: "--smoothing-from", label: "δ of h/δ", kind: "choice", values: ["mean", "largest", "local", "nearest", "8-nearest"], standard: "mean" },
        kernel: { option: "--kernel", label: "kernel W", kind: "choice", values: ["", ...kernels], names: { "": "Gaussian lowered to zero at 3.5 h" }, standard: "" },
        function: { option: "--function", label: "function B(x, y)", kind: "text", size: 22, example: "exp(x+y/2)+sin(x+2*y)", standard: "" },
        particles: { option: "--particles", label: "particles along a side", kind: "range", least: 5, most: 24, step: 1, standard: "14", usual: "" },
        perturb: { ...onALine.perturb, standard: "0.25", usual: "0" },
        seed: onALine.seed,
        particle: { label: "particle, from 0", kind: "whole", least: 0, most: 575, standard: "0" },
    },
    redraw: async (page, answer) => {
        const show = page.value("show"), chosen = Number(page.value("particle")), flag = show === "laplacian" ? ["--laplacian"] : [];
        const whole = [...page.words(), ...flag], ofCloud = ["--particles", "--perturb", "--seed"];
        // The cloud as the program has it, and what was moved in it.
        const grid = page.kept.move === "" ? [] : await known(answer, ["derivative_test_in_space", "--states", "--formulation", "definite_fpm", ...whole.flatMap((word, k) => (ofCloud.includes(word) ? [word, whole[k + 1]] : []))]);
        const there = placesOf(grid), moves = movesOf(page, there.length, 2);
        for (const [i, x] of moves) there[i] = x;
        const moved = moves.size > 0, files = moved ? { "/tmp/cloud.csv": there.map((x) => x.join() + "\n").join("") } : {};
        const words = moved ? [...page.words(page.moves), ...flag, "--layout", "/tmp/cloud.csv"] : whole;
        const answered = await answer(words, files), all = read(answered.table).rows.filter((row) => row.particle !== "");
        page.show(words, files, answered);
        // Of several numbers of particles, the last.
        const rows = all.filter((row) => row.particles === all[all.length - 1].particles);
        if (tooMany(page, rows.length) || rows.length === 0) return;
        const places = moved ? there : placesOf(rows), ofChosen = rows.filter((row) => Number(row.particle) === chosen);
        if (ofChosen.length > 0)
            page.note.textContent = `Particle ${chosen} at (${places[chosen].join(", ")}): ` + ofChosen.map((row) => `${titled(row.formulation)} ${number(row[numbers[show]]).toPrecision(4)}`).join(", ") + ".";
        drawClouds(page, places, chosen, rows, numbers[show]);
    },
};
// By the number of the particle, as the program printed them.
function placesOf(rows) {
    const places = [];
    for (const row of rows) places[Number(row.particle)] = [row.x, row.y];
    return places;
}

function drawClouds(page, places, chosen, rows, column) {
    const edge = 22, total = drawingWidth(page.figure), shownNames = names(rows), across = total < 560 ? 1 : Math.min(2, shownNames.length);
    const size = Math.floor(Math.min(460, total / across)), inner = size - 2 * edge, radius = 0.32 * inner / Math.sqrt(places.length);
    const [least, most] = extremes([{ points: rows.map((row) => [0, number(row[column])]) }], 1, true), from = Math.log(least), to = Math.log(most);
    const shade = (value) => {
        const t = value > 0 && to > from ? (Math.log(value) - from) / (to - from) : 0;
        const k = Math.max(1, sequential.findIndex(([end]) => end >= t - 1e-12)), [a, low] = sequential[k - 1], [b, high] = sequential[k];
        const part = (t - a) / (b - a), mix = (c) => Math.round(parseInt(low.slice(c, c + 2), 16) * (1 - part) + parseInt(high.slice(c, c + 2), 16) * part);
        return `rgb(${mix(1)},${mix(3)},${mix(5)})`;
    };
    const at = (x) => edge + inner * x, up = (y) => size + 4 - at(y);
    const panels = shownNames.map((name) => {
        const of = rows.filter((row) => row.formulation === name), worst = of.reduce((a, b) => (number(b[column]) > number(a[column]) ? b : a));
        const root = svg("svg", { width: size, height: size + 10, viewBox: `0 0 ${size} ${size + 10}`, role: "application", tabindex: 0, "aria-label": `${titled(name)}: the arrow keys move particle ${chosen}; the control named particle chooses another.` });
        root.append(svg("text", { x: edge, y: 14, class: "heading" }, titled(name)), svg("text", { x: size - edge, y: 14, "text-anchor": "end" }, "largest " + number(worst[column]).toPrecision(3)));
        // The chosen one lies above the others.
        for (const row of [...of].sort((a, b) => (Number(a.particle) === chosen) - (Number(b.particle) === chosen))) {
            const i = Number(row.particle), [x, y] = places[i].map(Number);
            root.append(svg("circle", { cx: at(x), cy: up(y), r: radius, fill: shade(number(row[column])), "data-particle": i, class: `cell movable${i === chosen ? " chosen" : ""}` },
                svg("title", {}, `particle ${i}, ${row.place || "at"} (${x}, ${y}): ${number(row[column]).toPrecision(4)}`)));
        }
        return root;
    });
    const stops = sequential.map(([place, color]) => `${color} ${100 * place}%`).join();
    replacePanels(page, panels, html("div", { className: "scale" }, least.toPrecision(2), html("span", { style: `background: linear-gradient(to right, ${stops})` }), most.toPrecision(2) + ", logarithmic"));
    // A particle of a side stays on it, and none leaves the square.
    page.move = (i, [px, py]) => {
        const to = [(px - edge) / inner, (size + 4 - edge - py) / inner].map((c, k) => {
            const was = Number(places[i][k]);
            return was === 0 || was === 1 ? String(was) : Math.min(Math.max(c, 0.001), 0.999).toFixed(6);
        });
        page.kept.move = moveText(movesOf(page, places.length, 2).set(i, to));
        page.refresh();
    };
    if (!page.movable) movable(page, (i, place) => page.move(i, place));
    page.movable = true;
}
