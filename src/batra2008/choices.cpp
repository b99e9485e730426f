#include "batra2008/choices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "report/choices.hpp"

namespace batra2008 {

namespace {

using elastostatics::Corner;
using elastostatics::Plane;
using example_problems::Errors;
using example_problems::Method;
using report::Choice;

constexpr std::array<Method, 3> methods{Method::strong, Method::weak1, Method::weak2};
constexpr std::array<Method, 2> weak{Method::weak1, Method::weak2};

/// How the plate with 16 × 4 particles is solved.
struct Plate {
    plate::Corners corners = plate::default_corners();
    double penalty = 1;  ///< in units of the print's
    Index gauss = 10;    ///< points in each direction
};

struct PlateErrors {
    Errors norms;
    double field;     ///< largest error of u2 at the bottom, by the SSPH field [percent]
    double unknowns;  ///< the same, by the unknowns themselves
};

PlateErrors plate_errors(const Plate& choice, Method method) {
    const elastostatics::Material material{plate::E, plate::nu};
    const Problem problem = plate::problem(material, choice.corners);
    const Cloud<2> cloud(plate::grid(16, 4));
    const auto solution = example_problems::solve(
        problem, cloud, {method, 3, 2, choice.penalty * plate::penalty(material), 1, choice.gauss});
    double error = 0, largest = 0;
    for (Index I = 0; I < cloud.size(); I += 4) {
        const double exact = problem.exact.u(cloud.x().col(I))[1];
        error = std::max(error, std::abs(solution.u[2 * I + 1] - exact));
        largest = std::max(largest, std::abs(exact));
    }
    return {example_problems::errors(plate::mesh(16, 4), cloud, solution, problem),
            plate::largest_error_u2(cloud, solution, problem), 100 * error / largest};
}

double plate_log_dn(const Plate& choice, Method method) {
    return plate_errors(choice, method).norms.log_dn;
}

/// The logarithm of the error around a hole, as the difference of the norms.
double hole_log_dn(const Points<2>& x, Method method, const hole::Shape& shape,
                   const std::vector<Corner>& corners = {}) {
    Problem problem = hole::problem({hole::E, hole::nu, Plane::strain}, shape);
    problem.corners = corners;
    const Cloud<2> cloud(x);
    const auto solution =
        example_problems::solve(problem, cloud, {method, 4, 2, hole::penalty(problem.material)});
    return example_problems::errors(hole::mesh(shape), cloud, solution, problem).log_dn;
}

/// Appends a choice to the others.
void add(std::vector<Choice>& all, const char* choice, const char* one, const char* other,
         const char* quantity, Method method, double with_one, double with_other) {
    all.push_back({choice, one, other, quantity, example_problems::name(method), with_one, with_other});
}

void add_error_norms(std::vector<Choice>& all) {
    for (const Method method : methods) {
        const Errors norms = plate_errors({}, method).norms;
        add(all, "error norm", "difference of the norms (dn)", "norm of the difference (nd)", "log E, plate",
            method, norms.log_dn, norms.log_nd);
    }
}

void add_displacements_at_particles(std::vector<Choice>& all) {
    for (const Method method : methods) {
        const PlateErrors errors = plate_errors({}, method);
        add(all, "displacement at a particle", "SSPH field", "the unknown itself",
            "largest error of u2 in percent, plate", method, errors.field, errors.unknowns);
    }
}

void add_conditions_at_corner_1(std::vector<Choice>& all) {
    Plate other;
    other.corners[0] = {"s11", "s12"};
    const PlateErrors with_one = plate_errors({}, Method::strong),
                      with_other = plate_errors(other, Method::strong);
    add(all, "conditions at corner 1", "s11, s22", "s11, s12", "log E dn, plate", Method::strong,
        with_one.norms.log_dn, with_other.norms.log_dn);
    add(all, "conditions at corner 1", "s11, s22", "s11, s12", "largest error of u2 in percent, plate",
        Method::strong, with_one.field, with_other.field);
}

void add_weak_forms(std::vector<Choice>& all) {
    for (const Method method : weak)
        add(all, "Gauss points", "10", "32", "log E dn, plate", method, plate_log_dn({}, method),
            plate_log_dn({.gauss = 32}, method));
    for (const Method method : weak)
        add(all, "penalty", "the print's", "a hundredth of it", "log E dn, plate", method,
            plate_log_dn({}, method), plate_log_dn({.penalty = 0.01}, method));
    for (const Method method : weak)
        add(all, "penalty", "the print's", "a hundred times it", "log E dn, plate", method,
            plate_log_dn({}, method), plate_log_dn({.penalty = 100}, method));
}

void add_layouts_around_the_hole(std::vector<Choice>& all) {
    const hole::Shape shape;
    const Points<2> reference = hole::graded_layout(shape, 188, 11, 1);
    for (const Method method : methods)
        add(all, "layout around the hole", "graded-188-11, draw 1", "draw 2", "log E dn", method,
            hole_log_dn(reference, method, shape),
            hole_log_dn(hole::graded_layout(shape, 188, 11, 2), method, shape));
    for (const Method method : methods)
        add(all, "layout around the hole", "graded-188-11, draw 1", "polar-11x17", "log E dn", method,
            hole_log_dn(reference, method, shape),
            hole_log_dn(hole::polar_layout(shape, 11, 17), method, shape));
}

void add_radius_and_outer_corner(std::vector<Choice>& all) {
    const hole::Shape shape, larger{0.4, 3};
    const Points<2> layout = hole::polar_layout(shape, 11, 17);
    for (const Method method : methods)
        add(all, "radius of the hole", "0.3 m", "0.4 m", "log E dn, polar-11x17", method,
            hole_log_dn(layout, method, shape),
            hole_log_dn(hole::polar_layout(larger, 11, 17), method, larger));
    const Corner outer{{3, 3}, {plate::condition_named("s11"), plate::condition_named("s12")}};
    add(all, "conditions at the outer corner of the quarter", "s11, s22", "s11, s12", "log E dn, polar-11x17",
        Method::strong, hole_log_dn(layout, Method::strong, shape),
        hole_log_dn(layout, Method::strong, shape, {outer}));
}

}  // namespace

report::Table choices() {
    std::vector<Choice> all;
    add_error_norms(all);
    add_displacements_at_particles(all);
    add_conditions_at_corner_1(all);
    add_weak_forms(all);
    add_layouts_around_the_hole(all);
    add_radius_and_outer_corner(all);
    return report::table_of("Batra and Zhang (2008), Section 4", all);
}

}  // namespace batra2008
