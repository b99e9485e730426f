#include "particles/kernels.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <type_traits>
#include <variant>

#include "base/quad.hpp"
#include "particles/centred_kernel.hpp"
#include "particles/quadrature.hpp"
#include "tests/support/relative.hpp"

using namespace particles;
using std::numbers::pi;

namespace {

using OnLine = std::integral_constant<int, 1>;
using InPlane = std::integral_constant<int, 2>;
using InSpace = std::integral_constant<int, 3>;

template <int dim>
double W(const Kernel<dim>& kernel, double s) {
    return std::visit([&](const auto& k) { return k.W(s); }, kernel);
}
template <int dim>
double DW(const Kernel<dim>& kernel, double s) {
    return std::visit([&](const auto& k) { return k.DW(s); }, kernel);
}
template <int dim>
double D2W(const Kernel<dim>& kernel, double s) {
    return std::visit([&](const auto& k) { return k.D2W(s); }, kernel);
}

/// The kernels that need no number, and lowered Gaussians.
template <int dim>
void for_all_kernels(const std::function<void(const Kernel<dim>&)>& visit) {
    for_each_kernel<dim>(visit);
    for (const double rho : {0.5, 1.0, 2.1, 3.0, 4.0, 6.0}) visit(Kernel<dim>(TruncatedGaussian<dim>(rho)));
}

/// Points on the unit sphere of so many dimensions and their weights, exact on polynomials of degree 7.
template <int dim>
std::pair<Offsets<double, dim>, Column<double>> sphere() {
    constexpr Index around = 8;
    const Column<double> angle = Column<double>::LinSpaced(around, 0.1, 0.1 + 2 * pi * (around - 1) / around);
    if constexpr (dim == 1) {
        return {Offsets<double, 1>{{-1, 1}}, Column<double>::Ones(2)};
    } else if constexpr (dim == 2) {
        Offsets<double, 2> place(around, 2);
        place << angle.cos(), angle.sin();
        return {place, Column<double>::Constant(around, 2 * pi / around)};
    } else {
        const auto [z, w] = gauss_rule(4, -1, 1);
        Offsets<double, 3> place(z.size() * around, 3);
        Column<double> weight(z.size() * around);
        for (Index k = 0; k < z.size(); ++k) {
            const double r = std::sqrt(1 - z[k] * z[k]);
            place.middleRows(k * around, around) << r * angle.cos(), r * angle.sin(),
                Column<double>::Constant(around, z[k]);
            weight.segment(k * around, around).setConstant(w[k] * 2 * pi / around);
        }
        return {place, weight};
    }
}

/// A function of offsets on a sphere, their kernel values and gradients.
template <int dim>
using Integrand = std::function<Column<double>(const Offsets<double, dim>&, const Column<double>&,
                                               const Offsets<double, dim>&)>;

/// ∫ f dV over the support, by shells between the knots, where splines change their polynomial.
template <int dim>
double integral(const Kernel<dim>& kernel, const std::type_identity_t<Integrand<dim>>& f) {
    const auto [place, weight] = sphere<dim>();
    const auto shell = [&, &place = place, &weight = weight](double radius) {
        const Offsets<double, dim> s = radius * place;
        Column<double> W;
        Offsets<double, dim> DW;
        evaluate(kernel, s, W, DW);
        return std::pow(radius, dim - 1) * (weight * f(s, W, DW)).sum();
    };
    const auto edge = particles::support<double>(kernel);
    double sum = 0;
    for (int knot = 0; knot < edge; ++knot)
        sum += particles::integral(shell, knot, std::min<double>(knot + 1, edge));
    return sum;
}

/// Some offsets within and beyond the supports, one of them zero.
template <int dim>
Offsets<double, dim> some_offsets() {
    Offsets<double, dim> s(301, dim);
    for (Index k = 0; k < s.rows(); ++k)
        for (Index axis = 0; axis < dim; ++axis)
            s(k, axis) = 0.027 * static_cast<double>(k) * std::sin(static_cast<double>(k * (axis + 1)));
    return s;
}

}  // namespace

TEST_CASE_TEMPLATE("kernels: condition (1) of Section 2, non-negative", Dim, OnLine, InPlane, InSpace) {
    for_all_kernels<Dim::value>([](const auto& kernel) {
        CAPTURE(name(kernel));
        for (double s = -7; s <= 7; s += 0.01) CHECK(W(kernel, s) >= 0);
        CHECK(W(kernel, 0) > 0);
    });
}

TEST_CASE("kernels: condition (2), unit integral") {
    for_each_kernel([](const Kernel<>& kernel) {
        CAPTURE(name(kernel));
        const auto W_i = centred(kernel, 0.3, 0.7, {-10, 10});
        CHECK(W_i.integral(W_i.W) == support::relative(1, 1e-14));
    });
}

TEST_CASE_TEMPLATE("kernels: unit integral, no first moments, second moments alike in all directions", Dim,
                   OnLine, InPlane, InSpace) {
    for_all_kernels<Dim::value>([](const auto& kernel) {
        CAPTURE(name(kernel));
        CHECK(integral(kernel, [](const auto&, const auto& W, const auto&) { return W; }) ==
              support::relative(1, 1e-12));
        const double second = integral(kernel, [](const auto& s, const auto& W, const auto&) {
            return (W * s.square().rowwise().sum()).eval();
        });
        for (int a = 0; a < Dim::value; ++a) {
            CHECK(std::abs(integral(kernel, [a](const auto& s, const auto& W, const auto&) {
                      return (W * s.col(a)).eval();
                  })) < 1e-14);
            for (int b = 0; b < Dim::value; ++b) {
                const double found = integral(kernel, [a, b](const auto& s, const auto& W, const auto&) {
                    return (W * s.col(a) * s.col(b)).eval();
                });
                CHECK(std::abs(found - (a == b ? second / Dim::value : 0)) < 1e-12);
            }
        }
    });
}

TEST_CASE_TEMPLATE("kernels: the gradient's first moments are minus the identity, by parts", Dim, OnLine,
                   InPlane, InSpace) {
    for_all_kernels<Dim::value>([](const auto& kernel) {
        CAPTURE(name(kernel));
        for (int a = 0; a < Dim::value; ++a)
            for (int b = 0; b < Dim::value; ++b) {
                const double found = integral(kernel, [a, b](const auto& s, const auto&, const auto& DW) {
                    return (DW.col(a) * s.col(b)).eval();
                });
                CHECK(std::abs(found - (a == b ? -1 : 0)) < 1e-12);
            }
    });
}

TEST_CASE_TEMPLATE("kernels: condition (3), derivable with continuous derivatives", Dim, OnLine, InPlane,
                   InSpace) {
    for_each_kernel<Dim::value>([](const auto& kernel) {
        CAPTURE(name(kernel));
        const double step = 1e-5;
        for (double s = -3.97; s <= 4; s += 0.0937) {
            const double DW_found = (W(kernel, s + step) - W(kernel, s - step)) / (2 * step);
            const double D2W_found = (DW(kernel, s + step) - DW(kernel, s - step)) / (2 * step);
            CHECK(std::abs(DW(kernel, s) - DW_found) < 1e-8);
            CHECK(std::abs(D2W(kernel, s) - D2W_found) < 1e-4);
        }
        for (int knot = -3; knot <= 3; ++knot)
            for (const auto& f : {W<Dim::value>, DW<Dim::value>, D2W<Dim::value>}) {
                CAPTURE(knot);
                CHECK(std::abs(f(kernel, knot + 1e-9) - f(kernel, knot - 1e-9)) < 1e-7);
            }
    });
}

TEST_CASE_TEMPLATE("kernels: condition (4), nothing beyond the support", Dim, OnLine, InPlane, InSpace) {
    for_all_kernels<Dim::value>([](const auto& kernel) {
        CAPTURE(name(kernel));
        const double edge = particles::support<double>(kernel);
        const double negligible = std::holds_alternative<Gaussian<Dim::value>>(kernel)
                                      ? 1.01 * std::numeric_limits<double>::epsilon()
                                      : 0;
        for (const double s : {edge, 1.001 * edge, 2 * edge, 100.0}) {
            CHECK(W(kernel, s) <= negligible);
            CHECK(W(kernel, -s) <= negligible);
            CHECK(std::abs(DW(kernel, s)) <= 13 * negligible);
            CHECK(std::abs(D2W(kernel, s)) <= 150 * negligible);
        }
        CHECK(W(kernel, 0.99 * edge) > 0);
    });
}

TEST_CASE_TEMPLATE("kernels: even, with odd first and even second derivative", Dim, OnLine, InPlane,
                   InSpace) {
    for_all_kernels<Dim::value>([](const auto& kernel) {
        for (double s = 0; s < 4; s += 0.173) {
            CHECK(W(kernel, -s) == W(kernel, s));
            CHECK(DW(kernel, -s) == -DW(kernel, s));
            CHECK(D2W(kernel, -s) == D2W(kernel, s));
        }
    });
}

TEST_CASE_TEMPLATE("kernels: offsets have the values and the slopes of their lengths", Dim, OnLine, InPlane,
                   InSpace) {
    constexpr int dim = Dim::value;
    const Offsets<double, dim> s = some_offsets<dim>();
    for_all_kernels<dim>([&](const auto& kernel) {
        CAPTURE(name(kernel));
        Column<double> values;
        Offsets<double, dim> gradients;
        evaluate(kernel, s, values, gradients);
        REQUIRE(values.size() == s.rows());
        REQUIRE(gradients.rows() == s.rows());
        CHECK(values[0] == W(kernel, 0));
        CHECK((gradients.row(0) == 0).all());
        const double scale = W(kernel, 0);
        for (Index k = 1; k < s.rows(); ++k) {
            const Point<dim> offset = s.row(k).matrix().transpose();
            const double q = offset.norm();
            CHECK(std::abs(values[k] - W(kernel, q)) < 1e-14 * scale);
            const Point<dim> gradient = DW(kernel, q) / q * offset;
            CHECK((gradients.row(k).matrix().transpose() - gradient).norm() < 1e-14 * scale);
        }
    });
}

TEST_CASE("kernels: on a line offsets have the kernels' values to the last bit") {
    const Column<double> s = some_offsets<1>();
    for_each_kernel([&](const Kernel<>& kernel) {
        CAPTURE(name(kernel));
        Column<double> values, slopes;
        evaluate(kernel, s, values, slopes);
        for (Index k = 0; k < s.size(); ++k) {
            CHECK(values[k] == W(kernel, s[k]));
            CHECK(slopes[k] == DW(kernel, s[k]));
        }
    });
}

TEST_CASE("kernels: a rotation leaves the values and turns the gradients") {
    const auto check = [](const auto& rotation, auto s, auto gradients) {
        constexpr int dim = decltype(s)::ColsAtCompileTime;
        const Eigen::Matrix<double, dim, dim> turn = rotation.toRotationMatrix().transpose();
        const Offsets<double, dim> turned = s.matrix() * turn;
        for_all_kernels<dim>([&](const Kernel<dim>& kernel) {
            CAPTURE(name(kernel));
            Column<double> W, W_turned;
            Offsets<double, dim> gradients_turned;
            evaluate(kernel, s, W, gradients);
            evaluate(kernel, turned, W_turned, gradients_turned);
            CHECK((W - W_turned).abs().maxCoeff() < 1e-14 * W.maxCoeff());
            CHECK((gradients.matrix() * turn - gradients_turned.matrix()).cwiseAbs().maxCoeff() <
                  1e-14 * W.maxCoeff());
        });
    };
    check(Eigen::Rotation2Dd(0.7), some_offsets<2>(), Offsets<double, 2>());
    check(Eigen::AngleAxisd(0.7, Point<3>(2, -1, 2) / 3), some_offsets<3>(), Offsets<double, 3>());
}

TEST_CASE("kernels: values known in closed form") {
    CHECK(Gaussian<>::W(0.0) == support::relative(0.5641895835477563, 1e-15));
    CHECK(Gaussian<>::W(1.0) == support::relative(0.5641895835477563 * std::exp(-1), 1e-15));
    CHECK(CubicSpline<>::W(0.0) == support::relative(2.0 / 3, 1e-15));
    CHECK(CubicSpline<>::W(1.0) == support::relative(1.0 / 6, 1e-15));
    CHECK(QuinticSpline<>::W(0.0) == support::relative(66.0 / 120, 1e-15));
    CHECK(QuinticSpline<>::W(1.0) == support::relative(26.0 / 120, 1e-15));
    CHECK(QuinticSpline<>::W(2.0) == support::relative(1.0 / 120, 1e-15));
    CHECK(WendlandC2<>::W(0.0) == 5.0 / 8);
    CHECK(WendlandC4<>::W(0.0) == 3.0 / 4);
}

TEST_CASE("kernels: values in the plane and in space, known in closed form") {
    CHECK(Gaussian<2>::W(1.0) == support::relative(std::exp(-1) / pi, 1e-15));
    CHECK(Gaussian<3>::W(1.0) == support::relative(std::exp(-1) / std::pow(pi, 1.5), 1e-15));
    CHECK(CubicSpline<2>::W(0.0) == support::relative(10 / (7 * pi), 1e-15));
    CHECK(CubicSpline<2>::W(1.0) == support::relative(10 / (28 * pi), 1e-15));
    CHECK(CubicSpline<3>::W(0.0) == support::relative(1 / pi, 1e-15));
    CHECK(QuinticSpline<2>::W(0.0) == support::relative(66 * 7 / (478 * pi), 1e-15));
    CHECK(QuinticSpline<3>::W(2.0) == support::relative(1 / (120 * pi), 1e-15));
    CHECK(WendlandC2<2>::W(0.0) == support::relative(7 / (4 * pi), 1e-15));
    CHECK(WendlandC2<3>::W(1.0) == support::relative(21 / (16 * pi) * 3 / 16, 1e-15));
    CHECK(WendlandC4<2>::W(0.0) == support::relative(9 / (4 * pi), 1e-15));
    CHECK(WendlandC4<3>::W(1.0) == support::relative(495 / (256 * pi) * 83 / 768, 1e-15));
}

TEST_CASE("kernels: in the plane and in space the splines are those of a line times a constant") {
    for (double s = -1.97; s < 2; s += 0.17) {
        CHECK(CubicSpline<2>::W(s) * 7 * pi == support::relative(15 * CubicSpline<>::W(s), 1e-14));
        CHECK(CubicSpline<3>::DW(s) * 2 * pi == support::relative(3 * CubicSpline<>::DW(s), 1e-14));
        CHECK(QuinticSpline<2>::D2W(s) * 239 * pi == support::relative(420 * QuinticSpline<>::D2W(s), 1e-14));
        CHECK(QuinticSpline<3>::W(s) * pi == support::relative(QuinticSpline<>::W(s), 1e-14));
    }
}

TEST_CASE("kernels: the Gaussian's cut follows the scalar's precision") {
    const Kernel<> gaussian = Gaussian{};
    CHECK(particles::support<double>(gaussian) == support::relative(6.0037, 1e-4));
    CHECK(particles::support<long double>(gaussian) > particles::support<double>(gaussian));
    CHECK(static_cast<double>(Gaussian<>::W(1.0L)) == support::relative(Gaussian<>::W(1.0), 1e-15));
}

TEST_CASE_TEMPLATE("kernels: wider scalars give the same kernels", Dim, OnLine, InPlane, InSpace) {
    using base::Quad;
    for_all_kernels<Dim::value>([](const auto& any) {
        CAPTURE(name(any));
        std::visit(
            [](const auto& kernel) {
                const double most = 1e-15 * kernel.W(0.0);
                for (double s = -6.1; s < 6; s += 0.31) {
                    CHECK(std::abs(kernel.W(s) - static_cast<double>(kernel.W(Quad(s)))) < most);
                    CHECK(std::abs(kernel.DW(s) - static_cast<double>(kernel.DW(Quad(s)))) < 10 * most);
                    CHECK(std::abs(kernel.D2W(s) - static_cast<double>(kernel.D2W(Quad(s)))) < 50 * most);
                    CHECK(std::abs(static_cast<double>(kernel.W(static_cast<long double>(s)) - kernel.W(s))) <
                          most);
                }
            },
            any);
    });
}

TEST_CASE_TEMPLATE("kernels: each has a name of its own and is found by it", Dim, OnLine, InPlane, InSpace) {
    constexpr int dim = Dim::value;
    std::set<std::string> names;
    for_each_kernel<dim>([&](const Kernel<dim>& kernel) {
        names.insert(name(kernel));
        CHECK(kernel_named<dim>(name(kernel)).index() == kernel.index());
    });
    CHECK(names.size() == 5);
    CHECK_FALSE(names.contains(name(Kernel<dim>(TruncatedGaussian<dim>(3)))));
    CHECK_THROWS_WITH_AS(
        kernel_named<dim>("gauss"),
        "there is no kernel 'gauss'; choose one of gaussian, cubic_spline, quintic_spline, wendland_c2, wendland_c4",
        InvalidInput);
}
