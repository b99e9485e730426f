// Search: equations by their numbers, sections, figures, claims, and every function, type, heading and file, from landmarks.js.
const words = (text) => text.normalize("NFKC").toLowerCase().replace(/\.(?!\d)/g, " ").replace(/[^\p{L}\p{N}.]+/gu, " ").trim().split(" ");
// A number in brackets is an equation's.
const wordsOf = (query) => words(query.replace(/\(([A-Z]?[\d.]+)\)/gi, "equation $1")).filter((word) => word);

const texts = { A: "Asprone et al.", B: "Batra and Zhang", F: "FPM in space" };
// Formulations whose names in tables are not those of their code.
const formulations = {
    definite_fpm: "namespacefpm__in__space_1_1second__order__fpm.html", cubic_ssph: "namespacebatra2008_1_1ssph__basis.html",
    literal_modified_fpm: "namespacefpm__in__space_1_1literal__extension.html",
    literal_fpm_by_derivatives: "namespacefpm__in__space_1_1literal__extension.html",
    literal_second_order_fpm: "namespacefpm__in__space_1_1literal__extension.html" };

// What can be found: a label, where it stands, a link, and the words that find it.
function findable() {
    const sections = new Map(), all = { sections: [], equations: [], figures: [], others: [], claims: [], files: [] };
    const add = (kind, label, where, link, more = "") => all[kind].push({ label, where, link, words: words(label + " " + more), beside: words(where) });
    for (const link of document.querySelectorAll("#contents a")) {
        sections.set(link.getAttribute("href"), link.textContent);
        add("sections", link.textContent, link.closest(".list > ul").previousElementSibling?.textContent || "", link.getAttribute("href"), "section");
    }
    const titles = new Map(places.filter(([, anchor]) => !anchor).map(([file, , title]) => [file, title]));
    for (const [file, anchor, text] of places) {
        const where = sections.get(file) || titles.get(file) || "", link = file + (anchor && "#" + anchor);
        if (anchor.startsWith("eq_")) {
            const key = keyOf(anchor), number = numberOf(key);
            add("equations", titleOf(key), texts[key[0]] + ", " + where, link, "equation eq " + key + " " + number);
            all.equations.at(-1).number = number;
        } else if (anchor.startsWith("figure_")) add("figures", anchor.replace("figure_", "Figure ") + ". " + text, where, link);
        else if (anchor) add("others", text, where, link);
        else if (/_source\.html$|^dir_/.test(file)) add("files", text, "file", link);
        else if (!sections.has(file)) add("others", text, "", link);
    }
    for (const [id, text] of Object.entries(claims)) add("claims", id + ": " + text, "claims", "claims.html#claim_" + id.replace(/\./g, "_"), "claim");
    for (const [name, link] of Object.entries(formulations)) add("others", name, sections.get(link) || "", link, "formulation");
    return Object.values(all).flat();
}

// Every word of the query must be in what is found; whole words count most, then beginnings; what begins as the query, and an equation of
// its number, come first.
function score(found, wanted) {
    let sum = 0;
    for (const want of wanted) {
        const fit = (word) => word === want ? 9 : word.startsWith(want) ? 3 : want.length > 2 && word.includes(want) ? 1 : 0;
        const best = Math.max(...found.words.map(fit), ...found.beside.map((word) => fit(word) && 1));
        if (best === 0) return 0;
        sum += best;
    }
    return sum + (found.words.slice(0, wanted.length).join() === wanted.join() || found.number === wanted.at(-1) ? 1 : 0);
}

const all = findable(), query = document.getElementById("query"), results = document.getElementById("results");
function search() {
    const wanted = wordsOf(query.value);
    const found = wanted.length === 0 ? [] : all.map((entry) => [score(entry, wanted), entry]).filter(([points]) => points > 0);
    found.sort(([a], [b]) => b - a);  // of equal points, in the order of kinds
    results.replaceChildren(...found.slice(0, 40).map(([, entry]) =>
        element("li", {}, element("a", { href: entry.link }, entry.label, " ", element("small", {}, entry.where)))));
    if (wanted.length > 0 && found.length === 0) results.append(element("li", {}, "nothing found"));
    results.hidden = wanted.length === 0;
}
query.addEventListener("input", search);
query.addEventListener("focus", search);
query.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && results.querySelector("a")) results.querySelector("a").click();
    if (event.key === "Escape") results.hidden = true;
});
addEventListener("click", (event) => { if (!event.target.closest(".search") || event.target.closest("a")) results.hidden = true; });
addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.target === query) return;
    event.preventDefault();
    query.focus();
});
