#include "bodies/collocation.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace bodies {

namespace {

template <int dim>
constexpr std::array<std::array<int, 2>, second_derivatives<dim>> axes() {
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

/// A row of the system: a column of weights for each component.
template <int n>
using Row = Eigen::Array<double, Eigen::Dynamic, n>;

/// The balance of component i at a place.
template <int dim, int n>
Row<n> balance(const Equation<dim, n>& equation, const Point<dim>& x, const Weights<dim>& at, int i) {
    static constexpr auto pairs = axes<dim>();
    Row<n> row = Row<n>::Zero(at.value.size(), n);
    const auto A = equation.A(x);
    for (int j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const auto [a, b] = pairs[k];
            const double both = A(dim * i + a, dim * j + b) + (a == b ? 0 : A(dim * i + b, dim * j + a));
            row.col(j) += both * at.second.col(static_cast<Index>(k));
        }
        if (equation.div_A) {
            const auto div_A = equation.div_A(x);
            for (int b = 0; b < dim; ++b) row.col(j) += div_A(i, dim * j + b) * at.first.col(b);
        }
    }
    row.col(i) -= equation.c * at.value;
    return row;
}

/// The load along a direction on a plane.
template <int dim, int n>
Row<n> load(const Equation<dim, n>& equation, const Point<dim>& x, const Weights<dim>& at,
            const Condition<dim, n>& condition) {
    Row<n> row = Row<n>::Zero(at.value.size(), n);
    const auto A = equation.A(x);
    for (int j = 0; j < n; ++j) {
        for (int b = 0; b < dim; ++b) {
            double factor = 0;
            for (int i = 0; i < n; ++i)
                for (int a = 0; a < dim; ++a)
                    factor += condition.direction[i] * condition.normal[a] * A(dim * i + a, dim * j + b);
            row.col(j) += factor * at.first.col(b);
        }
        row.col(j) += condition.exchange * condition.direction[j] * at.value;
    }
    return row;
}

template <int n>
void set_row(solvers::SparseRows& A, Index row, const std::vector<int>& particle, const Row<n>& factors) {
    if constexpr (n == 1) solvers::set_row(A, row, particle, factors.col(0));
    if constexpr (n == 2) solvers::set_row(A, row, particle, factors.col(0), factors.col(1));
    if constexpr (n == 3) solvers::set_row(A, row, particle, factors.col(0), factors.col(1), factors.col(2));
}

}  // namespace

template <int dim, int n>
System collocated(const Problem<dim, n>& problem, const Body<dim>& body,
                  const Approximation<dim>& approximation, double) {
    const auto all = conditions(problem, body);
    const auto& equation = problem.equation;
    const Index M = approximation.cloud().size(), N = body.x.cols();
    std::vector<Index> owner(static_cast<std::size_t>(M));
    {
        Index g = N;
        for (Index I = 0; I < N; ++I) {
            owner[I] = I;
            if (M > N && !all[I].empty()) owner[g++] = I;
        }
    }
    std::vector<std::vector<int>> near(static_cast<std::size_t>(M)), few(near);
    base::for_each_index(M, [&](Index I) { near[I] = approximation.neighbours(owner[I]); });
    System system{solvers::rows_in_blocks(near, n), Eigen::VectorXd(n * M)};
    const auto rows = [&](Index R, const Weights<dim>& at) {
        const Index I = owner[R];
        const Point<dim> x = body.x.col(I);
        const Values<n> b = equation.b ? equation.b(x) : Values<n>(Values<n>::Zero());
        std::vector<std::pair<Row<n>, double>> found;
        const auto& here = all[static_cast<std::size_t>(I)];
        for (int i = 0; i < n; ++i) {
            if (here.empty() || (M > N && R == I)) {
                found.push_back({balance(equation, x, at, i), -b[i]});
                continue;
            }
            const Condition<dim, n>& one = here[static_cast<std::size_t>(i)];
            if (one.of_value) {
                Row<n> row(at.value.size(), n);
                for (int j = 0; j < n; ++j) row.col(j) = one.direction[j] * at.value;
                found.push_back({row, one.given});
                continue;
            }
            found.push_back({load(equation, x, at, one), one.given});
        }
        return found;
    };
    base::for_each_index(M, [&](Index R) {
        const Weights<dim> at = approximation.at_particle(owner[R]);
        const auto found = rows(R, at);
        for (int i = 0; i < n; ++i) {
            set_row<n>(system.A, n * R + i, at.particle, found[static_cast<std::size_t>(i)].first);
            system.b[n * R + i] = found[static_cast<std::size_t>(i)].second;
        }
    });
    if (n * M <= solvers::small_system) return system;
    const Index enough = solvers::enough_neighbours(n * M, particles::terms<dim, 2>);
    std::vector<Weights<dim>> nearest(static_cast<std::size_t>(M));
    base::for_each_index(M, [&](Index R) {
        nearest[R] = approximation.at_particle_from_nearest(owner[R], enough);
        few[R] = nearest[R].particle;
    });
    system.nearest = solvers::rows_in_blocks(few, n);
    base::for_each_index(M, [&](Index R) {
        const auto& at = nearest[R];
        const auto found = rows(R, at);
        for (int i = 0; i < n; ++i)
            set_row<n>(system.nearest, n * R + i, at.particle, found[static_cast<std::size_t>(i)].first);
    });
    return system;
}

template System collocated(const Problem<2, 1>&, const Body<2>&, const Approximation<2>&, double);
template System collocated(const Problem<3, 1>&, const Body<3>&, const Approximation<3>&, double);
template System collocated(const Problem<2, 2>&, const Body<2>&, const Approximation<2>&, double);
template System collocated(const Problem<3, 3>&, const Body<3>&, const Approximation<3>&, double);

}  // namespace bodies
