#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include "asprone2010/list_of_formulations.hpp"
#include "base/quad.hpp"
#include "particles/kernels.hpp"
#include "particles/quadrature.hpp"
#include "report/file.hpp"
#include "report/statistics.hpp"
#include "tests/support/relative.hpp"

// The kernel and the formulation of doc/extend.md, as they stand there.
namespace particles {

/// Cosine kernel \f$W(s) = \frac16(1 + \cos\frac{\pi s}2)^2\f$, three continuous derivatives, support 2h;
/// times \f$\frac{3\pi}{3\pi^2 - 16}\f$ in the plane and \f$\frac{3\pi}{8\pi^2 - 60}\f$ in space.
template <int dim = 1>
struct Cosine {
    static constexpr std::string_view name = "cosine";

    template <class Scalar>
    static Scalar support() {
        return Scalar(2);
    }
    template <class Scalar>
    static Scalar W(const Scalar& s) {
        using std::cos;
        return factor<Scalar>() * detail::power<2>(1 + cos(angle(s)));
    }
    template <class Scalar>
    static Scalar DW(const Scalar& s) {
        using std::cos, std::sin;
        return -factor<Scalar>() * pi<Scalar>() * (1 + cos(angle(s))) * sin(angle(s));
    }
    template <class Scalar>
    static Scalar D2W(const Scalar& s) {
        using std::cos;
        const Scalar c = cos(angle(s));
        return factor<Scalar>() * detail::power<2>(pi<Scalar>()) / 2 * (1 + c) * (1 - 2 * c);
    }

  private:
    template <class Scalar>
    static Scalar pi() {
        using std::acos;
        return acos(Scalar(-1));
    }
    /// πs/2, and π beyond the support.
    template <class Scalar>
    static Scalar angle(const Scalar& s) {
        const Scalar at_most = chosen(s < 2, s, Scalar(2));
        return pi<Scalar>() / 2 * chosen(at_most > -2, at_most, Scalar(-2));
    }
    template <class Scalar>
    static Scalar factor() {
        const Scalar p = pi<Scalar>();
        return dim == 1 ? Scalar(1) / 6 : dim == 2 ? p / (6 * p * p - 32) : p / (16 * p * p - 120);
    }
};

}  // namespace particles

namespace asprone2010 {

/// The derivatives of the cubic polynomial through \f$B(x_i)\f$ that is nearest to the other values, weighed
/// with \f$W_i\,\Delta\Omega\f$.
namespace cubic_fit {

/// \return weights on \f$B(x_j) - B(x_i)\f$ [1/h, 1/h²]
/// \throws SingularNeighbourhood where the particles do not determine the polynomial
template <class Scalar>
Derivatives<Scalar> derivatives(const Neighbourhood<Scalar>& near) {
    const auto& [r, W, DW, V] = near;
    Eigen::Matrix<Scalar, Eigen::Dynamic, 3> P(r.size(), 3);
    P << r, r * r / 2, r * r * r / 6;
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 3> WP = (W * V).matrix().asDiagonal() * P;
    const Eigen::Matrix<Scalar, 3, 3> A = P.transpose() * WP;
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 3> weights = WP * particles::inverse(A);
    return {weights.col(0), weights.col(1)};
}

}  // namespace cubic_fit
}  // namespace asprone2010

using namespace particles;

namespace {

constexpr int lanes = Pack::lanes;

/// \f$\int W\,dV\f$ by shells.
template <int dim>
double volume() {
    const double sphere = dim == 1 ? 2 : dim == 2 ? 2 * M_PI : 4 * M_PI;
    return integral([&](double s) { return sphere * std::pow(s, dim - 1) * Cosine<dim>::W(s); }, 0, 2);
}

/// A formulation of this page as the list has them.
const asprone2010::Formulation<double> cubic = asprone2010::detail::formulation<double>(
    "cubic_fit", "none", "none", 4, {3, 3},
    [](const auto& near) { return asprone2010::cubic_fit::derivatives(near); });
const asprone2010::Formulation<double> fpm_with_cosine = asprone2010::detail::formulation<double>(
    "cosine_fpm", "4", "(43)", 4, {2, 3}, []<class Scalar>(Neighbourhood<Scalar> near) {
        near.W = near.r.unaryExpr([](const Scalar& s) { return Cosine<>::W(s); });
        near.DW = near.r.unaryExpr([](const Scalar& s) { return Cosine<>::DW(s); });
        return asprone2010::second_order_fpm::derivatives(near);
    });

Operators<> operators_on(const Line<>& line, const asprone2010::Formulation<double>& formulation) {
    return formulation.operators(line, Smoothing<>(CubicSpline{}, 2.5 * line.spacing()));
}

}  // namespace

TEST_CASE("own kernel: it has unit integral on a line, in the plane and in space") {
    CHECK(volume<1>() == support::relative(1, 1e-12));
    CHECK(volume<2>() == support::relative(1, 1e-12));
    CHECK(volume<3>() == support::relative(1, 1e-12));
}

TEST_CASE("own kernel: its derivatives are those of W, and nothing is left beyond its support") {
    const double step = 1e-5;
    for (double s = -2.5; s < 2.5; s += 0.093) {
        const auto slope = [&](const auto& f) { return (f(s + step) - f(s - step)) / (2 * step); };
        CHECK(std::abs(Cosine<>::DW(s) - slope([](double t) { return Cosine<>::W(t); })) < 1e-8);
        CHECK(std::abs(Cosine<>::D2W(s) - slope([](double t) { return Cosine<>::DW(t); })) < 1e-8);
    }
    for (const double s : {-100.0, -2.0, 2.0, 2.001})
        for (const double left : {Cosine<>::W(s), Cosine<>::DW(s), Cosine<>::D2W(s)}) CHECK(left == 0);
}

TEST_CASE("own kernel: packs have the bits of their lanes, and wider scalars the same values") {
    for (double s = -2.3; s < 2.4; s += 0.17) {
        double each[lanes];
        for (int lane = 0; lane < lanes; ++lane) each[lane] = s + 0.1 * lane;
        const Pack pack = Pack::from(each), W = Cosine<>::W(pack), DW = Cosine<2>::DW(pack),
                   D2W = Cosine<3>::D2W(pack);
        for (int lane = 0; lane < lanes; ++lane) {
            CHECK(W[lane] == Cosine<>::W(each[lane]));
            CHECK(DW[lane] == Cosine<2>::DW(each[lane]));
            CHECK(D2W[lane] == Cosine<3>::D2W(each[lane]));
        }
        CHECK(std::abs(static_cast<double>(Cosine<>::W(base::Quad(s)) - Cosine<>::W(s))) < 1e-15);
        CHECK(std::abs(static_cast<double>(Cosine<>::DW(static_cast<long double>(s)) - Cosine<>::DW(s))) <
              1e-15);
    }
}

TEST_CASE("own formulation: both derivatives of cubic polynomials are exact on any particles") {
    const auto line = line_at(perturbed_positions(40, 0.25, 7), Volumes::equal);
    const auto [D, D2] = operators_on(line, cubic);
    const Column<>& x = line.x();
    CHECK((apply(D, Column<>(x.cube() - x)) - (3 * x.square() - 1)).abs().maxCoeff() < 1e-10);
    CHECK((apply(D2, Column<>(x.cube() - x)) - 6 * x).abs().maxCoeff() < 1e-8);
}

TEST_CASE("own kernel: the second-order FPM is exact to its degrees with it") {
    const auto line = line_at(perturbed_positions(40, 0.25, 7), Volumes::equal);
    const auto [D, D2] = operators_on(line, fpm_with_cosine);
    const Column<>& x = line.x();
    CHECK((apply(D, Column<>(x.square() - x)) - (2 * x - 1)).abs().maxCoeff() < 1e-10);
    CHECK((apply(D2, Column<>(x.cube() - x)) - 6 * x).abs().maxCoeff() < 1e-8);
}

TEST_CASE("own kernel, own formulation: second derivatives are second order, ends included") {
    for (const auto& formulation : {cubic, fpm_with_cosine}) {
        CAPTURE(formulation.name);
        std::vector<double> spacing, error;
        for (const Index N : {80, 160, 320}) {
            const auto line = line_at(uniform_positions(N), Volumes::equal);
            const Column<> B = line.x().exp();
            spacing.push_back(line.spacing());
            error.push_back((apply(operators_on(line, formulation).D2, B) - B).abs().maxCoeff());
        }
        CHECK(report::observed_order(spacing, error) == support::relative(2, 0.03));
    }
}

TEST_CASE("own kernel, own formulation: the page shows code that is compiled") {
    const std::string page = report::read_whole("doc/extend.md"),
                      code = report::read_whole("examples/own_kernel.cpp") +
                             report::read_whole("tests/examples/own_kernel_test.cpp");
    int blocks = 0;
    const std::string begin = "```cpp\n", end = "```\n";
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
        const std::size_t first = at + begin.size();
        const std::string block = page.substr(first, page.find(end, first) - first);
        CAPTURE(block);
        CHECK(code.find(block) != std::string::npos);
        ++blocks;
    }
    CHECK(blocks >= 4);
}
