#include "fpm_in_space/formulations.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace fpm_in_space;

TEST_CASE("formulations in space: a place is named by the number of sides that it lies on") {
    CHECK(place<2>(0) == "inside");
    CHECK(place<2>(1) == "edge");
    CHECK(place<2>(2) == "corner");
    CHECK(place<3>(0) == "inside");
    CHECK(place<3>(1) == "face");
    CHECK(place<3>(2) == "edge");
    CHECK(place<3>(3) == "corner");
}

TEST_CASE("formulations in space: each has the same name in the plane, in space and in both precisions") {
    for (const std::string& name : formulation_names()) {
        CAPTURE(name);
        const auto& plane = formulation_named<double, 2>(name);
        const auto& space = formulation_named<base::Quad, 3>(name);
        CHECK(plane.name == space.name);
        CHECK(plane.particles < space.particles);
        CHECK(plane.exact.second == space.exact.second);
    }
    CHECK_THROWS_AS((formulation_named<double, 2>("second_order_fpm")), base::InvalidInput);
}
