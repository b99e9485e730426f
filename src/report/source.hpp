#pragma once

#include <string>
#include <vector>

namespace report {

/// The names of the test cases in the text of a test file.
std::vector<std::string> test_cases(const std::string& text);

/// What stands in braces behind each occurrence of a command in a text. \param command without backslash:
/// "eq"
std::vector<std::string> keys(const std::string& text, const std::string& command);

}  // namespace report
