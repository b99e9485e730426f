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

/// Replaces the tractions (3.14) of a system by those with the entry as printed.
void print_tractions(System& system, const Problem& problem, const Cloud<2>& cloud, const Kernel& kernel) {
    for (Index I = 0; I < cloud.size(); ++I) {
        const auto conditions = elastostatics::conditions_at(problem, cloud.x().col(I));
        for (std::size_t row = 0; row < conditions.size(); ++row) {
            if (conditions[row].displacement || conditions[row].component == 0) continue;
            const auto basis =
                ssph_basis::basis_at<2>(cloud, kernel, Point<2>(cloud.x().col(I)), cloud.apart()[I]);
            const Column<double> too_much = excess(basis, problem.material, conditions[row].n);
            for (std::size_t j = 0; j < basis.particle().size(); ++j)
                system.A.coeffRef(2 * I + static_cast<Index>(row), 2 * basis.particle()[j] + 1) +=
                    too_much[static_cast<Index>(j)];
        }
    }
}

/// Largest error of u2 in per cent on 16 × 4 particles, with the tractions (3.14) as printed or mended.
double plate_error(bool printed) {
    const Material material{plate::E, plate::nu};
    const Problem problem = plate::problem(material);
    const Cloud<2> cloud(plate::grid(16, 4));
    const example_problems::Discretisation how{example_problems::Method::strong, 3};
    System system = example_problems::system(problem, cloud, how);
    if (printed) print_tractions(system, problem, cloud, Kernel(how.scaling));
    return plate::largest_error_u2(cloud, {how, material, cloud.apart(), solved(system)}, problem);
}

}  // namespace

report::Computations section_3_1() {
    return {
        // Largest relative error of the tractions of linear displacements, as printed, then mended
        {"B-3.1-traction", readings([]() -> std::vector<Measurement> {
             return {{"", traction_error(true)}, {mended, traction_error(false)}};
         })},
        // Largest error of u2 of the plate, as printed, then mended
        {"B-3.1-printed-traction", readings([]() -> std::vector<Measurement> {
             return {{"", plate_error(true)}, {mended, plate_error(false)}};
         })},
    };
}

}  // namespace batra2008::claims
