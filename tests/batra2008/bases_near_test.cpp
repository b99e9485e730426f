#include "batra2008/bases_near.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/clouds.hpp"
#include "tests/support/relative.hpp"

using namespace batra2008;
using particles::Cloud;
using particles::TruncatedGaussian;
using ssph_basis::BasesNear;
using ssph_basis::basis_at;
using ssph_basis::Slopes;

namespace {

/// A column of weights with an entry for each of some particles.
Column<double> among(const std::vector<int>& all, const std::vector<int>& some,
                     const Column<double>& weights) {
    Column<double> spread = Column<double>::Zero(static_cast<Index>(all.size()));
    for (std::size_t j = 0; j < some.size(); ++j)
        spread[std::find(all.begin(), all.end(), some[j]) - all.begin()] = weights[static_cast<Index>(j)];
    return spread;
}

}  // namespace

TEST_CASE("BasesNear: at each place of a disc the basis is that of the particles in the support") {
    const Cloud<2> cloud(support::irregular_points<2>(20, 0.3, 4));
    const TruncatedGaussian<2> kernel(3);
    const double h = 0.06;
    const Point<2> centre = cloud.x().col(cloud.nearest({0.45, 0.55}));
    const std::vector<int> near = cloud.within(centre, 4 * h);
    const BasesNear<2> bases(cloud, kernel, h, near, Slopes::known, {});
    CHECK(bases.particle() == near);
    for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
        const Point<2> x = centre + 0.9 * h * Point<2>(std::cos(angle), std::sin(angle));
        const auto shared = bases.basis_at(x);
        const auto own = basis_at<2>(cloud, kernel, x, h);
        REQUIRE(own.particle().size() < near.size());
        for (Index I = 1; I <= 6; ++I) {
            const Column<double> expected = among(near, own.particle(), own.row(I));
            CHECK((shared.row(I) - expected).abs().maxCoeff() < 1e-11 * expected.abs().maxCoeff());
        }
        for (const int axis : {0, 1}) {
            const Column<double> expected = among(near, own.particle(), own.DK(1, axis));
            CHECK((shared.DK(1, axis) - expected).abs().maxCoeff() < 1e-11 * expected.abs().maxCoeff());
        }
    }
}

TEST_CASE("BasesNear: too few particles are refused as basis_at() refuses them, with a remedy") {
    const Cloud<2> cloud(support::grid_points<2>(9));
    const TruncatedGaussian<2> kernel(1.2);
    const std::vector<int> near = cloud.within({0.5, 0.5}, 0.4);
    const Column<double> h = cloud.apart();
    std::string expected;
    try {
        static_cast<void>(basis_at<2>(cloud, kernel, Point<2>(0.5, 0.5), h[0], near, Slopes::none, h));
    } catch (const base::FailedComputation& refused) {
        expected = refused.what();
    }
    CHECK(expected.find("try --scaling") != std::string::npos);
    const BasesNear<2> bases(cloud, kernel, h[0], near, Slopes::none, h);
    CHECK_THROWS_WITH_AS(static_cast<void>(bases.basis_at({0.5, 0.5})), expected.c_str(),
                         base::FailedComputation);
}
