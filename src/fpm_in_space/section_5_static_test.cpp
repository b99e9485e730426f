#include "fpm_in_space/section_5_static_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "base/text.hpp"
#include "batra2008/basis_at.hpp"
#include "fpm_in_space/ssph_with_value_given.hpp"
#include "particles/on_values.hpp"
#include "particles/quality.hpp"
#include "particles/requirement.hpp"
#include "solvers/sparse.hpp"

namespace fpm_in_space::static_test {

namespace ssph_basis = batra2008::ssph_basis;
using base::FailedComputation;
using base::InvalidInput;
using base::shown;

namespace {

const std::vector<std::pair<std::string, Conditions>>& known_conditions() {
    static const std::vector<std::pair<std::string, Conditions>> all{
        {"dirichlet", Conditions::dirichlet}, {"mixed", Conditions::mixed}, {"neumann", Conditions::neumann}};
    return all;
}

/// The multi-index of a derivative of some order along an axis.
template <int dim>
Exponents<dim> along(int axis, int order) {
    Exponents<dim> a{};
    a[static_cast<std::size_t>(axis)] = order;
    return a;
}

template <int dim>
double laplacian(const Function<dim>& B, const Point<dim>& x) {
    double sum = 0;
    for (int axis = 0; axis < dim; ++axis) sum += B(x, along<dim>(axis, 2));
    return sum;
}

template <int dim>
Point<dim> gradient(const Function<dim>& B, const Point<dim>& x) {
    Point<dim> all;
    for (int axis = 0; axis < dim; ++axis) all[axis] = B(x, along<dim>(axis, 1));
    return all;
}

/// \throws InvalidInput
template <int dim>
void require_sides(const Cloud<dim>& cloud) {
    for (Index i = 0; i < cloud.size(); ++i)
        if (const auto x = cloud.x().col(i).array(); (x < 0).any() || (x > 1).any())
            throw InvalidInput(
                "the static test needs particles between 0 and 1 along each axis, and particle " +
                std::to_string(i) + " lies at " + particles::position_in_words(cloud, i) +
                "; move and scale them");
    for (int axis = 0; axis < dim; ++axis)
        for (const double end : {0.0, 1.0})
            if (!(cloud.x().row(axis).array() == end).any())
                throw InvalidInput("the static test needs particles on all sides, and there is none with " +
                                   std::string(1, "xyz"[axis]) + " = " + shown(end) + "; add them");
}

/// Moves the rows of some particles from the operators.
template <int dim>
void take(const particles::Operators<double, dim>& operators, Index row, Index i, Row<dim>& at) {
    const auto& pattern = operators.D[0];
    const int first = pattern.outerIndexPtr()[row], count = pattern.outerIndexPtr()[row + 1] - first;
    const auto weights = [&](const particles::Operator<double>& D) {
        return Eigen::Map<const Column<double>>(D.valuePtr() + first, count);
    };
    at.particle.assign(pattern.innerIndexPtr() + first, pattern.innerIndexPtr() + first + count);
    at.own = std::lower_bound(at.particle.begin(), at.particle.end(), i) - at.particle.begin();
    at.first.resize(count, dim);
    at.laplacian = Column<double>::Zero(count);
    for (int axis = 0; axis < dim; ++axis) {
        at.first.col(axis) = weights(operators.D[static_cast<std::size_t>(axis)]);
        at.laplacian += weights(operators.D2[static_cast<std::size_t>(axis)]);
    }
}

template <int dim>
double quality(const Row<dim>& at, const Cloud<dim>& cloud, Index i, double delta, int exact) {
    Offsets<double, dim> r(at.laplacian.size(), dim);
    for (Index k = 0; k < r.rows(); ++k)
        r.row(k) = (cloud.x().col(at.particle[static_cast<std::size_t>(k)]) - cloud.x().col(i)).transpose();
    return particles::quality<double, dim>(at.laplacian * delta * delta, r / delta, exact);
}

constexpr Index block = 512;  // rows whose operators are in memory at once

/// The rows of some particles.
template <int dim>
std::vector<Row<dim>> rows_of(const Formulation<double, dim>& formulation, const Cloud<dim>& cloud,
                              const Smoothing<double, dim>& smoothing, const Column<double>& spacing,
                              const Range& range) {
    std::vector<Row<dim>> all(static_cast<std::size_t>(range.size()));
    for (Index first = range.first; first < range.last; first += block) {
        const Range some{first, std::min(first + block, range.last)};
        const auto operators =
            particles::assemble(cloud, smoothing, formulation.required(), formulation.weights, some);
        base::for_each_index(some.size(), [&](Index row) {
            const Index i = first + row;
            Row<dim>& at = all[static_cast<std::size_t>(i - range.first)];
            take<dim>(operators, row, i, at);
            at.R = quality<dim>(at, cloud, i, spacing[spacing.size() == 1 ? 0 : i], formulation.exact.second);
        });
    }
    return all;
}

/// The first particle of a range inside whose Laplacian is too bad for a solution; or the end of the range.
/// \param all the rows of the range
template <int dim>
Index first_bad(const std::vector<Row<dim>>& all, const Cloud<dim>& cloud, const Range& range) {
    Index i = range.first;
    while (i < range.last && (!outward<dim>(cloud.x().col(i)).isZero() ||
                              all[static_cast<std::size_t>(i - range.first)].R <= ssph_basis::most))
        ++i;
    return i;
}

/// \throws FailedComputation where a Laplacian inside is too bad for a solution, with what helps
template <int dim>
void require_quality(const std::vector<Row<dim>>& all, const Formulation<double, dim>& formulation,
                     const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                     const Column<double>& spacing) {
    const Range everywhere{0, cloud.size()};
    const Index i = first_bad<dim>(all, cloud, everywhere);
    if (i == cloud.size()) return;
    const auto serves = [&](const Smoothing<double, dim>& tried) {
        const auto none_bad = [&](const Range& range) {
            return first_bad<dim>(rows_of<dim>(formulation, cloud, tried, spacing, range), cloud, range) ==
                   range.last;
        };
        try {
            return none_bad({i, i + 1}) && none_bad(everywhere);
        } catch (const FailedComputation&) {
            return false;
        }
    };
    throw FailedComputation(std::string(formulation.name) + ": the Laplacian of particle " +
                            std::to_string(i) + " (" + particles::position_in_words(cloud, i) +
                            ") has the quality number " + shown(all[static_cast<std::size_t>(i)].R, 3) +
                            ", more than " + shown(ssph_basis::most, 3) +
                            ": no solution by it can be trusted; take another formulation, or " +
                            particles::another_smoothing(cloud, smoothing, formulation.particles, serves));
}

/// By SSPH of degree 2 with the value given, on few neighbours.
template <int dim>
Row<dim> row_from_nearest(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing, Index i,
                          Index enough) {
    const particles::TruncatedGaussian<dim> kernel(particles::support<double>(smoothing.kernel()));
    const double h = smoothing.h(i);
    Row<dim> at;
    at.particle = ssph_basis::nearest_that_determine<2, dim>(cloud, kernel, i, h, enough);
    at.own = std::lower_bound(at.particle.begin(), at.particle.end(), i) - at.particle.begin();
    const auto weights = ssph_with_value_given<2>(
        particles::neighbourhood<dim>(cloud, kernel, cloud.x().col(i), h, at.particle));
    at.first = particles::on_values<double, dim>(weights.first / h, at.own);
    at.laplacian =
        particles::on_values<double, 1>(weights.second.leftCols(dim).rowwise().sum() / (h * h), at.own);
    return at;
}

/// The rows of the preconditioner.
template <int dim>
std::vector<Row<dim>> nearest_of(const std::vector<Row<dim>>& all, const Cloud<dim>& cloud,
                                 const Smoothing<double, dim>& smoothing) {
    const Index enough = solvers::enough_neighbours(cloud.size(), particles::terms<dim, 2>);
    std::vector<Row<dim>> nearest(all.size());
    base::for_each_index(cloud.size(), [&](Index i) {
        const auto x = cloud.x().col(i).array();
        const bool inside = (x > smoothing.h(i)).all() && (x < 1 - smoothing.h(i)).all();
        const auto at = static_cast<std::size_t>(i);
        nearest[at] = inside ? row_from_nearest<dim>(cloud, smoothing, i, enough) : all[at];
    });
    return nearest;
}

template <int dim>
std::vector<std::vector<int>> neighbours(const std::vector<Row<dim>>& rows) {
    std::vector<std::vector<int>> near;
    near.reserve(rows.size());
    for (const Row<dim>& at : rows) near.push_back(at.particle);
    return near;
}

/// The equations of all particles.
template <int dim>
solvers::SparseRows system(const std::vector<Row<dim>>& rows, const Cloud<dim>& cloud, const Function<dim>& B,
                           Conditions conditions, Eigen::VectorXd& given) {
    solvers::SparseRows A = solvers::rows_in_blocks(neighbours(rows), 1);
    given.resize(cloud.size());
    base::for_each_index(cloud.size(), [&](Index i) {
        const Row<dim>& at = rows[static_cast<std::size_t>(i)];
        const Equation equation = equation_at<dim>(at, cloud.x().col(i), B, conditions);
        solvers::set_row(A, i, at.particle, equation.weights);
        given[i] = equation.given;
    });
    return A;
}

/// \throws InvalidInput
template <int dim>
void require_finite(const Eigen::VectorXd& given, const Cloud<dim>& cloud) {
    for (Index i = 0; i < cloud.size(); ++i)
        if (!std::isfinite(given[i]))
            throw InvalidInput("the function or a derivative is not finite at particle " + std::to_string(i) +
                               " (" + particles::position_in_words(cloud, i) + "); take another function");
}

}  // namespace

std::vector<std::string> condition_names() {
    std::vector<std::string> names;
    for (const auto& [name, conditions] : known_conditions()) names.push_back(name);
    return names;
}

Conditions conditions_named(std::string_view wanted) {
    return base::choose("condition", wanted, known_conditions());
}

template <int dim>
Equation equation_at(const Row<dim>& at, const Point<dim>& x, const std::type_identity_t<Function<dim>>& B,
                     Conditions conditions) {
    const Point<dim> n = outward<dim>(x);
    const double u = B(x, {}), c = reaction(conditions);
    if (n.isZero()) return balance(at, c, c * u - laplacian<dim>(B, x));
    if (has_value<dim>(conditions, n)) return value(at, u);
    return flux<dim>(at, n, gradient<dim>(B, x).dot(n));
}

template <int dim>
Rows<dim> rows(const Formulation<double, dim>& formulation, const Cloud<dim>& cloud,
               const Smoothing<double, dim>& smoothing, const Column<double>& spacing) {
    require_sides(cloud);
    Rows<dim> rows{rows_of<dim>(formulation, cloud, smoothing, spacing, {0, cloud.size()}), {}};
    require_quality<dim>(rows.all, formulation, cloud, smoothing, spacing);
    if (cloud.size() > solvers::small_system) rows.nearest = nearest_of<dim>(rows.all, cloud, smoothing);
    return rows;
}

template <int dim>
Column<double> solution(const Rows<dim>& rows, const Cloud<dim>& cloud,
                        const std::type_identity_t<Function<dim>>& B, Conditions conditions) {
    Eigen::VectorXd given, same;
    solvers::SparseRows A = system<dim>(rows.all, cloud, B, conditions, given);
    require_finite(given, cloud);
    solvers::SparseRows nearest =
        rows.nearest.empty() ? solvers::SparseRows() : system<dim>(rows.nearest, cloud, B, conditions, same);
    return solvers::solve_sparse(std::move(A), given, std::move(nearest)).array();
}

template <int dim>
std::vector<AtParticle> errors(const Rows<dim>& rows, const Cloud<dim>& cloud,
                               const std::type_identity_t<Function<dim>>& B, const Column<double>& u) {
    std::vector<AtParticle> all(rows.all.size());
    base::for_each_index(cloud.size(), [&](Index i) {
        const Row<dim>& at = rows.all[static_cast<std::size_t>(i)];
        const Point<dim> x = cloud.x().col(i);
        const Column<double> difference = u(at.particle) - u[i];
        const Point<dim> missed = at.first.matrix().transpose() * difference.matrix() - gradient<dim>(B, x);
        all[static_cast<std::size_t>(i)] = {i, std::abs(u[i] - B(x, {})), missed.cwiseAbs().maxCoeff(), at.R};
    });
    return all;
}

AtParticle largest(const std::vector<AtParticle>& all, const Range& place) {
    AtParticle most{-1, 0, 0, 0};
    for (Index i = place.first; i < place.last; ++i) {
        const AtParticle& one = all[static_cast<std::size_t>(i)];
        if (most.particle < 0 || one.value > most.value) most.particle = one.particle;
        most.value = std::max(most.value, one.value);
        most.first = std::max(most.first, one.first);
        most.R = std::max(most.R, one.R);
    }
    return most;
}

FPM_IN_SPACE_STATIC_TEST(template, 2)
FPM_IN_SPACE_STATIC_TEST(template, 3)

}  // namespace fpm_in_space::static_test
