#include "batra2008/section_4_example_problems.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace batra2008::example_problems {

namespace {

/// Calls `work` with the degree as a compile-time number.
/// \throws base::InvalidInput for a degree that the method cannot use
template <class Work>
auto with_degree(const Discretisation& how, const Work& work) {
    if (how.degree == 2) return work(std::integral_constant<int, 2>{});
    if (how.degree == 3) return work(std::integral_constant<int, 3>{});
    if (how.degree == 1) return work(std::integral_constant<int, 1>{});
    throw base::InvalidInput("monomials of degree 1, 2 or 3 are known, not " + std::to_string(how.degree));
}

}  // namespace

System system(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how) {
    const Kernel kernel(how.scaling);
    return with_degree(how, [&](auto m) -> System {
        if (how.method != Method::strong)
            return mlpg::system<m>(
                problem, cloud, kernel,
                {how.method == Method::weak1 ? mlpg::Gradient::own_basis : mlpg::Gradient::differentiated,
                 how.penalty, how.test_scaling, how.gauss});
        if constexpr (m >= 2) return collocation::system<m>(problem, cloud, kernel);
        throw base::InvalidInput("strong: equilibrium has second derivatives; take --degree 2 or 3");
    });
}

Solution solve(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how) {
    elastostatics::check_inside(cloud, problem);
    return {how, problem.material, solved(system(problem, cloud, how))};
}

State state_at(const Cloud<2>& cloud, const Solution& of, const Point<2>& x) {
    const double h = cloud.h()[cloud.nearest(x)];
    return with_degree(of.how, [&](auto m) -> State {
        const auto basis = ssph_basis::basis_at<m>(cloud, Kernel(of.how.scaling), x, h);
        const auto K1 = basis.K(0);
        const auto [K2, K3] =
            mlpg::gradient(basis, of.how.method == Method::weak2 ? mlpg::Gradient::differentiated
                                                                 : mlpg::Gradient::own_basis);
        Vector u = Vector::Zero();
        Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
        for (std::size_t j = 0; j < basis.particle().size(); ++j) {
            const auto at = static_cast<Index>(j);
            const Vector u_J = of.u.segment<2>(2 * basis.particle()[j]);
            u += K1[at] * u_J;
            gradient += u_J * Eigen::RowVector2d(K2[at], K3[at]);
        }
        return {u, elastostatics::stress(of.material, elastostatics::strain(gradient))};
    });
}

std::vector<MeshPoint> background_mesh(Index nx, Index ny, const elastostatics::FieldOf<Point<2>>& map,
                                       const elastostatics::FieldOf<double>& area) {
    // Cowper (1973), degree 7: multiplicity 1, 3, 3 and 6; barycentric coordinates and weight of one of each.
    struct Orbit {
        double a, b, weight;
    };
    constexpr std::array<Orbit, 4> orbits{{{1.0 / 3, 1.0 / 3, -0.149570044467670},
                                           {0.260345966079038, 0.260345966079038, 0.175615257433204},
                                           {0.065130102902216, 0.065130102902216, 0.053347235608839},
                                           {0.048690315425316, 0.312865496004875, 0.077113760890257}}};
    std::vector<std::array<double, 4>> rule;
    for (const auto& [a, b, weight] : orbits) {
        std::array<double, 3> corner{a, b, 1 - a - b};
        std::sort(corner.begin(), corner.end());
        if (a == 1.0 / 3) corner = {a, a, a};
        do rule.push_back({corner[0], corner[1], corner[2], weight});
        while (std::next_permutation(corner.begin(), corner.end()));
    }
    std::vector<MeshPoint> mesh;
    const Vector cell(1 / static_cast<double>(nx), 1 / static_cast<double>(ny));
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            for (const bool upper : {false, true})
                for (const auto& [a, b, c, weight] : rule) {
                    const Vector within = upper ? Vector(1 - b, 1 - c) : Vector(b, c);
                    const Point<2> at =
                        (Vector(static_cast<double>(i), static_cast<double>(j)) + within).cwiseProduct(cell);
                    mesh.push_back({map(at), weight * cell.prod() / 2 * area(at)});
                }
    return mesh;
}

Errors errors(const std::vector<MeshPoint>& mesh, const Cloud<2>& cloud, const Solution& solution,
              const Problem& problem) {
    std::vector<Vector> u(mesh.size());
    base::for_each_index(static_cast<Index>(mesh.size()), [&](Index k) {
        const auto at = static_cast<std::size_t>(k);
        u[at] = state_at(cloud, solution, mesh[at].x).u;
    });
    return errors(mesh, u, problem.exact.u);
}

}  // namespace batra2008::example_problems
