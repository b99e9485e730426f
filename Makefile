# `make help` lists the targets: each one's line of help stands after two hashes, here and in make/.
# Variables: BUILD=folder for what is built (default build), CXX, OPTIMISE, SANITIZE=address,undefined or thread.
SHELL := /bin/bash
.ONESHELL:
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:
.DEFAULT_GOAL := help
# The output of a recipe stays together, except for long checks, whose lines appear at once.
long_checks := bench elements fresh fuzz lint mutants coverage compilers valgrind check-%
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += --jobs=$(shell nproc) $(if $(filter $(long_checks),$(MAKECMDGOALS)),,--output-sync=target)
endif

BUILD ?= build
CXX ?= g++
# No contraction and no -march, so that another build computes the same bytes.
OPTIMISE ?= -O2 -ffp-contract=off
comma := ,
ifdef SANITIZE
# The thread sanitizer understands OpenMP's barriers only in LLVM's runtime.
CXX := $(if $(filter thread,$(SANITIZE)),clang++,$(CXX))
OPTIMISE := -O1 -g -ffp-contract=off -fno-omit-frame-pointer -Wno-maybe-uninitialized -fsanitize=$(SANITIZE) \
            -fno-sanitize-recover=all
override BUILD := $(BUILD)/sanitize-$(subst $(comma),-,$(SANITIZE))
export TSAN_OPTIONS := ignore_noninstrumented_modules=1
endif
# Objects go into programs and into shared libraries such as Python's module; no other library replaces their functions (interposition).
in_libraries := -fPIC -fno-semantic-interposition
CXXFLAGS := -std=c++20 $(OPTIMISE) -fopenmp $(in_libraries) -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
# Eigen aligns memory as widely for every processor, so that programs may have other flags than the library.
CPPFLAGS := -DEIGEN_MAX_ALIGN_BYTES=64 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16 -Isrc -I. -isystem /usr/include/eigen3 -isystem /usr/include/suitesparse
LDLIBS := -lumfpack -lcholmod -llapacke -lopenblas -lgsl -lquadmath
# clang++ needs the place of g++'s quadmath.h and libquadmath, and its -Wconversion includes signs.
gcc = $(shell dirname "$$(g++ -print-libgcc-file-name)")
for_clang_only = -idirafter $(gcc)/include -Wno-sign-conversion
ifneq (,$(findstring clang,$(CXX)))
CPPFLAGS += $(for_clang_only)
CXXFLAGS := $(filter-out -Wno-maybe-uninitialized,$(CXXFLAGS))
LDLIBS += -L$(gcc)
endif
# OpenBLAS chooses its kernels by the processor; data are computed with the same kernels on all.
ifeq ($(shell uname -m),x86_64)
export OPENBLAS_CORETYPE := Nehalem
endif
# Memory by large pages, where the system gives them on request: a large plate takes a quarter less time.
export GLIBC_TUNABLES := glibc.malloc.hugetlb=1

# A new source file is found by its folder. The folders that compile longest come first, so that no long file is left
# for the end. No figure needs libclaims.a, which decides and shows the claims, or libbodies.a, which solves problems on bodies.
bin := $(BUILD)/bin
version := $(shell sed -n 's/^version: //p' CITATION.cff)
papers := $(shell tail -n +2 paper/papers.csv | cut -d, -f2)
sources := $(shell find src tests -name '*.cpp' | LC_ALL=C sort)
objects_in = $(patsubst %.cpp,$(BUILD)/%.o,$(foreach files,$(1),$(filter $(files),$(sources))))
body_objects := $(call objects_in,src/bodies/% src/command_line/body_%)
tool_objects := $(filter-out $(body_objects),\
                  $(call objects_in,src/expressions/% src/command_line/% src/report/file.cpp src/report/table.cpp))
claim_objects := $(filter-out $(tool_objects),$(call objects_in,\
                   $(foreach paper,$(papers:%=src/%),$(addprefix $(paper)/,claims/% claims.cpp choices.cpp)) src/report/%))
method_objects := $(filter-out $(claim_objects),\
                    $(call objects_in,$(papers:%=src/%/%) src/solvers/% src/particles/% src/base/%))
library_objects := $(method_objects) $(call objects_in,src/bodies/%)
cli := $(BUILD)/src/command_line/command_line.o
methods := $(BUILD)/libmethods.a
bodies := $(BUILD)/libbodies.a
tools := $(BUILD)/libtools.a
claims := $(BUILD)/libclaims.a
# Gmsh's library and PETSc are for two programs and their tests, which make/body.mk and make/distributed.mk link.
programs := $(patsubst src/programs/%.cpp,$(bin)/%,$(filter-out %/body.cpp %/distributed.cpp,$(filter src/programs/%,$(sources))))
body_tests := $(call objects_in,tests/meshes/% tests/programs/body%)
tests := $(filter-out $(body_tests) $(addprefix $(BUILD)/tests/,benchmarks/% fuzzing/% refusals/% distributed/% programs/distributed%),\
           $(call objects_in,tests/%))

.PHONY: help setup build data figures check claims clean FORCE
help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-18s %s\n", $$1, $$2 }' Makefile make/*.mk

goals := $(filter-out setup,$(MAKECMDGOALS))
setup: ## install missing Debian packages: those that the other targets of the command need, or, alone, those of programs, tests and walkthrough
	@CXX='$(CXX)' SANITIZE='$(SANITIZE)' bash make/setup $(goals)

include make/tables.mk make/live.mk make/doc.mk make/quality.mk make/install.mk make/body.mk make/python.mk make/distributed.mk

build: $(programs) ## compile the programs into build/bin

data: $(data) ## compute the tables of the figures into data/
	@echo "data: $(words $(data)) tables are up to date in data/"

figures: $(data) $(figures) ## draw the figures of the papers into figures/
	@echo "figures: $(words $(figures)) drawings are up to date in figures/, such as $(firstword $(figures))"

check: $(bin)/check build ## run the tests
	@$(bin)/check

claims: $(ledger) $(bin)/walkthrough ## decide every claim, measure the choices, write the counts into README.md, doc/reproduction.md and the walkthrough
	@$(bin)/walkthrough --write
	$(bin)/claims --count $(filter %/claims.csv,$(ledger))

clean: ## remove what was built
	rm -rf $(BUILD)
	find data figures -name '*.tmp.*' -delete

# Every file is written under a temporary name and renamed when complete. Other flags compile everything anew.
flags := $(CXX) $(CXXFLAGS) $(CPPFLAGS) $(LDLIBS)
$(BUILD)/flags: FORCE $(filter setup,$(MAKECMDGOALS))
	@mkdir -p $(@D)
	[[ -f $@ && "$$(< $@)" == '$(flags)' ]] || echo '$(flags)' > $@
# With setup beside other targets, setup comes first.
ifneq ($(filter setup,$(MAKECMDGOALS)),)
$(goals) $(goals:%=%-build): | setup
endif

# g++ parses the headers of libraries once for the folders that use Eigen. clang++ and make lint do without, so that
# every file includes what it needs.
ifeq (,$(findstring clang,$(CXX)))
libraries := $(BUILD)/src/libraries.hpp.gch $(BUILD)/tests/libraries.hpp.gch
with_eigen := $(papers) bodies meshes solvers particles expressions command_line programs
$(filter-out $(cli),$(call objects_in,$(with_eigen:%=src/%/%))): $(BUILD)/src/libraries.hpp.gch
$(call objects_in,$(with_eigen:%=tests/%/%)): $(BUILD)/tests/libraries.hpp.gch
$(libraries): make/libraries.hpp $(BUILD)/flags
	@mkdir -p $(@D)
	echo "precompile $<"
	$(CXX) $(CXXFLAGS) $(CPPFLAGS) -x c++-header $< -o $@.tmp.gch
	mv $@.tmp.gch $@
endif

$(BUILD)/%.o: %.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	echo "compile $<"
	$(CXX) $(CXXFLAGS) $(CPPFLAGS) $(patsubst %.gch,-include %,$(filter $(libraries),$^)) \
	    -MMD -MP -MF $(@:.o=.d) -MT $@ -c $< -o $@.tmp.o
	mv $@.tmp.o $@
# At -O1 tests compile a sixth faster and run as fast, and CLI11 compiles a third faster. --plot finds the figures' scripts in the folder of the source.
$(tests) $(body_tests) $(BUILD)/tests/libraries.hpp.gch $(cli): private CXXFLAGS := $(patsubst -O2,-O1,$(CXXFLAGS))
$(cli): CITATION.cff
$(cli): private CPPFLAGS += -DVERSION='"$(version)"'
$(BUILD)/src/command_line/plot.o: private CPPFLAGS += -DSOURCE_FOLDER='"$(CURDIR)"'

$(methods): $(method_objects)
$(bodies): $(body_objects)
$(tools): $(tool_objects)
$(claims): $(claim_objects)
$(BUILD)/lib%.a:
	@rm -f $@
	ar qcs $@.tmp.a $^
	mv $@.tmp.a $@

$(programs): $(bin)/%: $(BUILD)/src/programs/%.o
$(bin)/check: $(tests) | $(refusals)
$(bin)/check $(bin)/claims $(bin)/choices $(bin)/walkthrough: $(claims)
for_bodies := $(addprefix $(bin)/,body check_body distributed check_parts check_distributed)
$(bin)/check $(for_bodies): $(bodies)
$(programs) $(refusals) $(bin)/check $(bin)/bench $(for_bodies): $(tools) $(methods)
	@mkdir -p $(@D)
	echo "link $@"
	$(CXX) $(CXXFLAGS) $(filter %.o,$^) $(filter $(claims) $(bodies),$^) $(tools) $(methods) $(LDLIBS) $(LDFLAGS) -o $@.tmp.bin
	mv $@.tmp.bin $@

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
