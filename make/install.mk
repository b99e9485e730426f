# Installed are the library of the methods, bodies among them, and its headers, without those of the claims.
# Variables: PREFIX, and DESTDIR, which goes before it.
PREFIX ?= /usr/local
headers := $(filter-out %/choices.hpp,$(shell find src/base src/particles src/solvers src/bodies $(papers:%=src/%) \
             -name '*.hpp' -not -path '*/claims/*'))
library := $(BUILD)/libparticle-methods.a
$(library): $(library_objects)
define install_below
	prefix=$$(realpath -ms -- "$(1)")
	root="$(2)$$prefix"
	for header in $(headers); do
	    install -D -m 644 "$$header" "$$root/include/particle-methods/$${header#src/}"
	done
	install -D -m 644 -t "$$root/lib" $(library)
	# Programs compiled with other flags than the library need the width of its vector registers.
	register=$$(echo '#include "base/vector_width.hpp"' | $(CXX) $(CXXFLAGS) $(CPPFLAGS) -x c++ -E -dM - |
	    sed -n 's/^#define PARTICLE_METHODS_REGISTER //p')
	sed -i "1i #define PARTICLE_METHODS_REGISTER $$register" "$$root/include/particle-methods/base/vector_width.hpp"
	install -d "$$root/lib/pkgconfig" "$$root/lib/cmake/particle-methods"
	{ printf '%s\n' "prefix=$${prefix// /\\ }" "version=$(version)"; cat make/install/particle-methods.pc; } \
	    > "$$root/lib/pkgconfig/particle-methods.pc"
	cp make/install/particle-methods-config.cmake "$$root/lib/cmake/particle-methods"
	{ echo "set(PACKAGE_VERSION $(version))"; cat make/install/particle-methods-config-version.cmake; } \
	    > "$$root/lib/cmake/particle-methods/particle-methods-config-version.cmake"
	echo "installed below $$root; Python's module is another target: make setup install-python"
endef

.PHONY: install examples
install: $(library) ## install headers, library and particle-methods.pc below PREFIX (default /usr/local)
	@$(call install_below,$(PREFIX),$(DESTDIR))

examples: $(library) ## build and run the examples as a user would: outside of the tree, on what install installs
	@$(call install_below,$(BUILD)/install,)
	export PKG_CONFIG_PATH="$$prefix/lib/pkgconfig"
	folder=$$(mktemp -d)
	trap 'rm -rf "$$folder"' EXIT
	cp examples/Makefile examples/CMakeLists.txt examples/*.cpp "$$folder"
	# With the library's flags and with those of this processor, by both compilers, by make and by CMake.
	for compiler in g++ clang++; do
	    for flags in -O2 "-O2 -march=native -w"; do  # g++ 12 warns of its own AVX-512
	        echo "with $$compiler $$flags"
	        env -u MAKEFLAGS make --no-print-directory --always-make -C "$$folder" CXX=$$compiler OPTIMISE="$$flags"
	        "$$folder/heat_equation"
	        "$$folder/laplacian"
	        "$$folder/own_body"
	        "$$folder/own_formulation"
	        "$$folder/own_kernel"
	    done
	    cmake -S "$$folder" -B "$$folder/$$compiler" -DCMAKE_CXX_COMPILER=$$compiler -DCMAKE_PREFIX_PATH="$$prefix"
	    cmake --build "$$folder/$$compiler" --target heat_equation
	    "$$folder/$$compiler/heat_equation"
	done
