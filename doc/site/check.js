// What check looks at in each page: formulas, messages, scripts, images, widths, links, contents and search.
const widths = [960, 1400].map((screen) => screen - 15);  // less a scroll bar
const inCode = {  // names that are links
    "asprone2010::chen_beraun": ["nonzero_sum"], "asprone2010::second_order_fpm": ["moments", "matrix"],
    "asprone2010::rkpm": ["inverse", "moment_matrix"], "fpm_in_space::second_order_fpm": ["corrections", "moments"] };
const known = new Set(pages), ids = {}, links = [], problems = [];
let formulas = 0, images = 0;
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

async function look(page, frame) {
    const complain = (what) => problems.push(page + ": " + what);
    const loaded = new Promise((done) => { frame.onload = done; });
    frame.width = 1400;
    frame.src = page + "?checked";
    await loaded;
    const view = frame.contentWindow, shown = frame.contentDocument;
    const typeset = async () => {
        const ready = new Promise((done) => view.MathJax.Hub.Queue(() => done(true)));
        if (!await Promise.race([ready, pause(60000)])) complain("MathJax did not finish");
    };
    // MathJax loads where there are formulas, and two seconds later its menu.
    const typesetting = view.MathJax && view.MathJax.Hub;
    if (typesetting) {
        await typeset();
        await pause(4000);
        const message = shown.getElementById("MathJax_Message");
        if (message && message.offsetHeight > 0) complain("MathJax says " + message.textContent);
        if (view.MathJax.Hub.config.messageStyle !== "none") complain("MathJax shows messages while it loads");
    }
    for (const failure of view.failures || ["the page could not be watched"]) complain("error: " + failure);

    const rendered = shown.querySelectorAll(".MathJax_SVG svg").length;
    const sources = shown.querySelectorAll('script[type^="math/tex"]').length;
    formulas += rendered;
    if (rendered !== sources) complain(sources + " formulas, " + rendered + " rendered");
    const wrong = (node) => node && (node.type === "merror" || (node.data || []).some((part) => part && wrong(part)));
    for (const formula of typesetting ? view.MathJax.Hub.getAllJax() : [])
        if (wrong(formula.root)) complain("MathJax cannot read " + formula.originalText.slice(0, 60));
    const left = shown.querySelector("main").innerText.replace(/\\\\/g, "").match(/.{0,30}(\\\(|\\\[|\\f\$|\\(eq|defeq|claim|ref)\b).{0,30}/);
    if (left && !/_source\.html$/.test(page)) complain("formula or command left as text: " + left[0]);

    for (const name of shown.querySelectorAll("td.memname"))
        if (/^(?:.* )?(?:asprone2010|batra2008|fpm_in_space|particles|solvers|report)[a-z]/.test(name.textContent.trim()))
            complain("a name runs into its section's: " + name.textContent.trim());
    for (const image of shown.querySelectorAll("main img")) { ++images; if (!image.naturalWidth) complain("image " + image.src + " did not load"); }
    for (const image of shown.querySelectorAll("main object")) {
        ++images;
        if (!image.contentDocument || !image.contentDocument.querySelector("svg")) complain("image " + image.data + " did not load");
    }

    for (const anchor of shown.querySelectorAll("main .anchor[id^=eq_]"))
        if (!anchor.nextElementSibling.textContent.includes("(" + anchor.id.slice(4).replace("_", ".") + ") "))
            complain(anchor.id + " shows no heading");
    for (const [section, names] of Object.entries(inCode))
        for (const name of page === "namespace" + section.replace(/_/g, "__").replace(/::/g, "_1_1") + ".html" ? names : [])
            if (![...shown.querySelectorAll(".fragment a.code")].some((link) => link.textContent === name)) complain(name + " is no link in its code");
    if (/^namespace(asprone2010|batra2008|fpm__in__space)_1_1/.test(page) && shown.querySelector(`#contents .here[href="${page}"]`) && shown.querySelectorAll(".turn a").length < 4)
        complain("previous or next section is missing");

    for (const width of [390, ...widths]) {
        frame.width = width;
        if (typesetting) {
            view.dispatchEvent(new Event("resize"));  // a frame out of sight hears of its size late
            await pause(300);
            await typeset();
        } else await pause(30);
        const needed = shown.documentElement.scrollWidth;
        if (needed > width) complain("needs " + needed + " pixels on a screen of " + width);
        if (width > 390)
            for (const box of shown.querySelectorAll("main :is(.formulaDsp, .fragment, .memproto, .markdownTable, .doxtable, .image, pre)"))
                if (box.scrollWidth > box.clientWidth + 1)
                    complain("cut at " + width + " pixels, needs " + (box.scrollWidth - box.clientWidth) + " more: " + box.className + " " + box.textContent.trim().slice(0, 60).replace(/\s+/g, " "));
    }

    ids[page] = new Set([...shown.querySelectorAll("[id], a[name]")].flatMap((node) => [node.id, node.getAttribute("name")]));
    for (const link of shown.querySelectorAll("a[href]")) links.push([page, link.getAttribute("href")]);
    for (const asset of shown.querySelectorAll("script[src], link[href], img[src]"))
        if (/^(https?:)?\/\//.test(asset.getAttribute("src") || asset.getAttribute("href"))) complain("loads from the network: " + (asset.src || asset.href));
    if (page === "index.html") {
        const titles = [...shown.querySelectorAll("#contents li")].map((item) => item.textContent.trim().split(" ")[0]);
        const query = shown.getElementById("query");
        for (const [word, target] of wanted) {
            query.value = word;
            query.dispatchEvent(new view.Event("input"));
            const found = [...shown.querySelectorAll("#results a")].slice(0, 3).map((link) => link.getAttribute("href"));
            if (found.length === 0 || !found.some((link) => link.includes(target))) complain("the search for " + word + " does not find " + (target || "anything"));
        }
        for (const section of [...sections, "5.1"]) if (!titles.includes(section)) complain("the contents miss Section " + section);
    }
}

(async () => {
    // Most of the time is waiting: several pages are looked at together.
    const left = [...pages];
    await Promise.all(Array.from({ length: 8 }, async () => {
        const frame = document.createElement("iframe");
        frame.height = 1000;
        document.body.append(frame);
        while (left.length > 0) await look(left.pop(), frame);
    }));
    let followed = 0;
    for (const [page, link] of links) {
        if (/^https?:\/\/(dx\.)?doi\.org\//.test(link) || link.startsWith("javascript:") || /^#\w+=/.test(link)) continue;  // the state of a page that computes
        ++followed;
        const [target, id] = link.split("#");
        const file = decodeURIComponent(target) || page;
        if (!known.has(file)) problems.push(page + ": dead link " + link);
        else if (id && !ids[file].has(decodeURIComponent(id))) problems.push(page + ": dead link " + link);
    }
    const unique = [...new Set(problems)];
    document.getElementById("report").textContent =
        unique.join("\n") + "\n" + pages.length + " pages, " + formulas + " formulas rendered, " + followed + " links followed, " + images +
        " images, " + wanted.length + " words searched, " + unique.length + " problems";
})().catch((error) => { document.getElementById("report").textContent = "the check itself failed: " + error.stack; });
