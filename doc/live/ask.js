// Runs the programs of the package in a worker, so that the page never waits. `programs` is the function of
// programs.js; a page that is read from a file may start a worker from the text of a function only.

// In the worker: runs one command after another. Files are written first, under the names that the command has.
function serve() {
    let said = "", printed = [];
    const told = (text) => {
        said += text;
        // A terminal erases its line at these letters.
        if (said.includes("\x1b[K")) said = said.slice(said.lastIndexOf("\x1b[K") + 3);
        const progress = /\r(\d+) of (\d+)$/.exec(said);
        if (progress) postMessage({ done: Number(progress[1]), all: Number(progress[2]) });
    };
    const started = programs()({ told, print: (line) => printed.push(line) });
    onmessage = async ({ data: { words, files } }) => {
        const program = await started;
        said = "";
        printed = [];
        for (const [name, text] of Object.entries(files)) program.FS.writeFile(name, text);
        let code = 1, ended = false;
        try {
            code = program.ccall("run", "number", ["string"], [words.map((word) => word + "\n").join("")]);
        } catch (error) {
            said = words[0] + ": the browser ended it: " + error;
            ended = true;
        }
        // Memory that a large table took comes back only with the worker.
        ended ||= program.HEAP8.length > 2 ** 28;
        postMessage({ code, table: printed.map((line) => line + "\n").join(""), message: said.trim(), ended });
    };
}

class GivenUp extends Error {}

const ask = (() => {
    const patience = 1000;  // milliseconds that a command may take while another is wanted
    let address = "", worker = null, current = null, since = 0, hurry;
    const waiting = [];
    const start = () => {
        address ||= URL.createObjectURL(new Blob([`${programs}\n(${serve})();`], { type: "text/javascript" }));
        worker = new Worker(address);
        worker.onmessage = ({ data }) => {
            if ("done" in data) return current.progress(data.done, data.all);
            if (data.ended) stop();
            const { resolve } = current;
            current = null;
            resolve(data);
            next();
        };
    };
    const stop = () => {
        worker.terminate();
        worker = null;
    };
    const next = () => {
        clearTimeout(hurry);
        if (current || waiting.length === 0) return;
        if (!worker) start();
        current = waiting.shift();
        since = performance.now();
        worker.postMessage({ words: current.words, files: current.files });
    };
    // A promise of {code, table, message}: exit code, standard output and standard error.
    const ask = (words, files = {}, progress = () => {}) => new Promise((resolve, reject) => {
        waiting.push({ words, files, progress, resolve, reject });
        next();
    });
    // Another command is wanted: the one that runs is given up if it takes long.
    ask.hurry = () => {
        if (!current) return;
        clearTimeout(hurry);
        hurry = setTimeout(() => {
            const { reject } = current;
            stop();
            current = null;
            reject(new GivenUp());
            next();
        }, Math.max(0, patience - (performance.now() - since)));
    };
    return ask;
})();

// A command as a shell takes it.
const quoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : "'" + word.replaceAll("'", "'\\''") + "'");
const typed = (words, files = {}) => [
    ...Object.entries(files).map(([name, text]) => "printf '%s\\n' " + text.trim().split("\n").map(quoted).join(" ") + " > " + name),
    ["build/bin/" + words[0], ...words.slice(1).map(quoted)].join(" "),
].join(" && ");

// The rows of a table, each an object by the names of the columns, and the comments before it.
function read(table) {
    const lines = table.split("\n").filter((line) => line !== "");
    const comments = lines.filter((line) => line.startsWith("# ")).map((line) => line.slice(2));
    const [head, ...rows] = lines.filter((line) => !line.startsWith("#")).map(cells);
    return { comments, rows: rows.map((row) => Object.fromEntries(head.map((name, k) => [name, row[k]]))) };
}
const cells = (line) => [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, inside, plain]) => plain ?? inside.replaceAll('""', '"'));
const number = (cell) => (cell === undefined || cell === "" ? NaN : Number(cell));
