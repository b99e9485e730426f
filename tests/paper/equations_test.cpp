#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/file.hpp"
#include "report/source.hpp"
#include "report/table.hpp"

namespace {

using report::Table;

/// The text of a file by its path below src/ or tests/.
using Texts = std::map<std::string, std::string>;

Texts texts_below(const std::string& folder, const std::string& ending) {
    Texts texts;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (const std::string path = entry.path().generic_string(); path.ends_with(ending))
            texts[path.substr(folder.size() + 1)] = report::read_whole(path);
    return texts;
}

/// The files that define each equation, above its code.
std::map<std::string, std::vector<std::string>> definitions(const Texts& headers) {
    std::map<std::string, std::vector<std::string>> files;
    for (const auto& [file, text] : headers)
        for (const std::string& equation : report::keys(text, "defeq")) files[equation].push_back(file);
    return files;
}

/// Does a test case of a file name an equation by its number, "(16)", or by its key, "(F7)"?
bool named(const std::string& equation, const std::string& test_file) {
    const auto names = report::test_cases(test_file);
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return name.find("(" + equation.substr(1) + ")") != std::string::npos ||
               name.find("(" + equation + ")") != std::string::npos;
    });
}

/// What is wrong with the list of equations: an equation without code or test, code without a row.
std::vector<std::string> complaints(const Table& equations, const Texts& headers, const Texts& tests) {
    std::vector<std::string> found;
    auto defined = definitions(headers);
    for (std::size_t row = 0; row < equations.rows.size(); ++row) {
        const std::string equation = equations.word(row, "equation"), code = equations.word(row, "code"),
                          test = equations.word(row, "test");
        if (defined[equation] != std::vector<std::string>{code})
            found.push_back(equation + " must stand once, in " + code);
        if (tests.count(test) == 0 || !named(equation, tests.at(test)))
            found.push_back(equation + " is named by no test case of " + test);
        defined.erase(equation);
    }
    for (const auto& [equation, files] : defined) found.push_back(equation + " has no row");
    return found;
}

}  // namespace

TEST_CASE(
    "equations: each, the papers' 104 among them, stands once above its code, is named by a test, and has a row") {
    const Table equations = report::parsed_words(report::read_whole("paper/equations.csv"));
    CHECK(std::count_if(equations.rows.begin(), equations.rows.end(), [](const auto& row) {
              return !std::get<std::string>(row.front()).starts_with("F");
          }) == 104);
    for (const std::string& complaint :
         complaints(equations, texts_below("src", ".hpp"), texts_below("tests", "_test.cpp")))
        FAIL_CHECK(complaint);
}

TEST_CASE("equations: one without code, defined twice, without a test or without a row is found") {
    using Complaints = std::vector<std::string>;
    const Table equations =
        report::parsed_words("equation,code,test\nA2,a.hpp,a_test.cpp\nB2.1,b.hpp,b_test.cpp\n");
    const Texts headers{{"a.hpp", "/// \\defeq{A2}\n"}, {"b.hpp", "/// \\defeq{B2.1}\n"}};
    const Texts tests{{"a_test.cpp", "TEST_CASE(\"sums: (2)\") {}"},
                      {"b_test.cpp", "TEST_CASE(\n    \"basis: (2.1) and \"\n    \"more\") {}"}};
    const auto with = [](Texts texts, const std::string& file, const std::string& text) {
        texts[file] = text;
        return texts;
    };
    CHECK(complaints(equations, headers, tests).empty());
    CHECK(complaints(equations, with(headers, "a.hpp", ""), tests) ==
          Complaints{"A2 must stand once, in a.hpp"});
    CHECK(complaints(equations, with(headers, "c.hpp", "\\defeq{A2}"), tests) ==
          Complaints{"A2 must stand once, in a.hpp"});
    CHECK(complaints(equations, headers, with(tests, "a_test.cpp", "TEST_CASE(\"sums: two\") {}")) ==
          Complaints{"A2 is named by no test case of a_test.cpp"});
    CHECK(complaints(equations, headers, with(tests, "b_test.cpp", "TEST_CASE(\"basis: (2.10)\") {}")) ==
          Complaints{"B2.1 is named by no test case of b_test.cpp"});
    CHECK(complaints(equations, with(headers, "c.hpp", "\\defeq{A3}"), tests) == Complaints{"A3 has no row"});
}
