#include "command_line/timed_solutions.hpp"

#include "tests/programs/run.hpp"

using namespace programs;

TEST_CASE("timed_solutions: --seconds says what a solution took") {
    const auto table = report::parsed(run("plate --method strong --seconds").output);
    for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
        CHECK(std::get<double>(table.rows[0][table.column(name)]) > 0);
}

TEST_CASE("timed_solutions: the memory of a small solution is not that of a large one before it") {
    const auto table = report::parsed(run("plate --method strong --particles 121x25,16x4 --seconds").output);
    const auto megabytes = [&](std::size_t row) {
        return std::get<double>(table.rows[row][table.column("megabytes")]);
    };
    CHECK(megabytes(1) < 0.6 * megabytes(0));
}
