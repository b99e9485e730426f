# Python's module: core.so from src/python, __init__.py, and the programs behind table(). PYTHON is the interpreter.
PYTHON ?= /usr/bin/python3
package := $(BUILD)/python/particle_methods
python_objects := $(call objects_in,src/python/%)
with_python = -isystem $(shell $(PYTHON) -c 'import sysconfig; print(sysconfig.get_path("include"))')
$(python_objects): $(BUILD)/python/interpreter
$(BUILD)/python/interpreter: FORCE
	@mkdir -p $(@D)
	[[ -f $@ && "$$(< $@)" == '$(with_python)' ]] || echo '$(with_python)' > $@
# pybind11 wants its types hidden, so that modules do not share them.
$(python_objects): private CXXFLAGS += -fvisibility=hidden
# The interpreter is asked only where it is needed.
without_python := $(CPPFLAGS)
$(python_objects) $(filter $(BUILD)/lint/src/python/%,$(linted)): private CPPFLAGS = $(without_python) $(with_python)
# All programs but those that serve the package.
tabulating := $(filter-out $(addprefix $(bin)/,claims choices compare_tables walkthrough),$(programs))

.PHONY: python check-python install-python
python: $(package)/core.so $(package)/__init__.py $(tabulating) ## compile Python's module particle_methods into build/python
	@mkdir -p $(package)/bin
	ln -sf $(tabulating:$(bin)/%=../../../bin/%) $(package)/bin

# Waiting threads sleep, as for tables: small operators would wait for each other most of the time.
check-python: export OMP_WAIT_POLICY := passive
check-python: python ## run the tests of Python's module
	@PYTHONPATH=$(BUILD)/python $(PYTHON) -W error -m unittest discover --start-directory tests/python --pattern '*_test.py'

install-python: python ## install Python's module below PREFIX, too
	@folder="$(DESTDIR)$$(realpath -ms -- "$(PREFIX)")/lib/python$$($(PYTHON) -c 'import sys; print("%d.%d" % sys.version_info[:2])')/dist-packages"
	install -D -m 644 -t "$$folder/particle_methods" $(package)/core.so $(package)/__init__.py
	install -D -t "$$folder/particle_methods/bin" $(tabulating)
	echo "installed in $$folder"

$(package)/__init__.py: src/python/__init__.py
	@install -D -m 644 $< $@
$(package)/core.so: $(python_objects) $(bodies) $(tools) $(methods)
	@mkdir -p $(@D)
	echo "link $@"
	$(CXX) $(CXXFLAGS) -shared $^ $(LDLIBS) -Wl,--exclude-libs,ALL -o $@.tmp.so
	mv $@.tmp.so $@
