#include "command_line/timed_solutions.hpp"

#include "tests/programs/run.hpp"

using namespace programs;

TEST_CASE("timed_solutions: --seconds says what a solution took") {
    const auto table = report::parsed(run("plate --method strong --seconds").output);
    for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
        CHECK(std::get<double>(table.rows[0][table.column(name)]) > 0);
}
