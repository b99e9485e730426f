# Installed are the library of the methods and its headers, without those of the claims.
# Variables: PREFIX, and DESTDIR, which goes before it.
PREFIX ?= /usr/local
headers := $(filter-out %/choices.hpp,$(shell find src/base src/particles src/solvers $(papers:%=src/%) \
             -name '*.hpp' -not -path '*/claims/*'))
define install_below
	prefix=$$(realpath -ms -- "$(1)")
	root="$(2)$$prefix"
	for header in $(headers); do
	    install -D -m 644 "$$header" "$$root/include/particle-methods/$${header#src/}"
	done
	install -D -m 644 -t "$$root/lib" $(methods)
	install -d "$$root/lib/pkgconfig"
	{ echo "prefix=$${prefix// /\\ }"; cat make/particle-methods.pc; } > "$$root/lib/pkgconfig/particle-methods.pc"
	echo "installed below $$root"
endef

.PHONY: install examples
install: $(methods) ## install headers, library and particle-methods.pc below PREFIX (default /usr/local)
	@$(call install_below,$(PREFIX),$(DESTDIR))

examples: $(methods) ## build and run the examples as a user would: outside of the tree, on what install installs
	@$(call install_below,$(BUILD)/install,)
	export PKG_CONFIG_PATH="$$prefix/lib/pkgconfig"
	folder=$$(mktemp -d)
	trap 'rm -rf "$$folder"' EXIT
	cp examples/Makefile examples/*.cpp "$$folder"
	env -u MAKEFLAGS make --no-print-directory -C "$$folder"
	"$$folder/heat_equation"
	"$$folder/laplacian"
	"$$folder/own_formulation"
