#pragma once

#include <string>
#include <vector>

namespace report {

/// The names of the test cases in the text of a test file.
std::vector<std::string> test_cases(const std::string& text);

/// The keys with which a command occurs in a text: A16 for \\defeq{A16}. \param command such as "defeq"
std::vector<std::string> keys(const std::string& text, const std::string& command);

}  // namespace report
