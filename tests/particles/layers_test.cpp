#include "particles/layers.hpp"

#include <doctest/doctest.h>

#include "fpm_in_space/formulations.hpp"
#include "tests/support/clouds.hpp"

using namespace particles;

namespace {

/// A grid of nx times ny particles.
Cloud<2> grid(Index nx, Index ny) {
    Points<2> x(2, nx * ny);
    for (Index j = 0; j < x.cols(); ++j)
        x.col(j) = Point<2>(static_cast<double>(j % nx) / 10, static_cast<double>(j / nx) / 10);
    return Cloud<2>(x);
}

/// Why a formulation does not work on a cloud; empty where it does.
template <int dim>
std::string refusal(std::string_view name, const Cloud<dim>& cloud) {
    const auto& formulation = fpm_in_space::formulation_named<double, dim>(name);
    const Smoothing<double, dim> smoothing(TruncatedGaussian<dim>(3.5), spacing(cloud, Spacing::mean), 1.4);
    try {
        static_cast<void>(assemble(cloud, smoothing, formulation.required(), formulation.weights));
    } catch (const base::FailedComputation& failed) {
        return failed.what();
    }
    return "";
}

}  // namespace

TEST_CASE("layers: the coordinates of a grid along each axis, also with round-off") {
    const Cloud<2> cloud = grid(7, 3);
    CHECK(layers(cloud, 0) == 7);
    CHECK(layers(cloud, 1) == 3);
    Points<2> x = cloud.x();
    x(1, 3) += 1e-12;
    CHECK(layers(Cloud<2>(x), 1) == 3);
    x(1, 3) += 1e-3;
    CHECK(layers(Cloud<2>(x), 1) == 4);
}

TEST_CASE("layers: where they are too few for a formulation, the number that it needs is named, and works") {
    for (const char* name : {"definite_fpm", "cubic_ssph", "literal_second_order_fpm"}) {
        CAPTURE(name);
        CHECK(
            refusal(name, grid(16, 3))
                .ends_with(
                    "; take at least 4 layers of particles along x2: fewer do not determine polynomials of degree 3"));
        CHECK(refusal(name, grid(16, 4)).empty());
    }
    CHECK(refusal("ssph", grid(16, 2)).find("; take at least 3 layers of particles along x2: ") !=
          std::string::npos);
    CHECK(refusal("ssph", grid(16, 3)).empty());
    CHECK(refusal("definite_fpm", Cloud<3>(support::grid_points<3>(3))).find("along x1, x2, x3: ") !=
          std::string::npos);
    CHECK(refusal("definite_fpm", Cloud<3>(support::grid_points<3>(4))).empty());
    CHECK(refusal("definite_fpm", Cloud<2>(support::random_points<2>(9, 1)))
              .ends_with("needs 10; take at least 10 particles in all"));
}

TEST_CASE("layers: the degree of complete polynomials by the number of their monomials") {
    CHECK(degree_of<2>(3) == 1);
    CHECK(degree_of<2>(6) == 2);
    CHECK(degree_of<2>(10) == 3);
    CHECK(degree_of<3>(10) == 2);
    CHECK(degree_of<3>(20) == 3);
    CHECK(degree_of<2>(7) == 0);
}
