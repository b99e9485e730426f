# The programs of the pages that compute, for a browser: the same sources, compiled by emscripten. src/web has the
# libraries that it lacks, as much of each as the programs use, and the function that runs a program.
live_programs := derivative_test static_test vibration_test stencil derivative_test_in_space
live := $(BUILD)/live
live_sources := $(live_programs:%=src/programs/%.cpp) $(wildcard $(addsuffix /*.cpp,$(addprefix src/,\
                  web base particles solvers expressions asprone2010 fpm_in_space command_line))) src/report/file.cpp src/report/table.cpp
# None of these programs needs them.
without := %/choices.cpp $(addprefix src/,solvers/definite.cpp solvers/sparse.cpp solvers/sparse_spectrum.cpp solvers/rows.cpp particles/quadrature.cpp particles/region_% \
               particles/triangle_rule.cpp fpm_in_space/section_3% fpm_in_space/section_5% fpm_in_space/section_6% fpm_in_space/section_7% \
               command_line/body_% command_line/timed_% command_line/example_problems.cpp command_line/membranes.cpp command_line/field_file.cpp)
live_objects := $(patsubst %.cpp,$(live)/%.o,$(filter-out $(without),$(live_sources)))
# Libraries that are headers only. The folder that holds them has headers of this machine's, too.
header_libraries := Spectra boost CLI eigen3/Eigen eigen3/unsupported
LIVEFLAGS := -std=c++20 $(OPTIMISE) -fwasm-exceptions -Wall -Wextra -Wpedantic -Wshadow -Werror -Wno-unknown-pragmas

.PHONY: live check-live
live: $(live)/programs.js ## compile the programs of the live pages for a browser; make doc puts them into the walkthrough

check-live: live build ## compare what the browser's programs compute with the committed tables and with the programs of build/bin
	@node tests/web/check.js $(BUILD)

$(live)/include:
	@mkdir -p $@
	ln -sfn $(header_libraries:%=/usr/include/%) $@

# Debian's emscripten finds what it needs of node here, whichever node runs it.
$(live)/%: export NODE_PATH := /usr/share/nodejs
$(live)/%.o: %.cpp $(BUILD)/flags | $(live)/include
	@mkdir -p $(@D)
	echo "compile $< for a browser"
	em++ $(LIVEFLAGS) $(filter -DEIGEN%,$(CPPFLAGS)) -DVERSION='"$(version)"' -DSOURCE_FOLDER='""' \
	    $(patsubst %,-Dmain=%_main,$(filter $(basename $(notdir $<)),$(live_programs))) -isystem src/web/libraries -Isrc -isystem $(live)/include \
	    -MMD -MP -MF $(@:.o=.d) -MT $@ -c $< -o $@.tmp.o
	mv $@.tmp.o $@
# A page that is read from a file may start a worker from the text of a function only: `programs` is one.
$(live)/programs.js: $(live_objects) make/live.mk
	@echo "link $@"
	rm -f $(live)/all.a
	emar qcs $(live)/all.a $(filter-out $(live)/src/programs/% $(live)/src/web/run.o,$(live_objects))
	em++ $(LIVEFLAGS) $(filter $(live)/src/programs/% $(live)/src/web/run.o,$(live_objects)) $(live)/all.a -sSINGLE_FILE=1 -sMODULARIZE=1 -sENVIRONMENT=worker,node \
	    -sEXPORT_NAME=particle_methods -sALLOW_MEMORY_GROWTH=1 -sEXPORTED_RUNTIME_METHODS=ccall,FS -o $(live)/linked.js
	{ echo 'function programs() {'; cat $(live)/linked.js; echo 'return particle_methods; }'; } > $@.tmp.js
	mv $@.tmp.js $@
