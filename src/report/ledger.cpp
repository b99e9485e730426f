#include "report/ledger.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace report {

namespace {

using base::FailedComputation;

/// The table of verdicts, without rows.
Table empty_table(const Paper& paper) {
    const auto& [about, one, other] = paper.conventions;
    const Tolerance tolerance{1e-3, 1e-9};
    return {
        {paper.citation + ": every testable statement, what was measured under both conventions of the " +
             about + ", and the verdict that follows",
         "conditional: what was measured under the condition that the verdict names, the first of several; where the condition leaves a range open, conditional is its beginning and conditional_upper its end"},
        {{"id"},
         {"section"},
         {"claim"},
         {"quantity"},
         {"statement"},
         {"measured_" + one.name, tolerance},
         {"measured_" + other.name, tolerance},
         {"conditional", tolerance},
         {"conditional_upper", tolerance},
         {"verdict"}},
        {}};
}

/// A number; empty where it is not finite.
Cell number(double value) {
    return std::isfinite(value) ? Cell(value) : Cell();
}

/// What was measured of the claim as it stands.
Cell as_it_stands(const std::vector<Measurement>& measured) {
    return measured.empty() ? Cell() : number(measured.front().value);
}

const Computation& computation_of(const std::string& id, const Computations& computations) {
    const auto found = computations.find(id);
    if (found == computations.end())
        throw FailedComputation("claim " + id + " has no computation that decides it");
    return found->second;
}

}  // namespace

Computations joined(std::vector<Computations> sections) {
    Computations all;
    for (Computations& section : sections) {
        all.merge(section);
        if (!section.empty())
            throw base::InvalidInput("claim " + section.begin()->first + " has two computations");
    }
    return all;
}

Statement statement(const Table& claims, std::size_t row) {
    const auto value = [&](const char* column) {
        return std::get<double>(claims.rows[row][claims.column(column)]);
    };
    return {claims.word(row, "relation"), value("expected"), value("tolerance")};
}

Statement statement(const Table& claims, const std::string& id) {
    for (std::size_t row = 0; row < claims.rows.size(); ++row)
        if (claims.word(row, "id") == id) return statement(claims, row);
    throw base::InvalidInput("there is no claim " + id);
}

std::string shown(const Statement& statement) {
    const auto& [relation, expected, tolerance] = statement;
    return relation + " " + base::shown(expected) + (tolerance > 0 ? " ± " + base::shown(tolerance) : "");
}

Table judged(const Table& claims, const Paper& paper, const Computations& computations,
             const std::function<void()>& after_each) {
    Table table = empty_table(paper);
    for (std::size_t row = 0; row < claims.rows.size(); ++row) {
        const auto word = [&](const char* column) { return claims.word(row, column); };
        const Computation& measure = computation_of(word("id"), computations);
        const Statement stated = statement(claims, row);
        const auto with_one = measure(stated, 0), with_other = measure(stated, 1);
        const auto [verdict, conditional] =
            decided(stated, paper.conventions, with_one, with_other.empty() ? with_one : with_other);
        const bool definition = word("kind") == "definition" && verdict == "reproduced";
        table.rows.push_back(
            {word("id"), word("section"), word("claim"), word("quantity"), shown(stated),
             as_it_stands(with_one), as_it_stands(with_other),
             conditional ? number(conditional->value) : Cell(),
             conditional && conditional->upper > conditional->value ? number(conditional->upper) : Cell(),
             definition ? "by definition" : verdict});
        after_each();
    }
    if (computations.size() != claims.rows.size())
        throw FailedComputation(std::to_string(computations.size()) + " computations decide " +
                                std::to_string(claims.rows.size()) +
                                " claims; every computation needs its row");
    return table;
}

}  // namespace report
