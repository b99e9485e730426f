#pragma once

#include <pybind11/pybind11.h>

namespace python {

/// The module's functions, each in the file of its name.
void define_operators(pybind11::module_& module);
void define_weights(pybind11::module_& module);
void define_solve(pybind11::module_& module);

}  // namespace python
