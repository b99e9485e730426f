#include "bodies/collocation.hpp"

#include <array>
#include <numeric>

#include "base/parallel.hpp"

namespace bodies {

namespace {

/// The two coordinates of each second derivative.
template <int dim>
constexpr std::array<std::array<int, 2>, second_derivatives<dim>> axes_of_second() {
    std::array<std::array<int, 2>, second_derivatives<dim>> pairs{};
    constexpr auto all = particles::monomials<dim, 2>();
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        std::size_t found = 0;
        for (int axis = 0; axis < dim; ++axis)
            for (int times = 0; times < all[1 + dim + k][static_cast<std::size_t>(axis)]; ++times)
                pairs[k][found++] = axis;
    }
    return pairs;
}

/// \f$\sum_a \partial_a F_{ia} - c\,u_i\f$ at a place.
template <int dim, int n>
Factors<n> balance(const Equation<dim, n>& equation, const Point<dim>& x, const Weights<dim>& at, int i) {
    static constexpr auto pairs = axes_of_second<dim>();
    const auto A = equation.A(x);
    Factors<n> factors = -equation.c * value_along<n>(Values<n>::Unit(i), at.value);
    for (int j = 0; j < n; ++j)
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const auto [a, b] = pairs[k];
            const double A_ab = A(dim * i + a, dim * j + b), A_ba = A(dim * i + b, dim * j + a);
            factors.col(j) += (a == b ? A_ab : A_ab + A_ba) * at.second.col(static_cast<Index>(k));
        }
    if (!equation.div_A) return factors;
    const auto div_A = equation.div_A(x);
    for (int j = 0; j < n; ++j)
        for (int b = 0; b < dim; ++b) factors.col(j) += div_A(i, dim * j + b) * at.first.col(b);
    return factors;
}

/// Equation i of a particle.
template <int dim, int n>
Row<n> equation_at(const Equation<dim, n>& equation, const std::vector<Condition<dim, n>>& here,
                   const Point<dim>& x, const Weights<dim>& at, int i) {
    if (here.empty()) return {balance(equation, x, at, i), -source(equation, x)[i]};
    const Condition<dim, n>& one = here[static_cast<std::size_t>(i)];
    return {one.of_value ? value_along<n>(one.direction, at.value) : load(equation, x, at, one), one.given};
}

/// Writes the equations of the k-th of some particles into rows of A and b.
template <int dim, int n>
void write(solvers::SparseRows& A, Eigen::VectorXd& b, Index k, const Equation<dim, n>& equation,
           const std::vector<Condition<dim, n>>& here, const Point<dim>& x, const Weights<dim>& at) {
    for (int i = 0; i < n; ++i) {
        const Row<n> row = equation_at(equation, here, x, at, i);
        set_row<n>(A, n * k + i, at.particle, row.factors);
        b[n * k + i] = row.given;
    }
}

/// Calls `work(k, I)` for the k-th of some particles, I, in parallel.
template <class Work>
void for_each_of(const std::vector<int>& rows, const Work& work) {
    base::for_each_index(static_cast<Index>(rows.size()),
                         [&](Index k) { work(k, Index{rows[static_cast<std::size_t>(k)]}); });
}

/// The equations on few neighbours, for a preconditioner.
/// \param enough least number of neighbours, see solvers::enough_neighbours()
template <int dim, int n>
solvers::SparseRows collocated_on_nearest(const Problem<dim, n>& problem,
                                          const Conditions<dim, n>& conditions,
                                          const Approximation<dim>& approximation, Index enough,
                                          const std::vector<int>& rows) {
    const Cloud<dim>& cloud = approximation.cloud();
    std::vector<Weights<dim>> few(rows.size());
    std::vector<std::vector<int>> near(rows.size());
    for_each_of(rows, [&](Index k, Index I) {
        const auto place = static_cast<std::size_t>(k);
        few[place] = approximation.at_particle_from_nearest(I, enough);
        near[place] = few[place].particle;
    });
    solvers::SparseRows A = solvers::rows_in_blocks(near, n, cloud.size());
    Eigen::VectorXd b(A.rows());
    for_each_of(rows, [&](Index k, Index I) {
        write<dim, n>(A, b, k, problem.equation, conditions[static_cast<std::size_t>(I)], cloud.x().col(I),
                      few[static_cast<std::size_t>(k)]);
    });
    return A;
}

}  // namespace

template <int dim, int n>
System collocated(const Problem<dim, n>& problem, const Conditions<dim, n>& conditions,
                  const Approximation<dim>& approximation, Wanted wanted, const std::vector<int>& rows) {
    const Cloud<dim>& cloud = approximation.cloud();
    std::vector<std::vector<int>> near(rows.size());
    for_each_of(rows,
                [&](Index k, Index I) { near[static_cast<std::size_t>(k)] = approximation.neighbours(I); });
    System system = empty_system<n>(near, wanted, cloud.size());
    for_each_of(rows, [&](Index k, Index I) {
        const Weights<dim> at = approximation.at_particle(I);
        const auto& here = conditions[static_cast<std::size_t>(I)];
        write<dim, n>(system.A, system.b, k, problem.equation, here, cloud.x().col(I), at);
        if (wanted == Wanted::solution || !here.empty()) return;
        for (int i = 0; i < n; ++i)
            set_row<n>(system.M, n * k + i, at.particle, -value_along<n>(Values<n>::Unit(i), at.value));
    });
    return system;
}

template <int dim, int n>
System collocated(const Problem<dim, n>& problem, const Conditions<dim, n>& conditions,
                  const Approximation<dim>& approximation, Wanted wanted) {
    const Index N = approximation.cloud().size();
    std::vector<int> all(static_cast<std::size_t>(N));
    std::iota(all.begin(), all.end(), 0);
    System system = collocated(problem, conditions, approximation, wanted, all);
    if (n * N > solvers::small_system)
        system.nearest =
            collocated_on_nearest(problem, conditions, approximation,
                                  solvers::enough_neighbours(n * N, approximation.least_neighbours()), all);
    return system;
}

template System collocated(const Problem<2, 1>&, const Conditions<2, 1>&, const Approximation<2>&, Wanted);
template System collocated(const Problem<3, 1>&, const Conditions<3, 1>&, const Approximation<3>&, Wanted);
template System collocated(const Problem<2, 2>&, const Conditions<2, 2>&, const Approximation<2>&, Wanted);
template System collocated(const Problem<3, 3>&, const Conditions<3, 3>&, const Approximation<3>&, Wanted);
template System collocated(const Problem<2, 1>&, const Conditions<2, 1>&, const Approximation<2>&, Wanted,
                           const std::vector<int>&);
template System collocated(const Problem<3, 1>&, const Conditions<3, 1>&, const Approximation<3>&, Wanted,
                           const std::vector<int>&);
template System collocated(const Problem<2, 2>&, const Conditions<2, 2>&, const Approximation<2>&, Wanted,
                           const std::vector<int>&);
template System collocated(const Problem<3, 3>&, const Conditions<3, 3>&, const Approximation<3>&, Wanted,
                           const std::vector<int>&);

}  // namespace bodies
