#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "report/verdict.hpp"

namespace report {

/// A paper that the package reproduces, or a text of our own in the same shape.
struct Paper {
    std::string letter;       ///< first in the keys of its equations and claims: A for A16 and A-5.2-order
    std::string folder;       ///< of its source, tests, data and figures: asprone2010
    std::string citation;     ///< Asprone et al. (2010)
    bool own;                 ///< a text of our own, whose claims are counted apart from the papers'
    Conventions conventions;  ///< under which its claims are measured
};

/// The papers and texts of paper/papers.csv, in its order.
std::vector<Paper> papers(const Table& table);

/// A paper by its folder. \throws base::InvalidInput where there is none of that name
const Paper& paper_named(const std::string& folder, const std::vector<Paper>& papers);

/// The rows of a table whose first entry is an equation's or a claim's key, by the folder of the paper that
/// the key belongs to. Every paper has its part, if an empty one.
/// \throws base::FailedComputation naming a key that belongs to no paper
std::map<std::string, Table> by_paper(const Table& table, const std::vector<Paper>& papers);

}  // namespace report
