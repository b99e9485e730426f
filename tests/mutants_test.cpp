#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "report/file.hpp"

TEST_CASE("mutants: each has its place in today's source, so that make mutants breaks what it names") {
    std::istringstream lines(report::read_whole("tests/scripts/mutants.txt"));
    std::string file, source, anchor;
    int mutants = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with("#")) continue;
        if (line.starts_with("@ ")) {
            anchor = line.substr(2);
            INFO(file, ": ", anchor);
            CHECK(source.find(anchor) != std::string::npos);
            CHECK(source.find(anchor) == source.rfind(anchor));
        } else if (line.starts_with("- ")) {
            INFO(file, ": ", line, ", after ", anchor);
            CHECK(source.find(line.substr(2), source.find(anchor) + anchor.size()) != std::string::npos);
        } else if (line.starts_with("+ ")) {
            ++mutants;
        } else {
            file = line;
            source = report::read_whole("src/" + file);
        }
    }
    CHECK(mutants > 300);
}
