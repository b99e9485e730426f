#include "report/choices.hpp"

#include <doctest/doctest.h>

TEST_CASE("table_of: a row for each choice, under the paper's section") {
    const report::Table table =
        report::table_of("A paper, Section 1", {{"volumes", "equal", "partition", "error", "fpm", 1.5, -2}});
    CHECK(table.comments.front() ==
          "A paper, Section 1: what the print leaves open, and what another choice changes");
    REQUIRE(table.rows.size() == 1);
    CHECK(table.word(0, "choice") == "volumes");
    CHECK(table.word(0, "one") == "equal");
    CHECK(table.word(0, "other") == "partition");
    CHECK(table.word(0, "quantity") == "error");
    CHECK(table.word(0, "formulation") == "fpm");
    CHECK(std::get<double>(table.rows[0][table.column("with_one")]) == 1.5);
    CHECK(std::get<double>(table.rows[0][table.column("with_other")]) == -2);
}
