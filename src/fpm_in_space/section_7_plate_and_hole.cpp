#include "fpm_in_space/section_7_plate_and_hole.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "batra2008/section_3_1_collocation.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"
#include "particles/on_values.hpp"
#include "particles/quality.hpp"
#include "particles/requirement.hpp"

namespace fpm_in_space::plate_and_hole {

namespace collocation = batra2008::collocation;
namespace ssph_basis = batra2008::ssph_basis;

namespace {

using Entry = particles::Operator<double>::InnerIterator;

constexpr particles::Requirement required{"fpm", second_order_fpm::required<2>.particles};
constexpr int exact = 3;  // degree of the polynomials whose second derivatives are exact

Column<double> lengths(const particles::Smoothing<double, 2>& smoothing, Index N) {
    Column<double> h(N);
    for (Index I = 0; I < N; ++I) h[I] = smoothing.h(I);
    return h;
}

/// The row of the equations whose derivatives are determined worst.
/// \param order of the highest derivative in the equations of each particle
/// \param h smoothing lengths
particles::WorstRow worst_row(const Operators<double, 2>& w, const Cloud<2>& cloud,
                              const std::vector<int>& order, const Column<double>& h) {
    particles::WorstRow worst;
    const auto look_at = [&](const particles::Operator<double>& D, int k) {
        const Column<double> R = particles::quality(D, cloud, k, exact, h);
        for (Index I = 0; I < R.size(); ++I)
            if (order[static_cast<std::size_t>(I)] == k && R[I] > worst.R) worst = {R[I], I, k};
    };
    for (const auto& D : w.D) look_at(D, 1);
    for (const auto& D2 : w.D2) look_at(D2, 2);
    return worst;
}

/// \throws base::FailedComputation where the worst row is too bad for a solution, with what helps
void require_quality(const particles::WorstRow& worst, const Cloud<2>& cloud, const std::vector<int>& order,
                     const particles::Smoothing<double, 2>& smoothing) {
    if (worst.R <= ssph_basis::most) return;
    const auto serves = [&](const particles::Smoothing<double, 2>& tried) {
        try {
            return worst_row(operators(cloud, tried), cloud, order, lengths(tried, cloud.size())).R <=
                   ssph_basis::most;
        } catch (const base::FailedComputation&) {
            return false;
        }
    };
    throw base::FailedComputation("fpm: particle " + std::to_string(worst.particle) + " at " +
                                  particles::shown_point(cloud.x().col(worst.particle)) +
                                  " has the quality number " + base::shown(worst.R, 3) + ", more than " +
                                  base::shown(ssph_basis::most, 3) + ": its derivatives cannot be trusted; " +
                                  particles::another_smoothing(cloud, smoothing, required.particles, serves));
}

/// The neighbours of a particle.
std::vector<int> neighbours(const Operators<double, 2>& w, Index I) {
    std::vector<int> near;
    for (Entry entry(w.D[0], I); entry; ++entry) near.push_back(static_cast<int>(entry.col()));
    return near;
}

}  // namespace

particles::Smoothing<double, 2> smoothing(const Cloud<2>& cloud, const Discretisation& how) {
    return {particles::TruncatedGaussian<2>(cut<2>), particles::spacing(cloud, how.smoothing_from),
            how.smoothing};
}

Basis::Basis(std::vector<int> particle, Index I, const particles::Derivatives<double, 2>& w)
    : particle_(std::move(particle)), K_(static_cast<Index>(particle_.size()), 6) {
    const Index own = std::lower_bound(particle_.begin(), particle_.end(), I) - particle_.begin();
    const auto& [first, second] = w;
    K_ << Column<double>::Zero(K_.rows()), first, second.col(0) / 2, second.col(1) / 2, second.col(2);
    K_ = particles::on_values<double, 6>(std::move(K_), own);
    K_(own, 0) = 1;
}

Basis basis_at(const Operators<double, 2>& w, Index I) {
    std::vector<int> near = neighbours(w, I);
    const auto count = static_cast<Index>(near.size());
    const auto row = [&](const particles::Operator<double>& D) {
        Column<double> weights(count);
        Index J = 0;
        for (Entry entry(D, I); entry; ++entry) weights[J++] = entry.value();
        return weights;
    };
    particles::Derivatives<double, 2> all{Offsets<double, 2>(count, 2), Offsets<double, 3>(count, 3)};
    all.first << row(w.D[0]), row(w.D[1]);
    all.second << row(w.D2[0]), row(w.D2[1]), row(w.D2[2]);
    return {std::move(near), I, all};
}

Operators<double, 2> operators(const Cloud<2>& cloud, const particles::Smoothing<double, 2>& smoothing) {
    return particles::assemble(cloud, smoothing, required, second_order_fpm::derivatives<double, 2>);
}

Collocated collocated(Problem problem, const Cloud<2>& cloud, const Discretisation& how) {
    problem = batra2008::elastostatics::checked(std::move(problem), cloud);
    const auto smoothing_lengths = smoothing(cloud, how);
    const Index N = cloud.size();
    const Column<double> h = lengths(smoothing_lengths, N);
    auto w = operators(cloud, smoothing_lengths);  // before `all`: g++ 12 frees a half-made aggregate twice
    Collocated all{{}, std::move(w)};
    const std::vector<int> order = collocation::highest_derivatives(problem, cloud);
    const particles::WorstRow worst = worst_row(all.w, cloud, order, h);
    require_quality(worst, cloud, order, smoothing_lengths);
    std::vector<std::vector<int>> near;
    for (Index I = 0; I < N; ++I) near.push_back(neighbours(all.w, I));
    all.system = collocation::system_on(near, problem, cloud, [&](Index I) { return basis_at(all.w, I); });
    all.system.worst = worst;
    if (N > solvers::small_system / 2) all.system.elements = batra2008::linear_elements(problem, cloud);
    return all;
}

Solution solved(Collocated&& equations, const batra2008::elastostatics::Material& material) {
    const Eigen::VectorXd unknowns = batra2008::solved(std::move(equations.system));
    const auto& [D, D2] = equations.w;
    Solution solution{material, {}, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const Column<double> u = unknowns(Eigen::seq(static_cast<Index>(i), Eigen::last, 2));
        solution.u[i] = u;
        solution.Du[i].resize(u.size(), 2);
        solution.D2u[i].resize(u.size(), 3);
        solution.Du[i] << particles::apply(D[0], u), particles::apply(D[1], u);
        solution.D2u[i] << particles::apply(D2[0], u), particles::apply(D2[1], u), particles::apply(D2[2], u);
    }
    return solution;
}

Solution solve(const Problem& problem, const Cloud<2>& cloud, const Discretisation& how) {
    return solved(collocated(problem, cloud, how), problem.material);
}

batra2008::example_problems::State state_at(const Cloud<2>& cloud, const Solution& solution,
                                            const Point<2>& x) {
    const Index I = cloud.nearest(x);
    const Point<2> s = x - cloud.x().col(I);
    batra2008::Vector u;
    Eigen::Matrix2d gradient;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto row = static_cast<Index>(i);
        const Point<2> Du = solution.Du[i].row(I).transpose();
        const auto second = solution.D2u[i].row(I);
        const Eigen::Matrix2d D2u{{second[0], second[2]}, {second[2], second[1]}};
        u[row] = solution.u[i][I] + s.dot(Du) + s.dot(D2u * s) / 2;
        gradient.row(row) = (Du + D2u * s).transpose();
    }
    namespace elastostatics = batra2008::elastostatics;
    return {u, elastostatics::stress(solution.material, elastostatics::strain(gradient))};
}

}  // namespace fpm_in_space::plate_and_hole
