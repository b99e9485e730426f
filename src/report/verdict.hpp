#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/choose.hpp"
#include "base/errors.hpp"

namespace report {

/// What a claim says of a quantity: that it equals a number within a tolerance, or lies below or above it.
struct Statement {
    std::string relation;  ///< "=", "<" or ">"
    double expected, tolerance;
};

/// Does a measured number fit the statement? NaN fits none.
/// \throws base::InvalidInput for an unknown relation
inline bool fits(const Statement& statement, double measured) {
    const auto& [relation, expected, tolerance] = statement;
    return base::choose<bool>("relation", relation,
                              {{"=", std::abs(measured - expected) <= tolerance},
                               {"<", measured < expected},
                               {">", measured > expected}});
}

/// A measured number under a condition; the condition is empty for the claim as it stands.
struct Measurement {
    std::string condition;
    double value;
};

/// A convention by its name, "equal", and as a condition, "volumes are equal".
struct Convention {
    std::string name, condition;
};

/// Two conventions that the print does not decide between, and what they are about: "volumes".
struct Conventions {
    std::string about;
    Convention one, other;
};

/// The reading with a condition that decides a claim: the first that fits under both conventions, else the
/// first.
inline std::size_t deciding_reading(const Statement& statement, const std::vector<Measurement>& one,
                                    const std::vector<Measurement>& other) {
    for (std::size_t k = 1; k < std::min(one.size(), other.size()); ++k)
        if (fits(statement, one[k].value) && fits(statement, other[k].value)) return k;
    return 1;
}

/// The verdict on a claim, from measurements under the one convention and under the other.
/// The first measurement of each is of the claim as it stands; further ones are of readings that add a
/// condition.
/// \return "reproduced", "holds only if …", "differs", or "cannot tell" where nothing finite was measured
inline std::string verdict(const Statement& statement, const Conventions& conventions,
                           const std::vector<Measurement>& one, const std::vector<Measurement>& other) {
    const auto finite = [](const std::vector<Measurement>& of) {
        return !of.empty() && std::isfinite(of.front().value);
    };
    if (!finite(one) || !finite(other)) return "cannot tell";
    const bool with_one = fits(statement, one.front().value);
    const bool with_other = fits(statement, other.front().value);
    if (with_one && with_other) return "reproduced";
    if (with_one) return "holds only if " + conventions.one.condition;
    if (with_other) return "holds only if " + conventions.other.condition;
    const std::size_t k = deciding_reading(statement, one, other);
    if (k < std::min(one.size(), other.size()) && fits(statement, one[k].value) &&
        fits(statement, other[k].value))
        return "holds only if " + one[k].condition;
    return "differs";
}

}  // namespace report
