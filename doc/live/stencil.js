// The stencil of one particle on a line whose particles can be moved: weights, moments, what is left of Taylor's expansion.
const around = { left: 24, right: 24, bars: 150, line: 56 };

// "D, moment 3 / 3!: 0.251281: leaves 0.251281 delta^2 B^(3)" and the other comments of the program.
function parsed(comments) {
    const moments = { D: [], D2: [] };
    for (const comment of comments) {
        const found = /^(D2?), moment \d+ \/ \d+!: ([^,:]+)(?:: leaves (.*))?/.exec(comment);
        if (found) moments[found[1]].push({ value: found[2], left: found[3] });
    }
    return { moments, said: comments.filter((comment) => /^(condition of|no local system|D2?, quality|sum of)/.test(comment)) };
}
const typeset = (text) => text.replace(/delta/g, "δ").replace(/\^\((\d+)\)/g, (all, digits) => "⁽" + raised(digits) + "⁾").replace(/\^(\d+)/g, (all, digits) => raised(digits)).replace("D2", "D²").replace(/e\+?(-?)0?(\d+)/g, (all, minus, digits) => "·10" + raised(minus + digits)).replace(/-(?=\d)/g, "−");

function momentsTable(of, columns) {
    const cell = (entry) => {
        const wrong = entry.left !== undefined;
        return html("td", { className: wrong ? "wrong" : "" }, typeset(wrong ? entry.left : entry.value));
    };
    const head = html("tr", {}, html("th", {}, "k"), ...columns.map(({ name }) => html("th", {}, name)));
    const rows = Array.from({ length: 7 }, (unused, k) => html("tr", {}, html("td", {}, String(k)), ...columns.map(({ moments }) => (moments[k] ? cell(moments[k]) : html("td", {}, "–")))));
    return html("table", { className: "markdownTable" }, html("caption", {}, `Moments of ${of} over k!, and what they leave as an error`), html("thead", {}, head), html("tbody", {}, ...rows));
}

pages.stencil = {
    program: "stencil",
    moves: ["particles", "perturb", "seed"],
    options: {
        formulation: { option: "--formulation", label: "formulation", kind: "choice", values: [...formulations, "definite_fpm"], standard: "second_order_fpm", usual: "all" },
        beside: { label: "beside it", kind: "choice", values: ["", ...formulations, "definite_fpm"], names: { "": "none" }, standard: "definite_fpm" },
        smoothing: onALine.smoothing, from: { option: "--smoothing-from", label: "δ of h/δ", kind: "choice", values: ["mean", "largest", "local", "nearest"], standard: "mean" },
        kernel: onALine.kernel, volumes: onALine.volumes,
        particles: { option: "--particles", label: "number of particles N", kind: "range", least: 4, most: 40, step: 1, standard: "12", usual: "50" },
        perturb: onALine.perturb, seed: onALine.seed,
        particle: { option: "--particle", label: "particle, from 0", kind: "whole", least: 0, most: 39, standard: "0" },
    },
    redraw: async (page, answer) => {
        // The line as the program has it, by the formulation that needs the fewest neighbours, and what was moved on it.
        const name = page.value("formulation"), beside = page.value("beside"), chosen = Number(page.value("particle"));
        const whole = page.words(), ofLine = ["--particles", "--perturb", "--seed"];
        const line = await known(answer, ["derivative_test", "--formulation", "original", "--states", ...whole.flatMap((word, k) => (ofLine.includes(word) ? [word, whole[k + 1]] : []))]);
        const places = line.map((row) => row.x), moves = movesOf(page, places.length - 1, 1);
        moves.delete(0);
        for (const [i, [x]] of moves) places[i] = x;
        const moved = moves.size > 0, files = moved ? { "/tmp/line.csv": places.join("\n") + "\n" } : {};
        const words = moved ? [...page.words(page.moves), "--positions", "/tmp/line.csv"] : whole;
        const stencils = [];
        for (const formulation of beside === "" ? [name] : [name, beside]) {
            const same = [...words];
            same[same.indexOf("--formulation") + 1] = formulation;
            stencils.push({ name: formulation, answered: await answer(same, files) });
        }
        page.show(words, files, stencils[0].answered);
        const tables = stencils.map(({ name, answered: { table, message } }) => ({ name, message, ...read(table) }));
        const good = tables.filter(({ rows }) => rows.length > 0).map((one) => ({ ...one, ...parsed(one.comments) }));
        if (!tooMany(page, places.length)) drawLine(page, places.map(Number), chosen, tables);
        if (places[chosen] !== undefined) page.note.textContent += `Particle ${chosen}, x = ${places[chosen]}.`;
        if (beside !== "" && places.length > 0) page.note.textContent += ` Grey: ${titled(beside)}.`;
        page.below ||= page.note.parentNode.insertBefore(html("div", { className: "moments" }), page.note.nextSibling);
        page.below.replaceChildren(
            ...["D", "D2"].map((of) => momentsTable(typeset(of), good.map(({ name, moments }) => ({ name: titled(name), moments: moments[of] })))),
            ...good.map(({ name, said }) => html("p", {}, html("b", {}, titled(name)), ": " + said.map((line) => typeset(line)).join("; ") + ".")),
            ...tables.slice(1).filter(({ message }) => message !== "").map(({ message }) => html("p", { className: "message" }, message)));
    },
};

// Particles that were moved, from the address: 3:0.21,5:0.4 on a line, 3:0.2:0.7 in the plane. Others are passed over.
const movesOf = (page, count, dimension) => new Map(page.kept.move.split(",").map((text) => text.split(":")).filter(([i, ...x]) =>
    /^\d+$/.test(i) && Number(i) < count && x.length === dimension && x.every((c) => /^[0-9.]+(e-\d+)?$/.test(c) && Number(c) >= 0 && Number(c) <= 1)).map(([i, ...x]) => [Number(i), x]));
const moveText = (moves) => [...moves].map(([i, x]) => [i, ...x].join(":")).join();

// A pointer and the arrow keys move the particles of a drawing, which is drawn anew meanwhile: each has its number in data-particle, and
// a place in the units of the viewBox at (cx, cy). \param moved(i, [x, y]) such a place for a particle
function movable(page, moved) {
    const panel = (k) => page.figure.querySelectorAll("svg")[k];
    const place = (event, k) => new DOMPoint(event.clientX, event.clientY).matrixTransform(panel(k).getScreenCTM().inverse());
    const choose = (i, k) => {
        if (page.value("particle") !== String(i)) {
            page.made.particle.set(String(i));
            page.refresh();
        }
        panel(k).focus({ preventScroll: true });
    };
    page.figure.addEventListener("pointerdown", (event) => {
        const node = event.target.closest("[data-particle]");
        if (!node || event.button !== 0) return;
        event.preventDefault();
        const i = Number(node.dataset.particle), k = [...page.figure.querySelectorAll("svg")].indexOf(node.ownerSVGElement), from = place(event, k);
        const offset = [Number(node.getAttribute("cx")) - from.x, Number(node.getAttribute("cy")) - from.y];
        choose(i, k);
        if (!node.classList.contains("movable")) return;
        let far = false;
        const follow = (now) => {
            if (now.pointerId !== event.pointerId || !panel(k)) return;
            const to = place(now, k);
            far ||= Math.hypot(now.clientX - event.clientX, now.clientY - event.clientY) > 3;
            if (far) moved(i, [to.x + offset[0], to.y + offset[1]]);
        };
        const listeners = { pointermove: follow, pointerup: () => page.letGo(), pointercancel: () => page.letGo() };
        page.letGo = () => { for (const [type, listener] of Object.entries(listeners)) removeEventListener(type, listener); };
        for (const [type, listener] of Object.entries(listeners)) addEventListener(type, listener);
    });
    page.figure.addEventListener("keydown", (event) => {
        const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
        const node = step && page.figure.querySelector(`[data-particle="${Number(page.value("particle"))}"].movable`);
        if (!node) return;
        event.preventDefault();
        const pixels = event.shiftKey ? 5 : 0.5;
        moved(Number(node.dataset.particle), [Number(node.getAttribute("cx")) + pixels * step[0], Number(node.getAttribute("cy")) + pixels * step[1]]);
    });
}
// Draws the panels in place of the old ones; the focus stays.
function replacePanels(page, panels, ...below) {
    const focused = [...page.figure.querySelectorAll("svg")].indexOf(document.activeElement);
    page.figure.replaceChildren(...panels, ...below);
    if (focused >= 0 && panels[focused]) panels[focused].focus({ preventScroll: true });
}
const tooMany = (page, count) => {
    const most = 4000;
    page.note.textContent = count > most ? `${count} particles are too many to draw; save CSV has the table.` : "";
    return count > most;
};

function drawLine(page, places, chosen, stencils) {
    const { left, right, bars, line } = around, width = drawingWidth(page.figure), height = 2 * bars + line + 20;
    const at = (x) => left + (width - left - right) * x;
    const root = svg("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "application", tabindex: 0, "aria-label": `Weights of particle ${chosen}. The arrow keys move it; the control named particle chooses another.` });
    ["weight_first", "weight_second"].forEach((column, k) => {
        const middle = 28 + k * bars + bars / 2;
        const largest = Math.max(1e-300, ...stencils.flatMap(({ rows }) => rows.map((row) => Math.abs(number(row[column])))));
        root.append(svg("text", { x: left, y: middle - bars / 2 - 4, class: "heading" }, (k === 0 ? "weights of D, times δ" : "weights of D², times δ²") + `; the longest is ${Number(largest.toPrecision(3))}`),
            svg("path", { class: "axes", d: `M${left},${middle}H${width - right}` }));
        stencils.forEach(({ name, rows }, place) => {
            const style = place === 0 ? styles[name] : { ...styles[name], color: "#8f8f8f", point: 6 };
            for (const row of rows) {
                const x = at(places[number(row.particle)]) + (stencils.length > 1 ? (place - 0.5) * 7 : 0), y = middle - (bars / 2 - 22) * number(row[column]) / largest;
                root.append(svg("path", { d: `M${x},${middle}V${y}`, stroke: style.color, "stroke-width": 3 }), symbol(style, x, y));
            }
        });
    });
    const y = 2 * bars + 40;
    root.append(svg("path", { class: "axes", d: `M${left},${y}H${width - right}` }), svg("text", { x: at(0), y: y + 28, "text-anchor": "middle" }, "0"), svg("text", { x: at(1), y: y + 28, "text-anchor": "middle" }, "1"));
    places.forEach((x, i) => {
        const ends = i === 0 || i === places.length - 1;
        root.append(svg("circle", { cx: at(x), cy: y, r: 9, "data-particle": i, class: `particle${i === chosen ? " chosen" : ""}${ends ? "" : " movable"}` },
            svg("title", {}, `particle ${i}, x = ${x}`)));
    });
    replacePanels(page, [root]);
    // Not beyond its neighbours, nor onto them.
    page.move = (i, [to]) => {
        const least = places[i - 1] + 2e-6, most = places[i + 1] - 2e-6, moves = movesOf(page, places.length - 1, 1);
        page.kept.move = moveText(moves.set(i, [Math.min(Math.max((to - left) / (width - left - right), least), most).toFixed(6)]));
        page.refresh();
    };
    if (!page.movable) movable(page, (i, to) => page.move(i, to));
    page.movable = true;
}
