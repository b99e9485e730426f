// Small comforts of reading; every page can be read without them.
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
    if (window.matchMedia("(max-width: 1079px)").matches) document.querySelector("#contents details").open = false;
});
