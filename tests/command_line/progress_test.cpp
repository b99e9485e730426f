#include "command_line/progress.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <stdexcept>

using command_line::Progress;

TEST_CASE("progress: steps are shown on a terminal and wiped at the end, also when the work fails") {
    std::ostringstream terminal;
    try {
        Progress progress(3, terminal, true);
        progress.step();
        progress.step();
        throw std::runtime_error("the work failed");
    } catch (const std::runtime_error&) {
        terminal << "the error";
    }
    CHECK(terminal.str() == "\r0 of 3\r1 of 3\r2 of 3\r\033[Kthe error");
}

TEST_CASE("progress: nothing is written where nobody looks") {
    std::ostringstream file;
    {
        Progress progress(2, file, false);
        progress.step();
    }
    CHECK(file.str().empty());
}

TEST_CASE("progress: results stand in the order of the cases") {
    const std::vector<int> cases{3, 1, 2};
    const auto squares = command_line::computed_in_parallel(cases, [](int n) { return n * n; });
    CHECK(squares == std::vector<int>{9, 1, 4});
}
