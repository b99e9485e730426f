# The program for many processes and its tests: only they need MPI, PETSc and SLEPc.
.PHONY: distributed check-distributed
distributed: $(bin)/distributed ## compile the program for a body on many processes into build/bin

# Processes may outnumber cores, and root may start them, as in a container.
check-distributed: export OMPI_MCA_rmaps_base_oversubscribe := true
check-distributed: export OMPI_ALLOW_RUN_AS_ROOT := 1
check-distributed: export OMPI_ALLOW_RUN_AS_ROOT_CONFIRM := 1
check-distributed: export OMP_NUM_THREADS := 1
check-distributed: $(bin)/check_parts $(bin)/check_distributed $(bin)/distributed $(bin)/body ## run the tests of what works on many processes
	@for processes in 1 2 3 4; do mpirun --quiet -n $$processes $(bin)/check_parts; done
	$(bin)/check_distributed

# pkg-config is asked only where it is needed.
petsc := PETSc SLEPc mpi-c
with_mpi = -DOMPI_SKIP_MPICXX $(patsubst -I%,-isystem %,$(shell pkg-config --cflags-only-I $(petsc)))
mpi_objects := $(call objects_in,src/distributed/%)
part_tests := $(call objects_in,tests/distributed/%)
distributed_linted := $(filter $(BUILD)/lint/src/distributed/% $(BUILD)/lint/tests/distributed/% $(BUILD)/lint/src/programs/distributed.cpp.%,$(linted))
$(mpi_objects) $(part_tests) $(BUILD)/src/programs/distributed.o $(distributed_linted): private CPPFLAGS = $(without_python) $(with_mpi)

$(bin)/distributed: $(BUILD)/src/programs/distributed.o $(mpi_objects) $(mesh_objects)
$(bin)/check_parts: $(part_tests) $(mpi_objects)
$(bin)/distributed $(bin)/check_parts: LDLIBS += $(shell pkg-config --libs $(petsc)) $(if $(filter %/distributed,$@),-lgmsh)
$(bin)/check_distributed: $(BUILD)/tests/main.o $(call objects_in,tests/programs/distributed_test.cpp)

.PHONY: bench-distributed
bench-distributed: export OMPI_ALLOW_RUN_AS_ROOT := 1
bench-distributed: export OMPI_ALLOW_RUN_AS_ROOT_CONFIRM := 1
bench-distributed: MOST ?= 1000000
bench-distributed: $(bin)/distributed $(bin)/body ## measure the program for many processes beside that for one, up to MOST particles, into data/benchmarks
	@bash tests/benchmarks/distributed $(bin) $(MOST) > $(BUILD)/distributed.csv
	mv $(BUILD)/distributed.csv data/benchmarks/distributed.csv
