#include "tests/batra2008/bases.hpp"

#include <Eigen/Eigenvalues>

#include "batra2008/basis_at.hpp"

namespace support {

namespace {

using namespace batra2008;

template <int dim, int m>
Bases bases_at(const particles::Cloud<dim>& cloud, double rho, const Point<dim>& place, double h) {
    const auto basis = ssph_basis::basis_at<m>(cloud, particles::TruncatedGaussian<dim>(rho), place, h);
    Bases all;
    all.particle = basis.particle();
    const auto count = static_cast<Index>(all.particle.size());
    all.K.resize(count, basis.n);
    for (const auto& exponents : ssph_basis::monomials<dim, m>()) {
        const auto I = static_cast<Index>(all.exponents.size());
        all.exponents.push_back(powers(exponents));
        all.K.col(I) = basis.row(I + 1);
        all.slopes.emplace_back(count, dim);
        for (int axis = 0; axis < dim; ++axis) all.slopes.back().col(axis) = basis.DK(I + 1, axis);
    }
    return all;
}

template <int dim>
Bases in_space(int m, const Points<dim>& particles, double rho, const Point<dim>& place, double h) {
    const particles::Cloud<dim> cloud(particles);
    return m == 1   ? bases_at<dim, 1>(cloud, rho, place, h)
           : m == 2 ? bases_at<dim, 2>(cloud, rho, place, h)
                    : bases_at<dim, 3>(cloud, rho, place, h);
}

}  // namespace

Bases bases(int m, const Eigen::MatrixXd& particles, double rho, const Eigen::VectorXd& place, double h) {
    if (particles.rows() == 1) return in_space<1>(m, particles, rho, place, h);
    if (particles.rows() == 2) return in_space<2>(m, particles, rho, place, h);
    return in_space<3>(m, particles, rho, place, h);
}

double condition(const Eigen::MatrixXd& C) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(C, Eigen::EigenvaluesOnly);
    return spectrum.eigenvalues().maxCoeff() / spectrum.eigenvalues().minCoeff();
}

}  // namespace support
