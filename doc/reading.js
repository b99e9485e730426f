// Comforts of reading: formulas are typeset, bodies of functions start where their signatures end, the contents show the page.

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
    const script = document.createElement("script");
    script.src = "mathjax/MathJax.js";
    document.head.append(script);
    // The number of an equation stands at the right edge, wherever that is.
    let width = document.body.clientWidth, soon;
    addEventListener("resize", () => {
        if (document.body.clientWidth === width) return;
        width = document.body.clientWidth;
        clearTimeout(soon);
        soon = setTimeout(() => window.MathJax.Hub.Queue(["Rerender", window.MathJax.Hub]), 200);
    });
}

document.addEventListener("DOMContentLoaded", () => {
    // The body of a function starts where its signature ended: neither a lone brace nor the signature's width is of use.
    for (const first of document.querySelectorAll(".memdoc > .fragment > .line:first-child")) {
        const code = [...first.childNodes].filter((node) => !(node.classList && node.classList.contains("lineno")));
        const text = code.map((node) => node.textContent).join("").trim();
        if (text === "{") first.remove();
        else if (code.length > 0 && code[0].nodeType === Node.TEXT_NODE) code[0].textContent = "    " + code[0].textContent.trimStart();
    }
    const page = location.pathname.split("/").pop() || "index.html";
    for (const link of document.querySelectorAll("#contents a"))
        if (link.getAttribute("href").split("#")[0] === page) link.classList.add("here");
    if (window.matchMedia("(max-width: 1239px)").matches) document.querySelector("#contents details").open = false;
    typeset();
});
