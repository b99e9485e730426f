#include "bodies/hats.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/errors.hpp"
#include "base/parallel.hpp"

namespace bodies {

namespace {

template <int dim>
Point<dim> centre(const Points<dim>& x, const std::array<int, dim + 1>& cell) {
    Point<dim> sum = Point<dim>::Zero();
    for (const int k : cell) sum += x.col(k);
    return sum / (dim + 1);
}

/// The hats of a cell: the gradient of each, a row, and the size of the cell.
template <int dim>
struct Simplex {
    Eigen::Matrix<double, dim + 1, dim> gradient;
    double size = 0;
};

template <int dim>
Simplex<dim> simplex(const Points<dim>& x, const std::array<int, dim + 1>& cell) {
    Eigen::Matrix<double, dim, dim> edges;
    for (int k = 0; k < dim; ++k)
        edges.col(k) = x.col(cell[static_cast<std::size_t>(k) + 1]) - x.col(cell[0]);
    Simplex<dim> all;
    all.size = std::abs(edges.determinant()) / (dim == 2 ? 2 : 6);
    all.gradient.template bottomRows<dim>() = edges.inverse();
    all.gradient.row(0) = -all.gradient.template bottomRows<dim>().colwise().sum();
    return all;
}

/// The corners of a piece of the boundary.
std::array<Point<2>, 2> corners_of(const Piece<2>& piece) {
    if (const auto* side = std::get_if<particles::Segment>(&piece)) return {side->from, side->to};
    throw base::InvalidInput("hats: an arc is no edge of a cell; the cells of a mesh have straight edges");
}
std::array<Point<3>, 3> corners_of(const Piece<3>& piece) {
    return piece.corners;
}

/// Outward normal times the size of a piece.
Point<2> area(const std::array<Point<2>, 2>& corners) {
    const Point<2> along = corners[1] - corners[0];
    return {along[1], -along[0]};
}
Point<3> area(const std::array<Point<3>, 3>& corners) {
    return Point<3>(corners[1] - corners[0]).cross(Point<3>(corners[2] - corners[0])) / 2;
}

/// A quadrature rule on a piece, exact for polynomials of degree 2: the hats at its places.
template <int dim>
std::array<std::array<double, dim>, dim> rule() {
    const double most = dim == 2 ? 0.5 + std::sqrt(1.0 / 12) : 2.0 / 3, least = dim == 2 ? 1 - most : 1.0 / 6;
    std::array<std::array<double, dim>, dim> places{};
    for (std::size_t k = 0; k < dim; ++k) {
        places[k].fill(least);
        places[k][k] = most;
    }
    return places;
}

/// A place on a piece of the boundary. \param hats of its particles there
template <int dim>
Point<dim> place(const Points<dim>& x, const std::array<int, dim>& particle,
                 const std::array<double, dim>& hats) {
    Point<dim> sum = Point<dim>::Zero();
    for (std::size_t k = 0; k < dim; ++k) sum += hats[k] * x.col(particle[k]);
    return sum;
}

}  // namespace

template <int dim, int n>
Hats<dim, n>::Hats(const Problem<dim, n>& problem, const Body<dim>& body,
                   const Approximation<dim>& approximation)
    : problem_(problem),
      body_(body),
      approximation_(approximation),
      cells_of_(static_cast<std::size_t>(body.x.cols())),
      facets_of_(cells_of_.size()) {
    if (body.cells.empty())
        throw base::InvalidInput("hats: a body without a mesh has no hats; take another method, or a mesh");
    for (std::size_t c = 0; c < body.cells.size(); ++c)
        for (const int particle : body.cells[c])
            cells_of_[static_cast<std::size_t>(particle)].push_back(static_cast<int>(c));
    for (const Side<dim>& side : body.sides) {
        const Given<dim, n>* given = problem.given_on(side);
        if (given == nullptr) continue;
        for (const Piece<dim>& piece : side.pieces) {
            const auto corners = corners_of(piece);
            const Point<dim> whole = area(corners);
            Facet facet{{}, whole.normalized(), whole.norm(), given};
            for (std::size_t k = 0; k < dim; ++k) {
                facet.particle[k] = approximation.cloud().nearest(corners[k]);
                if ((body.x.col(facet.particle[k]) - corners[k]).norm() > 0)
                    throw base::InvalidInput("hats: the side " + side.name + " has no particle at " +
                                             particles::shown_point(corners[k]));
                facets_of_[static_cast<std::size_t>(facet.particle[k])].push_back(
                    static_cast<int>(facets_.size()));
            }
            facets_.push_back(facet);
        }
    }
}

template <int dim, int n>
typename Hats<dim, n>::Trial Hats<dim, n>::of_particles() const {
    return {[this](int c) {
                return approximation_.at(centre<dim>(body_.x, body_.cells[static_cast<std::size_t>(c)]));
            },
            [this](const auto&, const Point<dim>& x) { return approximation_.at(x); },
            [this](Index I) { return approximation_.at_particle(I, Derivatives::first); }};
}

template <int dim, int n>
typename Hats<dim, n>::Trial Hats<dim, n>::linear() const {
    const auto on_cell = [this](int c) {
        auto cell = body_.cells[static_cast<std::size_t>(c)];
        std::sort(cell.begin(), cell.end());
        return Weights<dim>{{cell.begin(), cell.end()},
                            Column<double>::Constant(dim + 1, 1.0 / (dim + 1)),
                            simplex<dim>(body_.x, cell).gradient.array(),
                            {}};
    };
    const auto on_facet = [](std::array<int, dim> facet, const Point<dim>&) {
        std::sort(facet.begin(), facet.end());
        return Weights<dim>{{facet.begin(), facet.end()}, Column<double>::Constant(dim, 1.0 / dim), {}, {}};
    };
    const auto at_particle = [](Index I) {
        return Weights<dim>{{static_cast<int>(I)}, Column<double>::Ones(1), {}, {}};
    };
    return {on_cell, on_facet, at_particle};
}

template <int dim, int n>
std::vector<int> Hats<dim, n>::near(Index I, const Trial& trial) const {
    std::vector<int> all = trial.at_particle(I).particle;
    const auto append = [&all](const Weights<dim>& at) {
        all.insert(all.end(), at.particle.begin(), at.particle.end());
    };
    for (const int c : cells_of_[static_cast<std::size_t>(I)]) append(trial.on_cell(c));
    for (const int f : facets_of_[static_cast<std::size_t>(I)]) {
        const Facet& facet = facets_[static_cast<std::size_t>(f)];
        if (!facet.given->exchange) continue;
        for (const auto& hats : rule<dim>())
            append(trial.on_facet(facet.particle, place<dim>(body_.x, facet.particle, hats)));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

template <int dim, int n>
typename Hats<dim, n>::Equations Hats<dim, n>::equations(Index I, const std::vector<int>& near,
                                                         const Trial& trial) const {
    Equations all;
    const Factors<n> zero = Factors<n>::Zero(static_cast<Index>(near.size()), n);
    all.K.fill(zero);
    all.M.fill(zero);
    for (const int c : cells_of_[static_cast<std::size_t>(I)]) {
        const auto& cell = body_.cells[static_cast<std::size_t>(c)];
        const Point<dim> x = centre<dim>(body_.x, cell);
        const auto [gradient, size] = simplex<dim>(body_.x, cell);
        const Index own = std::find(cell.begin(), cell.end(), I) - cell.begin();
        const Weights<dim> at = trial.on_cell(c);
        const auto A = problem_.equation.A(x);
        const double share = size / (dim + 1);
        all.f += share * source(problem_.equation, x);
        for (int i = 0; i < n; ++i) {
            const Eigen::Matrix<double, n, dim> DW = Values<n>::Unit(i) * gradient.row(own);
            const Factors<n> mass = share * value_along<n>(Values<n>::Unit(i), at.value);
            const auto k = static_cast<std::size_t>(i);
            add<n>(all.K[k], near, size * work<dim, n>(DW, A, at.first) + problem_.equation.c * mass,
                   at.particle);
            add<n>(all.M[k], near, mass, at.particle);
        }
    }
    for (const int f : facets_of_[static_cast<std::size_t>(I)]) {
        const auto& [particle, normal, measure, given] = facets_[static_cast<std::size_t>(f)];
        const auto own =
            static_cast<std::size_t>(std::find(particle.begin(), particle.end(), I) - particle.begin());
        for (const auto& hats : rule<dim>()) {
            const Point<dim> x = place<dim>(body_.x, particle, hats);
            const double share = measure / dim * hats[own];
            for (const Load<dim, n>& load : given->loads) all.f += share * load(x, normal);
            if (!given->exchange) continue;
            const double a = given->exchange(x);
            all.f += share * a * Values<n>::Constant(given->surroundings(x));
            const Weights<dim> at = trial.on_facet(particle, x);
            for (int i = 0; i < n; ++i)
                add<n>(all.K[static_cast<std::size_t>(i)], near,
                       share * a * value_along<n>(Values<n>::Unit(i), at.value), at.particle);
        }
    }
    return all;
}

template <int dim, int n>
System Hats<dim, n>::system(const Trial& trial, const Conditions<dim, n>& conditions, Wanted wanted,
                            const std::vector<int>& rows) const {
    const auto N = static_cast<Index>(rows.size());
    std::vector<std::vector<int>> all_near(static_cast<std::size_t>(N));
    base::for_each_index(N, [&](Index place) {
        const auto k = static_cast<std::size_t>(place);
        all_near[k] = near(rows[k], trial);
    });
    System system = empty_system<n>(all_near, wanted, body_.x.cols());
    base::for_each_index(N, [&](Index place) {
        const auto& here = all_near[static_cast<std::size_t>(place)];
        const Index I = rows[static_cast<std::size_t>(place)];
        const auto& given = conditions[static_cast<std::size_t>(I)];
        const Equations all = equations(I, here, trial);
        for (int i = 0; i < n; ++i) {
            const bool is_inside = given.empty();
            const Values<n> d =
                is_inside ? Values<n>(Values<n>::Unit(i)) : given[static_cast<std::size_t>(i)].direction;
            Factors<n> K = Factors<n>::Zero(static_cast<Index>(here.size()), n), M = K;
            double f = 0;
            if (!is_inside && given[static_cast<std::size_t>(i)].of_value) {
                const Weights<dim> at = trial.at_particle(I);
                add<n>(K, here, value_along<n>(d, at.value), at.particle);
                f = given[static_cast<std::size_t>(i)].given;
            } else {
                for (int k = 0; k < n; ++k) {
                    K += d[k] * all.K[static_cast<std::size_t>(k)];
                    M += d[k] * all.M[static_cast<std::size_t>(k)];
                }
                f = d.dot(all.f);
            }
            set_row<n>(system.A, n * place + i, here, K);
            if (wanted == Wanted::eigenvalues) set_row<n>(system.M, n * place + i, here, M);
            system.b[n * place + i] = f;
        }
    });
    return system;
}

template <int dim, int n>
System Hats<dim, n>::system(const Conditions<dim, n>& conditions, Wanted wanted) const {
    std::vector<int> rows(static_cast<std::size_t>(body_.x.cols()));
    std::iota(rows.begin(), rows.end(), 0);
    Trial trial = of_particles();
    std::vector<Weights<dim>> on_cell(body_.cells.size());
    base::for_each_index(static_cast<Index>(on_cell.size()), [&](Index c) {
        on_cell[static_cast<std::size_t>(c)] = trial.on_cell(static_cast<int>(c));
    });
    trial.on_cell = [&](int c) { return on_cell[static_cast<std::size_t>(c)]; };
    System all = system(trial, conditions, wanted, rows);
    if (n * body_.x.cols() > solvers::small_system) all.nearest = elements(conditions, rows);
    return all;
}

template <int dim, int n>
solvers::SparseRows Hats<dim, n>::elements(const Conditions<dim, n>& conditions,
                                           const std::vector<int>& rows) const {
    return system(linear(), conditions, Wanted::solution, rows).A;
}

template <int dim, int n>
double Hats<dim, n>::volume(Index I) const {
    double sum = 0;
    for (const int c : cells_of_[static_cast<std::size_t>(I)])
        sum += simplex<dim>(body_.x, body_.cells[static_cast<std::size_t>(c)]).size / (dim + 1);
    return sum;
}

template <int dim, int n>
Values<n> Hats<dim, n>::residual(Index I, const Eigen::VectorXd& u) const {
    const Trial trial = of_particles();
    const std::vector<int> here = near(I, trial);
    const Equations all = equations(I, here, trial);
    Values<n> left = -all.f;
    for (int i = 0; i < n; ++i)
        for (std::size_t j = 0; j < here.size(); ++j)
            left[i] += all.K[static_cast<std::size_t>(i)]
                           .row(static_cast<Index>(j))
                           .matrix()
                           .dot(u.segment<n>(n * here[j]));
    return left;
}

template class Hats<2, 1>;
template class Hats<3, 1>;
template class Hats<2, 2>;
template class Hats<3, 3>;

}  // namespace bodies
