#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "report/verdict.hpp"

namespace report {

/// What a claim's quantity measures under a convention of its paper, 0 for the one and 1 for the other: first for the claim as it
/// stands, then for readings that add a condition.
using Computation = std::function<std::vector<Measurement>(std::size_t convention)>;

/// The computations that decide a paper's claims in paper/claims.csv, by the claim that each decides.
struct Ledger {
    std::string paper;  ///< its folder: asprone2010
    std::map<std::string, Computation> computations;
};

}  // namespace report
