#include "batra2008/linear_elements.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "particles/triangles.hpp"

namespace batra2008 {

namespace {

/// A particle's rows of the stiffness: its neighbours in increasing order, with two rows for each.
struct Rows {
    std::vector<int> near;
    Eigen::Array<double, Eigen::Dynamic, 4> K;  ///< K11, K12, K21, K22
};

Rows rows(const Cloud<2>& cloud, Index I, const Eigen::Matrix3d& D) {
    const auto triangles = particles::triangles_at(cloud, I);
    Rows rows{{static_cast<int>(I)}, {}};
    for (const auto& triangle : triangles)
        rows.near.insert(rows.near.end(), triangle.begin(), triangle.end());
    std::sort(rows.near.begin(), rows.near.end());
    rows.near.erase(std::unique(rows.near.begin(), rows.near.end()), rows.near.end());
    rows.K.setZero(static_cast<Index>(rows.near.size()), 4);
    for (const auto& [J, K] : triangles) {
        const std::array<int, 3> corner{static_cast<int>(I), J, K};
        Eigen::Matrix<double, 2, 3> x;
        for (int k = 0; k < 3; ++k) x.col(k) = cloud.x().col(corner[static_cast<std::size_t>(k)]);
        // Gradients of the three hat functions, times twice the area.
        Eigen::Matrix<double, 2, 3> gradient;
        for (int k = 0; k < 3; ++k) {
            const Vector opposite = x.col((k + 2) % 3) - x.col((k + 1) % 3);
            gradient.col(k) << -opposite[1], opposite[0];
        }
        const double area = (x.col(1) - x.col(0)).dot(Vector(gradient.col(1))) / 2;
        for (int k = 0; k < 3; ++k) {
            const Eigen::Matrix2d block = elastostatics::L(gradient.col(0)).transpose() * D *
                                          elastostatics::L(gradient.col(k)) / (4 * area);
            const auto at =
                std::lower_bound(rows.near.begin(), rows.near.end(), corner[static_cast<std::size_t>(k)]) -
                rows.near.begin();
            rows.K.row(at) += Eigen::Array4d(block(0, 0), block(0, 1), block(1, 0), block(1, 1)).transpose();
        }
    }
    return rows;
}

}  // namespace

solvers::Elements linear_elements(const Problem& problem, const Cloud<2>& cloud) {
    const Eigen::Matrix3d D = elastostatics::D(problem.material);
    std::vector<Rows> of(static_cast<std::size_t>(cloud.size()));
    std::vector<std::vector<int>> near(of.size());
    base::for_each_index(cloud.size(), [&](Index I) {
        of[static_cast<std::size_t>(I)] = rows(cloud, I, D);
        near[static_cast<std::size_t>(I)] = of[static_cast<std::size_t>(I)].near;
    });
    solvers::Elements elements{solvers::rows_in_blocks(near, 2), {}};
    base::for_each_index(cloud.size(), [&](Index I) {
        const auto& [here, K] = of[static_cast<std::size_t>(I)];
        solvers::set_row(elements.K, 2 * I, here, K.col(0), K.col(1));
        solvers::set_row(elements.K, 2 * I + 1, here, K.col(2), K.col(3));
    });
    for (Index I = 0; I < cloud.size(); ++I) {
        const auto conditions = elastostatics::conditions_at(problem, cloud.x().col(I));
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            const auto& [displacement, component, n] = conditions[i];
            elements.edge.push_back(2 * I + static_cast<Index>(i));
            if (displacement) elements.K.coeffRef(2 * I + component, 2 * I + component) *= 1000;
        }
    }
    return elements;
}

}  // namespace batra2008
