#include "batra2008/section_4_2_hole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"
#include "report/read_table.hpp"

namespace batra2008::claims {

namespace {

using elastostatics::Plane;
using example_problems::Method;

// On a family of layouts: data/batra2008/layouts.csv

/// Layouts with about the same number of particles: five radii, four draws of the graded one and the polar
/// one for each.
struct Layouts {
    std::string graded, polar;
};
const Layouts about_188{"graded-188-11", "polar-11x17"}, about_686{"graded-686-21", "polar-21x33"};

using Numbers = std::vector<double>;

/// A column of numbers of a method, one for each layout; all columns and methods are in the same order.
Numbers family(Method method, const Layouts& layouts, const std::string& column) {
    static const report::Table table = report::read_table("data/batra2008/layouts.csv");
    Numbers numbers;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string layout = table.word(row, "layout");
        if (table.word(row, "method") == example_problems::name(method) &&
            (layout == layouts.graded || layout == layouts.polar))
            numbers.push_back(std::get<double>(table.rows[row][table.column(column)]));
    }
    if (numbers.empty())
        throw base::FailedComputation("data/batra2008/layouts.csv has no rows of " +
                                      example_problems::name(method));
    return numbers;
}

/// One number for each layout from several columns.
template <class Combine>
Numbers combined(const Combine& combine, const Numbers& first, const std::same_as<Numbers> auto&... others) {
    Numbers numbers;
    for (std::size_t k = 0; k < first.size(); ++k) numbers.push_back(combine(first[k], others.at(k)...));
    return numbers;
}

/// A number for each layout, under a convention of the error norm, 0 or 1.
using OnLayouts = std::function<Numbers(std::size_t convention)>;

/// On how many layouts a statement is true: under both conventions, else under this one.
std::size_t fitting_layouts(const report::Statement& claim, const OnLayouts& numbers,
                            std::size_t convention) {
    const std::array under{numbers(0), numbers(1)};
    std::size_t both = 0, this_one = 0;
    for (std::size_t k = 0; k < under[0].size(); ++k) {
        const std::array fit{report::fits(claim, {"", under[0][k]}), report::fits(claim, {"", under[1][k]})};
        if (fit[0] && fit[1]) ++both;
        if (fit[convention]) ++this_one;
    }
    return both > 0 ? both : this_one;
}

/// The number of these that fits a statement best, and the one that fits worst.
std::array<double, 2> best_and_worst(const report::Statement& claim, const Numbers& numbers) {
    const auto misfit = [&](double number) {
        return claim.relation == "<"   ? number
               : claim.relation == ">" ? -number
                                       : std::abs(number - claim.expected);
    };
    const auto [best, worst] = std::minmax_element(numbers.begin(), numbers.end(),
                                                   [&](double a, double b) { return misfit(a) < misfit(b); });
    return {*best, *worst};
}

/// A claim about a number that each layout has. The layout of the print is lost, so that a statement stands
/// if it is true on every layout of the family. It may hold for the print's if it is true on some, or if a
/// number lies between those of two layouts.
Computation on_layouts(const OnLayouts& numbers) {
    return [=](const report::Statement& claim, std::size_t convention) {
        const Numbers all = numbers(convention);
        const std::string ours = "our " + std::to_string(all.size());
        const auto [best, worst] = best_and_worst(claim, all);
        const std::size_t count = fitting_layouts(claim, numbers, convention);
        std::vector<Measurement> readings{
            {"", worst},
            {"the layout is like " + (count > 0 ? std::to_string(count) : "one") + " of " + ours, best}};
        const auto [least, most] = std::minmax_element(all.begin(), all.end());
        if (claim.relation == "=") readings.push_back({"the layout lies between " + ours, *least, *most});
        return readings;
    };
}

Computation on_layouts(Method method, const Layouts& layouts, const std::string& column) {
    return on_layouts([=](std::size_t) { return family(method, layouts, column); });
}

std::string log_E_column(std::size_t convention) {
    return std::array{"log_error_dn", "log_error_nd"}.at(convention);
}

Numbers log_E(Method method, const Layouts& layouts, std::size_t convention) {
    return family(method, layouts, log_E_column(convention));
}

Computation log_E_on_layouts(Method method, const Layouts& layouts) {
    return on_layouts([=](std::size_t convention) { return log_E(method, layouts, convention); });
}

/// log E of one method and layout less that of another.
Computation difference_of_log_E(Method one, const Layouts& on_one, Method other, const Layouts& on_other) {
    return on_layouts([=](std::size_t convention) {
        return combined(std::minus(), log_E(one, on_one, convention), log_E(other, on_other, convention));
    });
}

Computation difference_of_methods(Method one, Method other, const Layouts& layouts) {
    return difference_of_log_E(one, layouts, other, layouts);
}

Computation gain_of_more_particles(Method method) {
    return difference_of_log_E(method, about_686, method, about_188);
}

/// Angle in degrees between the place where strong and weak2 deviate most and the axis that the print names:
/// in u1 x2 = 0, in u2 x1 = 0. The largest of the four.
Numbers farthest_from_axes() {
    const auto degrees = [](double across, double along) {
        return std::atan2(across, along) * 90 / std::acos(0.0);
    };
    const auto from_axes = [=](Method method) {
        const auto column = [=](const std::string& name) { return family(method, about_188, name); };
        return combined([=](double u1_x1, double u1_x2, double u2_x1,
                            double u2_x2) { return std::max(degrees(u1_x2, u1_x1), degrees(u2_x1, u2_x2)); },
                        column("deviation_u1_x1"), column("deviation_u1_x2"), column("deviation_u2_x1"),
                        column("deviation_u2_x2"));
    };
    return combined([](double a, double b) { return std::max(a, b); }, from_axes(Method::strong),
                    from_axes(Method::weak2));
}

/// How far from the centre weak1 deviates most, over the hole's radius.
Numbers farthest_from_hole() {
    const auto column = [](const std::string& name) { return family(Method::weak1, about_188, name); };
    return combined(
        [](double u1_x1, double u1_x2, double u2_x1, double u2_x2, double radius) {
            return std::max(std::hypot(u1_x1, u1_x2), std::hypot(u2_x1, u2_x2)) / radius;
        },
        column("deviation_u1_x1"), column("deviation_u1_x2"), column("deviation_u2_x1"),
        column("deviation_u2_x2"), column("radius"));
}

/// A deviation of weak1 over the smaller of those of the other methods.
Computation weak1_over_others(const Layouts& layouts, const std::string& column,
                              const std::function<double(double)>& deviation) {
    return on_layouts([=](std::size_t) {
        return combined(
            [&](double strong, double weak1, double weak2) {
                return deviation(weak1) / std::min(deviation(strong), deviation(weak2));
            },
            family(Method::strong, layouts, column), family(Method::weak1, layouts, column),
            family(Method::weak2, layouts, column));
    });
}

/// Share of 101 places on the x2-axis at which u2 of weak1 is closest to the exact one, on each layout of 188
/// particles.
Numbers shares_of_axis() {
    Numbers shares;
    const auto share = [&](const hole::Shape& shape, const Points<2>& x) {
        const Problem problem = hole::problem({hole::E, hole::nu, Plane::strain}, shape);
        const Cloud<2> cloud(x);
        const auto deviations = [&](Method method) {
            const auto solution =
                example_problems::solve(problem, cloud, {method, 4, 2, hole::penalty(problem.material)});
            Numbers size;
            for (int k = 0; k <= 100; ++k) {
                const Point<2> at(0, shape.b + (shape.side - shape.b) * k / 100.0);
                size.push_back(
                    std::abs(example_problems::state_at(cloud, solution, at).u[1] - problem.exact.u(at)[1]));
            }
            return size;
        };
        const Numbers closest =
            combined([](double strong, double weak1,
                        double weak2) { return weak1 <= std::min(strong, weak2) ? 1.0 : 0.0; },
                     deviations(Method::strong), deviations(Method::weak1), deviations(Method::weak2));
        shares.push_back(std::accumulate(closest.begin(), closest.end(), 0.0) / 101);
    };
    for (const double radius : {0.25, 0.3, 0.35, 0.4, 0.5}) {
        for (const unsigned long draw : {1, 2, 3, 4})
            share({radius}, hole::graded_layout({radius}, 188, 11, draw));
        share({radius}, hole::polar_layout({radius}, 11, 17));
    }
    return shares;
}

/// The largest deviation of the three methods, on each layout.
Numbers largest_of_methods(const Layouts& layouts, const std::string& column,
                           const std::function<double(double)>& deviation) {
    return combined(
        [&](double strong, double weak1, double weak2) {
            return std::max({deviation(strong), deviation(weak1), deviation(weak2)});
        },
        family(Method::strong, layouts, column), family(Method::weak1, layouts, column),
        family(Method::weak2, layouts, column));
}

double from_three(double concentration) {
    return std::abs(concentration - 3);
}

double itself(double deviation) {
    return deviation;
}

/// The most of the numbers printed for this many particles that one layout and one error norm give.
double most_at_once(const std::string& particles, const Layouts& layouts, std::size_t convention) {
    const report::Table claims = report::read_table("paper/claims.csv");
    Numbers fitting(25);
    for (const Method method : {Method::strong, Method::weak1, Method::weak2})
        for (const auto& [quantity, column] :
             std::vector<std::pair<std::string, std::string>>{{"concentration", "stress_concentration"},
                                                              {"E", log_E_column(convention)},
                                                              {"u1", "deviation_u1_mm"},
                                                              {"u2", "deviation_u2_mm"}}) {
            if (particles == "686" && quantity.starts_with("u")) continue;  // printed for 188 only
            const auto claim = report::statement(
                claims, "B-4.2-" + particles + "-" + quantity + "-" + example_problems::name(method));
            const Numbers numbers = family(method, layouts, column);
            for (std::size_t k = 0; k < numbers.size(); ++k)
                fitting.at(k) += report::fits(claim, {"", numbers[k]}) ? 1 : 0;
        }
    return *std::max_element(fitting.begin(), fitting.end());
}

Computation at_once(const std::string& particles, const Layouts& layouts) {
    return [=](const report::Statement&, std::size_t convention) {
        return std::vector<Measurement>{{"", most_at_once(particles, layouts, convention)}};
    };
}

/// The largest deviation of u2 along the x2-axis with 686 particles over that with 188, the largest of the
/// three methods.
Numbers closer_with_more_particles() {
    const auto ratio = [](Method method) {
        return combined(std::divides(), family(method, about_686, "axis_deviation_u2_mm"),
                        family(method, about_188, "axis_deviation_u2_mm"));
    };
    return combined(
        [](double strong, double weak1, double weak2) {
            return std::max({strong, weak1, weak2});
        },
        ratio(Method::strong), ratio(Method::weak1), ratio(Method::weak2));
}

// Without layouts

/// Largest deviation of the exact stress concentration from 3 over three values of Poisson's ratio.
double deviation_from_three() {
    const hole::Shape shape;
    double most = 0;
    for (const double nu : {0.0, 0.33, 0.49})
        most = std::max(most,
                        std::abs(hole::along_x2_axis({hole::E, nu, Plane::strain}, shape, shape.b)[1] - 3));
    return most;
}

report::Computations printed_numbers() {
    const auto concentration = [](Method method, const Layouts& layouts) {
        return on_layouts(method, layouts, "stress_concentration");
    };
    const auto deviation = [](Method method, const std::string& component) {
        return on_layouts(method, about_188, "deviation_" + component + "_mm");
    };
    return {
        // Stress concentration at the top of the hole
        {"B-4.2-188-concentration-strong", concentration(Method::strong, about_188)},
        {"B-4.2-188-concentration-weak1", concentration(Method::weak1, about_188)},
        {"B-4.2-188-concentration-weak2", concentration(Method::weak2, about_188)},
        {"B-4.2-686-concentration-strong", concentration(Method::strong, about_686)},
        {"B-4.2-686-concentration-weak1", concentration(Method::weak1, about_686)},
        {"B-4.2-686-concentration-weak2", concentration(Method::weak2, about_686)},
        // log E
        {"B-4.2-188-E-strong", log_E_on_layouts(Method::strong, about_188)},
        {"B-4.2-188-E-weak1", log_E_on_layouts(Method::weak1, about_188)},
        {"B-4.2-188-E-weak2", log_E_on_layouts(Method::weak2, about_188)},
        {"B-4.2-686-E-strong", log_E_on_layouts(Method::strong, about_686)},
        {"B-4.2-686-E-weak1", log_E_on_layouts(Method::weak1, about_686)},
        {"B-4.2-686-E-weak2", log_E_on_layouts(Method::weak2, about_686)},
        // Largest deviations of the displacements over the particles, in mm
        {"B-4.2-188-u1-strong", deviation(Method::strong, "u1")},
        {"B-4.2-188-u2-strong", deviation(Method::strong, "u2")},
        {"B-4.2-188-u1-weak1", deviation(Method::weak1, "u1")},
        {"B-4.2-188-u2-weak1", deviation(Method::weak1, "u2")},
        {"B-4.2-188-u1-weak2", deviation(Method::weak2, "u1")},
        {"B-4.2-188-u2-weak2", deviation(Method::weak2, "u2")},
    };
}

report::Computations comparisons() {
    return {
        // Where strong and weak2 deviate most: angle from the x1-axis in u1, from the x2-axis in u2
        {"B-4.2-place-strong-weak2", on_layouts([](std::size_t) { return farthest_from_axes(); })},
        // Where weak1 deviates most: distance from the centre over the hole's radius
        {"B-4.2-place-weak1", on_layouts([](std::size_t) { return farthest_from_hole(); })},
        // log E of one method less that of another
        {"B-4.2-188-weak1-below-weak2", difference_of_methods(Method::weak1, Method::weak2, about_188)},
        {"B-4.2-188-weak2-below-strong", difference_of_methods(Method::weak2, Method::strong, about_188)},
        {"B-4.2-686-weak1-below-weak2", difference_of_methods(Method::weak1, Method::weak2, about_686)},
        {"B-4.2-686-weak2-below-strong", difference_of_methods(Method::weak2, Method::strong, about_686)},
        // log E with 686 particles less that with 188
        {"B-4.2-finer-strong", gain_of_more_particles(Method::strong)},
        {"B-4.2-finer-weak1", gain_of_more_particles(Method::weak1)},
        {"B-4.2-finer-weak2", gain_of_more_particles(Method::weak2)},
        // Share of the places on the x2-axis at which weak1 is closest in u2
        {"B-4.2-axis-u2", on_layouts([](std::size_t) {
             static const Numbers shares = shares_of_axis();
             return shares;
         })},
        // Largest deviation of σ11 by weak1 on the x2-axis over the smaller of the others
        {"B-4.2-axis-stress", weak1_over_others(about_188, "axis_deviation_s11", itself)},
        // Largest deviation of u2 on the x2-axis with 686 particles over that with 188
        {"B-4.2-686-much-closer", on_layouts([](std::size_t) { return closer_with_more_particles(); })},
        // Deviation of the concentration from three, weak1 over the smaller of the others
        {"B-4.2-686-best-concentration", weak1_over_others(about_686, "stress_concentration", from_three)},
        // Largest deviation of the concentrations from three, and of σ11 on the x2-axis, of the three methods
        {"B-4.2-686-concentrations", on_layouts([](std::size_t) {
             return largest_of_methods(about_686, "stress_concentration", from_three);
         })},
        {"B-4.2-686-stresses",
         on_layouts([](std::size_t) { return largest_of_methods(about_686, "axis_deviation_s11", itself); })},
        // The most printed numbers that one layout gives
        {"B-4.2-188-at-once", at_once("188", about_188)},
        {"B-4.2-686-at-once", at_once("686", about_686)},
        // Deviation of the exact stress concentration from three
        {"B-4.2-exact-concentration", measured(deviation_from_three)},
    };
}

}  // namespace

report::Computations section_4_2() {
    return report::joined({printed_numbers(), comparisons()});
}

}  // namespace batra2008::claims
