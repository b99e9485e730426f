#include "batra2008/section_4_2_hole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"
#include "report/read_table.hpp"
#include "report/statistics.hpp"

namespace batra2008::claims {

namespace {

using elastostatics::Plane;
using example_problems::Method;
using example_problems::Solution;

// On a family of layouts: data/batra2008/layouts.csv

/// Layouts with about the same number of particles. The reference is the first draw of the graded one with
/// radius 0.3.
struct Layouts {
    std::string graded, polar;
};
const Layouts about_188{"graded-188-11", "polar-11x17"}, about_686{"graded-686-21", "polar-21x33"};

/// A column of numbers of a method: on all layouts, the reference first, and on the polar ones alone.
struct Family {
    std::vector<double> all, polar;
};

Family family(Method method, const Layouts& layouts, const std::string& column) {
    static const report::Table table = report::read_table("data/batra2008/layouts.csv");
    Family numbers;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string layout = table.word(row, "layout");
        if (table.word(row, "method") != example_problems::name(method)) continue;
        if (layout != layouts.graded && layout != layouts.polar) continue;
        const double number = std::get<double>(table.rows[row][table.column(column)]);
        const bool reference =
            layout == layouts.graded && table.word(row, "radius") == "0.3" && table.word(row, "draw") == "1";
        numbers.all.insert(reference ? numbers.all.begin() : numbers.all.end(), number);
        if (layout == layouts.polar) numbers.polar.push_back(number);
    }
    if (numbers.all.empty())
        throw base::FailedComputation("data/batra2008/layouts.csv has no rows of " +
                                      example_problems::name(method));
    return numbers;
}

std::string log_E(std::size_t convention) {
    return std::array{"log_error_dn", "log_error_nd"}.at(convention);
}

/// A number on the reference layout, then on the layout that comes nearest to what the paper says.
std::vector<Measurement> on_layouts(const report::Statement& claim, Method method, const Layouts& layouts,
                                    const std::string& column) {
    const std::vector<double> numbers = family(method, layouts, column).all;
    const double nearest = *std::min_element(numbers.begin(), numbers.end(), [&](double a, double b) {
        return std::abs(a - claim.expected) < std::abs(b - claim.expected);
    });
    return {{"", numbers.front()},
            {"the layout that comes nearest of " + std::to_string(numbers.size()) + " is taken", nearest}};
}

Computation on_layouts(Method method, const Layouts& layouts, const std::string& column) {
    return [=](const report::Statement& claim, std::size_t) {
        return on_layouts(claim, method, layouts, column);
    };
}

Computation log_E_on_layouts(Method method, const Layouts& layouts) {
    return [=](const report::Statement& claim, std::size_t convention) {
        return on_layouts(claim, method, layouts, log_E(convention));
    };
}

double median(const std::vector<double>& numbers) {
    return report::quartiles(numbers).median;
}

/// log E of one method and layout less that of another: on the reference, in the median, in the median of
/// polar layouts.
Computation difference_of_log_E(Method one, const Layouts& on_one, Method other, const Layouts& on_other) {
    return [=](const report::Statement&, std::size_t convention) -> std::vector<Measurement> {
        const Family a = family(one, on_one, log_E(convention));
        const Family b = family(other, on_other, log_E(convention));
        return {{"", a.all.front() - b.all.front()},
                {"the median over our layouts is meant", median(a.all) - median(b.all)},
                {"the layout is polar (median)", median(a.polar) - median(b.polar)}};
    };
}

Computation difference_of_methods(Method one, Method other, const Layouts& layouts) {
    return difference_of_log_E(one, layouts, other, layouts);
}

Computation gain_of_more_particles(Method method) {
    return difference_of_log_E(method, about_686, method, about_188);
}

// On the reference layout of 188 particles

const hole::Shape shape;

const Problem& problem() {
    static const Problem plane_strain = hole::problem({hole::E, hole::nu, Plane::strain}, shape);
    return plane_strain;
}

const Cloud<2>& reference() {
    static const Cloud<2> cloud(hole::graded_layout(shape, 188, 11, 1));
    return cloud;
}

/// The solution of a method; each is computed once.
const Solution& solution(Method method) {
    static std::map<Method, Solution> known;
    const auto found = known.find(method);
    if (found != known.end()) return found->second;
    const double penalty = hole::penalty(problem().material);
    return known.emplace(method, example_problems::solve(problem(), reference(), {method, 4, 2, penalty}))
        .first->second;
}

/// The particle at which a component of the displacement deviates most.
Point<2> place_of_largest_deviation(Method method, Index component) {
    const auto& x = reference().x();
    Index worst = 0;
    double most = -1;
    for (Index I = 0; I < x.cols(); ++I) {
        const Vector u = example_problems::state_at(reference(), solution(method), x.col(I)).u;
        const double deviation = std::abs((u - problem().exact.u(x.col(I)))[component]);
        if (deviation > most) {
            most = deviation;
            worst = I;
        }
    }
    return x.col(worst);
}

enum class Quantity { u2, stress };

/// Largest deviation along the x2-axis.
double deviation_on_axis(Method method, Quantity quantity) {
    double most = 0;
    for (int k = 0; k <= 100; ++k) {
        const Point<2> x(0, shape.b + (shape.side - shape.b) * k / 100.0);
        const auto state = example_problems::state_at(reference(), solution(method), x);
        most = std::max(most,
                        std::abs(quantity == Quantity::stress ? state.stress[0] - problem().exact.stress(x)[0]
                                                              : state.u[1] - problem().exact.u(x)[1]));
    }
    return most;
}

/// The largest deviation of weak1 over the smaller of those of the other methods.
Computation deviation_of_weak1(Quantity quantity) {
    return measured([=] {
        return deviation_on_axis(Method::weak1, quantity) /
               std::min(deviation_on_axis(Method::strong, quantity),
                        deviation_on_axis(Method::weak2, quantity));
    });
}

/// Largest deviation of the exact stress concentration from 3 over three values of Poisson's ratio.
double deviation_from_three() {
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
        // Where strong and weak2 deviate most: distance from the x1-axis in u1, from the x2-axis in u2
        {"B-4.2-place-strong-weak2", measured([] {
             return std::max({place_of_largest_deviation(Method::strong, 0)[1],
                              place_of_largest_deviation(Method::weak2, 0)[1],
                              place_of_largest_deviation(Method::strong, 1)[0],
                              place_of_largest_deviation(Method::weak2, 1)[0]});
         })},
        // Where weak1 deviates most: distance from the centre over the hole's radius
        {"B-4.2-place-weak1", measured([] {
             return std::max(place_of_largest_deviation(Method::weak1, 0).norm(),
                             place_of_largest_deviation(Method::weak1, 1).norm()) /
                    shape.b;
         })},
        // log E of one method less that of another
        {"B-4.2-188-weak1-below-weak2", difference_of_methods(Method::weak1, Method::weak2, about_188)},
        {"B-4.2-188-weak2-below-strong", difference_of_methods(Method::weak2, Method::strong, about_188)},
        {"B-4.2-686-weak1-below-weak2", difference_of_methods(Method::weak1, Method::weak2, about_686)},
        {"B-4.2-686-weak2-below-strong", difference_of_methods(Method::weak2, Method::strong, about_686)},
        // log E with 686 particles less that with 188
        {"B-4.2-finer-strong", gain_of_more_particles(Method::strong)},
        {"B-4.2-finer-weak1", gain_of_more_particles(Method::weak1)},
        {"B-4.2-finer-weak2", gain_of_more_particles(Method::weak2)},
        // Largest deviation of weak1 on the x2-axis over the smaller of the others
        {"B-4.2-axis-u2", deviation_of_weak1(Quantity::u2)},
        {"B-4.2-axis-stress", deviation_of_weak1(Quantity::stress)},
        // Deviation of the exact stress concentration from three
        {"B-4.2-exact-concentration", measured(deviation_from_three)},
    };
}

}  // namespace

report::Computations section_4_2() {
    return report::joined({printed_numbers(), comparisons()});
}

}  // namespace batra2008::claims
