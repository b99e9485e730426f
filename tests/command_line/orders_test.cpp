#include "command_line/orders.hpp"

#include <doctest/doctest.h>

#include <cmath>

using command_line::add_orders;
using report::Cell;
using report::Table;

namespace {

/// Errors of two methods with the distances 1, 1/2 and 1/4 between particles.
Table errors() {
    Table table;
    table.columns = {{"method"}, {"particles"}, {"error_u"}, {"log_error_dn"}, {"error_u_lower"}};
    for (const std::string method : {"second", "first"})
        for (const double h : {1.0, 0.5, 0.25}) {
            const double e = method == "second" ? 3 * h * h : 3 * h;
            table.rows.push_back({method, std::lround(1 / h), e, std::log10(e), e});
        }
    return table;
}

double spacing(const Table& table, std::size_t row) {
    return 1 / static_cast<double>(std::get<long>(table.rows[row][1]));
}

}  // namespace

TEST_CASE("orders: between the rows of a case, of errors and of their logarithms") {
    Table table = errors();
    const Table before = table;
    add_orders(table, {"method"}, [&](std::size_t row) { return spacing(before, row); });
    REQUIRE(table.columns.size() == 7);
    CHECK(table.columns[5].name == "order_u");
    CHECK(table.columns[6].name == "order_dn");
    for (const std::size_t row : {0U, 3U}) CHECK(table.rows[row][5] == Cell());
    for (const std::size_t row : {1U, 2U})
        for (const std::size_t column : {5U, 6U}) CHECK(table.rows[row][column] == Cell(2.0));
    for (const std::size_t row : {4U, 5U}) CHECK(table.rows[row][5] == Cell(1.0));
}

TEST_CASE("orders: a zero reads as a zero, and errors that are not there have no order") {
    Table table = errors();
    table.rows[1][2] = 3.0 * (1 + 1e-4);
    table.rows[5][2] = Cell();
    table.rows[4][2] = 0.0;
    const Table before = table;
    add_orders(table, {"method"}, [&](std::size_t row) { return spacing(before, row); });
    CHECK(table.word(1, "order_u") == "0");
    CHECK(table.word(4, "order_u").empty());
    CHECK(table.word(5, "order_u").empty());
}

TEST_CASE("orders: a table with one number of particles for each case stays as it is") {
    Table table = errors();
    const std::size_t columns = table.columns.size(), comments = table.comments.size();
    add_orders(table, {"method", "particles"}, [](std::size_t) { return 1.0; });
    CHECK(table.columns.size() == columns);
    CHECK(table.comments.size() == comments);
}

TEST_CASE("orders: the reasons of failures stay the last column") {
    Table table = errors();
    table.columns.push_back({"failure"});
    for (auto& row : table.rows) row.emplace_back();
    table.incomplete = "one of six cases failed";
    const Table before = table;
    add_orders(table, {"method"}, [&](std::size_t row) { return spacing(before, row); });
    CHECK(table.columns.back().name == "failure");
    CHECK(table.rows[1].back() == Cell());
    CHECK(table.word(1, "order_u") == "2");
}

TEST_CASE("orders: round-off has none") {
    Table table;
    table.columns = {{"method"}, {"particles"}, {"error_u", {1e-6, 1e-12}}};
    table.rows = {{"exact", 1L, 1e-15}, {"exact", 2L, 4e-15}, {"small", 1L, 4e-13}, {"small", 2L, 1e-13}};
    const Table before = table;
    add_orders(table, {"method"}, [&](std::size_t row) { return spacing(before, row); });
    CHECK(table.rows[1][3] == Cell());
    CHECK(table.rows[3][3] == Cell(2.0));
}
