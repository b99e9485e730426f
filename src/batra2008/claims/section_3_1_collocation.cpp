#include "batra2008/section_3_1_collocation.hpp"

#include <algorithm>
#include <vector>

#include "batra2008/claims/ledger.hpp"
#include "batra2008/claims/measures.hpp"
#include "batra2008/section_4_1_plate.hpp"

namespace batra2008::claims {

namespace {

using elastostatics::Material;

const char* const mended = "entry (2, 2) reads n2 K3J";

/// What entry (2, 2) of (3.14) has too much of as printed, ν0 n2 K3J instead of n2 K3J.
Column<double> excess(const ssph_basis::Basis<2, 2>& basis, const Material& material, const Vector& n) {
    const double nu0 = elastostatics::nu0(material);
    return (nu0 - 1) * elastostatics::E0(material) / (1 - nu0 * nu0) * n[1] * ssph_basis::K<3>(basis);
}

/// Largest relative error of the tractions (3.14) of linear displacements, as printed or mended.
double traction_error(bool printed) {
    const auto cloud = random_cloud<2>(60, 4);
    const auto basis = ssph_basis::basis_at<2>(cloud, Kernel(3), Point<2>(0.1, 0), 0.3);
    const Material material{plate::E, plate::nu};
    const Eigen::Matrix2d gradient{{0.3, -0.2}, {0.5, 0.7}};
    Column<double> u1(static_cast<Index>(basis.particle().size())), u2 = u1;
    for (Index j = 0; j < u1.size(); ++j) {
        const Vector u = gradient * cloud.x().col(basis.particle()[static_cast<std::size_t>(j)]);
        u1[j] = u[0];
        u2[j] = u[1];
    }
    double most = 0;
    for (const Vector& n : {Vector(1, 0), Vector(0, 1), Vector(0.6, 0.8)}) {
        Block block = collocation::traction(basis, material, n);
        if (printed) block.K22 += excess(basis, material, n);
        const Vector exact =
            elastostatics::traction(elastostatics::stress(material, elastostatics::strain(gradient)), n);
        most = std::max(most, (collocation::sums(block, u1, u2) - exact).norm() / exact.norm());
    }
    return most;
}

}  // namespace

report::Computations section_3_1() {
    return {
        // Largest relative error of the tractions of linear displacements, as printed, then mended
        {"B-3.1-traction", readings([]() -> std::vector<Measurement> {
             return {{"", traction_error(true)}, {mended, traction_error(false)}};
         })},
    };
}

}  // namespace batra2008::claims
