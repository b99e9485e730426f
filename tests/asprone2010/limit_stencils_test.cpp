#include "asprone2010/limit_stencils.hpp"

#include <cmath>

#include "tests/asprone2010/stencils.hpp"

using namespace asprone2010;
using namespace limit_stencils;
using numerical_tests::Discretisation;
using support::relative;

TEST_CASE("limit_stencils: moments of the central difference") {
    const auto central = support::central_difference();
    CHECK(moment(central, 0) == 0);
    CHECK(moment(central, 1) == 0);
    CHECK(moment(central, 2) == 2);
    CHECK(moment(central, 3) == 0);
    CHECK(absolute_moment(central, 0) == 4);
    CHECK(absolute_moment(central, 3) == 2);
}

TEST_CASE("limit_stencils: a stencil does not depend on the spacing") {
    for (const std::string_view name : support::all_names) {
        CAPTURE(name);
        const auto& formulation = formulation_named<double>(name);
        const auto wide = near_end(formulation, {}, 3, 2, 1.0),
                   narrow = near_end(formulation, {}, 3, 2, std::exp2(-12));
        REQUIRE(wide.w.size() == narrow.w.size());
        CHECK((wide.w - narrow.w).abs().maxCoeff() < 1e-9 * absolute_moment(wide, 0));
    }
}

TEST_CASE("limit_stencils: inside, rows neither feel the end nor lean to a side") {
    for (const auto& kernel :
         {particles::Kernel<>(particles::Gaussian{}), particles::Kernel<>(particles::QuinticSpline{})})
        for (const std::string_view name : support::all_names) {
            CAPTURE(name);
            const Discretisation how{particles::Volumes::equal, kernel, 1.3};
            const Index inside = first_interior(how);
            const auto near = support::near_end(name, 2, how, inside),
                       far = support::near_end(name, 2, how, inside + 7);
            REQUIRE(near.w.size() == far.w.size());
            CHECK(static_cast<double>((near.w - far.w).abs().maxCoeff()) < 1e-15);
            CHECK(static_cast<double>((far.w - far.w.reverse()).abs().maxCoeff()) < 1e-15);
            CHECK(std::abs(static_cast<double>(moment(far, 3))) < 1e-12);
        }
}

TEST_CASE("limit_stencils: one particle closer to the end, the rows of an operator applied twice feel it") {
    const Discretisation how{particles::Volumes::equal, particles::CubicSpline{}, 1.3};
    const auto inside = support::near_end("original", 2, how, first_interior(how)),
               closer = support::near_end("original", 2, how, reach_in_spacings(how) - 1);
    CHECK(inside.w.size() != closer.w.size());
}

TEST_CASE("limit_stencils: a smoothing length that no stencil can have is refused") {
    for (const double smoothing : {0.0, -1.0, 1e3, std::nan("")})
        CHECK_THROWS_AS(reach_in_spacings({particles::Volumes::equal, particles::Gaussian{}, smoothing}),
                        base::InvalidInput);
}
