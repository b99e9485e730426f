#include "batra2008/linear_elements.hpp"

#include <doctest/doctest.h>

#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "solvers/definite.hpp"
#include "tests/batra2008/elastic.hpp"

using namespace batra2008;

namespace {

/// Displacements of all particles.
Eigen::VectorXd values(const Cloud<2>& cloud, const elastostatics::FieldOf<Vector>& u) {
    Eigen::VectorXd all(2 * cloud.size());
    for (Index I = 0; I < cloud.size(); ++I) all.segment<2>(2 * I) = u(cloud.x().col(I));
    return all;
}

}  // namespace

TEST_CASE("linear_elements: the matrix is symmetric, and definite where the body is held") {
    const Problem of_hole = hole::problem({hole::E, hole::nu}, {});
    const Problem of_plate =
        elastostatics::checked(plate::problem({plate::E, plate::nu}), Cloud<2>(plate::grid(31, 7)));
    for (const auto& [problem, x] :
         {std::pair(of_plate, plate::grid(31, 7)), std::pair(of_hole, hole::graded_layout({}, 686, 21, 1)),
          std::pair(of_hole, hole::polar_layout({}, 21, 33))}) {
        const auto K = linear_elements(elastostatics::checked(problem, Cloud<2>(x)), Cloud<2>(x)).K;
        const solvers::SparseRows transposed = K.transpose();
        CHECK((K - transposed).norm() < 1e-12 * K.norm());
        CHECK(solvers::DefiniteFactors(K).succeeded());
    }
}

TEST_CASE("linear_elements: a uniform strain is in equilibrium inside, and its energy is that of the body") {
    const elastostatics::Material material{plate::E, plate::nu};
    Problem problem = plate::problem(material);
    problem.corners.clear();
    for (auto& side : problem.sides) side.displaced = {false, false};
    const Cloud<2> cloud(support::moved_grid(31, 7, 0.1, 2));
    problem = elastostatics::checked(problem, cloud);
    const auto elements = linear_elements(problem, cloud);
    CHECK(!solvers::DefiniteFactors(elements.K).succeeded());  // nothing holds the plate
    const Eigen::Matrix2d gradient{{0.3, -0.2}, {0.5, 0.7}};
    const Eigen::VectorXd u = values(cloud, [&](const Point<2>& x) -> Vector { return gradient * x; });
    Eigen::VectorXd forces = elements.K * u;
    const Eigen::Vector3d strain = elastostatics::strain(gradient);
    const double energy = strain.dot(elastostatics::D(material) * strain) * plate::L1 * plate::L2;
    CHECK(u.dot(forces) == doctest::Approx(energy).epsilon(1e-10));
    CHECK(elements.edge.size() == 2 * (2 * 31 + 2 * 5));
    for (const Index row : elements.edge) forces[row] = 0;
    CHECK(forces.cwiseAbs().maxCoeff() < 1e-12 * plate::E);
}
