#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
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

/// A number measured under a condition, or the range of numbers that the condition leaves open. The condition
/// is empty for the claim as it stands.
struct Measurement {
    std::string condition;
    double value;
    double upper = value;  ///< end of the range, of which value is the beginning
};

/// Does the measured number, or one of its range, fit the statement? NaN fits none.
/// \throws base::InvalidInput for an unknown relation
inline bool fits(const Statement& statement, const Measurement& measured) {
    const auto& [relation, expected, tolerance] = statement;
    const double distance = std::max(measured.value - expected, expected - measured.upper);
    return base::choose<bool>(
        "relation", relation,
        {{"=", distance <= tolerance}, {"<", measured.value < expected}, {">", measured.upper > expected}});
}

/// A convention by its name, "equal", and as a condition, "volumes are equal".
struct Convention {
    std::string name, condition;
};

/// Two conventions that the print does not decide between, and what they are about: "volumes".
struct Conventions {
    std::string about;
    Convention one, other;
};

/// A verdict, and the measurement of a condition that it rests on, or that was tried without success.
struct Decision {
    std::string verdict;
    std::optional<Measurement> conditional = {};
};

/// The verdict on a claim, from measurements under the one convention and under the other.
///
/// The first measurement of each is of the claim as it stands; further ones are of readings that add a
/// condition. A reading that fits under both conventions goes before one that needs a convention, too.
/// \return "reproduced", "holds only if …", "differs" with the conditions tried, or "cannot tell" where nothing
/// finite was measured
inline Decision decided(const Statement& statement, const Conventions& conventions,
                        const std::vector<Measurement>& one, const std::vector<Measurement>& other) {
    const auto finite = [](const std::vector<Measurement>& of) {
        return !of.empty() && std::isfinite(of.front().value);
    };
    if (!finite(one) || !finite(other)) return {"cannot tell"};
    const auto fitting = [&](const std::vector<Measurement>& of, std::size_t k) {
        return k < of.size() && fits(statement, of[k]);
    };
    if (fitting(one, 0) && fitting(other, 0)) return {"reproduced"};
    if (fitting(one, 0)) return {"holds only if " + conventions.one.condition};
    if (fitting(other, 0)) return {"holds only if " + conventions.other.condition};
    for (std::size_t k = 1; k < one.size(); ++k)
        if (fitting(one, k) && fitting(other, k)) return {"holds only if " + one[k].condition, one[k]};
    for (std::size_t k = 1; k < one.size(); ++k)
        if (fitting(one, k))
            return {"holds only if " + conventions.one.condition + " and " + one[k].condition, one[k]};
    for (std::size_t k = 1; k < other.size(); ++k)
        if (fitting(other, k))
            return {"holds only if " + conventions.other.condition + " and " + other[k].condition, other[k]};
    if (one.size() == 1) return {"differs"};
    std::string tried = "differs, also if " + one[1].condition;
    for (std::size_t k = 2; k < one.size(); ++k) tried += ", or if " + one[k].condition;
    return {tried, one[1]};
}

}  // namespace report
