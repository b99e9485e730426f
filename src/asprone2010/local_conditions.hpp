#pragma once

#include <Eigen/SVD>
#include <string_view>
#include <vector>

#include "asprone2010/section_4_second_order_fpm.hpp"

namespace asprone2010 {

/// Beyond the print: the condition numbers of the small systems that a formulation solves for each particle,
/// in units of h.
namespace local_conditions {

/// Condition number of a matrix: its largest singular value over its smallest.
/// \f[ \kappa(A) = \frac{\sigma_1(A)}{\sigma_n(A)} \f]
template <class Matrix>
double condition(const Matrix& A) {
    const auto sigma = Eigen::JacobiSVD<Matrix>(A).singularValues();
    return sigma[0] / sigma[sigma.size() - 1];
}

/// Condition number of the moments' matrix M of \eq{A24}, which gives the coefficients of the correction
/// polynomial \f$C_i\f$.
/// \tparam p the exponents of the polynomial
template <int... p>
double condition_of_correction(const Neighbourhood<double>& near) {
    const auto moment = [&](int k) { return (near.W * near.V * near.r.pow(k)).sum(); };
    return condition(rkpm::moment_matrix<double, p...>(moment));
}

/// A local system: what it is solved for, and its condition number.
struct System {
    std::string_view unknowns;
    double condition;
};

/// The local systems of a formulation for one particle, in the order in which they are solved; none where it
/// divides by a sum, or where its matrix is not of this paper.
/// \param formulation its name in formulations()
inline std::vector<System> systems(std::string_view formulation, const Neighbourhood<double>& near) {
    if (formulation == "rkpm_first_order") return {{"C", condition_of_correction<0, 1>(near)}};
    if (formulation == "rkpm_second_order") return {{"C", condition_of_correction<0, 1, 2>(near)}};
    if (formulation == "fpm") return {{"B and DB", condition(fpm::matrix(near))}};
    if (formulation == "modified_fpm") return {{"DB and D2B", condition(modified_fpm::matrix(near))}};
    if (formulation == "second_order_fpm")
        return {{"C", condition_of_correction<0, 1, 3>(near)},
                {"DB and D2B", condition(modified_fpm::matrix(second_order_fpm::corrected(near)))}};
    return {};
}

}  // namespace local_conditions
}  // namespace asprone2010
