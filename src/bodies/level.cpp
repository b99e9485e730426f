#include "bodies/level.hpp"

#include <algorithm>
#include <utility>

namespace bodies {

double Range::nearest_to_zero() const {
    return lowest <= highest ? std::clamp(0.0, lowest, highest) : 0;
}

template <int dim, int n>
Range range_of(const Problem<dim, n>& problem, const Body<dim>& body, const Conditions<dim, n>& conditions) {
    Range range;
    if constexpr (n == 1)
        for (std::size_t I = 0; I < conditions.size(); ++I)
            for (const Condition<dim, n>& one : conditions[I]) {
                if (!one.of_value && one.exchange == 0) continue;
                const double u = one.of_value
                                     ? one.given
                                     : problem.given[static_cast<std::size_t>(one.from)].surroundings(
                                           body.x.col(static_cast<Index>(I)));
                range = {std::min(range.lowest, u), std::max(range.highest, u)};
            }
    return range;
}

template <int dim, int n>
Problem<dim, n> above_level(Problem<dim, n> problem, double level) {
    if (level == 0) return problem;
    const auto lower = [level](Field<dim>& given) {
        if (given) given = [level, given](const Point<dim>& x) { return given(x) - level; };
    };
    for (Given<dim, n>& given : problem.given) {
        for (Field<dim>& value : given.value) lower(value);
        lower(given.surroundings);
    }
    if (const double of_level = problem.equation.c * level; of_level != 0) {
        const Field<dim, Values<n>> b = std::move(problem.equation.b);
        problem.equation.b = [b, of_level](const Point<dim>& x) {
            return Values<n>((b ? b(x) : Values<n>::Zero()).array() - of_level);
        };
    }
    return problem;
}

template Range range_of(const Problem<2, 1>&, const Body<2>&, const Conditions<2, 1>&);
template Range range_of(const Problem<3, 1>&, const Body<3>&, const Conditions<3, 1>&);
template Range range_of(const Problem<2, 2>&, const Body<2>&, const Conditions<2, 2>&);
template Range range_of(const Problem<3, 3>&, const Body<3>&, const Conditions<3, 3>&);
template Problem<2, 1> above_level(Problem<2, 1>, double);
template Problem<3, 1> above_level(Problem<3, 1>, double);
template Problem<2, 2> above_level(Problem<2, 2>, double);
template Problem<3, 3> above_level(Problem<3, 3>, double);

}  // namespace bodies
