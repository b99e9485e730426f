#pragma once

#include <functional>
#include <optional>

#include "batra2008/section_4_example_problems.hpp"
#include "command_line/example_cases.hpp"
#include "particles/quality.hpp"

namespace command_line {

/// A solution by any of the methods.
struct Solution {
    std::function<batra2008::Vector(const batra2008::Point<2>&)> displacement;
    std::function<batra2008::example_problems::State(const batra2008::Point<2>&)> state;
    std::optional<double> noise;  ///< of methods whose field need not meet the unknowns
};

/// What the example problems ask of a solution.
inline batra2008::Vector displacement_at(const batra2008::Cloud<2>& /*cloud*/, const Solution& solution,
                                         const batra2008::Point<2>& x) {
    return solution.displacement(x);
}
inline batra2008::example_problems::State state_at(const batra2008::Cloud<2>& /*cloud*/,
                                                   const Solution& solution, const batra2008::Point<2>& x) {
    return solution.state(x);
}

/// A solution with its problem and particles.
struct Solved {
    const batra2008::Problem& problem;
    const batra2008::Cloud<2>& cloud;
    const Solution& solution;
};

/// Costs and quality of a solution.
struct About {
    double assembly = 0, solution = 0;  ///< [s]
    double megabytes = 0;               ///< largest memory meanwhile
    particles::WorstRow worst;          ///< of the derivatives at the particles
};

/// Returns freed memory to the system, so that earlier solutions do not count in the peak of the next.
void give_freed_memory_back();

/// The solution of a case, timed.
/// \throws base::InvalidInput, base::FailedComputation if the method cannot solve the problem
Solution solved(const ExampleCase& one, const batra2008::Problem& problem, const batra2008::Cloud<2>& cloud,
                About& about);

}  // namespace command_line
