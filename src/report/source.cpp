#include "report/source.hpp"

#include <regex>

#include "report/markdown.hpp"

namespace report {

namespace {

/// What the first group of a pattern matches, occurrence by occurrence.
std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> all;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        all.push_back((*match)[1]);
    return all;
}

}  // namespace

std::vector<std::string> test_cases(const std::string& text) {
    static const std::regex test(R"re(TEST_CASE\(((?:\s*"(?:[^"\\]|\\.)*")+)\s*\))re");
    static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
    std::vector<std::string> names;
    for (const std::string& literals : matches(text, test)) {
        std::string name;
        for (const std::string& part : matches(literals, literal)) name += part;
        names.push_back(replaced(name, "\\\"", "\""));
    }
    return names;
}

std::vector<std::string> keys(const std::string& text, const std::string& command) {
    return matches(text, std::regex("\\\\" + command + R"re(\{([\w.-]+)\})re"));
}

}  // namespace report
