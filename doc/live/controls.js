// A page that computes: controls that stand for the options of a program, the command that they make, its table, and the place for a
// drawing. The state of the page is the part of its address behind #, so that a link restores it.
const html = (name, properties = {}, ...children) => {
    const node = Object.assign(document.createElement(name), properties);
    node.append(...children);
    return node;
};
const titled = (name) => (styles[name] || { title: name }).title;

const formulations = ["original", "chen_beraun", "rkpm_first_order", "rkpm_second_order", "fpm", "modified_fpm", "second_order_fpm", "ssph"];
const kernels = ["gaussian", "cubic_spline", "quintic_spline", "wendland_c2", "wendland_c4"];

// Kinds of controls. Each makes {node, value(), set(text)}; a value is what the option says on the command line.
const kinds = {
    // Several of some names, with a sample of each curve and room for a note, such as its order.
    several: ({ values }, changed) => {
        const boxes = values.map((value) => html("input", { type: "checkbox", value, onchange: changed }));
        const notes = Object.fromEntries(values.map((value) => [value, html("span", { className: "note" })]));
        const node = html("div", { className: "several" }, ...boxes.map((box) =>
            html("label", {}, box, sample(styles[box.value]), html("span", {}, titled(box.value)), notes[box.value])));
        return {
            node, notes, value: () => boxes.filter((box) => box.checked).map((box) => box.value).join(),
            set: (text) => boxes.forEach((box) => { box.checked = text.split(",").includes(box.value); }),
        };
    },
    choice: ({ values, names = {}, standard }, changed) => {
        const node = html("select", { onchange: changed }, ...values.map((value) => html("option", { value }, names[value] || titled(value))));
        return { node, value: () => node.value, set: (text) => { node.value = values.includes(text) ? text : standard; } };
    },
    // A number that a slider moves, too.
    range: ({ least, most, step }, changed) => {
        const slider = html("input", { type: "range", min: least, max: most, step, tabIndex: -1, ariaHidden: "true" });
        const exact = html("input", { type: "text", inputMode: "decimal", size: 5 });
        slider.oninput = () => { exact.value = slider.value; changed(); };
        exact.onchange = () => { slider.value = exact.value; changed(); };
        return { node: html("span", { className: "range" }, slider, exact), labelled: exact, value: () => exact.value, set: (text) => { exact.value = slider.value = text; } };
    },
    text: ({ size = 8, example = "" }, changed) => {
        const node = html("input", { type: "text", size, placeholder: example, spellcheck: false, onchange: changed });
        return { node, value: () => node.value, set: (text) => { node.value = text; } };
    },
    whole: ({ least, most }, changed) => {
        const node = html("input", { type: "number", min: least, max: most, oninput: changed });
        return { node, value: () => node.value, set: (text) => { node.value = text; } };
    },
};

// The options that the numerical tests on a line share.
const onALine = {
    formulation: { option: "--formulation", label: "formulations, and their orders", kind: "several", values: [...formulations, "definite_fpm"], standard: formulations.join() },
    smoothing: { option: "--smoothing", label: "smoothing length h/δ", kind: "range", least: 0.5, most: 3, step: 0.05, standard: "1" },
    kernel: { option: "--kernel", label: "kernel W", kind: "choice", values: kernels, standard: "gaussian" },
    volumes: { option: "--volumes", label: "volumes", kind: "choice", values: ["equal", "partition"], standard: "equal" },
    perturb: { option: "--perturb", label: "perturbation a, in δ", kind: "range", least: 0, most: 0.49, step: 0.01, standard: "0" },
    seed: { option: "--seed", label: "seed", kind: "whole", least: 1, most: 2147483647, standard: "1" },
};

// What a page shows and does. `redraw` is called after each change: it asks for tables, and draws them.
// \param options by their keys in the address \param always words that every command has
// \param moves keys of controls that make new particles; then none is moved
function live(root, { program, options, always = [], moves = [], redraw }) {
    const made = {}, form = html("form", { className: "controls", onsubmit: (event) => event.preventDefault() });
    const figure = html("figure", { className: "drawing" }), command = html("code", { className: "command" });
    const message = html("p", { className: "message" }), note = html("p", { className: "note" });
    message.setAttribute("role", "status");
    const bar = html("progress", { hidden: true, ariaLabel: "progress" });
    let table = "", asked = 0, running = false;
    // What no control shows: the places of particles that were moved.
    const kept = moves.length > 0 ? { move: "" } : {};

    for (const [key, option] of Object.entries(options)) {
        const control = (made[key] = kinds[option.kind](option, () => {
            if (moves.includes(key)) {
                kept.move = "";
                shown.letGo?.();
            }
            refresh();
        }));
        const labelled = control.labelled || control.node;
        labelled.id = "control_" + key;
        const label = option.kind === "several" ? html("legend", {}, option.label) : html("label", { htmlFor: labelled.id }, option.label);
        form.append(option.kind === "several" ? html("fieldset", {}, label, control.node) : html("div", { className: "control" }, label, control.node));
    }

    const value = (key) => made[key].value();
    // Options that are not the program's own choice.
    const words = (leave = []) => [program, ...always, ...Object.entries(options).flatMap(([key, option]) =>
        (!option.option || leave.includes(key) || value(key) === option.usual || (option.usual === undefined && value(key) === option.standard) ? [] : [option.option, value(key)]))];
    const state = () => {
        const keys = new URLSearchParams();
        for (const [key, option] of Object.entries(options)) if (value(key) !== option.standard) keys.set(key, value(key));
        for (const [key, text] of Object.entries(kept)) if (text !== "") keys.set(key, text);
        return keys.toString();
    };
    const restore = () => {
        const keys = new URLSearchParams(location.hash.slice(1));
        // No letter of an address may act on the terminal into which a command is pasted.
        for (const [key, text] of [...keys]) keys.set(key, text.replace(/[\x00-\x1f\x7f-\x9f]/g, " "));
        for (const [key, option] of Object.entries(options)) made[key].set(keys.get(key) ?? option.standard);
        for (const key of Object.keys(kept)) kept[key] = keys.get(key) ?? "";
    };
    let pending;
    const write = () => {
        const hash = state();
        history.replaceState(null, "", hash === "" ? location.pathname + location.search : "#" + hash);
    };
    // Draws what the controls say. While it computes, changes wait for the next time: what is done is shown, unless it takes long.
    async function refresh() {
        root.dataset.asked = String(++asked);
        // Browsers allow few changes of the address in a second.
        clearTimeout(pending);
        pending = setTimeout(write, 250);
        if (running) return ask.hurry();
        running = true;
        for (let turn = 0; turn < asked;) {
            turn = asked;
            const begun = performance.now(), late = setTimeout(() => { bar.hidden = false; }, 200);
            bar.removeAttribute("value");
            const answer = (words, files) => ask(words, files, (done, all) => { bar.max = all; bar.value = done; });
            try {
                await redraw(shown, answer);
                root.dataset.drawn = String(turn);
            } catch (error) {
                if (!(error instanceof GivenUp)) {
                    message.textContent = "This page failed: " + error.message;
                    message.hidden = false;
                    root.dataset.drawn = String(turn);
                }
            }
            clearTimeout(late);
            bar.hidden = true;
            root.dataset.milliseconds = (performance.now() - begun).toFixed(1);
        }
        running = false;
    }
    // Shows the command of the table on the page, the table and what the program said.
    const show = (words, files, answered) => {
        command.textContent = typed(words, files);
        table = answered.table;
        message.textContent = answered.message;
        message.hidden = answered.message === "";
        figure.classList.toggle("refused", answered.table === "");
    };

    const copy = (text) => async (event) => {
        const button = event.target, name = button.textContent;
        try {
            await navigator.clipboard.writeText(text());
        } catch {  // a browser that does not let a page of a file do so
            const area = html("textarea", { value: text() });
            button.after(area);
            area.select();
            document.execCommand("copy");
            area.remove();
        }
        button.textContent = "copied";
        setTimeout(() => { button.textContent = name; }, 1200);
    };
    const save = () => {
        const link = html("a", { href: URL.createObjectURL(new Blob([table], { type: "text/csv" })), download: program + ".csv" });
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    };
    const button = (name, onclick) => html("button", { type: "button", onclick }, name);
    const buttons = html("div", { className: "buttons" }, button("copy as command", copy(() => command.textContent)), button("save CSV", save),
        button("copy link", copy(() => location.href.split("#")[0] + "#" + state())),
        button("start again", () => { history.replaceState(null, "", location.pathname); restore(); refresh(); }));
    root.append(form, html("div", { className: "result" }, figure, bar, message, note, command, buttons));
    const shown = { figure, note, made, kept, moves, value, words, show, refresh };
    const begin = () => { restore(); refresh(); };
    addEventListener("hashchange", () => {
        begin();
        figure.scrollIntoView({ block: "nearest" });
    });
    let width = 0;
    new ResizeObserver(() => { if (width !== figure.clientWidth) { if (width > 0) refresh(); width = figure.clientWidth; } }).observe(figure);
    // The page of a walkthrough that was made without the compiler for browsers.
    if (typeof programs === "undefined") {
        message.textContent = "This page is without its programs: run `make setup live doc`.";
        restore();
    } else setTimeout(begin);
    return shown;
}
