#pragma once

#include <string>
#include <vector>

#include "report/papers.hpp"
#include "report/table.hpp"

namespace report {

/// A paper with its equations, its claims and the verdicts on these.
struct Reproduction {
    Paper paper;
    Table equations, claims, verdicts;
};

/// Every paper that has equations or claims.
/// \throws base::FailedComputation where its verdicts are missing
std::vector<Reproduction> reproductions();

/// Every numbered equation, with its section, its tests and the claims about it: a page in Doxygen's
/// Markdown.
std::string equation_page(const std::vector<Reproduction>& all);

/// The ledger of claims: what each says, its verdict, and what was measured.
/// \throws base::FailedComputation for a claim without a verdict
std::string claims_page(const std::vector<Reproduction>& all);

/// What the print leaves open, measured both ways.
std::string choices_page(const std::vector<Reproduction>& all);

/// The names of the test cases of each file below tests/.
std::string tests_page(const std::vector<Reproduction>& all);

/// What each equation and each claim says, by its key: two objects of JavaScript, for the headings of the
/// pages and their search.
std::string landmarks(const std::vector<Reproduction>& all);

/// The verdicts on all papers in one sentence, or those on texts of our own.
std::string sentence(const std::vector<Reproduction>& all, bool own = false);

/// What the papers hold: command, output, source and verdicts of each item of paper/items.csv.
/// \throws base::FailedComputation for an item of no paper
std::string items(const std::vector<Reproduction>& all);

}  // namespace report
