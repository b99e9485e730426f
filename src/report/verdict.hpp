#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "particles/errors.hpp"

namespace report {

/// What a claim says of a quantity: that it equals a number within a tolerance, or lies below or above it.
struct Statement {
    std::string relation;  ///< "=", "<" or ">"
    double expected, tolerance;
};

/// Does a measured number fit the statement? NaN fits none.
/// \throws particles::InvalidInput for an unknown relation
inline bool fits(const Statement& statement, double measured) {
    const auto& [relation, expected, tolerance] = statement;
    if (relation == "=") return std::abs(measured - expected) <= tolerance;
    if (relation == "<") return measured < expected;
    if (relation == ">") return measured > expected;
    throw particles::InvalidInput("there is no relation '" + relation + "'; choose =, < or >");
}

/// A measured number under a condition; the condition is empty for the claim as it stands.
struct Measurement {
    std::string condition;
    double value;
};

/// The verdict on a claim, from measurements under two conventions that the print does not decide between.
/// The first measurement of each is of the claim as it stands; further ones are of readings that add a condition.
/// \return "reproduced", "holds only if …", "differs", or "cannot tell" where nothing finite was measured
inline std::string verdict(const Statement& statement, const std::vector<Measurement>& equal,
                           const std::vector<Measurement>& partition) {
    const auto finite = [](const std::vector<Measurement>& of) {
        return !of.empty() && std::isfinite(of.front().value);
    };
    if (!finite(equal) || !finite(partition)) return "cannot tell";
    const bool with_equal = fits(statement, equal.front().value);
    const bool with_partition = fits(statement, partition.front().value);
    if (with_equal && with_partition) return "reproduced";
    if (with_equal) return "holds only if volumes are equal";
    if (with_partition) return "holds only if volumes are a partition";
    for (std::size_t k = 1; k < std::min(equal.size(), partition.size()); ++k)
        if (fits(statement, equal[k].value) && fits(statement, partition[k].value))
            return "holds only if " + equal[k].condition;
    return "differs";
}

}  // namespace report
