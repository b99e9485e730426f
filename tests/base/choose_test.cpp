#include "base/choose.hpp"

#include <doctest/doctest.h>

TEST_CASE("choose: the value of a name, or one message that lists the names") {
    const std::vector<std::pair<std::string, int>> known{{"one", 1}, {"two", 2}};
    CHECK(base::choose("number", "two", known) == 2);
    CHECK(base::choose<int>("number", "one", {{"one", 1}}) == 1);
    for (const char* wanted : {"three", "", "on", "ONE"})
        CHECK_THROWS_WITH_AS(
            base::choose("number", wanted, known),
            ("there is no number '" + std::string(wanted) + "'; choose one of one, two").c_str(),
            base::InvalidInput);
}
