#include "fpm_in_space/section_4_derivative_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "base/text.hpp"
#include "particles/quality.hpp"
#include "particles/requirement.hpp"

namespace fpm_in_space::derivative_test {

using base::InvalidInput;
using particles::Column;
using particles::Operators;
using particles::Points;

template <int dim>
double exponential_and_wave(const Point<dim>& x, const Exponents<dim>& a) {
    const Point<dim> c = Point<3>(1, 0.5, -0.3).head<dim>(), k = Point<3>(1, 2, 1.5).head<dim>();
    double wave = std::sin(k.dot(x) + particles::order<dim>(a) * std::acos(0.0)), growth = std::exp(c.dot(x));
    for (int axis = 0; axis < dim; ++axis)
        for (int times = 0; times < a[static_cast<std::size_t>(axis)]; ++times) {
            growth *= c[axis];
            wave *= k[axis];
        }
    return growth + wave;
}

namespace {

/// \throws InvalidInput
void check_growth(double growth) {
    if (!(growth >= 1e-3 && growth <= 1e3))
        throw InvalidInput("distances grow by a factor from 0.001 to 1000, got " + base::shown(growth));
}

}  // namespace

double stretched(double s, double growth) {
    check_growth(growth);
    return growth == 1 ? s : (std::pow(growth, s) - 1) / (growth - 1);
}

template <int dim>
double stretched_spacing(const Point<dim>& x, double spacing, double growth) {
    check_growth(growth);
    if (growth == 1) return spacing;
    // dx/ds = log(G) Gˢ / (G − 1), and Gˢ = 1 + (G − 1) x
    return spacing * std::log(growth) / (growth - 1) * (1 + ((growth - 1) * x.array()).maxCoeff());
}

template <int dim>
Body<dim> body(Index n, double perturbation, unsigned long seed, double growth) {
    if (n < 3) throw InvalidInput("a side needs at least 3 particles, got " + std::to_string(n));
    if (!(perturbation >= 0 && perturbation < 0.5))
        throw InvalidInput("the perturbation must lie in [0, 1/2), got " + base::shown(perturbation));
    const auto N = static_cast<Index>(std::lround(std::pow(static_cast<double>(n), dim)));
    base::Random random(seed);
    /// A particle before it is sorted.
    struct Placed {
        int sides;
        double order;
        Point<dim> x;
    };
    std::vector<Placed> all;
    all.reserve(static_cast<std::size_t>(N));
    for (Index j = 0; j < N; ++j) {
        Placed one{0, random.uniform(0, 1), {}};
        Index rest = j;
        for (double& coordinate : one.x) {
            const Index k = rest % n;
            rest /= n;
            const bool on_side = k == 0 || k == n - 1;
            const double moved =
                on_side || perturbation == 0 ? 0 : random.uniform(-perturbation, perturbation);
            one.sides += on_side ? 1 : 0;
            coordinate = stretched((static_cast<double>(k) + moved) / static_cast<double>(n - 1), growth);
        }
        all.push_back(one);
    }
    std::sort(all.begin(), all.end(), [](const Placed& one, const Placed& other) {
        return std::pair(one.sides, one.order) < std::pair(other.sides, other.order);
    });
    Points<dim> x(dim, N);
    std::array<Range, dim + 1> on_sides;
    for (Index j = 0; j < N; ++j) {
        const Placed& one = all[static_cast<std::size_t>(j)];
        x.col(j) = one.x;
        Range& range = on_sides[static_cast<std::size_t>(one.sides)];
        if (range.last == 0) range.first = j;
        range.last = j + 1;
    }
    return {Cloud<dim>(x), on_sides};
}

namespace {

/// Compares a derivative at a particle, \eq{F16}.
/// \param D rows of its operator \param row that of particle i
/// \param exact degree up to which polynomials are differentiated exactly
template <int dim>
void compare(const particles::Operator<double>& D, Index row, const Cloud<dim>& cloud, Index i,
             const Exponents<dim>& a, const Column<double>& values, const Function<dim>& B, double delta,
             int exact, AtParticle& at) {
    const Index count = D.outerIndexPtr()[row + 1] - D.outerIndexPtr()[row];
    Column<double> w(count), difference(count);
    particles::Offsets<double, dim> r(count, dim);
    Index k = 0;
    for (typename particles::Operator<double>::InnerIterator entry(D, row); entry; ++entry, ++k) {
        w[k] = entry.value();
        difference[k] = values[entry.col()] - values[i];
        r.row(k) = (cloud.x().col(entry.col()) - cloud.x().col(i)).transpose();
    }
    const double error = (w * difference).sum() - B(cloud.x().col(i), a);
    if (!std::isfinite(error))
        throw InvalidInput("a derivative of the function is not finite at particle " + std::to_string(i) +
                           " (" + particles::position_in_words(cloud, i) + "); take another function");
    if (particles::order<dim>(a) == 1) {
        at.first = std::max(at.first, std::abs(error));
    } else {
        at.second = std::max(at.second, std::abs(error));
        if (std::find(a.begin(), a.end(), 2) != a.end()) at.laplacian += error;
        at.R = std::max(at.R, particles::quality<double, dim>(w * delta * delta, r / delta, exact));
    }
}

constexpr Index block = 512;  // rows whose operators are in memory at once

/// \throws InvalidInput for a value that is not finite
template <int dim>
Column<double> values_of(const Function<dim>& B, const Cloud<dim>& cloud) {
    Column<double> values(cloud.size());
    base::for_each_index(cloud.size(), [&](Index j) { values[j] = B(cloud.x().col(j), {}); });
    for (Index j = 0; j < cloud.size(); ++j)
        if (!std::isfinite(values[j]))
            throw InvalidInput("the function is not finite at particle " + std::to_string(j) + " (" +
                               particles::position_in_words(cloud, j) + "); take another function");
    return values;
}

template <int dim>
std::vector<AtParticle> errors_of_block(const Formulation<double, dim>& formulation, const Cloud<dim>& cloud,
                                        const Smoothing<double, dim>& smoothing,
                                        const Column<double>& spacing, const Function<dim>& B,
                                        const Column<double>& values, const Range& rows) {
    const Operators<double, dim> operators =
        particles::assemble(cloud, smoothing, formulation.required(), formulation.weights, rows);
    std::vector<AtParticle> found(static_cast<std::size_t>(rows.size()));
    base::for_each_index(rows.size(), [&](Index row) {
        const Index i = rows.first + row;
        AtParticle& at = found[static_cast<std::size_t>(row)] = {i, 0, 0, 0, 0};
        for (const auto& a : particles::monomials<dim, 2>())
            if (const int order = particles::order<dim>(a); order > 0)
                compare<dim>(derivative(operators, a), row, cloud, i, a, values, B,
                             spacing[spacing.size() == 1 ? 0 : i],
                             order == 1 ? formulation.exact.first : formulation.exact.second, at);
        at.laplacian = std::abs(at.laplacian);
    });
    return found;
}

}  // namespace

template <int dim>
std::vector<std::vector<AtParticle>> errors(const Formulation<double, dim>& formulation,
                                            const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                            const Column<double>& spacing,
                                            const std::type_identity_t<Function<dim>>& B,
                                            const std::vector<Range>& places) {
    const Column<double> values = values_of<dim>(B, cloud);
    std::vector<std::vector<AtParticle>> all;
    all.reserve(places.size());
    for (const Range& place : places) {
        std::vector<AtParticle> there;
        for (Index first = place.first; first < place.last; first += block) {
            const Range some{first, std::min(first + block, place.last)};
            const auto found = errors_of_block<dim>(formulation, cloud, smoothing, spacing, B, values, some);
            there.insert(there.end(), found.begin(), found.end());
        }
        all.push_back(std::move(there));
    }
    return all;
}

AtParticle largest(const std::vector<AtParticle>& all) {
    AtParticle most{-1, 0, 0, 0, 0};
    for (const AtParticle& one : all) {
        if (most.particle < 0 || one.second > most.second) most.particle = one.particle;
        most.first = std::max(most.first, one.first);
        most.second = std::max(most.second, one.second);
        most.laplacian = std::max(most.laplacian, one.laplacian);
        most.R = std::max(most.R, one.R);
    }
    return most;
}

template double exponential_and_wave<2>(const Point<2>&, const Exponents<2>&);
template double exponential_and_wave<3>(const Point<3>&, const Exponents<3>&);
template Body<2> body(Index, double, unsigned long, double);
template Body<3> body(Index, double, unsigned long, double);
template double stretched_spacing<2>(const Point<2>&, double, double);
template double stretched_spacing<3>(const Point<3>&, double, double);
template std::vector<std::vector<AtParticle>> errors(const Formulation<double, 2>&, const Cloud<2>&,
                                                     const Smoothing<double, 2>&, const Column<double>&,
                                                     const Function<2>&, const std::vector<Range>&);
template std::vector<std::vector<AtParticle>> errors(const Formulation<double, 3>&, const Cloud<3>&,
                                                     const Smoothing<double, 3>&, const Column<double>&,
                                                     const Function<3>&, const std::vector<Range>&);

}  // namespace fpm_in_space::derivative_test
