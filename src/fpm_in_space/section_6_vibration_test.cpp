#include "fpm_in_space/section_6_vibration_test.hpp"

#include <Eigen/LU>
#include <array>
#include <functional>
#include <limits>

#include "base/errors.hpp"
#include "particles/operators.hpp"
#include "solvers/sparse_spectrum.hpp"
#include "solvers/spectrum.hpp"

namespace fpm_in_space::vibration_test {

using particles::Derivatives;
using particles::Neighbourhood;
using particles::Operators;
using particles::Range;

template <int dim>
SparseRows stiffness(const Formulation<double, dim>& formulation, const Body<dim>& body,
                     const Smoothing<double, dim>& smoothing) {
    const Range inside = body.on_sides[0];
    const Operators<double, dim> all =
        particles::assemble(body.cloud, smoothing, formulation.required(), formulation.weights, inside);
    SparseRows laplacian = all.D2[0];
    for (std::size_t axis = 1; axis < dim; ++axis) laplacian += all.D2[axis];
    return laplacian.leftCols(inside.size());
}

namespace {

/// All m with 1 ≤ m_a ≤ most.
template <int dim>
std::vector<Exponents<dim>> half_waves(Index most) {
    const auto count = static_cast<Index>(std::lround(std::pow(static_cast<double>(most), dim)));
    std::vector<Exponents<dim>> all(static_cast<std::size_t>(count));
    for (Index k = 0; k < count; ++k) {
        Index rest = k;
        for (int& m_a : all[static_cast<std::size_t>(k)]) {
            m_a = static_cast<int>(1 + rest % most);
            rest /= most;
        }
    }
    return all;
}

/// The frequencies of the waves of a grid by the eigenvalues of a lattice.
/// \param lambda eigenvalue times δ² for phases θ
template <int dim>
std::vector<double> wave_frequencies(const std::function<double(const Point<dim>&)>& lambda, Index n) {
    const auto intervals = static_cast<double>(n - 1);
    std::vector<double> omega;
    for (const Exponents<dim>& m : half_waves<dim>(n - 2)) {
        Point<dim> theta;
        for (int axis = 0; axis < dim; ++axis)
            theta[axis] = std::numbers::pi * m[static_cast<std::size_t>(axis)] / intervals;
        omega.push_back(std::sqrt(std::max(-lambda(theta), 0.0)) * intervals);
    }
    std::sort(omega.begin(), omega.end());
    return omega;
}

}  // namespace

template <int dim>
std::vector<double> exact_frequencies(Index count) {
    // A cube of so many half waves holds a ball with more than `count` of them.
    const Index most = 2 + 2 * static_cast<Index>(std::ceil(std::pow(static_cast<double>(count), 1.0 / dim)));
    std::vector<double> omega;
    for (const Exponents<dim>& m : half_waves<dim>(most)) omega.push_back(exact_frequency<dim>(m));
    std::sort(omega.begin(), omega.end());
    omega.resize(static_cast<std::size_t>(count));
    return omega;
}

namespace {

/// The weights of \eq{A11} along each coordinate. Those of second derivatives do not exist.
template <int dim>
Derivatives<double, dim> original_weights(const Neighbourhood<double, dim>& near) {
    Derivatives<double, dim> weights;
    weights.first = near.DW.colwise() * -near.V;
    weights.second.setZero(near.W.size(), particles::second_derivatives<dim>);
    return weights;
}

}  // namespace

template <int dim>
SparseRows original_stiffness(const Body<dim>& body, const Smoothing<double, dim>& smoothing, On weights) {
    const Index inside = body.on_sides[0].size();
    const Operators<double, dim> all =
        particles::assemble(body.cloud, smoothing, {"original", 2}, original_weights<dim>);
    SparseRows sum(body.cloud.size(), body.cloud.size());
    for (int axis = 0; axis < dim; ++axis) {
        SparseRows D_a;
        if constexpr (dim == 1)
            D_a = all.D;
        else
            D_a = all.D[static_cast<std::size_t>(axis)];
        if (weights == On::values) D_a.diagonal().setZero();
        sum += SparseRows(D_a * D_a);
    }
    return sum.topRows(inside).leftCols(inside);
}

namespace {

/// A triangle by its corners.
using Triangle = std::array<Index, 3>;

/// Two triangles in each square of a grid. A perturbed particle is nearer to its own place than to others.
std::vector<Triangle> triangles(const particles::Points<2>& x) {
    const auto n = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(x.cols()))));
    Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> at(n, n);
    for (Index j = 0; j < x.cols(); ++j) {
        const auto place = (x.col(j) * static_cast<double>(n - 1)).array().round().cast<Index>().eval();
        at(place[0], place[1]) = j;
    }
    std::vector<Triangle> all;
    for (Index k = 0; k + 1 < n; ++k)
        for (Index l = 0; l + 1 < n; ++l) {
            all.push_back({at(k, l), at(k + 1, l), at(k + 1, l + 1)});
            all.push_back({at(k, l), at(k + 1, l + 1), at(k, l + 1)});
        }
    return all;
}

/// The three values 1, x, y at the corners: the inverse has the hats' coefficients.
Eigen::Matrix3d corners(const Triangle& triangle, const particles::Points<2>& x) {
    Eigen::Matrix3d values = Eigen::Matrix3d::Ones();
    for (Index k = 0; k < 3; ++k)
        values.row(k).tail<2>() = x.col(triangle[static_cast<std::size_t>(k)]).transpose();
    return values;
}

}  // namespace

Elements elements(const Body<2>& body, Mass mass) {
    const Index inside = body.on_sides[0].size();
    std::vector<Eigen::Triplet<double>> K, M;
    for (const Triangle& triangle : triangles(body.cloud.x())) {
        const Eigen::Matrix3d values = corners(triangle, body.cloud.x());
        const double area = values.determinant() / 2;
        if (!(area > 0))
            throw base::FailedComputation("the triangle of particles " + std::to_string(triangle[0]) + ", " +
                                          std::to_string(triangle[1]) + " and " +
                                          std::to_string(triangle[2]) +
                                          " is turned over; take --perturb up to 0.25");
        const Eigen::Matrix<double, 2, 3> DN = values.inverse().bottomRows<2>();
        const Eigen::Matrix3d K_e = -area * DN.transpose() * DN, I = Eigen::Matrix3d::Identity(),
                              M_e = mass == Mass::lumped ? Eigen::Matrix3d(area / 3 * I)
                                                         : area / 12 * (Eigen::Matrix3d::Ones() + I);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                if (std::max(triangle[i], triangle[j]) >= inside) continue;
                K.emplace_back(triangle[i], triangle[j], K_e(static_cast<Index>(i), static_cast<Index>(j)));
                M.emplace_back(triangle[i], triangle[j], M_e(static_cast<Index>(i), static_cast<Index>(j)));
            }
    }
    Elements all;
    all.K.resize(inside, inside);
    all.M.resize(inside, inside);
    all.K.setFromTriplets(K.begin(), K.end());
    all.M.setFromTriplets(M.begin(), M.end());
    return all;
}

namespace {

/// Removes imaginary parts that are round-off, see frequencies().
void remove_round_off(Frequencies& eigenvalues) {
    double largest = 0;
    for (const auto& one : eigenvalues) largest = std::max(largest, std::abs(one));
    const double round_off = std::sqrt(std::numeric_limits<double>::epsilon()) * largest;
    for (auto& one : eigenvalues)
        if (std::abs(one.imag()) <= round_off) one = one.real();
}

/// \f$\sqrt{-\lambda}\f$ of all eigenvalues, in order.
Frequencies ordered(Frequencies eigenvalues) {
    std::transform(eigenvalues.begin(), eigenvalues.end(), eigenvalues.begin(), frequency);
    std::sort(eigenvalues.begin(), eigenvalues.end(), lower);
    return eigenvalues;
}

}  // namespace

Frequencies frequencies(const SparseRows& K) {
    Frequencies lambda = solvers::eigenvalues(Eigen::MatrixXd(K));
    remove_round_off(lambda);
    return ordered(lambda);
}

Frequencies frequencies(const Elements& elements) {
    const auto minus_lambda =
        solvers::symmetric_eigenvalues(Eigen::MatrixXd(-elements.K), Eigen::MatrixXd(elements.M));
    Frequencies lambda;
    for (const double one : minus_lambda) lambda.emplace_back(-one);
    return ordered(lambda);
}

Frequencies lowest_frequencies(const SparseRows& K, Index count) {
    SparseRows I(K.rows(), K.rows());
    I.setIdentity();
    return lowest_frequencies(Elements{K, I}, count);
}

Frequencies lowest_frequencies(const Elements& elements, Index count) {
    const Eigen::VectorXcd inverses = solvers::largest_of_inverse(elements.K, elements.M, count);
    Frequencies lambda(inverses.begin(), inverses.end());
    remove_round_off(lambda);
    for (auto& one : lambda) one = 1.0 / one;
    return ordered(lambda);
}

Index complex_pairs(const Frequencies& frequencies) {
    return std::count_if(frequencies.begin(), frequencies.end(),
                         [](const auto& omega) { return omega.real() > 0 && omega.imag() > 0; });
}

template <int dim>
std::vector<double> symbol_frequencies(const Formulation<base::Quad, dim>& formulation,
                                       const Lattice<dim>& lattice, Index n) {
    const auto [r, w] = error_constants::laplacian(error_constants::limit_stencils(formulation, lattice));
    const error_constants::Stencil<double, dim> row{r.template cast<double>(), w.template cast<double>()};
    return wave_frequencies<dim>([&](const Point<dim>& theta) { return error_constants::symbol(row, theta); },
                                 n);
}

template <int dim>
std::vector<double> original_symbol_frequencies(const Lattice<dim>& lattice, Index n) {
    const auto near = error_constants::neighbourhood<double>(lattice);
    const particles::Offsets<double, dim> w = original_weights<dim>(near).first / lattice.smoothing;
    const auto D = [&](const Point<dim>& theta) {
        const Column<double> phase = (near.r.matrix() * theta).array() * lattice.smoothing;
        return (w.colwise() * phase.sin()).colwise().sum().eval();
    };
    return wave_frequencies<dim>([&](const Point<dim>& theta) { return -D(theta).square().sum(); }, n);
}

template SparseRows stiffness(const Formulation<double, 2>&, const Body<2>&, const Smoothing<double, 2>&);
template SparseRows stiffness(const Formulation<double, 3>&, const Body<3>&, const Smoothing<double, 3>&);
template std::vector<double> exact_frequencies<2>(Index);
template std::vector<double> exact_frequencies<3>(Index);
template SparseRows original_stiffness(const Body<1>&, const Smoothing<double, 1>&, On);
template SparseRows original_stiffness(const Body<2>&, const Smoothing<double, 2>&, On);
template SparseRows original_stiffness(const Body<3>&, const Smoothing<double, 3>&, On);
template std::vector<double> symbol_frequencies(const Formulation<base::Quad, 2>&, const Lattice<2>&, Index);
template std::vector<double> symbol_frequencies(const Formulation<base::Quad, 3>&, const Lattice<3>&, Index);
template std::vector<double> original_symbol_frequencies(const Lattice<2>&, Index);
template std::vector<double> original_symbol_frequencies(const Lattice<3>&, Index);

}  // namespace fpm_in_space::vibration_test
