# The walkthrough: generated pages, Doxygen (a warning is an error), and the parts of MathJax that it needs.
.PHONY: doc check-doc
doc: $(BUILD)/doc/html/index.html ## compile the walkthrough into build/doc/html

check-doc: doc build ## open every page of the walkthrough in a browser, and fail on what does not work
	@bash doc/site/check $(BUILD)/doc/html
	$(if $(live_built),node tests/web/pages.js $(BUILD))

mathjax := /usr/share/javascript/mathjax
mathjax_extensions := tex2jax toMathML MathEvents MathMenu MathZoom HelpDialog AssistiveMML
# The programs of the pages that compute, if they are compiled or em++ is installed. The pages' scripts are joined into one function, so that no other script sees their names.
live_built := $(if $(or $(filter live,$(MAKECMDGOALS)),$(wildcard $(live)/programs.js),$(shell command -v em++)),$(live)/programs.js)
live_scripts := $(addprefix doc/live/,ask.js draw.js controls.js figures.js stencil.js plane.js start.js)
walkthrough := $(wildcard doc/live/*) figures/style.gp $(wildcard doc/site/*) $(wildcard paper/* src/*/*.hpp) \
               $(filter %_test.cpp,$(sources))
$(BUILD)/doc/html/index.html: $(walkthrough) $(bin)/walkthrough $(ledger) $(figures) $(live_built)
	@rm -rf $(BUILD)/doc
	$(bin)/walkthrough --pages $(BUILD)/doc/pages
	mkdir $(BUILD)/doc/figures
	for figure in $(figures:figures/%=%); do cp "figures/$$figure" "$(BUILD)/doc/figures/$${figure/\//_}"; done
	BUILD=$(BUILD) SECTIONS='$(wildcard src/*/section_*.hpp)' doxygen doc/site/Doxyfile
	rm -f $(BUILD)/doc/html/*-members.html
	sed -i -E -e 's@ (Namespace|Struct|Class|Struct Template|Class Template) Reference</div>@</div>@' \
	    -e 's@<h2 class="groupheader">(Detailed Description|Function Documentation)</h2>@@' \
	    -e '/^<div class="ttc"/d' $(BUILD)/doc/html/*.html
	sed -n 's|.*relpath^\(namespace[^"]*\)">\(.*\)</a>.*|\1 \2|p' doc/site/header.html | while read -r page title; do
	    sed -i "s|<div class=\"title\">.*</div></div>|<div class=\"title\">$$title</div></div>|" "$(BUILD)/doc/html/$$page"
	done
	if [[ -s $(BUILD)/doc/warnings.log ]]; then cat $(BUILD)/doc/warnings.log >&2; rm -rf $(BUILD)/doc/html; exit 1; fi
	{ cat $(BUILD)/doc/pages/landmarks.js; (cd $(BUILD)/doc/html; awk -f $(CURDIR)/doc/site/places.awk *.html); } > $(BUILD)/doc/landmarks.js
	mv $(BUILD)/doc/landmarks.js $(BUILD)/doc/html
	for part in MathJax.js extensions/TeX $(mathjax_extensions:%=extensions/%.js) jax/element jax/input/TeX \
	            jax/output/SVG/jax.js jax/output/SVG/config.js jax/output/SVG/autoload jax/output/SVG/fonts/TeX; do
	    mkdir -p "$$(dirname $(BUILD)/doc/html/mathjax/$$part)"
	    cp -rL "$(mathjax)/$$part" "$$(dirname $(BUILD)/doc/html/mathjax/$$part)"
	done
	mkdir $(BUILD)/doc/html/live
	{ echo '(() => {'; sed -n -E -f doc/live/styles.sed figures/style.gp; cat $(live_scripts); echo '})();'; } > $(BUILD)/doc/html/live/live.js
	cat $(live_built) /dev/null > $(BUILD)/doc/html/live/programs.js
	$(if $(live_built),,echo "the pages that compute are empty: make setup live doc")
	echo "$@"
