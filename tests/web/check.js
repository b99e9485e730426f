// Compares what the programs compute that are compiled for a browser with the committed tables, within the tolerances that these
// state, and with what the programs of build/bin print; prints the largest difference of each formulation. A refusal must be the same line.
// Use: node tests/web/check.js BUILD
const { execFileSync, spawnSync } = require("child_process");
const fs = require("fs"), os = require("os"), path = require("path");
const { withoutRoundOff } = require("./round_off.js");
const build = process.argv[2], bin = (name) => path.join(build, "bin", name);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "live-"));
process.on("exit", () => fs.rmSync(folder, { recursive: true }));
const particle_methods = new Function("require", "__dirname", fs.readFileSync(path.join(build, "live/programs.js"), "utf8") + "\nreturn programs();")(require, folder);

(async () => {
    let printed = [], said = "", failed = 0, compared = 0;
    const program = await particle_methods({ print: (line) => printed.push(line + "\n"), told: (text) => { said += text; } });
    const run = (words) => {
        printed = [];
        said = "";
        const begun = process.hrtime.bigint(), code = program.ccall("run", "number", ["string"], [words.map((word) => word + "\n").join("")]);
        return { code, output: printed.join(""), message: said.split("\x1b[K").pop(), ms: Number(process.hrtime.bigint() - begun) / 1e6 };
    };
    const native = (words) => {
        const { status, stdout, stderr } = spawnSync(bin(words[0]), words.slice(1), { encoding: "utf8", maxBuffer: 1 << 28 });
        return { code: status, output: stdout, message: stderr };
    };
    const complain = (what) => { ++failed; console.error(what); };
    const agrees = (name, ...tables) => {
        ++compared;
        const both = ["expected", "found"].map((which) => path.join(folder, which + ".csv"));
        tables.forEach((table, k) => fs.writeFileSync(both[k], withoutRoundOff(table)));
        const { status, stdout, stderr } = spawnSync(bin("compare_tables"), both, { encoding: "utf8" });
        if (status !== 0) complain(name + ": " + (stderr || stdout.replaceAll(both[0], name)));
    };

    // The committed tables that take some seconds; others differ in their size only.
    const tables = { "asprone2010/figure_1": [], "asprone2010/figure_2_left": [], "asprone2010/figure_2_right": [], "asprone2010/figure_3": [], "fpm_in_space/rows": [] };
    for (const table of Object.keys(tables)) {
        // The Makefile has the command of each table.
        const command = execFileSync("make", ["--no-print-directory", "-n", "-B", `BUILD=${build}`, `data/${table}.csv`], { encoding: "utf8", env: { ...process.env, MAKEFLAGS: "", MAKELEVEL: "" } })
            .split("\n").find((line) => line.includes("--output"));
        const words = [...command.matchAll(/'([^']*)'|([^\s']+)/g)].map(([, inside, plain]) => inside ?? plain);
        const start = words.findIndex((word) => word.startsWith(build + "/bin/")), out = words.indexOf("--output");
        const asked = [path.basename(words[start]), ...words.slice(start + 1, out), "--output", "/tmp/table.csv"];
        const { code, message, ms } = run(asked);
        if (code !== 0) complain(`${table}: exit code ${code}, ${message}`);
        else agrees(`data/${table}.csv`, fs.readFileSync(`data/${table}.csv`, "utf8"), program.FS.readFile("/tmp/table.csv", { encoding: "utf8" }));
        console.log(`data/${table}.csv: ${(ms / 1000).toFixed(1)} s`);
    }

    // Each formulation with other options than the papers', against the programs of this machine.
    const formulations = ["original", "chen_beraun", "rkpm_first_order", "rkpm_second_order", "fpm", "modified_fpm", "second_order_fpm", "ssph", "definite_fpm"];
    const asks = [
        (name) => ["derivative_test", "--formulation", name, "--particles", "10,37,640", "--smoothing", "1.3", "--kernel", "wendland_c4", "--function", "sin(5*x)+x^2"],
        (name) => ["derivative_test", "--formulation", name, "--particles", "40", "--perturb", "0.25", "--seed", "7", "--states"],
        (name) => ["static_test", "--formulation", name, "--particles", "10,37,640", "--volumes", "partition", "--displacement", "x*exp(-x)"],
        (name) => ["vibration_test", "--formulation", name, "--particles", "200", "--lowest", "3"],
        (name) => ["vibration_test", "--formulation", name, "--particles", "40", "--smoothing", "2"],
        (name) => ["vibration_test", "--formulation", name, "--particles", "60", "--perturb", "0.1", "--seed", "3"],
        ...[0, 1, 6].map((particle) => (name) => ["stencil", "--formulation", name, "--particles", "14", "--perturb", "0.2", "--particle", String(particle)]),
    ];
    const largest = (expected, found) => {
        const lines = (table) => table.split("\n").filter((line) => line !== "" && !line.startsWith("#")).slice(1).map((line) => line.split(","));
        const [a, b] = [lines(expected), lines(found)];
        let most = 0;
        a.forEach((row, i) => row.forEach((cell, k) => {
            const [x, y] = [Number(cell), Number(b[i] && b[i][k])];
            // An error of the size of round-off has no digits in common.
            if (Number.isFinite(x) && Number.isFinite(y) && Math.abs(x) > 1e-6) most = Math.max(most, Math.abs(x - y) / Math.abs(x));
        }));
        return most;
    };
    const both = (words, name) => {
        const expected = native(words), found = run(words);
        if (expected.code !== found.code || withoutRoundOff(expected.message) !== withoutRoundOff(found.message))
            complain(`${words.join(" ")}: ${found.code} ${found.message.trim()}, natively ${expected.code} ${expected.message.trim()}`);
        if (expected.output !== "") agrees(words.join(" "), expected.output, found.output);
        return largest(expected.output, found.output);
    };
    const told = (name, most) => console.log(`${name}: ${most === 0 ? "no printed digit differs" : "relative differences of at most " + most.toExponential(1)}`);
    for (const name of formulations) told(name, Math.max(...asks.map((ask) => both(ask(name)))));
    for (const name of ["definite_fpm", "ssph", "cubic_ssph", "literal_modified_fpm", "literal_fpm_by_derivatives", "literal_second_order_fpm"]) {
        const most = Math.max(...[[], ["--laplacian"]].map((more) => both(["derivative_test_in_space", "--formulation", name, "--particles", "14", "--perturb", "0.25", "--states", ...more])));
        told(name + " in the plane", most);
    }

    // Refusals, options and numbers beyond what this machine holds.
    for (const words of [["derivative_test", "--formulation", "nope"], ["derivative_test", "--smoothing", "0.1", "--particles", "12"], ["static_test", "--displacement", "log(x)"],
                         ["stencil"], ["stencil", "--particle", "99", "--formulation", "fpm"], ["derivative_test", "--particles", "010"], ["derivative_test", "--particles", ""],
                         ["derivative_test", "--particles", "1,5"], ["derivative_test_in_space", "--layout", "/tmp/none.csv"], ["derivative_test", "--help"], ["stencil", "--version"]]) {
        const expected = native(words), found = run(words);
        ++compared;
        if (expected.code !== found.code || expected.message !== found.message || expected.output !== found.output)
            complain(`${words.join(" ")}: ${found.code} ${found.message}${found.output}natively ${expected.code} ${expected.message}${expected.output}`);
    }
    for (const words of [["derivative_test", "--particles", "1e12"], ["derivative_test", "--particles", "50000000"], ["derivative_test", "--seed", "1e18"]]) {
        const { code, output, message } = run(words);
        ++compared;
        if (code !== 2 || output !== "" || !/^derivative_test: [^\n]*\n$/.test(message)) complain(`${words.join(" ")}: ${code} ${message}${output}`);
    }

    // How long the figures of the pages take, once the compiler of the browser has seen the programs.
    for (const words of [["derivative_test", "--particles", "640"], ["static_test", "--particles", "640"], ["vibration_test", "--particles", "100"], ["stencil", "--formulation", "second_order_fpm"],
                         ["derivative_test_in_space", "--particles", "14", "--states", "--laplacian"]]) {
        const times = Array.from({ length: 5 }, () => run(words).ms).sort((a, b) => a - b);
        console.log(`${words.join(" ")}: ${times[2].toFixed(1)} ms`);
    }
    console.log(`${compared} compared, ${failed} differ; programs.js has ${(fs.statSync(path.join(build, "live/programs.js")).size / 1e6).toFixed(2)} MB`);
    process.exit(failed === 0 ? 0 : 1);
})();
