#pragma once

#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "tests/support/bodies.hpp"

/// The plate and the hole of Batra and Zhang as bodies.
namespace support {

/// Values or tractions of an exact solution on a side. \param valued components whose value is given
inline Given<2, 2> exact_on(const std::string& side, const batra2008::elastostatics::Exact& exact,
                            const std::vector<int>& valued) {
    Given<2, 2> given{side};
    for (const int i : valued)
        given.value[static_cast<std::size_t>(i)] = [u = exact.u, i](const Point<2>& x) { return u(x)[i]; };
    given.loads.push_back([stress = exact.stress](const Point<2>& x, const Point<2>& n) {
        return Values<2>(batra2008::elastostatics::traction(stress(x), n));
    });
    return given;
}

inline batra2008::elastostatics::Material plate_material() {
    return {batra2008::plate::E, batra2008::plate::nu, batra2008::elastostatics::Plane::stress};
}

/// \param n cells along both directions
inline Body<2> plate_body(const std::array<int, 2>& n) {
    return block<2>({n, 0, 1, [](const Point<2>& s) {
                         return Point<2>(batra2008::plate::L1 * s[0], batra2008::plate::L2 * s[1]);
                     }});
}

/// With the conditions of plate::default_corners().
inline Problem<2, 2> plate_problem() {
    const auto exact = batra2008::plate::problem(plate_material()).exact;
    Problem<2, 2> problem{bodies::elasticity<2>(plate_material())};
    problem.given.push_back(exact_on("left", exact, {0, 1}));
    for (const char* side : {"bottom", "right", "top"}) problem.given.push_back(exact_on(side, exact, {}));
    problem.corners = {{{"right", "top"}, {"right", "top"}}, {{"right", "bottom"}, {"right", "bottom"}}};
    return problem;
}

inline batra2008::elastostatics::Material hole_material() {
    return {batra2008::hole::E, batra2008::hole::nu, batra2008::elastostatics::Plane::strain};
}

/// \param N number of particles \param on_arc of these on the hole
inline Body<2> hole_body(Index N, Index on_arc) {
    const batra2008::hole::Shape shape;
    const auto problem = batra2008::hole::problem(hole_material(), shape);
    const std::array<const char*, 5> names{"x1-axis", "right", "top", "x2-axis", "hole"};
    std::vector<std::pair<std::string, particles::Curve>> sides;
    for (std::size_t k = 0; k < names.size(); ++k) sides.emplace_back(names[k], problem.sides[k].curve);
    return body_within(batra2008::hole::graded_layout(shape, N, on_arc, 1), sides, shape.side);
}

/// Named in an order in which the corners have the conditions of elastostatics::conditions_at().
inline Problem<2, 2> hole_problem() {
    const auto exact = batra2008::hole::problem(hole_material(), {}).exact;
    Problem<2, 2> problem{bodies::elasticity<2>(hole_material())};
    for (const char* side : {"right", "top", "hole"}) problem.given.push_back(exact_on(side, exact, {}));
    problem.given.push_back(exact_on("x1-axis", exact, {1}));
    problem.given.push_back(exact_on("x2-axis", exact, {0}));
    problem.corners = {{{"right", "top"}, {"right", "top"}}};
    return problem;
}

}  // namespace support
