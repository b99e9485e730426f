// How a page reads: its formulas, headings and code, and the contents beside it. landmarks.js holds what each equation says and the
// places of all pages.
const page = location.pathname.split("/").pop() || "index.html";
const element = (name, properties, ...children) => {
    const node = Object.assign(document.createElement(name), properties);
    node.append(...children);
    return node;
};

// An equation's key and its number in print: A13 and 13, B2.11 and 2.11.
const keyOf = (anchor) => anchor.replace("eq_", "").replace("_", ".");
const numberOf = (key) => key.slice(1);
const titleOf = (key) => "(" + numberOf(key) + ") " + equations[key][0].toUpperCase() + equations[key].slice(1);

// MathJax is loaded where there are formulas. Its menu offers only what is copied with it.
window.MathJax = {
    extensions: ["tex2jax.js", "TeX/AMSmath.js", "TeX/AMSsymbols.js"],
    jax: ["input/TeX", "output/SVG"],
    messageStyle: "none",
    MathMenu: { showRenderer: false, showLocale: false },
};
function typeset() {
    const prose = [...document.querySelectorAll("main :is(p, li, td, dd, h1, h2, h3)")];
    if (!prose.some((part) => /\\[([]/.test(part.textContent))) return;
    // Formulas move what stands below them; the place that the reader asked for comes back.
    let moved = false;
    addEventListener("wheel", () => { moved = true; }, { once: true, passive: true });
    addEventListener("keydown", () => { moved = true; }, { once: true });
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const back = () => window.MathJax.Hub.Queue(() => { if (target && !moved) target.scrollIntoView({ behavior: "instant" }); });
    document.head.append(element("script", { src: "mathjax/MathJax.js", onload: back }));
    // The number of an equation stands at the right edge, wherever that is.
    let width = document.body.clientWidth, soon;
    addEventListener("resize", () => {
        if (document.body.clientWidth === width) return;
        width = document.body.clientWidth;
        clearTimeout(soon);
        soon = setTimeout(() => window.MathJax.Hub.Queue(["Rerender", window.MathJax.Hub]), 200);
    });
}

// "(13) Taylor's expansion to the first derivative", with the function's name small beside it. The anchor of an equation shows its heading.
function nameEquations() {
    for (const anchor of document.querySelectorAll("main .anchor[id^=eq_]")) {
        const item = anchor.closest(".memitem");
        const heading = item ? item.previousElementSibling : document.querySelector(".header .title");
        if (!heading.querySelector("code")) {
            const name = [...heading.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE);
            heading.append(" ", element("code", {}, name.map((node) => node.textContent).join("").trim()));
            for (const node of name) node.remove();
        }
        const link = anchor.nextElementSibling;
        const number = element("a", { href: link.firstElementChild.getAttribute("href"), title: "tests and claims" }, "(" + numberOf(keyOf(anchor.id)) + ")");
        heading.querySelector("code").before(number, titleOf(keyOf(anchor.id)).replace(/^\(.*?\)/, ""), " ");
        heading.before(anchor);
        link.remove();
    }
}

// Figures have a number to be found by, as the paper's.
function nameFigures() {
    for (const figure of document.querySelectorAll("main .image object")) {
        const [, name] = /_(figure_\w+)\.svg/.exec(figure.data) || [];
        if (!name) continue;
        figure.parentElement.id = name;
        const number = /^figure_(\d+)$/.exec(name);
        if (number) figure.parentElement.querySelector(".caption").prepend("Figure " + number[1] + ". ");
    }
}

// Signatures name what they declare without the section. Bodies start where their signatures ended: neither a lone brace nor the
// signature's width is of use.
function trimCode() {
    const path = [...document.querySelectorAll(".navpath .navelem")].map((part) => part.textContent.trim());
    // Pages of whole parts have no path.
    const scope = path.length > 0 ? path.join("::") + "::" : /(?:\w+::)+(?=\w+\s*$)/;
    for (const name of document.querySelectorAll("td.memname, h2.memtitle"))
        for (const node of name.childNodes)
            if (node.nodeType === Node.TEXT_NODE) node.textContent = node.textContent.replace(scope, "");
    for (const first of document.querySelectorAll(".memdoc > .fragment > .line:first-child")) {
        const code = [...first.childNodes].filter((node) => !(node.classList && node.classList.contains("lineno")));
        const text = code.map((node) => node.textContent).join("").trim();
        if (text === "{") first.remove();
        else if (code.length > 0 && code[0].nodeType === Node.TEXT_NODE) code[0].textContent = "    " + code[0].textContent.trimStart();
    }
}

// Contents: beside the page where there is room, else a menu; they show the page, or the section that it belongs to. Before and behind
// each section stand its neighbours.
function turnPages() {
    const contents = document.querySelector("#contents details"), wide = matchMedia("(min-width: 1240px)");
    const fit = () => { contents.open = wide.matches; };
    wide.addEventListener("change", fit);
    fit();
    addEventListener("click", (event) => { if (!wide.matches && !contents.contains(event.target)) contents.open = false; });
    const links = [...contents.querySelectorAll("a")];
    const inside = [page, ...[...document.querySelectorAll(".navpath a")].map((link) => link.getAttribute("href")).reverse()];
    const mine = inside.map((each) => links.findIndex((link) => link.getAttribute("href") === each)).find((index) => index >= 0);
    if (mine === undefined) return;
    links[mine].classList.add("here");
    if (links[mine].getAttribute("href") !== page) return;
    const turn = () => element("nav", { className: "turn" },
        ...[["← ", links[mine - 1], ""], ["", links[mine + 1], " →"]].map(([before, link, behind]) =>
            link ? element("a", { href: link.getAttribute("href") }, before + link.textContent + behind) : element("span")));
    document.querySelector("main").prepend(turn());
    document.querySelector("main").append(turn());
}

// Names in code that Doxygen leaves without a link: functions and types of this page, of the scope before the name, or with a name
// that stands in one place only. A parameter or a local name is none of these.
function linkNames() {
    const byName = new Map();
    for (const [file, anchor, text] of places) {
        if (/_source\.html$|^dir_/.test(file)) continue;
        const name = /^(?:\w+::)*(\w+)(?:\(\)|<.*>)?$/.exec(text.replace(/ /g, ""));
        if (name && (/^a[0-9a-f]{20,}/.test(anchor) || (!anchor && /^(struct|class)/.test(file))))
            byName.set(name[1], [...(byName.get(name[1]) || []), [file, anchor]]);
    }
    const target = (name, scope) => {
        const known = byName.get(name) || [];
        if (scope) return known.find(([file]) => new RegExp("(^(namespace|struct|class)|_1_1)" + scope.replace(/_/g, "__") + "\\.html$").test(file));
        const here = known.find(([file]) => file === page);
        const elsewhere = known.filter(([file, anchor]) => !anchor || file.startsWith("namespace"));
        return here || (new Set(elsewhere.map(([file]) => file)).size === 1 ? elsewhere[0] : null);
    };
    for (const code of document.querySelectorAll(".memdoc > .fragment")) {
        const own = new Set([...code.parentElement.parentElement.querySelectorAll("td.paramname em")].map((name) => name.textContent));
        for (const [, name] of code.textContent.matchAll(/\b(?:auto&?|bool|int|double|Index|Scalar) (\w+)/g)) own.add(name);
        for (const link of code.querySelectorAll("a.code"))
            if (own.has(link.textContent) && !/[.:>]$/.test(link.previousSibling?.textContent || "")) link.replaceWith(link.textContent);
        for (const line of code.querySelectorAll(".line"))
            for (const node of [...line.childNodes].filter((child) => child.nodeType === Node.TEXT_NODE)) {
                const before = node.previousSibling ? node.previousSibling.textContent : "";
                const parts = [];
                let from = 0;
                for (const match of node.textContent.matchAll(/((?:(\w+)|^)::)?\b([A-Za-z]\w+|[A-Z](?=<))(?=[(<{])/g)) {
                    const scope = match[2] || (match[1] ? before.split("::").pop() : "");
                    const at = match.index + (match[1] || "").length;
                    const place = /[.>]$/.test(node.textContent.slice(0, at)) || (!scope && own.has(match[3])) ? null : target(match[3], scope);
                    if (!place) continue;
                    parts.push(node.textContent.slice(from, at), element("a", { className: "code", href: place[0] + (place[1] && "#" + place[1]) }, match[3]));
                    from = at + match[3].length;
                }
                if (parts.length > 0) node.replaceWith(...parts, node.textContent.slice(from));
            }
    }
}

trimCode();
nameEquations();
nameFigures();
turnPages();
linkNames();
typeset();
