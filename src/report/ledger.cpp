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
         "conditional: what the reading that the verdict names gives, else the first that adds a condition, " +
             about + " " + one.name},
        {{"id"},
         {"section"},
         {"claim"},
         {"quantity"},
         {"statement"},
         {"measured_" + one.name, tolerance},
         {"measured_" + other.name, tolerance},
         {"conditional", tolerance},
         {"verdict"}},
        {}};
}

/// The number of a reading; empty where it was not measured or is not finite.
Cell number(const std::vector<Measurement>& measured, std::size_t reading) {
    const bool known = reading < measured.size() && std::isfinite(measured[reading].value);
    return known ? Cell(measured[reading].value) : Cell();
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
        table.rows.push_back({word("id"), word("section"), word("claim"), word("quantity"), shown(stated),
                              number(with_one, 0), number(with_other, 0),
                              number(with_one, deciding_reading(stated, with_one, with_other)),
                              verdict(stated, paper.conventions, with_one, with_other)});
        after_each();
    }
    if (computations.size() != claims.rows.size())
        throw FailedComputation(std::to_string(computations.size()) + " computations decide " +
                                std::to_string(claims.rows.size()) +
                                " claims; every computation needs its row");
    return table;
}

}  // namespace report
