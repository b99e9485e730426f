#include "report/table.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <locale>

#include "base/errors.hpp"

using namespace report;

namespace {

Table example() {
    return {{"a title"},
            {{"name"}, {"count"}, {"error", {1e-3, 1e-9}}},
            {{std::string("first"), 10L, 1.23456789e-5}, {std::string("second"), 20L, std::monostate{}}}};
}

}  // namespace

TEST_CASE("table: comments, tolerances, names, rows; digits follow the tolerance; empty cells stay empty") {
    CHECK(
        csv(example()) ==
        "# a title\n# tolerance of error: relative 0.001, absolute 1e-09\nname,count,error\nfirst,10,1.235e-05\nsecond,20,\n");
}

TEST_CASE("table: what is written is parsed") {
    const Table table = parsed(csv(example()));
    CHECK(table.comments == std::vector<std::string>{"a title"});
    REQUIRE(table.columns.size() == 3);
    CHECK(table.columns[2].name == "error");
    CHECK(table.columns[2].tolerance.relative == 1e-3);
    CHECK(table.columns[2].tolerance.absolute == 1e-9);
    CHECK(table.columns[0].tolerance.relative == 0);
    REQUIRE(table.rows.size() == 2);
    CHECK(std::get<std::string>(table.rows[0][0]) == "first");
    CHECK(std::get<double>(table.rows[0][1]) == 10);
    CHECK(std::get<double>(table.rows[0][2]) == 1.235e-5);
    CHECK(std::holds_alternative<std::monostate>(table.rows[1][2]));
    CHECK(table.column("count") == 1);
    CHECK_THROWS_AS(static_cast<void>(table.column("volume")), base::FailedComputation);
}

TEST_CASE("table: words with commas and quotes come back as they were") {
    const std::string word = "one, \"two\", three";
    const Table table{{}, {{"name"}, {"number"}}, {{word, 2.5}}};
    CHECK(csv(table) == "name,number\n\"one, \"\"two\"\", three\",2.5\n");
    CHECK(parsed(csv(table)).word(0, "name") == word);
    CHECK(parsed(csv(table)).word(0, "number") == "2.5");
}

TEST_CASE("table: read as words, entries that look like numbers stay as they are written") {
    const std::string text = "key,number\n4.10,1e-3\n4.1,\n";
    const Table words = parsed_words(text);
    CHECK(words.word(0, "key") == "4.10");
    CHECK(words.word(0, "number") == "1e-3");
    CHECK(words.word(1, "key") == "4.1");
    CHECK(words.word(1, "number").empty());
    CHECK(parsed(text).word(0, "key") == "4.1");
}

TEST_CASE("table: numbers are written and read with a point in every locale") {
    struct Comma : std::numpunct<char> {
        [[nodiscard]] char do_decimal_point() const override { return ','; }
        [[nodiscard]] char do_thousands_sep() const override { return '.'; }
        [[nodiscard]] std::string do_grouping() const override { return "\\3"; }
    };
    const std::string before = csv(example());
    const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const std::string after = csv(example());
    const Table back = parsed(after);
    std::locale::global(old);
    CHECK(after == before);
    CHECK(std::get<double>(back.rows[0][2]) == 1.235e-5);
}

TEST_CASE("table: other comments are a difference, since they say what was computed") {
    Table other = example();
    other.comments = {"another kernel"};
    CHECK(differences(example(), other).size() == 1);
}

TEST_CASE("table: a number that is not finite is never written") {
    for (const double bad :
         {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), std::nan("")}) {
        Table table = example();
        table.rows[1][2] = bad;
        CHECK_THROWS_WITH_AS(csv(table), "row 2 (second): error is not finite", base::FailedComputation);
    }
}

TEST_CASE("table: rows of another length are refused when written and when read") {
    Table table = example();
    table.rows[0].pop_back();
    CHECK_THROWS_WITH_AS(csv(table), "row 1 has 2 entries for 3 columns", base::FailedComputation);
    CHECK_THROWS_WITH_AS(parsed("a,b\n1,2\n1,2,3\n"), "line 3 has 3 entries for 2 columns",
                         base::FailedComputation);
    CHECK_THROWS_AS(parsed("# nothing\n"), base::FailedComputation);
    CHECK_THROWS_AS(parsed("# tolerance of error: little\nerror\n"), base::FailedComputation);
}

TEST_CASE("table: numbers within the first table's tolerance agree, others and other words do not") {
    const Table committed = parsed(csv(example()));
    const auto with = [&](Cell name, Cell error) {
        Table table = committed;
        table.rows[0][0] = std::move(name);
        table.rows[0][2] = std::move(error);
        return differences(committed, table);
    };
    CHECK(differences(committed, committed).empty());
    CHECK(with(std::string("first"), 1.236e-5).empty());
    CHECK(with(std::string("first"), 1.25e-5).size() == 1);
    CHECK(with(std::string("first"), 1.25e-5)[0] == "row 1 (first), error: 1.235e-05 != 1.25e-05");
    CHECK(with(std::string("fist"), 1.235e-5).size() == 1);
    CHECK(with(std::string("first"), std::monostate{}).size() == 1);
    Table shorter = committed;
    shorter.rows.pop_back();
    CHECK(differences(committed, shorter).size() == 1);
    Table renamed = committed;
    renamed.columns[2].name = "other";
    CHECK(differences(committed, renamed).size() == 1);
    Table lax = committed;
    lax.columns[2].tolerance.absolute = 1;
    CHECK(differences(committed, lax) == std::vector<std::string>{"the tolerance of error"});
    CHECK(differences(parsed("a b,c\n1,2\n"), parsed("a,b c\n1,2\n")).size() == 1);
}

TEST_CASE("table: the largest move is the one that takes most of its tolerance") {
    const Table a = parsed(
        "# tolerance of u: relative 0, absolute 0.5\n# tolerance of v: relative 0.01, absolute 0\nu,v\n1,100\n2,200\n");
    Table b = a;
    CHECK(report::largest_move(a, b).by == 0);
    b.rows[0][0] = 1.125;
    b.rows[1][1] = 199.0;
    const report::Move most = report::largest_move(a, b);
    CHECK(most.row == 1);
    CHECK(most.column == "v");
    CHECK(most.by == 1);
    CHECK(most.share == 0.5);
}

TEST_CASE("table: a tolerance does not let a zero pass for a number") {
    Table a = parsed(csv(example())), b = a;
    a.rows[0][2] = 0.0;
    b.rows[0][2] = 2e-9;
    CHECK(differences(a, b).size() == 1);
    b.rows[0][2] = 0.5e-9;
    CHECK(differences(a, b).empty());
}

TEST_CASE("table: what is read is finite, as what is written, and so are its tolerances") {
    CHECK_THROWS_WITH_AS(static_cast<void>(report::parsed("a\nnan\n")), "row 1: a is not finite",
                         base::FailedComputation);
    CHECK_THROWS_WITH_AS(static_cast<void>(report::parsed("a,b\n1,2\n1,-inf\n")), "row 2: b is not finite",
                         base::FailedComputation);
    for (const std::string relative : {"", "x", "nan", "inf", "-1", "1e999", "1 2"})
        CHECK_THROWS_WITH_AS(static_cast<void>(report::parsed("# tolerance of a: relative " + relative +
                                                              ", absolute 0\na\n1\n")),
                             doctest::Contains("is no tolerance"), base::FailedComputation);
    CHECK_THROWS_AS(static_cast<void>(report::parsed("# tolerance of a: , absolute 1: relative 1\na\n1\n")),
                    base::FailedComputation);
}
