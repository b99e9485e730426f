// Curves in SVG, in the colours, dashes and symbols of figures/style.gp, as styles.sed reads them.
const svg = (name, attributes = {}, ...children) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    node.append(...children);
    return node;
};

// A symbol of gnuplot's by its number, around (0, 0).
const outlines = {
    square: "M-4,-4H4V4H-4Z", circle: "M-4,0A4,4 0 1 0 4,0A4,4 0 1 0 -4,0Z", up: "M0,-5L4.5,3.5H-4.5Z", down: "M0,5L4.5,-3.5H-4.5Z",
    diamond: "M0,-5L5,0L0,5L-5,0Z", plus: "M-4,0H4M0,-4V4", cross: "M-4,-4L4,4M-4,4L4,-4", star: "M-4,0H4M0,-4V4M-3,-3L3,3M-3,3L3,-3",
};
const symbols = { 1: "plus", 2: "cross", 3: "star", 4: "square", 5: "square", 6: "circle", 7: "circle", 8: "up", 9: "up", 10: "down", 11: "down", 12: "diamond", 13: "diamond", 14: "diamond", 15: "diamond" };
const symbol = ({ color, point }, x, y) => svg("path", {
    d: outlines[symbols[point]], transform: `translate(${x.toFixed(1)},${y.toFixed(1)})`, stroke: color,
    fill: [5, 7, 9, 11, 13].includes(point) ? color : "none",
});
// A short piece of a curve, for the names of curves.
function sample(style) {
    const stroke = { stroke: style.color, "stroke-dasharray": style.dash, "stroke-width": style.width };
    return svg("svg", { width: 44, height: 14, viewBox: "0 0 44 14", class: "sample", "aria-hidden": "true" }, svg("path", { d: "M2,7H42", ...stroke }), symbol(style, 22, 7));
}

// Marks of an axis: powers of ten where it is logarithmic, else about six round numbers.
function ticks(axis) {
    const { log, least, most } = axis;
    if (axis.marks) return axis.marks;
    if (log) {
        const every = Math.max(1, Math.ceil((Math.log10(most) - Math.log10(least)) / 7)), marks = [];
        for (let k = Math.ceil(Math.log10(least) - 1e-9); 10 ** k <= most * (1 + 1e-9); k += every) marks.push(10 ** k);
        return marks;
    }
    const raw = (most - least) / 6, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((k) => k * power).find((size) => size >= raw), marks = [];
    for (let k = Math.ceil(least / step - 1e-9); k * step <= most + 1e-9 * step; ++k) marks.push(k * step);
    return marks;
}
const raised = (k) => [...String(k)].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
const shown = (value, log) => (log ? "10" + raised(Math.round(Math.log10(value))) : String(Number(value.toPrecision(6))).replace("-", "−"));

const drawingWidth = (figure) => Math.max(240, Math.floor(figure.getBoundingClientRect().width));

// Draws curves [{style, points: [[x, y]], every, back}] between two axes {label, log, least, most, marks}. A curve at the back is
// broad and grey; its style says how.
function draw(figure, title, x, y, curves) {
    const width = drawingWidth(figure), height = Math.min(0.8 * width, 540), left = 62, right = 12, top = 34, bottom = 48;
    const place = (axis, from, to) => {
        const scale = axis.log ? Math.log : (value) => value, a = scale(axis.least), b = scale(axis.most);
        return (value) => from + (to - from) * (scale(value) - a) / (b - a);
    };
    const at = [place(x, left, width - right), place(y, height - bottom, top)];
    const inside = ([px, py]) => Number.isFinite(px) && Number.isFinite(py) && (!x.log || px > 0) && (!y.log || py > 0);
    const parts = [];
    for (const mark of ticks(x)) {
        const px = at[0](mark);
        parts.push(svg("path", { class: "grid", d: `M${px},${top}V${height - bottom}` }),
            svg("text", { x: px, y: height - bottom + 18, "text-anchor": "middle" }, x.marks ? String(mark) : shown(mark, x.log)));
    }
    for (const mark of ticks(y)) {
        const py = at[1](mark);
        parts.push(svg("path", { class: "grid", d: `M${left},${py}H${width - right}` }),
            svg("text", { x: left - 6, y: py + 5, "text-anchor": "end" }, shown(mark, y.log)));
    }
    parts.push(svg("path", { class: "axes", d: `M${left},${top}V${height - bottom}H${width - right}` }),
        svg("text", { x: (left + width - right) / 2, y: height - 8, "text-anchor": "middle" }, x.label),
        svg("text", { x: -(top + height - bottom) / 2, y: 15, "text-anchor": "middle", transform: "rotate(-90)" }, y.label),
        svg("text", { x: left, y: 20, class: "heading" }, title));
    const clip = svg("clipPath", { id: "inside" }, svg("rect", { x: left - 5, y: top - 5, width: width - left - right + 10, height: height - top - bottom + 10 }));
    const drawn = svg("g", { "clip-path": "url(#inside)" });
    for (const { style, points, every = 1, back } of curves) {
        const corners = points.filter(inside).map(([px, py]) => [at[0](px), at[1](py)]);
        if (corners.length === 0) continue;
        drawn.append(svg("path", {
            d: "M" + corners.map((corner) => corner.map((c) => c.toFixed(2)).join()).join("L"), fill: "none",
            stroke: style.color, "stroke-width": style.width, "stroke-dasharray": style.dash || "none", class: back ? "back" : "curve",
        }));
        if (!back) drawn.append(...corners.filter((corner, k) => k % every === 0).map(([px, py]) => symbol(style, px, py)));
    }
    figure.replaceChildren(svg("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": title }, clip, ...parts, drawn));
}
