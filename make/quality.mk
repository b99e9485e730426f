# Checks beyond `make check`. A check with flags of its own is compiled into a folder of its own, by a recipe that
# calls make and does nothing else, because make -n runs it.
.PHONY: bench check-interrupts check-environments valgrind compilers fresh fuzz mutants lint coverage verify
.PHONY: bench-build mutants-build coverage-build fuzz-build

# Each program with a main that calls the program's own main for each of many invocations.
refusals := $(programs:$(bin)/%=$(bin)/refusals/%)
$(refusals): $(bin)/refusals/%: $(BUILD)/src/programs/%.o $(BUILD)/tests/refusals/main.o $(claims)
$(refusals): LDFLAGS := -Wl,--wrap=main

verify: $(tables) $(figures) $(bin)/compare_tables $(bin)/walkthrough ## compare data with the committed, check that figures are whole and generated parts of pages are up to date
	@bash tests/scripts/verify $(BUILD) $(tables) $(figures)

check-interrupts: build ## interrupt programs, data and figures in a copy of the tree: no unfinished file may look finished
	@bash tests/scripts/interrupts $(BUILD)

check-environments: build ## try a decimal comma, missing packages, a path with blanks, a full disk, a read-only tree
	@bash tests/scripts/environments $(BUILD)

valgrind: build ## run each program once under valgrind
	@bash tests/scripts/valgrind $(BUILD)

compilers: ## compute all data with other compilers and flags, and compare them with the committed
	@bash tests/scripts/compilers

fresh: ## try the README's two commands on an empty Debian 12, in a folder that debootstrap makes (as root)
	@bash tests/scripts/fresh

# clang-tidy reads the source files of src/, but those for the browser, with all the headers that they include; cppcheck reads the tests, too.
all_headers := $(shell find src tests -name '*.hpp' -not -path 'tests/benchmarks/*' | LC_ALL=C sort)
all_sources := $(filter-out src/web/%,$(filter src/%,$(sources)))
linted := $(all_headers:%=$(BUILD)/lint/%.alone) $(all_sources:%=$(BUILD)/lint/%.tidy)
lint: $(linted) ## compile every header alone, then clang-tidy and cppcheck
	@cppcheck --std=c++20 --enable=warning,performance,portability --inline-suppr --suppressions-list=tests/scripts/cppcheck.txt \
	    --error-exitcode=1 --quiet -j $(shell nproc) -Isrc -I. src tests
	echo "$(words $(all_headers)) headers compile alone; clang-tidy and cppcheck are content with $(words $(all_sources)) files"
$(BUILD)/lint/%.alone: % $(BUILD)/flags
	@mkdir -p $(@D)
	echo '#include "$*"' | $(CXX) $(CXXFLAGS) $(CPPFLAGS) -fsyntax-only -x c++ -MMD -MP -MF $@.d -MT $@ -
	touch $@
$(BUILD)/lint/%.tidy: % .clang-tidy $(all_headers) $(BUILD)/flags
	@mkdir -p $(@D)
	echo "read $<"
	clang-tidy --quiet $< -- $(CXXFLAGS) $(CPPFLAGS) -DSOURCE_FOLDER='""' -DVERSION='""' $(for_clang_only) 2> $@.log ||
	    { cat $@.log >&2; exit 1; }
	touch $@

# The tests of the sections are compiled again for each mutant, by clang++ in half of g++'s time.
mutated := $(shell sed -nE 's|^([a-z0-9_/]+)\.[ch]pp$$|\1|p' tests/scripts/mutants.txt)
mutable := $(filter-out %_test.o,$(tests)) $(call objects_in,$(wildcard $(mutated:%=tests/%*_test.cpp))) \
           $(library_objects) $(filter %/measures.o,$(claim_objects)) $(call objects_in,src/report/%)
mutants-build:
	@$(MAKE) --no-print-directory CXX=clang++ BUILD=$(BUILD)/mutants OPTIMISE="-O0 -ffp-contract=off" \
	    $(mutable:$(BUILD)/%=$(BUILD)/mutants/%)
mutants: mutants-build ## break the formulas of the sections on purpose, one at a time: their tests must fail
	@bash tests/scripts/mutants $(BUILD)/mutants

coverage-build:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/coverage $(BUILD)/coverage/bin/check build \
	    OPTIMISE="-O1 -ffp-contract=off -Wno-maybe-uninitialized --coverage -fprofile-update=atomic"
# The compiler's own additions to a struct count on the line where it begins; that line is not looked at.
coverage: coverage-build ## run the tests with gcov's counters; fail where a line of a section file is not reached
	@find $(BUILD)/coverage -name '*.gcda' -delete
	# Some runs may not write their counts.
	GCOV_ERROR_FILE=/dev/null $(BUILD)/coverage/bin/check
	gcovr --root . --object-directory $(BUILD)/coverage --filter 'src/' --exclude-throw-branches \
	    --html-details $(BUILD)/coverage/index.html --print-summary > $(BUILD)/coverage/summary.txt
	gcovr --root . --object-directory $(BUILD)/coverage --filter 'src/.*/section_' \
	    --filter 'src/asprone2010/(limit_stencils|leading_error|round_off|symbol|local_conditions)' \
	    --exclude-lines-by-pattern 'struct .*' --fail-under-line 100

# What reads a user's text, compiled with the sanitizers and the fuzzer. SECONDS is the time for each reader.
SECONDS ?= 60
readers := expression positions table
fuzz-build:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/fuzzing CXX=clang++ $(readers:%=$(BUILD)/fuzzing/bin/fuzz_%) \
	    CXXFLAGS="-std=c++20 -O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all"
fuzz: fuzz-build ## feed random input to what reads expressions, positions and tables, SECONDS=60 each
	@bash tests/scripts/fuzz $(BUILD)/fuzzing $(SECONDS) $(readers)
read := $(BUILD)/libreaders.a
$(read): $(call objects_in,src/base/% src/expressions/% src/report/% src/command_line/columns.cpp src/command_line/positions.cpp)
$(readers:%=$(bin)/fuzz_%): $(bin)/fuzz_%: $(BUILD)/tests/fuzzing/%.o $(read)
	@mkdir -p $(@D)
	echo "link $@"
	$(CXX) $(CXXFLAGS) -fsanitize=fuzzer $^ $(LDLIBS) -o $@.tmp.bin
	mv $@.tmp.bin $@

# Benchmarks are compiled for this machine. MOST_1D and MOST_2D are the largest numbers of particles.
MOST_1D ?= 10000000
MOST_2D ?= 100000
bench-build:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/bench $(BUILD)/bench/bin/bench \
	    OPTIMISE="-O3 -march=native -DNDEBUG -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-restrict -Wno-array-bounds"
bench: bench-build ## measure speed beside the machine's limits and NumPy, into data/ and figures/benchmarks
	@bash tests/benchmarks/run $(BUILD)/bench $(MOST_1D) $(MOST_2D)
$(bin)/bench: $(call objects_in,tests/benchmarks/%)
$(bin)/bench: LDFLAGS := -lbenchmark

.PHONY: elements
elements: $(bin)/plate $(bin)/hole $(bin)/body ## measure particles beside finite elements (FreeFem++), into data/benchmarks and doc/elements.md
	@bash tests/benchmarks/elements/run $(BUILD)
figures/benchmarks/figure_elements.svg: data/benchmarks/elements.csv
