#include "report/markdown.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace report;

TEST_CASE("markdown: tables, and text in which nothing counts as markup") {
    CHECK(head({"a", "b"}) + row({"1", ""}) == "| a | b |\n| --- | --- |\n| 1 |  |\n");
    CHECK(escaped("a|b_c < *d*") == "a\\|b\\_c \\< \\*d\\*");
    CHECK(replaced("aaa", "a", "aa") == "aaaaaa");
}

TEST_CASE("markdown: orders are shown to a thousandth, and other numbers as they are written") {
    CHECK(measured("order of D²B at an end", "-0.0002625") == "0");
    CHECK(measured("order of u", "1.99949") == "1.999");
    CHECK(measured("order of u", "").empty());
    CHECK(measured("error of an order", "-0.0002625") == "-0.0002625");
}

TEST_CASE("markdown: the part between two marks is replaced, and marks that are missing are missed") {
    const std::string first = "<!-- the table below is written by make claims -->\n",
                      last = "<!-- end of the table -->";
    CHECK(with_part("x\n" + first + "old\n" + last + "\ny", "table", "new\n", "f") ==
          "x\n" + first + "new\n" + last + "\ny");
    CHECK_THROWS_WITH_AS(with_part(first, "table", "", "a.md"), "a.md has lost the marks of the table",
                         base::FailedComputation);
    CHECK_THROWS_AS(with_part(first + last, "sentence", "", "a.md"), base::FailedComputation);
}
