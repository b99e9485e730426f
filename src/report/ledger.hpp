#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "report/papers.hpp"
#include "report/table.hpp"
#include "report/verdict.hpp"

namespace report {

/// Measures the quantity of a claim under one of the two conventions of its paper, 0 or 1: first for the
/// claim as it stands, then for readings that add a condition. The statement is what the paper says; it
/// serves those computations that pick, of several measured numbers, the nearest to it. Nothing under
/// convention 1: it has no bearing on the claim, which convention 0 decides.
using Computation = std::function<std::vector<Measurement>(const Statement&, std::size_t convention)>;

/// Computations by the id of the claim that each decides.
using Computations = std::map<std::string, Computation>;

/// The computations of several sections together. \throws base::InvalidInput where two decide the same claim
Computations joined(std::vector<Computations> sections);

/// The computations that decide a paper's claims in paper/claims.csv.
struct Ledger {
    std::string paper;  ///< its folder: asprone2010
    Computations computations;
};

/// What a row of paper/claims.csv states. The table's numbers are read as numbers, see parsed().
Statement statement(const Table& claims, std::size_t row);

/// What the claim of an id states. \throws base::InvalidInput where there is none
Statement statement(const Table& claims, const std::string& id);

/// A statement in signs: "= 2 ± 0.1".
std::string shown(const Statement& statement);

/// A paper's claims with what was measured under both conventions and the verdicts that follow.
/// \param claims its rows of paper/claims.csv \param after_each called when a claim is decided
/// \throws base::FailedComputation for a claim without a computation, or a computation without a claim
Table judged(const Table& claims, const Paper& paper, const Computations& computations,
             const std::function<void()>& after_each);

}  // namespace report
