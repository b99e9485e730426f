# The program for bodies of the reader's own and its tests: only they need Gmsh's library.
.PHONY: body check-body bodies
body: $(bin)/body ## compile the program for a body of your own into build/bin

check-body: $(bin)/check_body $(bin)/body ## run the tests of what reads drawings and meshes
	@$(bin)/check_body

bodies: $(bin)/body ## draw the pictures of doc/bodies.md, and measure its table of methods
	@bash make/bodies $(BUILD)

mesh_objects := $(call objects_in,src/meshes/%)
$(bin)/body: $(BUILD)/src/programs/body.o $(mesh_objects)
$(bin)/check_body: $(BUILD)/tests/main.o $(body_tests) $(mesh_objects)
$(bin)/body $(bin)/check_body: LDLIBS += -lgmsh
