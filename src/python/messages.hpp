#pragma once

#include <string>

namespace python {

/// A message of the package in Python's words: the option `--smoothing-from local` is the keyword
/// smoothing_from="local".
std::string in_python(const std::string& message);

}  // namespace python
