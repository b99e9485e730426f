# Targets that answer `make help` carry their line of help behind two hashes.
# Variables: BUILD=folder for everything that is built (default build), CXX, OPTIMISE; for install PREFIX and DESTDIR; for bench
# MOST_1D and MOST_2D, the most particles; SANITIZE=address,undefined or SANITIZE=thread.
SHELL := /bin/bash
.ONESHELL:
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:
.DEFAULT_GOAL := help
# What one recipe writes stays together; of those that take long, each line is shown at once.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += --jobs=$(shell nproc) $(if $(filter bench fresh fuzz lint mutants coverage compilers valgrind check-%,$(MAKECMDGOALS)),,--output-sync=target)
endif

BUILD ?= build
CXX ?= g++
# No contraction and no -march: data keep their bytes from one build to the next.
OPTIMISE ?= -O2 -ffp-contract=off
comma := ,
ifdef SANITIZE
# What OpenMP's threads wait for is known to the sanitizer with LLVM's runtime only.
CXX := $(if $(filter thread,$(SANITIZE)),clang++,$(CXX))
OPTIMISE := -O1 -g -ffp-contract=off -fno-omit-frame-pointer -Wno-maybe-uninitialized -fsanitize=$(SANITIZE) -fno-sanitize-recover=all
override BUILD := $(BUILD)/sanitize-$(subst $(comma),-,$(SANITIZE))
export LSAN_OPTIONS := suppressions=$(CURDIR)/tests/leaks.txt:print_suppressions=0
export TSAN_OPTIONS := ignore_noninstrumented_modules=1
endif
CXXFLAGS := -std=c++20 $(OPTIMISE) -fopenmp -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
CPPFLAGS := -Isrc -I. -isystem /usr/include/eigen3 -isystem /usr/include/suitesparse
LDLIBS := -lumfpack -llapacke -lopenblas -lgsl -lginac -lcln -lquadmath
# Clang finds quadmath.h behind its own headers, and counts more to -Wconversion.
gcc = $(shell dirname "$$(g++ -print-libgcc-file-name)")
for_clang_only = -idirafter $(gcc)/include -Wno-sign-conversion
ifneq (,$(findstring clang,$(CXX)))
CPPFLAGS += $(for_clang_only)
CXXFLAGS := $(filter-out -Wno-maybe-uninitialized,$(CXXFLAGS))
LDLIBS += -L$(gcc)
endif

# A browser is much to install for a figure: beside another target, setup installs what that target needs; alone, everything.
for_doc := doxygen libjs-mathjax
for_check_doc := chromium
for_fuzz := clang libclang-rt-14-dev
for_clang := clang libomp-dev
for_lint := clang-tidy cppcheck
for_coverage := gcovr
PACKAGES := g++ make gnuplot-nox libeigen3-dev libgsl-dev liblapacke-dev libopenblas-dev libsuitesparse-dev libspectra-dev \
            libginac-dev libboost-dev libcli11-dev doctest-dev pkg-config
for_bench := libbenchmark-dev python3-numpy python3-scipy
goals := $(filter-out setup,$(MAKECMDGOALS))
PACKAGES += $(if $(goals),$(if $(filter doc check-doc,$(goals)),$(for_doc)),$(for_doc))
PACKAGES += $(if $(goals),$(if $(filter check-doc,$(goals)),$(for_check_doc)),$(for_check_doc))
PACKAGES += $(if $(filter bench,$(goals)),$(for_bench))
PACKAGES += $(if $(filter fuzz,$(goals)),$(for_fuzz))
PACKAGES += $(if $(findstring clang,$(CXX))$(filter mutants compilers,$(goals)),$(for_clang))
PACKAGES += $(if $(SANITIZE),libclang-rt-14-dev)
PACKAGES += $(if $(filter lint,$(goals)),$(for_lint))
PACKAGES += $(if $(filter coverage,$(goals)),$(for_coverage))
PACKAGES += $(filter valgrind,$(goals))
PACKAGES += $(if $(filter fresh,$(goals)),debootstrap)

bin := $(BUILD)/bin
programs := derivative_test static_test vibration_test stencil constants orders roundoff draws plate hole choices claims walkthrough compare_tables
common := $(patsubst src/%.cpp,$(BUILD)/src/%.o,$(wildcard src/base/*.cpp src/expressions/*.cpp src/particles/*.cpp src/report/*.cpp src/solvers/*.cpp) \
            src/asprone2010/formulations.cpp $(filter-out %/example_problems.cpp,$(wildcard src/command_line/*.cpp)))
tests := $(patsubst %.cpp,$(BUILD)/%.o,$(shell find tests -name '*.cpp' -not -path 'tests/benchmarks/*' -not -path 'tests/fuzzing/*' | LC_ALL=C sort))
benchmarks := $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/benchmarks/*.cpp))
papers := $(shell tail -n +2 paper/papers.csv | cut -d, -f2)

# One command for each table, data/paper/name.csv, under the table's name.
asprone2010/figure_1       = $(bin)/derivative_test --perturb 0,0.25 --seeds 51 --median
asprone2010/figure_2_left  = $(bin)/static_test
asprone2010/figure_2_right = $(bin)/static_test --perturb 0.25 --seeds 51 --median
asprone2010/figure_3       = $(bin)/vibration_test
at_scale := 100,300,1000,3000,10000,30000,100000,300000,1000000
asprone2010/scale          = $(bin)/static_test --formulation second_order_fpm --particles $(at_scale)
asprone2010/scale_uncorrected = $(bin)/static_test --formulation second_order_fpm --particles $(at_scale) --corrections 0
asprone2010/constants      = $(bin)/constants
asprone2010/orders         = $(bin)/orders
asprone2010/precision      = $(bin)/roundoff
asprone2010/draws          = $(bin)/draws
asprone2010/claims         = $(bin)/claims --paper asprone2010
asprone2010/choices        = $(bin)/choices

grids := 16x4,31x7,61x13,91x19
batra2008/table_1          = $(bin)/plate --method strong --corner-3 all
batra2008/table_2          = $(bin)/plate --method strong --corner-1 all --particles $(grids)
batra2008/figure_4         = $(bin)/plate --states 46x10
batra2008/figure_5         = $(bin)/plate --states bottom
batra2008/figure_6         = $(bin)/plate --states top
batra2008/figure_7         = $(bin)/plate --states bottom --poisson 0.499999
batra2008/figure_7_strain  = $(bin)/plate --states bottom --poisson 0.499999 --plane strain
batra2008/locking          = $(bin)/plate --plane strain --poisson 0.3,0.4,0.45,0.49,0.499,0.4999,0.49999,0.499999
batra2008/figure_8         = $(bin)/plate --method weak1,weak2 --gauss 3:1:32
batra2008/figure_9         = $(bin)/plate --scaling 2.1:0.1:5
batra2008/figure_10        = $(bin)/plate --states bottom --method weak1,weak2 --scaling 4 --degree 1,2
batra2008/figure_11        = $(bin)/plate --states bottom --scaling 4 --particles $(grids)
batra2008/figure_12        = $(bin)/plate --scaling 4 --particles $(grids)
batra2008/figure_14        = $(bin)/hole --states particles --method weak1
batra2008/figure_15        = $(bin)/hole --states 25x25
batra2008/figure_16        = $(bin)/hole --states x2-axis
batra2008/figure_17        = $(bin)/hole --states x2-axis
batra2008/figure_18        = $(bin)/hole --states particles --method weak1 --layout graded-686-21
batra2008/figure_19        = $(bin)/hole --states x2-axis --layout graded-686-21
batra2008/figure_20        = $(bin)/hole --states x2-axis --layout graded-686-21
batra2008/layouts          = $(bin)/hole --radius 0.25,0.3,0.35,0.4,0.5 --draws 4 \
                             --layout graded-188-11,polar-11x17,graded-686-21,polar-21x33
batra2008/claims           = $(bin)/claims --paper batra2008
batra2008/choices          = $(bin)/choices --paper batra2008

# The names of the variables above are the list of tables.
tables := $(patsubst %,data/%.csv,$(sort $(filter $(papers:%=%/%),$(.VARIABLES))))
ledger := $(filter %/claims.csv %/choices.csv,$(tables))
data := $(filter-out $(ledger),$(tables))
figures := $(patsubst %.gp,%.svg,$(sort $(wildcard figures/*/figure_*.gp)))

.PHONY: help setup build data timings bench figures check check-interrupts check-environments valgrind compilers fresh fuzz mutants lint coverage claims doc check-doc verify install examples clean
help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-18s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

setup: ## install the Debian packages that are missing; all, or what the other targets beside it need
	@missing=
	for package in $(PACKAGES); do
	    status=$$(dpkg-query -W -f='$${Status}' "$$package" 2>/dev/null || true)
	    [[ $$status == "install ok installed" ]] || missing+=" $$package"
	done
	if [[ -z $$missing ]]; then exit 0; fi
	if ! command -v apt-get >/dev/null; then
	    echo "make setup: this system has no apt-get; install by hand what these Debian packages hold:$$missing" >&2
	    exit 1
	fi
	root=
	if [[ $$(id -u) != 0 ]]; then root=sudo; fi
	$$root apt-get update
	DEBIAN_FRONTEND=noninteractive $$root apt-get install --yes --no-install-recommends $$missing

build: $(addprefix $(BUILD)/bin/,$(programs)) ## compile the programs into build/bin

data: $(data) ## compute the tables of the figures into data/

timings: $(bin)/plate ## measure what the methods cost on this machine, into data/batra2008/seconds.csv
	@for run in "strong 16x4,31x7,61x13,91x19,201x41,401x81,706x142" "weak1 16x4,31x7,61x13,91x19,201x41" \
	           "weak2 16x4,31x7,61x13,91x19,201x41"; do
	    set -- $$run
	    env -u OPENBLAS_CORETYPE $(bin)/plate --method $$1 --particles $$2 --scaling 4 --seconds
	done | awk '!/^(#|method)/ || !seen[$$0]++' > $(BUILD)/seconds.csv
	cp $(BUILD)/seconds.csv data/batra2008/seconds.csv.tmp.csv
	mv data/batra2008/seconds.csv.tmp.csv data/batra2008/seconds.csv

# What is compiled with other flags lies in a folder of its own. A recipe that calls make is run by make -n, too: it does nothing else.
# The benchmarks are as fast as the compiler makes them for this machine; of its widest instructions, g++ 12 warns in its own headers.
.PHONY: bench-build mutants-build coverage-build
bench-build:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/bench OPTIMISE="-O3 -march=native -DNDEBUG -Wno-maybe-uninitialized" $(BUILD)/bench/bin/bench
mutants-build:
	@$(MAKE) --no-print-directory CXX=clang++ BUILD=$(BUILD)/mutants OPTIMISE="-O0 -ffp-contract=off" $(mutable)
coverage-build:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/coverage OPTIMISE="-O1 -ffp-contract=off -Wno-maybe-uninitialized --coverage -fprofile-update=atomic" \
	    $(BUILD)/coverage/bin/check build

MOST_1D ?= 10000000
MOST_2D ?= 100000
bench: bench-build ## measure speed against the machine's limits and against NumPy, into data/benchmarks and figures/benchmarks
	@for part in asprone2010 batra2008; do
	    python=$$(command -v /usr/bin/python3 || command -v python3 || true)
	    env -u OPENBLAS_CORETYPE $(BUILD)/bench/bin/bench --part $$part --most-1d $(MOST_1D) --most-2d $(MOST_2D) --output $(BUILD)/bench/$$part.csv
	    if [[ $$part == asprone2010 ]]; then most=$(MOST_1D); else most=$(MOST_2D); fi
	    if [[ -n $$python ]]; then env -u OPENBLAS_CORETYPE OPENBLAS_NUM_THREADS=1 $$python tests/benchmarks/arrays.py $$part $$((most > 1000000 ? 1000000 : most)) >> $(BUILD)/bench/$$part.csv
	    else echo "there is no python3; the rows of NumPy are left out" >&2; fi
	    cp $(BUILD)/bench/$$part.csv data/benchmarks/$$part.csv
	done
	for figure in $(wildcard figures/benchmarks/*.gp); do LC_ALL=C.UTF-8 gnuplot -e "output = '$${figure%.gp}.svg'" $$figure; done
	if [[ -n $$python ]]; then $$python tests/benchmarks/targets.py data/benchmarks README.md; fi

figures: $(figures) ## draw the figures of the paper into figures/

check: $(BUILD)/bin/check build ## run the tests
	@$(BUILD)/bin/check

check-interrupts: build ## interrupt programs, data and figures in a copy of the tree: nothing half-made may look finished
	@bash tests/interrupts $(BUILD)

check-environments: build ## try a decimal comma, missing packages, a path with blanks, a full disk, a tree that can only be read
	@bash tests/environments $(BUILD)

valgrind: build ## run each program once under valgrind
	@bash tests/valgrind $(BUILD)

compilers: ## compute all data with other compilers and flags, in copies of the last commit, and compare them with the committed
	@bash tests/compilers

fresh: ## try the README's two commands on an empty Debian 12, in a folder that debootstrap makes (as root)
	@bash tests/fresh

# Every header is compiled alone. clang-tidy reads src/, every header of it within some source file; cppcheck the tests too.
all_headers := $(shell find src tests -name '*.hpp' -not -path 'tests/benchmarks/*' | LC_ALL=C sort)
all_sources := $(shell find src -name '*.cpp' | LC_ALL=C sort)
lint: $(all_headers:%=$(BUILD)/lint/%.alone) $(all_sources:%=$(BUILD)/lint/%.tidy) ## compile every header alone, then clang-tidy and cppcheck
	@cppcheck --std=c++20 --enable=warning,performance,portability --inline-suppr --suppressions-list=tests/cppcheck.txt --error-exitcode=1 \
	    --quiet -j $(shell nproc) -Isrc -I. src tests
	echo "$(words $(all_headers)) headers compile alone; clang-tidy and cppcheck are content with $(words $(all_sources)) files"
$(BUILD)/lint/%.alone: % $(BUILD)/flags
	@mkdir -p $(@D)
	echo '#include "$*"' | $(CXX) $(CXXFLAGS) $(CPPFLAGS) -fsyntax-only -x c++ -MMD -MP -MF $@.d -MT $@ -
	touch $@
$(BUILD)/lint/%.tidy: % .clang-tidy $(all_headers) $(BUILD)/flags
	@mkdir -p $(@D)
	echo "read $<"
	clang-tidy --quiet $< -- $(CXXFLAGS) $(CPPFLAGS) -DSOURCE_FOLDER='""' $(for_clang_only) 2> $@.log || { cat $@.log >&2; exit 1; }
	touch $@

# The tests of the sections alone, which are compiled again for each mutant: by clang++, in half of g++'s time.
mutable := $(addprefix $(BUILD)/mutants/,tests/main.o tests/batra2008/bases.o \
           $(patsubst %.cpp,%.o,$(wildcard $(papers:%=tests/%/section_*_test.cpp) tests/asprone2010/limit_stencils_test.cpp src/report/*.cpp \
             src/asprone2010/formulations.cpp src/base/*.cpp src/particles/*.cpp src/solvers/*.cpp src/batra2008/section_4_example_problems.cpp)))
mutants: mutants-build ## break the formulas of the sections on purpose, one at a time: their tests must fail
	@bash tests/mutants $(BUILD)/mutants

# What the compiler adds to a struct, and counts on the line where it begins, is not looked at.
coverage: coverage-build ## run the tests on counting code; fail where a line of a section file is not reached
	@find $(BUILD)/coverage -name '*.gcda' -delete
	# Thousands of short runs would take most of the time to add their counts to the files; some runs may not write them.
	GCOV_ERROR_FILE=/dev/null $(BUILD)/coverage/bin/check --test-case-exclude="bad input: whatever*"
	gcovr --root . --object-directory $(BUILD)/coverage --filter 'src/' --exclude-throw-branches \
	    --html-details $(BUILD)/coverage/index.html --print-summary > $(BUILD)/coverage/summary.txt
	gcovr --root . --object-directory $(BUILD)/coverage --filter 'src/.*/section_' --filter 'src/.*/limit_stencils' \
	    --exclude-lines-by-pattern 'struct .*' --fail-under-line 100

SECONDS ?= 60
readers := expression positions table
fuzz: $(readers:%=$(BUILD)/fuzzing/%) ## feed random input to what reads expressions, positions and tables, SECONDS=60 each
	@for reader in $(readers); do
	    program=$(BUILD)/fuzzing/$$reader corpus=tests/fuzzing/corpus/$$reader
	    mkdir -p $$program.found
	    dictionary=
	    if [[ -e $$corpus.dict ]]; then dictionary=-dict=$$corpus.dict; fi
	    # Where CLN throws, it leaks a few bytes.
	    if ! ASAN_OPTIONS=detect_leaks=0 $$program -max_total_time=$(SECONDS) -timeout=10 -max_len=1000 -print_final_stats=1 \
	            -artifact_prefix=$$program- $$dictionary $$program.found $$corpus 2> $$program.log; then
	        tail -n 30 $$program.log >&2
	        exit 1
	    fi
	    echo "$$reader: $$(sed -n 's/^stat::number_of_executed_units: *//p' $$program.log) executions, nothing found"
	done

claims: $(ledger) $(bin)/walkthrough ## decide every claim of the papers, measure the choices, write the README's table
	@$(bin)/walkthrough --write-readme
	$(bin)/claims --count $(filter %/claims.csv,$(ledger))

doc: $(BUILD)/doc/html/index.html ## compile the walkthrough into build/doc/html

check-doc: doc ## open every page of the walkthrough in a browser, and fail on what does not work
	@bash doc/check $(BUILD)/doc/html

verify: $(tables) $(figures) $(bin)/compare_tables $(bin)/walkthrough ## compare the data that the programs compute with the committed, look that figures are whole
	@failed=0
	mkdir -p $(BUILD)/verify
	for table in $(tables); do
	    git show "HEAD:$$table" > $(BUILD)/verify/committed.csv
	    $(bin)/compare_tables $(BUILD)/verify/committed.csv "$$table" |
	        sed "s|$(BUILD)/verify/committed.csv|$$table|" || failed=1
	done
	for figure in $(figures); do
	    if $(call whole_svg,$$figure); then echo "$$figure: whole"
	    else echo "$$figure: missing or not whole"; failed=1; fi
	done
	git show HEAD:README.md > $(BUILD)/verify/README.md
	$(bin)/walkthrough --readme $(BUILD)/verify/README.md --check-readme || failed=1
	exit $$failed

# Installed are the headers of the methods and of what they stand on, not the claims'. Their source files become a small static library.
PREFIX ?= /usr/local
headers := $(filter-out %/claims.hpp,$(wildcard $(patsubst %,src/%/*.hpp,base particles solvers $(papers))))
define install_below
	prefix=$$(realpath -ms -- "$(1)")
	root="$(2)$$prefix"
	for header in $(headers); do
	    install -D -m 644 "$$header" "$$root/include/particle-methods/$${header#src/}"
	done
	install -D -m 644 -t "$$root/lib" $(BUILD)/libparticle-methods.a
	install -d "$$root/lib/pkgconfig"
	{ echo "prefix=$${prefix// /\\ }"; cat src/particle-methods.pc; } > "$$root/lib/pkgconfig/particle-methods.pc"
	echo "installed below $$root"
endef

install: $(BUILD)/libparticle-methods.a ## install headers, library and particle-methods.pc below PREFIX (default /usr/local)
	@$(call install_below,$(PREFIX),$(DESTDIR))

examples: $(BUILD)/libparticle-methods.a ## build and run the example as a user would: outside of the tree, on what install installs
	@$(call install_below,$(BUILD)/install,)
	export PKG_CONFIG_PATH="$$prefix/lib/pkgconfig"
	folder=$$(mktemp -d)
	trap 'rm -rf "$$folder"' EXIT
	cp examples/Makefile examples/*.cpp "$$folder"
	env -u MAKEFLAGS make --no-print-directory -C "$$folder"
	"$$folder/heat_equation"

clean: ## remove what was built
	rm -rf $(BUILD)

# What is to be set up is set up first, whatever is made beside it.
ifneq ($(filter setup,$(MAKECMDGOALS)),)
$(goals) $(goals:%=%-build): | setup
endif

# Compilation. A change of the compiler or its flags rebuilds everything.
flags := $(CXX) $(CXXFLAGS) $(CPPFLAGS) $(LDLIBS)
$(BUILD)/flags: FORCE $(filter setup,$(MAKECMDGOALS))
	@mkdir -p $(@D)
	[[ -f $@ && "$$(< $@)" == '$(flags)' ]] || echo '$(flags)' > $@
.PHONY: FORCE
FORCE:

# The tests compile a sixth faster, and run as long.
$(tests): CXXFLAGS := $(patsubst -O2,-O1,$(CXXFLAGS))
# Where the scripts of the figures lie, for --plot.
$(BUILD)/src/command_line/plot.o: CPPFLAGS += -DSOURCE_FOLDER='"$(CURDIR)"'
$(BUILD)/%.o: %.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	echo "compile $<"
	$(CXX) $(CXXFLAGS) $(CPPFLAGS) -MMD -MP -MF $(@:.o=.d) -MT $@ -c $< -o $@.tmp.o
	mv $@.tmp.o $@

$(addprefix $(BUILD)/bin/,$(programs)): $(BUILD)/bin/%: $(BUILD)/src/programs/%.o $(common)
	@mkdir -p $(@D)
	echo "link $@"
	$(CXX) $(CXXFLAGS) $^ $(LDLIBS) -o $@.tmp.bin
	mv $@.tmp.bin $@

$(bin)/plate $(bin)/hole $(bin)/check: $(BUILD)/src/command_line/example_problems.o
$(bin)/plate $(bin)/hole $(bin)/choices: $(BUILD)/src/batra2008/section_4_example_problems.o
$(bin)/claims $(bin)/check: $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard $(papers:%=src/%/*.cpp)))
$(BUILD)/bin/check: $(tests) $(common)
	@mkdir -p $(@D)
	echo "link $@"
	$(CXX) $(CXXFLAGS) $^ $(LDLIBS) -o $@.tmp.bin
	mv $@.tmp.bin $@

$(BUILD)/bin/bench: $(benchmarks) $(common) $(BUILD)/src/batra2008/section_4_example_problems.o
	@mkdir -p $(@D)
	echo "link $@"
	$(CXX) $(CXXFLAGS) $^ $(LDLIBS) -lbenchmark -o $@.tmp.bin
	mv $@.tmp.bin $@

# What is fuzzed runs under the compiler's sanitizers.
$(BUILD)/fuzzing/expression: src/expressions/expression.cpp
$(BUILD)/fuzzing/positions: src/command_line/positions.cpp src/base/memory.cpp src/report/file.cpp
$(BUILD)/fuzzing/table: src/report/table.cpp
$(readers:%=$(BUILD)/fuzzing/%): $(BUILD)/fuzzing/%: tests/fuzzing/%.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	echo "compile $@"
	clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $(CPPFLAGS) $(for_clang_only) \
	    $(filter %.cpp,$^) -L$(gcc) -lginac -lcln -lquadmath -o $@.tmp.bin
	mv $@.tmp.bin $@

$(BUILD)/libparticle-methods.a: $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard src/base/*.cpp src/particles/*.cpp src/solvers/*.cpp) \
                                  src/asprone2010/formulations.cpp src/batra2008/section_4_example_problems.cpp)
	@rm -f $@
	ar rcs $@ $^

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)

# OpenBLAS picks its kernels by the processor; data are computed with one set of them on all.
ifeq ($(shell uname -m),x86_64)
export OPENBLAS_CORETYPE := Nehalem
endif

# What is made takes its name when it is whole: whatever interrupts, nothing half-made looks finished.
# Data. Each table hangs on the program that its command names, and a ledger on its claims.
program_of = $(firstword $($(1:data/%.csv=%)))
$(foreach table,$(tables),$(eval $(table): $(call program_of,$(table))))
$(filter %/claims.csv,$(tables)): paper/claims.csv paper/papers.csv
# The claims about the hole are decided on the family of layouts.
data/batra2008/claims.csv: data/batra2008/layouts.csv
$(tables): data/%.csv: | data/BUILD-INFO.txt
	@mkdir -p $(@D)
	rm -f $@.tmp.*
	$($*) --output $@
data/BUILD-INFO.txt: $(sort $(foreach table,$(data),$(call program_of,$(table))))
	@{
	    echo "commit:   $$(git describe --always --dirty 2>/dev/null || echo unknown)"
	    echo "compiler: $$($(CXX) --version | head -n 1)"
	    echo "flags:    $(CXXFLAGS)"
	    echo "system:   $$(uname -srm)"
	    echo "date:     $$(date -u +%Y-%m-%dT%H:%M:%SZ)"
	} > $@.tmp.txt
	mv $@.tmp.txt $@

# Figures: gnuplot's complaints count as failures, and a failure leaves no file. Of a full disk it says nothing.
whole_svg = { head -n 1 "$(1)" | grep -q '<?xml' && tail -n 2 "$(1)" | grep -qx '</svg>'; }
$(foreach paper,$(papers),$(eval $(filter figures/$(paper)/%,$(figures)): $(filter data/$(paper)/%,$(data))))
figures/%.svg: figures/%.gp figures/style.gp
	@log=$(BUILD)/log/$*.gnuplot
	mkdir -p $$(dirname $$log)
	trap 'rm -f $@.tmp.svg' EXIT
	if ! LC_ALL=C.UTF-8 gnuplot -e "output = '$@.tmp.svg'" $< 2> $$log || [[ -s $$log ]]; then
	    cat $$log >&2
	    exit 1
	fi
	if ! $(call whole_svg,$@.tmp.svg); then echo "$@: gnuplot left it unfinished; is the disk full?" >&2; exit 1; fi
	mv $@.tmp.svg $@
	echo "$@"

# The walkthrough: generated pages, Doxygen (whose every warning is an error), and a copy of the parts of MathJax that it needs.
mathjax := /usr/share/javascript/mathjax
walkthrough := $(wildcard doc/* paper/* src/*/*.hpp) $(shell find tests -name '*_test.cpp')
$(BUILD)/doc/html/index.html: $(walkthrough) $(bin)/walkthrough $(ledger) $(figures)
	@rm -rf $(BUILD)/doc
	$(bin)/walkthrough --pages $(BUILD)/doc/pages
	mkdir $(BUILD)/doc/figures
	for figure in $(figures:figures/%=%); do cp "figures/$$figure" "$(BUILD)/doc/figures/$${figure/\//_}"; done
	BUILD=$(BUILD) doxygen doc/Doxyfile
	rm -f $(BUILD)/doc/html/*-members.html
	sed -i -E 's| (Namespace\|Struct\|Class\|Struct Template\|Class Template) Reference</div>|</div>|; s@<h2 class="groupheader">(Detailed Description|Function Documentation)</h2>@@' $(BUILD)/doc/html/*.html
	sed -n 's|.*relpath^\(namespace[^"]*\)">\(.*\)</a>.*|\1 \2|p' doc/header.html | while read -r page title; do
	    sed -i "s|<div class=\"title\">.*</div></div>|<div class=\"title\">$$title</div></div>|" "$(BUILD)/doc/html/$$page"
	done
	if [[ -s $(BUILD)/doc/warnings.log ]]; then cat $(BUILD)/doc/warnings.log >&2; rm -rf $(BUILD)/doc/html; exit 1; fi
	for part in MathJax.js extensions/tex2jax.js extensions/TeX extensions/MathEvents.js jax/element jax/input/TeX \
	            jax/output/SVG/jax.js jax/output/SVG/config.js jax/output/SVG/autoload jax/output/SVG/fonts/TeX; do
	    mkdir -p "$$(dirname $(BUILD)/doc/html/mathjax/$$part)"
	    cp -rL "$(mathjax)/$$part" "$$(dirname $(BUILD)/doc/html/mathjax/$$part)"
	done
	echo "$@"
