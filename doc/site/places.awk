# The places in the pages of the walkthrough, for its search and its links, as lines of JavaScript: page, anchor, text.
# A place is a page, a heading, a function or type, an equation or a figure.
# Use: awk -f doc/site/places.awk *.html
function text_of(html) {
    gsub(/<[^>]*>|&#9670;&nbsp;|\[[0-9]+\/[0-9]+\]/, "", html)
    gsub(/&lt;/, "<", html); gsub(/&gt;/, ">", html); gsub(/&amp;/, "\\&", html); gsub(/&#39;/, "'", html); gsub(/&quot;/, "\"", html)
    gsub(/\\/, "\\\\", html); gsub(/"/, "\\\"", html); gsub(/^ +| +$/, "", html)
    return html
}
function place(anchor, text) { printf "[\"%s\", \"%s\", \"%s\"],\n", FILENAME, anchor, text_of(text) }
function quoted(start) { sub(".*" start "\"", ""); sub(/".*/, ""); return $0 }
BEGIN { print "const places = [" }
END { print "];" }
/<div class="title">/ { sub(/ Directory Reference/, ""); place("", $0) }
/<h2 class="memtitle">/ { name = $0; place(substr(quoted("href="), 2), name) }
/<h[1-3]><a class="anchor"/ { anchor = quoted("id="); getline; place(anchor, $0) }
/<a class="anchor" id="eq_/ {
    line = $0
    while (match(line, /<a class="anchor" id="eq_[^"]*/)) {
        place(substr(line, RSTART + 22, RLENGTH - 22), "")
        line = substr(line, RSTART + RLENGTH)
    }
}
/<object .*_figure_/ { sub(/.*_figure_/, "figure_"); sub(/\.svg.*/, ""); anchor = $0; getline; getline; place(anchor, $0) }
