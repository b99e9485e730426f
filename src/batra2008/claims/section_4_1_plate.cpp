#include "batra2008/section_4_1_plate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <string>
#include <vector>

#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"

namespace batra2008::claims {

namespace {

using elastostatics::Plane;
using example_problems::Method;
using Conditions = std::array<std::string, 2>;

/// A case of the plate; by default the one that Section 4.1 begins with.
struct Plate {
    Index nx = 16, ny = 4;
    Method method = Method::strong;
    double scaling = 3;
    int degree = 2;
    Index gauss = 10;
    Conditions corner_1 = {"s11", "s22"}, corner_3 = {"u1", "u2"};
    double nu = plate::nu;
    // clang-tidy takes the 0 of a <=> b < 0 for a pointer. NOLINTNEXTLINE(modernize-use-nullptr)
    std::partial_ordering operator<=>(const Plate&) const = default;
};

struct Errors {
    double log_dn, log_nd;  ///< log E by difference of norms and by norm of difference
    double u2;              ///< largest error of u2 at the bottom, per cent
};

Errors computed(const Plate& at) {
    plate::Corners corners = plate::default_corners();
    corners[0] = at.corner_1;
    corners[2] = at.corner_3;
    const elastostatics::Material material{plate::E, at.nu, Plane::stress};
    const Problem problem = plate::problem(material, corners);
    const Cloud<2> cloud(plate::grid(at.nx, at.ny));
    const auto solution = example_problems::solve(
        problem, cloud, {at.method, at.scaling, at.degree, plate::penalty(material), 1, at.gauss});
    const auto [dn, nd] = example_problems::errors(plate::mesh(at.nx, at.ny), cloud, solution, problem);
    return {dn, nd, plate::largest_error_u2(cloud, solution, problem)};
}

/// The errors of a case; each is computed once.
const Errors& errors(const Plate& at) {
    static std::map<Plate, Errors> known;
    const auto found = known.find(at);
    return found != known.end() ? found->second : known.emplace(at, computed(at)).first->second;
}

double log_E(const Plate& at, Norm norm) {
    return norm == Norm::dn ? errors(at).log_dn : errors(at).log_nd;
}

Computation log_E(const Plate& at) {
    return measured([at](Norm norm) { return log_E(at, norm); });
}

Computation error_of_u2(const Plate& at) {
    return measured([at] { return errors(at).u2; });
}

/// log E of one case less log E of another.
Computation difference_of_log_E(const Plate& one, const Plate& other) {
    return measured([=](Norm norm) { return log_E(one, norm) - log_E(other, norm); });
}

// Cases

struct Grid {
    Index nx, ny;
};
constexpr std::array<Grid, 4> grids{{{16, 4}, {31, 7}, {61, 13}, {91, 19}}};
constexpr std::array methods{Method::strong, Method::weak1, Method::weak2};
const Conditions s11_s12{"s11", "s12"}, s12_s22{"s12", "s22"}, s11_s22{"s11", "s22"};

Plate with_corner_1(const Conditions& conditions, const Grid& grid = grids.front()) {
    return {.nx = grid.nx, .ny = grid.ny, .corner_1 = conditions};
}

Plate with_corner_3(const Conditions& conditions) {
    return {.corner_3 = conditions};
}

/// With a scaling factor of 4.
Plate with_degree(Method method, int degree) {
    return {.method = method, .scaling = 4, .degree = degree};
}

Plate with_gauss(Method method, Index gauss) {
    return {.method = method, .gauss = gauss};
}

/// As in Figure 12.
Plate on_grid(Method method, const Grid& grid) {
    return {.nx = grid.nx, .ny = grid.ny, .method = method, .scaling = 4, .corner_1 = s11_s12};
}

// Measures

/// Largest growth of the error of u2 from ν = 0.33 to ν = 0.499999 in plane stress, over the three methods.
double locking() {
    double most = 0;
    for (const Method method : methods)
        most = std::max(most, errors({.method = method, .nu = 0.499999}).u2 / errors({.method = method}).u2);
    return most;
}

/// Largest log E with σ11 = σ12 = 0 at corner 1 less log E with another pair, over the four grids.
double lead_of_s11_s12(Norm norm) {
    double most = -HUGE_VAL;
    for (const Grid& grid : grids)
        for (const Conditions& other : {s12_s22, s11_s22})
            most = std::max(
                most, log_E(with_corner_1(s11_s12, grid), norm) - log_E(with_corner_1(other, grid), norm));
    return most;
}

/// Fall from 10 to 32 Gauss points in per cent: of E, then of log E.
std::vector<Measurement> fall_with_gauss(Method method, Norm norm) {
    const double at_10 = log_E(with_gauss(method, 10), norm), at_32 = log_E(with_gauss(method, 32), norm);
    return {{"", 100 * (1 - std::pow(10, at_32 - at_10))},
            {"the fall is of log E", 100 * (at_10 - at_32) / std::abs(at_10)}};
}

/// How log E changes from a number of Gauss points up to 32.
struct Course {
    double largest_rise = -HUGE_VAL, largest_fall = -HUGE_VAL;  ///< with one point more
    double range = 0;
};
Course course_with_gauss(Method method, Index from, Norm norm) {
    Course course;
    double least = log_E(with_gauss(method, from), norm), most = least;
    for (Index gauss = from + 1; gauss <= 32; ++gauss) {
        const double before = log_E(with_gauss(method, gauss - 1), norm);
        const double now = log_E(with_gauss(method, gauss), norm);
        course.largest_rise = std::max(course.largest_rise, now - before);
        course.largest_fall = std::max(course.largest_fall, before - now);
        least = std::min(least, now);
        most = std::max(most, now);
    }
    course.range = most - least;
    return course;
}

/// log E of a method over scaling factors from 2.1 to 5.
struct Sweep {
    std::vector<double> scaling, log_error;
};
Sweep sweep(Method method, Norm norm) {
    Sweep result;
    for (int k = 21; k <= 50; ++k) {
        const Plate at{.method = method, .scaling = k / 10.0};
        result.scaling.push_back(at.scaling);
        result.log_error.push_back(log_E(at, norm));
    }
    return result;
}

/// The scaling factor of the least log E, the largest of the three methods.
double scaling_of_least_error(Norm norm) {
    double latest = 0;
    for (const Method method : methods) {
        const auto [scaling, log_error] = sweep(method, norm);
        const auto least = std::min_element(log_error.begin(), log_error.end()) - log_error.begin();
        latest = std::max(latest, scaling[static_cast<std::size_t>(least)]);
    }
    return latest;
}

/// Least fall of log E from the first scaling factor to its least value, of the three methods. \param first
/// the place of the first in the sweep
double fall_with_scaling(std::ptrdiff_t first, Norm norm) {
    double fall = HUGE_VAL;
    for (const Method method : methods) {
        const auto log_error = sweep(method, norm).log_error;
        const auto from = log_error.begin() + first;
        fall = std::min(fall, *from - *std::min_element(from, log_error.end()));
    }
    return fall;
}

/// Widest range of log E over scaling factors from 3.5 to 5, of the three methods.
double range_beyond_3_5(Norm norm) {
    double widest = 0;
    for (const Method method : methods) {
        const auto [scaling, log_error] = sweep(method, norm);
        const auto from = std::find(scaling.begin(), scaling.end(), 3.5) - scaling.begin();
        const auto [least, most] = std::minmax_element(log_error.begin() + from, log_error.end());
        widest = std::max(widest, *most - *least);
    }
    return widest;
}

/// Largest ratio of the error of u2 on a grid to that on the next coarser one, of the three methods.
double ratio_on_finer_grids() {
    double most = 0;
    for (const Method method : methods)
        for (std::size_t k = 1; k < grids.size(); ++k)
            most = std::max(most,
                            errors(on_grid(method, grids[k])).u2 / errors(on_grid(method, grids[k - 1])).u2);
    return most;
}

/// Rate of convergence between the coarsest and the finest grid; the distance of the particles falls to a
/// sixth.
double rate(Method method, Norm norm) {
    return (log_E(on_grid(method, grids.front()), norm) - log_E(on_grid(method, grids.back()), norm)) /
           std::log10(6.0);
}

double range_of_rates(Norm norm) {
    const auto [least, most] =
        std::minmax({rate(Method::strong, norm), rate(Method::weak1, norm), rate(Method::weak2, norm)});
    return most - least;
}

/// Largest log E of one method less that of another, over the four grids.
Computation largest_difference(Method one, Method other) {
    return measured([=](Norm norm) {
        double most = -HUGE_VAL;
        for (const Grid& grid : grids)
            most = std::max(most, log_E(on_grid(one, grid), norm) - log_E(on_grid(other, grid), norm));
        return most;
    });
}

/// Range of log E over the choices at a corner.
template <class Choices>
double range(const Choices& choices, Plate with(const Conditions&), Norm norm) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const Conditions& choice : choices) {
        least = std::min(least, log_E(with(choice), norm));
        most = std::max(most, log_E(with(choice), norm));
    }
    return most - least;
}

double range_at_corner_1(Norm norm) {
    return range(
        plate::choices_at_corner_1(), [](const Conditions& choice) { return with_corner_1(choice); }, norm);
}

double range_at_corner_3(Norm norm) {
    return range(plate::choices_at_corner_3(), with_corner_3, norm);
}

/// log E with u1 and u2 at corner 3 less the least of the other choices.
double lead_of_essential_conditions(Norm norm) {
    double most = -HUGE_VAL;
    for (const Conditions& choice : plate::choices_at_corner_3())
        if (choice != Plate{}.corner_3)
            most = std::max(most, log_E(Plate{}, norm) - log_E(with_corner_3(choice), norm));
    return most;
}

/// Largest σ_ij,j of (4.3), by central differences, over the shear stress F0/L2 per L2.
double divergence_of_stress() {
    const double step = 1e-4;
    double most = 0;
    for (const Point<2>& x : {Point<2>(0.1, 0.03), Point<2>(0.5, 0.17), Point<2>(0.93, 0.1)}) {
        Eigen::Matrix<double, 3, 2> gradient;
        for (Index axis = 0; axis < 2; ++axis)
            gradient.col(axis) = (plate::stress(x + step * Point<2>::Unit(axis)) -
                                  plate::stress(x - step * Point<2>::Unit(axis))) /
                                 (2 * step);
        most = std::max(most, elastostatics::imbalance(gradient, Vector::Zero()).norm());
    }
    return most / (plate::F0 / (plate::L2 * plate::L2));
}

/// Table 2: log E of the strong form, by the conditions at corner 1 and the grid.
report::Computations table_2() {
    return {
        {"B-4.1-table-2-16x4-s11-s12", log_E(with_corner_1(s11_s12, grids[0]))},
        {"B-4.1-table-2-16x4-s12-s22", log_E(with_corner_1(s12_s22, grids[0]))},
        {"B-4.1-table-2-16x4-s11-s22", log_E(with_corner_1(s11_s22, grids[0]))},
        {"B-4.1-table-2-31x7-s11-s12", log_E(with_corner_1(s11_s12, grids[1]))},
        {"B-4.1-table-2-31x7-s12-s22", log_E(with_corner_1(s12_s22, grids[1]))},
        {"B-4.1-table-2-31x7-s11-s22", log_E(with_corner_1(s11_s22, grids[1]))},
        {"B-4.1-table-2-61x13-s11-s12", log_E(with_corner_1(s11_s12, grids[2]))},
        {"B-4.1-table-2-61x13-s12-s22", log_E(with_corner_1(s12_s22, grids[2]))},
        {"B-4.1-table-2-61x13-s11-s22", log_E(with_corner_1(s11_s22, grids[2]))},
        {"B-4.1-table-2-91x19-s11-s12", log_E(with_corner_1(s11_s12, grids[3]))},
        {"B-4.1-table-2-91x19-s12-s22", log_E(with_corner_1(s12_s22, grids[3]))},
        {"B-4.1-table-2-91x19-s11-s22", log_E(with_corner_1(s11_s22, grids[3]))},
        // Largest log E with σ11 = σ12 = 0 less that with another pair
        {"B-4.1-table-2-least", measured(lead_of_s11_s12)},
    };
}

/// The methods on 16 × 4 particles, and what the conditions at the corners change.
report::Computations methods_and_corners() {
    return {
        // log E of each method
        {"B-4.1-E-strong", log_E(Plate{})},
        {"B-4.1-E-weak1", log_E({.method = Method::weak1})},
        {"B-4.1-E-weak2", log_E({.method = Method::weak2})},
        // Largest error of u2 of each method; of the strong form with both conditions at corner 1
        {"B-4.1-u2-strong", readings([]() -> std::vector<Measurement> {
             return {
                 {"", errors(with_corner_1(s11_s12)).u2},
                 {"corner 1 takes s11 and s22, and not what the text above announces", errors(Plate{}).u2}};
         })},
        {"B-4.1-u2-weak1", error_of_u2({.method = Method::weak1})},
        {"B-4.1-u2-weak2", error_of_u2({.method = Method::weak2})},
        // Table 1: log E of the strong form, by the conditions at corner 3, where t1 is -s12 and t2 is -s22
        {"B-4.1-table-1-u1-u2", log_E(with_corner_3({"u1", "u2"}))},
        {"B-4.1-table-1-u1-s12", log_E(with_corner_3({"u1", "s12"}))},
        {"B-4.1-table-1-u1-s22", log_E(with_corner_3({"u1", "s22"}))},
        {"B-4.1-table-1-u2-s22", log_E(with_corner_3({"u2", "s22"}))},
        {"B-4.1-table-1-u2-s12", log_E(with_corner_3({"u2", "s12"}))},
        {"B-4.1-table-1-s12-s22", log_E(with_corner_3({"s12", "s22"}))},
        // Range of log E over the choices at corner 3
        {"B-4.1-corner-3", measured(range_at_corner_3)},
        // Range over the choices at corner 1, divided by that at corner 3
        {"B-4.1-corner-1",
         measured([](Norm norm) { return range_at_corner_1(norm) / range_at_corner_3(norm); })},
        // log E with essential conditions at corner 3 less the least with others
        {"B-4.1-essential-first", measured(lead_of_essential_conditions)},
        // Divergence of the exact stresses
        {"B-4.1-equilibrium", measured(divergence_of_stress)},
    };
}

/// Degree, Poisson's ratio, Gauss points, scaling factor and grid.
report::Computations parameters() {
    return {
        // log E with ρ = 4 and m = 2
        {"B-4.1-quadratic-weak1", log_E(with_degree(Method::weak1, 2))},
        {"B-4.1-quadratic-weak2", log_E(with_degree(Method::weak2, 2))},
        // With m = 1
        {"B-4.1-linear-weak1", log_E(with_degree(Method::weak1, 1))},
        {"B-4.1-linear-weak2", log_E(with_degree(Method::weak2, 1))},
        // log E with m = 1 less log E with m = 2
        {"B-4.1-linear-as-good-weak1",
         difference_of_log_E(with_degree(Method::weak1, 1), with_degree(Method::weak1, 2))},
        {"B-4.1-linear-as-good-weak2",
         difference_of_log_E(with_degree(Method::weak2, 1), with_degree(Method::weak2, 2))},
        // log E of weak1 with m = 1 less that of the strong form with m = 2
        {"B-4.1-linear-weak1-against-strong",
         difference_of_log_E(with_degree(Method::weak1, 1), with_degree(Method::strong, 2))},
        // Smaller error of u2 by weak2 with m = 1 and by the strong form over the larger of weak1
        {"B-4.1-linear-u2", measured([] {
             const auto u2 = [](Method method, int degree) { return errors(with_degree(method, degree)).u2; };
             return std::min(u2(Method::weak2, 1), u2(Method::strong, 2)) /
                    std::max(u2(Method::weak1, 1), u2(Method::weak1, 2));
         })},
        // Growth of the error of u2 as ν approaches one half
        {"B-4.1-no-locking", measured(locking)},
        // Change of log E from 10 to 32 Gauss points in per cent, the larger of weak1 and weak2
        {"B-4.1-gauss-ten", measured([](Norm norm) {
             return std::max(std::abs(fall_with_gauss(Method::weak1, norm).back().value),
                             std::abs(fall_with_gauss(Method::weak2, norm).back().value));
         })},
        // Its fall, of each
        {"B-4.1-gauss-weak1", readings([](Norm norm) { return fall_with_gauss(Method::weak1, norm); })},
        {"B-4.1-gauss-weak2", readings([](Norm norm) { return fall_with_gauss(Method::weak2, norm); })},
        // Largest rise of log E of weak1 with one Gauss point more from 3 on; then its range from 7 on
        {"B-4.1-gauss-monotone", readings([](Norm norm) -> std::vector<Measurement> {
             return {{"", course_with_gauss(Method::weak1, 3, norm).largest_rise},
                     {"n_G is at least 7, from where all of log E keeps to a line's width",
                      course_with_gauss(Method::weak1, 7, norm).range}};
         })},
        // The smaller of the largest rise and the largest fall of log E of weak2, from 7 on
        {"B-4.1-gauss-oscillates", measured([](Norm norm) {
             const Course course = course_with_gauss(Method::weak2, 7, norm);
             return std::min(course.largest_rise, course.largest_fall);
         })},
        // Fall of log E from ρ = 2.1, then from 2.2, to the least of each method; the least of the three
        {"B-4.1-scaling-falls", readings([](Norm norm) -> std::vector<Measurement> {
             return {{"", fall_with_scaling(0, norm)},
                     {"ρ begins at 2.2 and not at 2.1", fall_with_scaling(1, norm)}};
         })},
        // Scaling factor of the least log E
        {"B-4.1-scaling-least", measured(scaling_of_least_error)},
        // Range of log E beyond a scaling factor of 3.5
        {"B-4.1-scaling-stable", measured(range_beyond_3_5)},
        // Largest difference of the rates
        {"B-4.1-rates-alike", measured(range_of_rates)},
        // Largest ratio of the error of u2 on a grid to that on the next coarser one
        {"B-4.1-u2-falls", measured(ratio_on_finer_grids)},
        // Larger error of u2 of the weak forms on 16 × 4 particles
        {"B-4.1-16x4-weak", measured([] {
             return std::max(errors(on_grid(Method::weak1, grids[0])).u2,
                             errors(on_grid(Method::weak2, grids[0])).u2);
         })},
        // Error of u2 of the strong form on 61 × 13 particles
        {"B-4.1-61x13-strong", error_of_u2(on_grid(Method::strong, grids[2]))},
        // Largest log E of weak1 less that of weak2, on four grids
        {"B-4.1-weak1-below-weak2", largest_difference(Method::weak1, Method::weak2)},
        // Largest log E of weak2 less that of the strong form
        {"B-4.1-weak2-below-strong", largest_difference(Method::weak2, Method::strong)},
    };
}

}  // namespace

report::Computations section_4_1() {
    return report::joined({methods_and_corners(), table_2(), parameters()});
}

}  // namespace batra2008::claims
