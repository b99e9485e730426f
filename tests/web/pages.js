// Opens each page that computes, from its file, on a wide screen and on a narrow one, moves its controls and its particles, and compares
// what it shows with the program of build/bin that its command names. Writes a picture of each page and size beside the pages.
// Use: node tests/web/pages.js BUILD
const { spawnSync } = require("child_process");
const fs = require("fs"), path = require("path");
const { start } = require("./browser.js");
const { withoutRoundOff } = require("./round_off.js");
const build = path.resolve(process.argv[2]), root = path.join(build, "doc/html"), pictures = path.join(build, "doc/live");

// Pages with, for each, the controls to change in turn and what must then stand on the page.
const pages = {
    figure_1: [{ smoothing: "1.5" }, { kernel: "wendland_c4" }, { perturb: "0.25", seed: "3" }, { function: "sin(5*x)+x^2" }, { particles: "20,40,80" }, { formulation: "fpm,definite_fpm" }, { derivative: "first" }],
    figure_2: [{ volumes: "partition" }, { function: "x*exp(-x)" }, { smoothing: "0.4" }, { particles: "10,20,abc" }],
    figure_3: [{ particles: "60" }, { symbol: "symbol" }, { perturb: "0.3" }, { smoothing: "1.6", formulation: "second_order_fpm,fem_lumped" }],
    stencil: [{ formulation: "modified_fpm" }, { particle: "5" }, { kernel: "cubic_spline", smoothing: "1.8" }, { from: "local", perturb: "0.2" }, { beside: "" }, { particle: "30" }],
    plane: [{ show: "quality" }, { formulation: "ssph,cubic_ssph" }, { function: "x^2*y", show: "second" }, { particles: "9" }, { smoothing: "0.2" }],
};

// A control of the page by its key, and the event that a reader's hand would cause.
const change = ([key, value]) => `{
    const boxes = [...document.querySelectorAll(".live fieldset input")], control = document.getElementById("control_${key}");
    if ("${key}" === "formulation" && boxes.length > 0) for (const box of boxes) { if (box.checked !== "${value}".split(",").includes(box.value)) box.click(); }
    else { control.value = "${value}"; for (const type of ["input", "change"]) control.dispatchEvent(new Event(type, { bubbles: true })); }
}`;
const shown = `({ command: document.querySelector(".command").textContent, message: document.querySelector(".message").textContent,
    refused: document.querySelector("figure").classList.contains("refused"), drawing: document.querySelector("figure").innerHTML, curves: document.querySelectorAll("figure svg :is(.curve, .cell, .particle)").length,
    width: document.documentElement.scrollWidth, ms: Number(document.querySelector(".live").dataset.milliseconds) })`;

(async () => {
    const browser = await start(), folder = fs.mkdtempSync(path.join(build, "live-")), problems = [];
    fs.mkdirSync(pictures, { recursive: true });
    await browser.tell("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: folder });
    let looked = 0;
    const complain = (page, what) => problems.push(`${page}: ${what}`);
    const settled = () => browser.until(`(({ drawn, asked }) => asked !== undefined && drawn === asked)(document.querySelector(".live").dataset)`);
    // The table of the page, which it saves, and that of the command which it shows.
    const compare = async (page) => {
        ++looked;
        const { command, message, refused, drawing } = await browser.evaluate(shown);
        const wrong = /NaN|Infinity|undefined/.exec(drawing);
        if (wrong) complain(page, `draws ${wrong[0]} for ${command}`);
        const native = spawnSync("bash", ["-c", command], { cwd: path.dirname(build), encoding: "utf8", maxBuffer: 1 << 26 });
        if (withoutRoundOff(native.stderr.trim()) !== withoutRoundOff(message)) complain(page, `says "${message}"; ${command} says "${native.stderr.trim()}"`);
        if (refused !== (native.stdout === "")) complain(page, `${command} prints ${native.stdout === "" ? "nothing" : "a table"}, the page differs`);
        if (refused) return;
        for (const old of fs.readdirSync(folder)) fs.rmSync(path.join(folder, old));
        await browser.evaluate(`[...document.querySelectorAll(".live button")].find((button) => button.textContent === "save CSV").click()`);
        for (let k = 0; k < 100 && !fs.readdirSync(folder).some((name) => name.endsWith(".csv")); ++k) await browser.pause(20);
        const [saved] = fs.readdirSync(folder);
        if (!saved) return complain(page, "saved no table");
        fs.writeFileSync(path.join(folder, "native"), withoutRoundOff(native.stdout));
        fs.writeFileSync(path.join(folder, saved), withoutRoundOff(fs.readFileSync(path.join(folder, saved), "utf8")));
        const { status, stdout, stderr } = spawnSync(path.join(build, "bin/compare_tables"), [path.join(folder, "native"), path.join(folder, saved)], { encoding: "utf8" });
        if (status !== 0) complain(page, command + ": " + stdout + stderr);
    };
    // The centre of what stands on the page, in pixels of the window.
    const centre = (selector) => browser.evaluate(`(() => { const node = ${selector}; node.scrollIntoView({ block: "center", behavior: "instant" }); const box = node.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()`);

    for (const [name, changes] of Object.entries(pages)) {
        const page = `live_${name}.html`, url = `file://${root}/${page}`;
        const times = [];
        for (const [width, dark] of [[1400, false], [400, true]]) {
            const begun = Date.now();
            await browser.open(url, width, 900, dark);
            await settled();
            const first = Date.now() - begun, { curves, width: needed, message } = await browser.evaluate(shown);
            if (curves === 0) complain(page, "draws nothing");
            if (needed > width) complain(page, `needs ${needed} pixels on a screen of ${width}`);
            if (message !== "") complain(page, `says ${message} before anything was asked`);
            await browser.screenshot(path.join(pictures, `${name}_${width}.png`));
            if (width === 1400) times.push(first);
        }
        await browser.open(url, 1400, 900);
        await settled();
        const redraws = [];
        for (const step of changes) {
            for (const control of Object.entries(step)) await browser.evaluate(change(control));
            await settled();
            redraws.push((await browser.evaluate(shown)).ms);
            await compare(page);
        }
        // A link restores what the page shows; the address follows the controls after a moment.
        await browser.pause(400);
        const hash = await browser.evaluate("location.hash"), before = await browser.evaluate(shown);
        await browser.open(url + hash, 1400, 900);
        await settled();
        const after = await browser.evaluate(shown);
        if (after.command !== before.command) complain(page, `${hash} restores ${after.command}, not ${before.command}`);
        await browser.evaluate(`[...document.querySelectorAll(".live button")].find((button) => button.textContent === "start again").click()`);
        await settled();
        // By pointer and by keys, where there are particles to move.
        if (await browser.evaluate(`document.querySelector("figure .movable") !== null`)) {
            const moved = async (how) => {
                const was = await browser.evaluate("location.hash");
                await how();
                await browser.until(`location.hash !== ${JSON.stringify(was)}`);
                await settled();
                if (!/move=/.test(await browser.evaluate("location.hash"))) complain(page, "a particle does not move");
                await compare(page);
            };
            const [x, y] = await centre(`document.querySelectorAll("figure .movable")[1]`);
            await moved(async () => {
                await browser.mouse("mousePressed", x, y);
                for (let k = 1; k <= 5; ++k) {
                    await browser.mouse("mouseMoved", x + 3 * k, y);
                    await browser.pause(100);  // the drawing is another then
                }
                await browser.mouse("mouseReleased", x + 15, y);
            });
            const [to] = await centre(`document.querySelector("figure .chosen")`);
            if (Math.abs(to - x - 15) > 1) complain(page, `a particle that is moved by 15 pixels moves by ${to - x}`);
            // An address that somebody typed.
            await browser.open(url + "#move=3,3:NaN,4:1e400,99999:0.5,-1:0.5:0.5,:0.1&kernel=none&particle=&show=none", 1400, 900);
            await settled();
            await compare(page);
            await browser.evaluate(change(["particle", "3"]));
            await settled();
            await browser.evaluate(`document.querySelector("figure svg[tabindex]").focus()`);
            await moved(() => browser.key("ArrowRight"));
        }
        for (const error of browser.errors.splice(0)) complain(page, "error: " + error);
        redraws.sort((a, b) => a - b);
        console.log(`${page}: first figure after ${times[0]} ms, then ${redraws[0]} to ${redraws[redraws.length - 1]} ms`);
    }

    // A command that takes minutes shows how far it is, leaves the page to its reader, and is given up for another.
    await browser.open(`file://${root}/live_figure_2.html#particles=100000:50000:800000`, 1400, 900);
    await browser.until(`!document.querySelector("progress").hidden && document.querySelector("progress").value > 0`);
    await browser.evaluate(change(["particles", "10,20"]));
    await settled();
    const { command } = await browser.evaluate(shown);
    if (!command.includes("--particles 10,20")) complain("live_figure_2.html", "does not give up a long command: " + command);

    fs.rmSync(folder, { recursive: true });
    await browser.stop();
    for (const problem of problems) console.error(problem);
    console.log(`${Object.keys(pages).length} pages that compute, ${looked} commands compared, ${problems.length} problems; pictures in ${path.relative(process.cwd(), pictures)}`);
    process.exit(problems.length === 0 ? 0 : 1);
})();
