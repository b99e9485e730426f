#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "bodies/mesh.hpp"
#include "bodies/solution.hpp"

using namespace bodies;

namespace {

/// The unit square with (n + 1)² particles and one side.
Body<2> square(int n) {
    Mesh<2> mesh{Points<2>(2, (n + 1) * (n + 1)), {}, {}};
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.x.col(j * (n + 1) + i) = Point<2>(i, j) / n;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, c = a + n + 1;
            mesh.cells.push_back({a, a + 1, c + 1});
            mesh.cells.push_back({a, c + 1, c});
        }
    return body_of(mesh);
}

}  // namespace

TEST_CASE("solution: reactions that cancel on the one side of a body have a defect of round-off") {
    const Body<2> body = square(8);
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 1.0; })};
    Given<2, 1> warm;
    warm.side = "boundary";
    warm.value = {[](const Point<2>& x) { return 1 + 2 * x[0]; }};
    heat.given.push_back(warm);
    Problem<2, 2> stretched{elasticity<2>({1, 0.3})};
    Given<2, 2> pulled;
    pulled.side = "boundary";
    pulled.value = {[](const Point<2>& x) { return x[0]; }, [](const Point<2>& x) { return x[1]; }};
    stretched.given.push_back(pulled);
    for (const Method method : {Method::hats, Method::strong, Method::fpm}) {
        Discretisation how;
        how.method = method;
        CHECK(balance(heat, body, solve(heat, body, how)).defect < 1e-9);
        CHECK(balance(stretched, body, solve(stretched, body, how)).defect < 1e-9);
    }
}

TEST_CASE("solution: too few particles for fpm are refused with their place") {
    const Body<2> body = square(1);
    Problem<2, 1> heat{diffusion<2>([](const Point<2>&) { return 1.0; })};
    Given<2, 1> warm;
    warm.side = "boundary";
    warm.value = {[](const Point<2>&) { return 1.0; }};
    heat.given.push_back(warm);
    Discretisation how;
    how.method = Method::fpm;
    CHECK_THROWS_WITH_AS(static_cast<void>(solve(heat, body, how)),
                         doctest::Contains("fpm: at (0, 0) there are 4 particles within "),
                         base::FailedComputation);
}
