#include "batra2008/section_4_example_problems.hpp"

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "batra2008/section_3_2_mlpg.hpp"
#include "particles/triangle_rule.hpp"

namespace batra2008::example_problems {

namespace {

/// Calls `work` with the degree as a compile-time number.
/// \throws base::InvalidInput for a degree that the method cannot use
template <class Work>
auto with_degree(const Discretisation& how, const Work& work) {
    if (how.degree == 2) return work(std::integral_constant<int, 2>{});
    if (how.degree == 3) return work(std::integral_constant<int, 3>{});
    if (how.degree == 1) return work(std::integral_constant<int, 1>{});
    throw base::InvalidInput("the degree of the monomials must be 1, 2 or 3, got " +
                             std::to_string(how.degree));
}

/// Displacement and its gradient at a place.
struct Field {
    Vector u = Vector::Zero();
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  ///< by the method's own first derivatives
};

Field field_at(const Cloud<2>& cloud, const Solution& solution, const Point<2>& x) {
    const double h = solution.h[cloud.nearest(x)];
    return with_degree(solution.how, [&](auto m) {
        const auto basis = ssph_basis::basis_at<m>(cloud, Kernel(solution.how.scaling), x, h,
                                                   ssph_basis::Slopes::known, solution.h);
        const Column<double> K1 = ssph_basis::K<1>(basis);
        const auto [K2, K3] =
            mlpg::gradient(basis, solution.how.method == Method::weak2 ? mlpg::Gradient::differentiated
                                                                       : mlpg::Gradient::own_basis);
        Field field;
        for (std::size_t j = 0; j < basis.particle().size(); ++j) {
            const auto at = static_cast<Index>(j);
            const Vector u_J = solution.u.segment<2>(2 * basis.particle()[j]);
            field.u += K1[at] * u_J;
            field.gradient += u_J * Eigen::RowVector2d(K2[at], K3[at]);
        }
        return field;
    });
}

}  // namespace

Column<double> smoothing_lengths(const Cloud<2>& cloud, const Discretisation& how) {
    const Column<double> h = particles::spacing(cloud, how.smoothing_from);
    return h.size() == 1 ? Column<double>(Column<double>::Constant(cloud.size(), h[0])) : h;
}

System system(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how) {
    const Kernel kernel(how.scaling);
    const Column<double> h = smoothing_lengths(cloud, how);
    return with_degree(how, [&](auto m) -> System {
        if (how.method != Method::strong)
            return mlpg::system<m>(
                problem, cloud, kernel, h,
                {how.method == Method::weak1 ? mlpg::Gradient::own_basis : mlpg::Gradient::differentiated,
                 how.penalty, how.test_scaling, how.gauss});
        if constexpr (m >= 2) return collocation::system<m>(problem, cloud, kernel, h);
        throw base::InvalidInput("strong: equilibrium has second derivatives; take --degree 2 or 3");
    });
}

Solution solve(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how) {
    return {how, problem.material, smoothing_lengths(cloud, how), solved(system(problem, cloud, how))};
}

Vector displacement_at(const Cloud<2>& cloud, const Solution& solution, const Point<2>& x) {
    const double h = solution.h[cloud.nearest(x)];
    return with_degree(solution.how, [&](auto m) {
        const auto basis = ssph_basis::basis_at<m>(cloud, Kernel(solution.how.scaling), x, h,
                                                   ssph_basis::Slopes::none, solution.h);
        const Column<double> K1 = ssph_basis::K<1>(basis);
        Vector u = Vector::Zero();
        for (std::size_t j = 0; j < basis.particle().size(); ++j)
            u += K1[static_cast<Index>(j)] * solution.u.segment<2>(2 * basis.particle()[j]);
        return u;
    });
}

State state_at(const Cloud<2>& cloud, const Solution& solution, const Point<2>& x) {
    const auto [u, gradient] = field_at(cloud, solution, x);
    return {u, elastostatics::stress(solution.material, elastostatics::strain(gradient))};
}

double noise(const Cloud<2>& cloud, const Solution& solution) {
    Column<double> unseen(cloud.size()), gradient(cloud.size());
    base::for_each_index(cloud.size(), [&](Index I) {
        const Field field = field_at(cloud, solution, cloud.x().col(I));
        unseen[I] = (solution.u.segment<2>(2 * I) - field.u).norm() / solution.h[I];
        gradient[I] = field.gradient.norm();
    });
    return unseen.maxCoeff() / std::sqrt(gradient.square().mean());
}

std::vector<MeshPoint> background_mesh(Index nx, Index ny, const elastostatics::FieldOf<Point<2>>& map,
                                       const elastostatics::FieldOf<double>& area) {
    const auto rule = particles::triangle_rule();
    std::vector<MeshPoint> mesh;
    const Vector cell(1 / static_cast<double>(nx), 1 / static_cast<double>(ny));
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            for (const bool upper : {false, true})
                for (const auto& [barycentric, weight] : rule) {
                    const auto& [a, b, c] = barycentric;
                    const Vector within = upper ? Vector(1 - b, 1 - c) : Vector(b, c);
                    const Point<2> at =
                        (Vector(static_cast<double>(i), static_cast<double>(j)) + within).cwiseProduct(cell);
                    mesh.push_back({map(at), weight * cell.prod() / 2 * area(at)});
                }
    return mesh;
}

}  // namespace batra2008::example_problems
