// A headless Chromium that listens on a pipe: its protocol is a text in JSON, ended by a zero byte, for each command and event.
const { spawn } = require("child_process");
const fs = require("fs"), os = require("os"), path = require("path");

exports.start = async () => {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), "browser-"));
    const chromium = spawn("chromium", ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-dev-shm-usage",
        "--hide-scrollbars", `--user-data-dir=${folder}`, "--remote-debugging-pipe", "about:blank"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    let count = 0, rest = "";
    const answers = new Map(), listeners = [];
    chromium.stdio[4].setEncoding("utf8").on("data", (text) => {
        const messages = (rest + text).split("\0");
        rest = messages.pop();
        for (const message of messages.map((each) => JSON.parse(each))) {
            if (message.id && answers.has(message.id)) answers.get(message.id)(message);
            else for (const listener of listeners) listener(message);
        }
    });
    const send = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
        const id = ++count;
        answers.set(id, ({ result, error }) => (error ? reject(new Error(method + ": " + error.message)) : resolve(result)));
        chromium.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    });
    const { targetId } = await send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
    const tell = (method, params) => send(method, params, sessionId);
    await tell("Page.enable");
    await tell("Runtime.enable");
    const errors = [];
    let onLoad = () => {};
    listeners.push(({ method, params }) => {
        if (method === "Page.loadEventFired") onLoad();
        if (method === "Runtime.exceptionThrown") errors.push((params.exceptionDetails.exception || {}).description || params.exceptionDetails.text);
    });
    const evaluate = async (expression) => {
        const { result, exceptionDetails } = await tell("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
        if (exceptionDetails) throw new Error(expression + ": " + ((exceptionDetails.exception || {}).description || exceptionDetails.text));
        return result.value;
    };
    const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
    return {
        errors, evaluate, pause, tell,
        open: async (url, width, height, dark = false) => {
            await tell("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 600 });
            await tell("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] });
            // By way of an empty page, since an address that differs behind # only is not loaded anew.
            for (const next of ["about:blank", url]) {
                const loaded = new Promise((resolve) => { onLoad = resolve; });
                await tell("Page.navigate", { url: next });
                await loaded;
            }
        },
        // Waits until an expression holds, for half a minute.
        until: async (expression) => {
            for (const begun = Date.now(); Date.now() - begun < 30000; await pause(20)) if (await evaluate(expression)) return;
            throw new Error("in 30 s never: " + expression);
        },
        mouse: (type, x, y) => tell("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons: type === "mouseReleased" ? 0 : 1, clickCount: 1, pointerType: "mouse" }),
        key: async (key) => { for (const type of ["keyDown", "keyUp"]) await tell("Input.dispatchKeyEvent", { type, key, code: key }); },
        screenshot: async (file) => {
            const { cssContentSize: { width, height } } = await tell("Page.getLayoutMetrics");
            const { data } = await tell("Page.captureScreenshot", { format: "png", captureBeyondViewport: true, clip: { x: 0, y: 0, width, height, scale: 1 } });
            fs.writeFileSync(file, Buffer.from(data, "base64"));
        },
        stop: async () => {
            const ended = new Promise((resolve) => chromium.on("exit", resolve));
            send("Browser.close").catch(() => {});
            await ended;
            fs.rmSync(folder, { recursive: true, force: true, maxRetries: 10 });
        },
    };
};
