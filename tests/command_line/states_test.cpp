#include "command_line/states.hpp"

#include "tests/support/relative.hpp"

using namespace command_line;

TEST_CASE("states: stresses near the incompressible are compared by what they are to strains") {
    const auto tolerance = [](double nu, const std::string& column) {
        ExampleCase of;
        of.material = {2e11, nu, batra2008::elastostatics::Plane::strain};
        report::Table table;
        table.columns = state_columns({of});
        return table.columns[table.column(column)].tolerance.absolute;
    };
    CHECK(tolerance(0.3, "s11") == 10);
    CHECK(tolerance(0.499999, "u1") == tolerance(0.3, "u1"));
    for (const char* column : {"s11", "s22", "s12", "s11_exact"})
        CHECK(tolerance(0.499999, column) == support::relative(33333.5, 1e-5));
}

TEST_CASE("states: places on a line lie at equal distances, its ends among them") {
    const auto places = places_between({0, 0.3}, {0, 3}, 4);
    REQUIRE(places.size() == 4);
    CHECK(places[0][1] == 0.3);
    CHECK(places[1][1] == support::relative(1.2, 1e-15));
    CHECK(places[3][1] == support::relative(3, 1e-15));
}
