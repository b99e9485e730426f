# Tables and figures: the command of each table, data/paper/name.csv, under the table's name.
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

fpm_in_space/constants = $(bin)/constants_in_space --formulation definite_fpm,literal_second_order_fpm,ssph,cubic_ssph
fpm_in_space/symbol    = $(bin)/constants_in_space --symbol --formulation definite_fpm,cubic_ssph --smoothing 1,1.5,2
fpm_in_space/plane     = $(bin)/derivative_test_in_space --formulation definite_fpm,ssph,cubic_ssph \
                         --particles 16,22,31,43,61,86,121 --perturb 0,0.25 --seeds 25 --median --sample 150
fpm_in_space/space     = $(bin)/derivative_test_in_space --dimension 3 --formulation definite_fpm,ssph,cubic_ssph \
                         --particles 9,12,17,24,34,48 --perturb 0,0.25 --seeds 25 --median --sample 100
around_the_hole := graded-188-11,polar-11x17
fpm_in_space/rows      = $(bin)/derivative_test_in_space --layout $(around_the_hole) --smoothing 1 --smoothing-from local \
                         --function 'log(x^2+y^2)/2' --states
fpm_in_space/layouts   = $(bin)/hole --method strong --draws 25 --quality
fpm_in_space/poisson   = $(bin)/static_test_in_space --formulation definite_fpm,ssph,cubic_ssph --particles 16,31,61,121 \
                         --conditions all
fpm_in_space/poisson_draws = $(bin)/static_test_in_space --formulation definite_fpm --layout grid,stretched-10 \
                         --particles 31,121 --perturb 0.25 --seeds 25 --median
fpm_in_space/poisson_in_space = $(bin)/static_test_in_space --dimension 3 --formulation definite_fpm,ssph,cubic_ssph \
                         --particles 9,12,17 --conditions all
fpm_in_space/poisson_in_space_draws = $(bin)/static_test_in_space --dimension 3 --formulation definite_fpm \
                         --particles 9,17 --perturb 0.25 --seeds 5 --median
fpm_in_space/poisson_in_space_stretched = $(bin)/static_test_in_space --dimension 3 --formulation definite_fpm \
                         --layout stretched-10 --particles 9,17 --perturb 0.25 --seeds 5 --median
fpm_in_space/plate     = $(bin)/plate --method strong,fpm --degree 2,3 --scaling 4 --particles $(grids)
finer := graded-686-21,graded-2600-41
fpm_in_space/hole      = $(bin)/hole --method strong,fpm --draws 11 --layout $(finer) --quality
fpm_in_space/hole_cubic = $(bin)/hole --method strong --degree 3 --scaling 4.5 --draws 11 --layout graded-188-11,$(finer) --quality
fpm_in_space/hole_fpm_coarse = $(bin)/hole --method fpm --draws 25 --quality
fpm_in_space/literal   = $(bin)/derivative_test_in_space --particles 16,31,61 --perturb 0,0.25 --seeds 25 --median --sample 300 \
                         --smoothing 1 --cut 6 --formulation definite_fpm,literal_modified_fpm,literal_fpm_by_derivatives,literal_second_order_fpm
fpm_in_space/membrane  = $(bin)/vibration_test_in_space --perturb 0,0.25 \
                         --formulation original,ssph,cubic_ssph,definite_fpm,fem_lumped,fem_consistent
fpm_in_space/membrane_lowest = $(bin)/vibration_test_in_space --particles 31,61,91 --lowest 10 \
                         --formulation ssph,cubic_ssph,definite_fpm,fem_lumped,fem_consistent

fpm_in_space/claims    = $(bin)/claims --paper fpm_in_space

# The names of the variables above are the list of tables; the one that takes longest is begun first.
tables := $(patsubst %,data/%.csv,$(sort $(filter $(papers:%=%/%),$(.VARIABLES))))
ledger := $(filter %/claims.csv %/choices.csv %/poisson_in_space_stretched.csv,$(tables))
slowest := data/batra2008/layouts.csv
data := $(slowest) $(filter-out $(slowest) $(ledger),$(tables))
figures := $(patsubst %.gp,%.svg,$(sort $(wildcard figures/*/figure_*.gp)))

# Each table depends on the program that its command names, and a ledger on its claims.
program_of = $(firstword $($(1:data/%.csv=%)))
$(foreach table,$(tables),$(eval $(table): $(call program_of,$(table))))
$(filter %/claims.csv,$(tables)): paper/claims.csv paper/papers.csv
# The claims about the hole are decided on the family of layouts.
data/batra2008/claims.csv: data/batra2008/layouts.csv
# Those about FPM in space, on tables of derivatives and of solutions.
data/fpm_in_space/claims.csv: $(patsubst %,data/fpm_in_space/%.csv,plane space poisson poisson_draws poisson_in_space poisson_in_space_draws poisson_in_space_stretched literal rows layouts membrane plate hole hole_fpm_coarse)
# A waiting thread leaves its processor to other tables, which are computed at the same time.
$(tables): export OMP_WAIT_POLICY := passive
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

# A message of gnuplot's is a failure, and a failure leaves no file. On a full disk gnuplot is silent: the end is missing.
$(foreach paper,$(papers),$(eval $(filter figures/$(paper)/%,$(figures)): $(filter data/$(paper)/%,$(data))))
figures/%.svg: figures/%.gp figures/style.gp
	@log=$(BUILD)/log/$*.gnuplot
	mkdir -p $$(dirname $$log)
	trap 'rm -f $@.tmp.svg' EXIT
	if ! LC_ALL=C.UTF-8 gnuplot -e "output = '$@.tmp.svg'" $< 2> $$log || [[ -s $$log ]]; then
	    cat $$log >&2
	    exit 1
	fi
	if [[ $$(tail -n 2 $@.tmp.svg) != *"</svg>"* ]]; then
	    echo "$@: gnuplot did not finish it; is the disk full?" >&2
	    exit 1
	fi
	mv $@.tmp.svg $@
	echo "$@"

.PHONY: timings
timings: $(bin)/plate ## measure what the methods cost on this machine, into data/batra2008/seconds.csv
	@unset OPENBLAS_CORETYPE
	weak=16x4,31x7,61x13,91x19,201x41
	for run in "strong $$weak,401x81,706x142" "weak1 $$weak" "weak2 $$weak"; do
	    set -- $$run
	    $(bin)/plate --method $$1 --particles $$2 --scaling 4 --seconds
	done | awk '!/^(#|method)/ || !seen[$$0]++' > $(BUILD)/seconds.csv
	cp $(BUILD)/seconds.csv data/batra2008/seconds.csv.tmp.csv
	mv data/batra2008/seconds.csv.tmp.csv data/batra2008/seconds.csv
figures/batra2008/figure_seconds.svg: data/batra2008/seconds.csv
