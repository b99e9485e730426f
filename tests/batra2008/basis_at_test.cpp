#include "batra2008/basis_at.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "particles/layouts.hpp"
#include "particles/spacing.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/support/relative.hpp"

using namespace batra2008;
using particles::Cloud;
using particles::TruncatedGaussian;

namespace {

/// The message of the refusal, or nothing.
template <class Work>
std::string refusal(const Work& work) {
    try {
        work();
    } catch (const base::FailedComputation& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("basis_at: too few particles are refused with place and numbers, and the remedy works") {
    const Points<2> grid = support::grid_points<2>(5);
    const Point<2> at_side(0, 0.5);
    CHECK(
        refusal([&] { support::bases(2, grid, 1.2, at_side, 0.25); }) ==
        "ssph_basis: at (0, 0.5) there are 4 particles within 1.2h = 0.3 for the 6 monomials of degree 2; try --scaling 2.1 or --smoothing-from 0.562");  // six particles in two columns, within 1.5h, do not suffice
    CHECK_NOTHROW(support::bases(2, grid, 2.1, at_side, 0.25));
    CHECK_NOTHROW(support::bases(2, grid, 1.2, at_side, 0.562));
    int refused = 0;
    support::for_each_dimension_and_degree([&](int dim, int m) {
        const support::Irregular irregular(dim);
        for (const Eigen::VectorXd& x : irregular.places())
            for (const double rho : {0.3, 0.8, 1.2, 1.6}) {
                const std::string why = refusal([&] { support::bases(m, irregular.x, rho, x, irregular.h); });
                if (why.empty()) continue;
                CAPTURE(why);
                ++refused;
                const std::size_t remedy = why.find("; try --scaling "),
                                  larger_h = why.find(" or --smoothing-from ");
                if (larger_h != std::string::npos) {
                    const double h = std::stod(why.substr(larger_h + 20));
                    CHECK_NOTHROW(support::bases(m, irregular.x, rho, x, h));
                    for (Eigen::Index j = refused % 16; j < irregular.x.cols(); j += 16)
                        CHECK_NOTHROW(support::bases(m, irregular.x, rho, irregular.x.col(j), h));
                }
                REQUIRE(remedy != std::string::npos);
                const double scaling = std::stod(why.substr(remedy + 16));
                CHECK(scaling > rho);
                CHECK_NOTHROW(support::bases(m, irregular.x, scaling, x, irregular.h));
            }
    });
    CHECK(refused > 100);
}

TEST_CASE("basis_at: of two particles that lie close together both are named") {
    Points<2> x(2, 26);
    x << support::grid_points<2>(5), Point<2>(0.5, 0.5009765625);
    CHECK(
        refusal([&] { support::bases(2, x, 3, Point<2>(0.5, 0.5), 1.0 / 1024); }) ==
        "ssph_basis: at (0.5, 0.5) there are 2 particles within 3h = 0.00293 for the 6 monomials of degree 2; particles 12 and 25 lie 0.000977 apart, the next one 0.25; leave one of them out, or try --smoothing-from 0.562");
}

TEST_CASE("basis_at: where no scaling factor helps on a graded cloud, the distance to more particles does") {
    int helped = 0;
    for (unsigned long draw = 1; draw <= 3; ++draw) {
        const Points<2> layout = particles::graded_layout({0.3, 3}, 80, 7, draw);
        for (Eigen::Index j = 40; j < 80; j += 3) {
            const double apart = Cloud<2>(layout).apart()[j];
            Points<2> x(2, 81);
            x << layout, layout.col(j) + apart * Point<2>(0.15, 0.1);
            const Cloud<2> cloud(x);
            const TruncatedGaussian<2> kernel(4);
            const auto solved_with = [&](const Column<double>& h) {
                for (Eigen::Index k = 0; k < 81; ++k)
                    static_cast<void>(ssph_basis::basis_at<2>(cloud, kernel, Point<2>(x.col(k)), h[k]));
            };
            const std::string why = refusal([&] { solved_with(cloud.apart()); });
            const std::size_t at = why.find("; try --smoothing-from ");
            if (at == std::string::npos || !why.ends_with("-nearest")) continue;
            CAPTURE(why);
            ++helped;
            const auto from = particles::spacing_named(why.substr(at + 23));
            CHECK_NOTHROW(solved_with(particles::spacing(cloud, from)));
        }
    }
    CHECK(helped > 10);
}

TEST_CASE("basis_at: a cloud with fewer particles than monomials is refused with the number it needs") {
    CHECK_THROWS_WITH_AS(
        support::bases(2, support::random_points<2>(5, 1), 1000, Point<2>(0.5, 0.25), 0.1),
        "ssph_basis: at (0.5, 0.25) there are 5 particles within 1000h = 100 for the 6 monomials of degree 2; take at least 6 particles in all",
        base::FailedComputation);
}

TEST_CASE(
    "basis_at: particles on a conic do not determine the monomials; no scaling factor helps, another particle does") {
    const Points<2> on_circle = support::circle(12, 1, {0, 0});
    const Point<2> x(0.2, 0);
    const std::string why = refusal([&] { support::bases(2, on_circle, 4, x, 0.5); });
    CHECK(why.starts_with(
        "ssph_basis: at (0.2, 0) there are 12 particles within 4h = 2 for the 6 monomials of degree 2, which they do not determine: the local system is singular (reciprocal condition "));
    CHECK(why.ends_with("); take other particles"));
    CHECK_NOTHROW(support::bases(1, on_circle, 4, x, 0.5));
    Points<2> with_another(2, 13);
    with_another << on_circle, Point<2>(0.1, 0.1);
    CHECK_NOTHROW(support::bases(2, with_another, 4, x, 0.5));
}

TEST_CASE(
    "basis_at: collinear and coplanar particles, and those of two rows, do not determine the monomials") {
    const auto undetermined = [](int m, const Eigen::MatrixXd& x, double rho, const Eigen::VectorXd& at,
                                 double h) {
        const std::string why = refusal([&] { support::bases(m, x, rho, at, h); });
        CAPTURE(why);
        CHECK(why.find(", which they do not determine: ") != std::string::npos);
    };
    Points<2> line = Points<2>::Zero(2, 20);
    line.row(0) = Eigen::RowVectorXd::LinSpaced(20, 0, 1);
    undetermined(1, line, 4, Point<2>(0.5, 0), 0.05);
    Points<3> plane = Points<3>::Zero(3, 100);
    plane.topRows(2) = support::random_points<2>(100, 2);
    undetermined(1, plane, 4, Point<3>(0.5, 0.5, 0), 0.1);
    // On a grid a particle at a distance of ρh has no weight: ρ = 2 leaves a place at the side two rows of
    // three.
    const Points<2> grid = support::grid_points<2>(5);
    undetermined(2, grid, 2, Point<2>(0, 0.5), 0.25);
    CHECK_NOTHROW(support::bases(2, grid, 2.5, Point<2>(0, 0.5), 0.25));
}

TEST_CASE("basis_at: a place so far away that the kernel underflows is refused") {
    Points<2> x = 4 * support::grid_points<2>(5);
    for (const auto& [away, rho] : {std::pair{26.5, 35.0}, {27.0, 35.0}, {30.0, 40.0}}) {
        const Point<2> far(-away, 2);
        const std::string why = refusal([&, rho = rho] { support::bases(2, x, rho, far, 1); });
        CAPTURE(why);
        const std::string before =
            "they do not determine: the kernel's values underflow; try --smoothing-from ";
        const auto remedy = why.find(before);
        REQUIRE(remedy != std::string::npos);
        CHECK_NOTHROW(support::bases(2, x, rho, far, std::stod(why.substr(remedy + before.size()))));
    }
    const std::string why = refusal([&] { support::bases(2, x, 303.1, Point<2>(-300, 2), 1); });
    CHECK(why.ends_with("the kernel's values underflow; take a place nearer to the particles"));
}

TEST_CASE(
    "basis_at: the reciprocal condition is that of the whole matrix, not of the factors up to the fault") {
    // Two rows of three particles: rank 5.
    const std::string why =
        refusal([&] { support::bases(2, support::grid_points<2>(5), 2, Point<2>(0, 0.5), 0.25); });
    const auto number = why.find("reciprocal condition ");
    REQUIRE(number != std::string::npos);
    CHECK(std::stod(why.substr(number + 21)) < 1e-15);
}

TEST_CASE("basis_at: without the kernel's gradient the basis is the same, and its derivatives are refused") {
    const Cloud<2> cloud(support::grid_points<2>(7));
    const TruncatedGaussian<2> kernel(3);
    const Point<2> x(0.4, 0.3);
    const auto with = ssph_basis::basis_at<2>(cloud, kernel, x, 1.0 / 6);
    const auto without = ssph_basis::basis_at<2>(cloud, kernel, x, 1.0 / 6, ssph_basis::Slopes::none);
    CHECK(with.K() == without.K());
    CHECK_NOTHROW((void)with.DK(1, 0));
    CHECK_THROWS_WITH_AS((void)without.DK(1, 0), "this SSPH basis was made without the kernel's gradient",
                         base::InvalidInput);
}

TEST_CASE("basis_at: the derivatives of its functions are the limits of difference quotients") {
    const Cloud<2> cloud(support::grid_points<2>(7));
    const Point<2> x(0.4, 0.3);
    const auto at = [&](const Point<2>& place) {
        return ssph_basis::basis_at<2>(cloud, TruncatedGaussian<2>(2.5), place, 1.0 / 6);
    };
    for (const int axis : {0, 1}) {
        const Point<2> step = 1e-6 * Point<2>::Unit(axis);
        const Column<double> quotient = (at(x + step).row(1) - at(x - step).row(1)) / 2e-6;
        CHECK((at(x).DK(1, axis) - quotient).abs().maxCoeff() < 1e-7 * quotient.abs().maxCoeff());
    }
}

TEST_CASE("basis_at: in one dimension m + 1 particles are needed and suffice") {
    const Points<1> x{{0.1, 0.4, 0.9, 1.1}};
    for (const int m : {1, 2, 3}) {
        CHECK_NOTHROW(support::bases(m, x.leftCols(m + 1), 3, Point<1>(0.5), 0.3));
        if (m > 1)
            CHECK_THROWS_AS(support::bases(m, x.leftCols(m), 3, Point<1>(0.5), 0.3), base::FailedComputation);
    }
}

namespace {

/// A square grid of 5 × 5 particles, each moved at random by at most a part of the spacing.
Cloud<2> nearly_a_grid(double part) {
    return Cloud<2>(support::grid_points<2>(5) +
                    part * 0.25 * (2 * support::random_points<2>(25, 3).array() - 1).matrix());
}

}  // namespace

TEST_CASE(
    "basis_at: R bounds the error of the derivatives of cubics, and does not depend on the unit of length") {
    const Cloud<2> cloud = nearly_a_grid(0.3);
    const Point<2> x = cloud.x().col(12);
    for (const double unit : {1.0, 1000.0}) {
        const Cloud<2> in_unit(unit * cloud.x());
        const double h = 0.25 * unit;
        const auto basis = ssph_basis::basis_at<2>(in_unit, TruncatedGaussian<2>(3), Point<2>(unit * x), h,
                                                   ssph_basis::Slopes::none);
        const auto in_units_of_h =
            ssph_basis::basis_at<2>(Cloud<2>(cloud.x() / 0.25), TruncatedGaussian<2>(3), Point<2>(x / 0.25),
                                    1, ssph_basis::Slopes::none);
        for (const int k : {1, 2}) {
            const double R = ssph_basis::quality(in_units_of_h, k);
            for (int turn = 0; turn < 12;
                 ++turn) {  // f = s^3 / 6 along a direction: its third derivative is 1
                const double angle = turn * std::acos(-1.0) / 12;
                const Point<2> along(std::cos(angle), std::sin(angle));
                for (const auto& a : ssph_basis::monomials<2, 2>()) {
                    if (ssph_basis::order<2>(a) != k) continue;
                    const Column<double> w = ssph_basis::derivative(basis, a);
                    double error = 0;
                    for (Index j = 0; j < w.size(); ++j) {
                        const double s = along.dot(
                            in_unit.x().col(basis.particle()[static_cast<std::size_t>(j)]) - unit * x);
                        error += w[j] * s * s * s / 6;
                    }
                    CHECK(std::abs(error) <= R * std::pow(h, 3 - k) * (1 + 1e-9));
                }
            }
        }
    }
}

TEST_CASE("basis_at: on grids R is largest on a side, whatever their number of particles") {
    for (const Index n : {5, 9, 17}) {
        const Cloud<2> grid(support::grid_points<2>(n));
        const Column<double> h = Column<double>::Constant(n * n, 1.0 / static_cast<double>(n - 1));
        const auto row = ssph_basis::require_quality<2>(grid, TruncatedGaussian<2>(3), h,
                                                        std::vector<int>(static_cast<std::size_t>(n * n), 2));
        CHECK(row.derivative == 2);
        const Point<2> x = grid.x().col(row.particle);
        CHECK((x.minCoeff() == 0 || x.maxCoeff() == 1));
        CHECK(row.R == support::relative(2.34045, 1e-5));
    }
}

TEST_CASE(
    "basis_at: where particles lie nearly on a conic R grows without bound, and a particle is refused with a remedy that works") {
    // Two rows, which a conic describes, their particles aside by a part of the spacing; a third row far off.
    const auto rows = [](double aside) {
        Points<2> x(2, 36);
        for (Index j = 0; j < 36; ++j) {
            const auto k = static_cast<double>(j / 3);
            x.col(j) << k, (j % 3 == 2 ? 3.2 : static_cast<double>(j % 3)) + aside * std::cos(3 * k);
        }
        return Cloud<2>(x);
    };
    const auto judged = [](const Cloud<2>& cloud, double rho) {
        return ssph_basis::require_quality<2>(cloud, TruncatedGaussian<2>(rho), Column<double>::Ones(36),
                                              std::vector<int>(36, 2))
            .R;
    };
    const double R = judged(rows(0.1), 3.1);
    CHECK(R < 1000);
    CHECK(judged(rows(0.05), 3.1) > 1.8 * R);
    const std::string why = refusal([&] { judged(rows(0.001), 3.1); });
    CHECK(
        why ==
        "ssph_basis: at (0, 0.001) there are 7 particles within 3.1h = 3.1 for the 6 monomials of degree 2, and a second derivative from them may err by R h |D3f| with R = 1.18e+03, where 1000 is the most for a solution; try --scaling 3.6 or --smoothing-from 3.02");
    const std::size_t remedy = why.find("; try --scaling ");
    REQUIRE(remedy != std::string::npos);
    CHECK(judged(rows(0.001), std::stod(why.substr(remedy + 16))) < 100);
    CHECK_NOTHROW(ssph_basis::require_quality<2>(
        rows(0.001), TruncatedGaussian<2>(3.1), Column<double>::Constant(36, 3.02), std::vector<int>(36, 2)));
}
