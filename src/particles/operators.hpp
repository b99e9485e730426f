#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "particles/banded_rows.hpp"
#include "particles/local_system.hpp"
#include "particles/multi_index.hpp"
#include "particles/neighbourhood.hpp"
#include "particles/operator.hpp"
#include "particles/requirement.hpp"

namespace particles {

using base::FailedComputation;
using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::Pack;

/// Number of second derivatives: one on a line, three in the plane, six in space.
template <int dim>
inline constexpr int second_derivatives = dim*(dim + 1) / 2;

/// The operators of a formulation: the first derivatives by coordinate, and the second in the order of
/// monomials(), in the plane \f$\partial_{11}, \partial_{22}, \partial_{12}\f$. See derivative().
template <class Scalar = double, int dim = 1>
struct Operators {
    std::array<Operator<Scalar>, dim> D;
    std::array<Operator<Scalar>, second_derivatives<dim>> D2;
};
template <class Scalar>
struct Operators<Scalar, 1> {
    Operator<Scalar> D, D2;
};

/// Weights on \f$B(x_j) - B(x_i)\f$ of a formulation that gives both derivatives of a neighbourhood; columns
/// in the order of the operators.
template <class Scalar = double, int dim = 1>
struct Derivatives {
    Offsets<Scalar, dim> first;                       ///< in units of 1/h
    Offsets<Scalar, second_derivatives<dim>> second;  ///< in units of 1/h²
};

/// The operator \f$\partial^a\f$.
/// \param a multi-index of order 1 or 2
/// \throws InvalidInput for another order
template <class Scalar, int dim>
const Operator<Scalar>& derivative(const Operators<Scalar, dim>& all,
                                   const std::type_identity_t<Exponents<dim>>& a) {
    static constexpr auto known = monomials<dim, 2>();
    const auto place = std::find(known.begin() + 1, known.end(), a) - known.begin() - 1;
    if (place == static_cast<std::ptrdiff_t>(known.size()) - 1)
        throw InvalidInput("operators of order 1 and 2 are known, not of order " +
                           std::to_string(order<dim>(a)));
    if constexpr (dim == 1)
        return place == 0 ? all.D : all.D2;
    else
        return place < dim ? all.D[static_cast<std::size_t>(place)]
                           : all.D2[static_cast<std::size_t>(place - dim)];
}

/// A formulation on a line, as assemble() takes it: pure functions.
template <class Scalar>
struct Rule {
    /// The weights of a neighbourhood; those of the second derivative are empty where `second` is given.
    std::function<Derivatives<Scalar>(const Neighbourhood<Scalar>&)> weights;
    /// The weights of several at once, where entries with W = DW = V = 0 must not count; or empty.
    std::function<Derivatives<Pack>(const Neighbourhood<Pack>&)> weights_of_pack;
    /// The operator D² as a function of D, in the memory of another operator; or empty.
    std::function<Operator<Scalar>(const Operator<Scalar>&, Operator<Scalar>&&)> second;
};

namespace detail {

/// \throws InvalidInput unless the rows are some of N particles
inline void check_rows(const Range& rows, Index N) {
    if (rows.first < 0 || rows.last > N || rows.first > rows.last)
        throw InvalidInput("there are no rows " + std::to_string(rows.first) + " to " +
                           std::to_string(rows.last - 1) + " among " + std::to_string(N) + " particles");
}

/// Gives D a row of the size of each neighbourhood.
/// \throws FailedComputation where a neighbourhood is too small
template <class Scalar>
void shape_as_neighbours(Operator<Scalar>& D, const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                         const Requirement& required, const Rule<Scalar>& rule, const Range& rows) {
    banded::shape(D, rows.size(), line.size(), [&](int* size) {
        banded::for_each_block(rows, line.size(), [&](const Range& block) {
            const Range some{std::max(block.first, rows.first), std::min(block.last, rows.last)};
            const std::vector<Range> near = all_within_reach(line, smoothing, some);
            for (Index i = some.first; i < some.last; ++i) {
                const Range& near_i = near[static_cast<std::size_t>(i - some.first)];
                require_neighbours(line, smoothing, i, near_i, required, rule.weights);
                size[i - rows.first] = static_cast<int>(near_i.size());
            }
        });
    });
}

/// \throws FailedComputation naming the first particle whose second derivative has weights that are not
///         finite, as its diagonal entry shows
template <class Scalar>
void require_finite(const Operator<Scalar>& D2, const Line<Scalar>& line, const Requirement& required) {
    const auto check = [&](Index i) {
        using std::isfinite;
        if (!isfinite(banded::diagonal_entry(D2, i)))
            throw FailedComputation(
                std::string(required.formulation) + ": at particle " + std::to_string(i) + " (" +
                position_in_words(line, i) +
                ") the weights of the second derivative are not finite; take another unit of length");
    };
    for_each_row(D2.rows(), check);
}

/// The weights that a function gives for a neighbourhood: of both derivatives, or of the first alone.
template <class Scalar, class Function>
Derivatives<Scalar> weights_of(const Function& function, const Neighbourhood<Scalar>& near) {
    if constexpr (std::is_same_v<std::invoke_result_t<Function, const Neighbourhood<Scalar>&>,
                                 Derivatives<Scalar>>)
        return function(near);
    else
        return {function(near), {}};
}

/// A rule from a function of a Neighbourhood of any scalar that returns Derivatives, or the weights of the
/// first derivative alone.
template <class Scalar, class Function>
Rule<Scalar> rule_of(Function function) {
    const auto weights = [function](const auto& near) { return weights_of(function, near); };
    Rule<Scalar> rule{weights, {}, {}};
    if constexpr (std::is_same_v<Scalar, double> && std::is_invocable_v<Function, const Neighbourhood<Pack>&>)
        rule.weights_of_pack = weights;
    return rule;
}

}  // namespace detail

/// Assembles D and D² of a formulation once more, in the memory that they have: for particles that have
/// moved, in every time step. Their bytes are those of assemble().
/// \param all what assemble() gave for other positions of the particles, or any other operators; after an
///        error of no use
template <class Scalar>
void assemble_again(Operators<Scalar>& all, const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                    const Requirement& required, const Rule<Scalar>& rule, const Range& rows) {
    const Index N = line.size();
    detail::check_rows(rows, N);
    smoothing.require_lengths_of(N);
    const bool gives_both = !rule.second;
    if (!gives_both && rows.size() < N)
        throw InvalidInput(std::string(required.formulation) +
                           ": a derivative of a derivative needs all rows");
    detail::shape_as_neighbours(all.D, line, smoothing, required, rule, rows);
    if (gives_both) banded::shape_as(all.D2, all.D);

    const auto alone = [&](Index i, const Range& near_i) {
        const Index row = i - rows.first, own = i - near_i.first;
        const Scalar per_h = 1 / smoothing.h(i);
        try {
            const auto [first, second] = rule.weights(neighbourhood(line, smoothing, i, near_i));
            banded::set_row(all.D, row, near_i, own, first, per_h);
            if (gives_both) banded::set_row(all.D2, row, near_i, own, second, Scalar(per_h * per_h));
        } catch (const FailedComputation& failed) {
            throw FailedComputation(
                neighbours_in_words(line, smoothing, i, near_i, required) + " (" + std::to_string(own) +
                " on the left, " + std::to_string(near_i.last - 1 - i) + " on the right), but " +
                failed.what() + "; " + remedy(line, smoothing, i, required, rule.weights));
        }
    };
    const auto together = [&](Index i, const Range* near_i) {
        if constexpr (std::is_same_v<Scalar, double>) {
            if (!rule.weights_of_pack) return false;
            const auto sides = banded::sides_of_pack(near_i, i, N);
            if (!sides) return false;
            const Pack per_h = 1 / smoothing.pack_of_h(i);
            try {
                const auto [first, second] =
                    rule.weights_of_pack(neighbourhoods(line, smoothing, i, sides->left, sides->right));
                banded::set_rows(all.D, rows, i, near_i, sides->left, first, per_h);
                if (gives_both)
                    banded::set_rows(all.D2, rows, i, near_i, sides->left, second, Pack(per_h * per_h));
                return true;
            } catch (const FailedComputation&) {
                return false;
            }
        }
        return false;
    };
    banded::for_each_block(rows, N, [&](const Range& block) {
        const std::vector<Range> near = all_within_reach(line, smoothing, block);
        const auto near_of = [&](Index i) { return near.data() + (i - block.first); };
        banded::for_each_pack(
            block, rows, [&](Index i) { return together(i, near_of(i)); },
            [&](Index i) { alone(i, *near_of(i)); });
    });

    if (rule.second) {
        Operator<Scalar> D2 = rule.second(all.D, std::move(all.D2));
        all.D2.swap(D2);  // Eigen's assignment would copy
        detail::require_finite(all.D2, line, required);
    }
}

/// Assembles D and D² of a formulation: the row of particle i holds the weights that `rule` gives for its
/// neighbourhood.
///
/// Particles are independent of one another, so that they are computed in parallel, with the same bytes on
/// any number of threads and whatever other rows are computed. In double precision, a Pack of consecutive
/// particles is computed at once where all its neighbourhoods lie on the line; the others, and those of a
/// Pack that fails, one by one.
/// \param rows particles that have a row; a rule that has D² from D needs all
/// \throws InvalidInput unless there is one smoothing length, or one for each particle
/// \throws FailedComputation where a neighbourhood is too small or singular or its weights are not finite,
///         naming the formulation, the particle, its position, its neighbours and a remedy
template <class Scalar>
Operators<Scalar> assemble(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                           const Requirement& required, const Rule<Scalar>& rule, const Range& rows) {
    Operators<Scalar> all;
    assemble_again(all, line, smoothing, required, rule, rows);
    return all;
}

// Compiled once for each scalar, in operators.cpp.
extern template void assemble_again(Operators<double>&, const Line<double>&, const Smoothing<double>&,
                                    const Requirement&, const Rule<double>&, const Range&);
extern template void assemble_again(Operators<long double>&, const Line<long double>&,
                                    const Smoothing<long double>&, const Requirement&,
                                    const Rule<long double>&, const Range&);

/// The same for all particles of the line.
/// \param weights a pure function of a Neighbourhood that returns Derivatives. If it accepts a Neighbourhood
///        of Packs as well, entries with W = DW = V = 0 must not count
template <class Scalar, class Weights>
Operators<Scalar> assemble(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                           const Requirement& required, const Weights& weights) {
    Operators<Scalar> all;
    assemble_again(all, line, smoothing, required, weights);
    return all;
}
template <class Scalar, class Weights>
void assemble_again(Operators<Scalar>& all, const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                    const Requirement& required, const Weights& weights) {
    static_assert(
        std::is_same_v<std::invoke_result_t<Weights, const Neighbourhood<Scalar>&>, Derivatives<Scalar>>,
        "weights of the first derivative alone need another function, which makes the operator D² of D");
    assemble_again(all, line, smoothing, required, detail::rule_of<Scalar>(weights), {0, line.size()});
}

/// The same from weights of the first derivative alone.
/// \param second the operator D² as a function of D, and of an operator whose memory it may take
template <class Scalar, class Weights, class Second>
Operators<Scalar> assemble(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                           const Requirement& required, const Weights& weights, const Second& second) {
    Operators<Scalar> all;
    assemble_again(all, line, smoothing, required, weights, second);
    return all;
}
template <class Scalar, class Weights, class Second>
void assemble_again(Operators<Scalar>& all, const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                    const Requirement& required, const Weights& weights, const Second& second) {
    Rule<Scalar> rule = detail::rule_of<Scalar>(weights);
    if constexpr (std::is_invocable_v<Second, const Operator<Scalar>&, Operator<Scalar>&&>)
        rule.second = second;
    else
        rule.second = [second](const Operator<Scalar>& D, Operator<Scalar>&&) { return second(D); };
    assemble_again(all, line, smoothing, required, rule, {0, line.size()});
}

/// A formulation on a cloud: a pure function.
template <int dim>
using CloudRule = std::function<Derivatives<double, dim>(const Neighbourhood<double, dim>&)>;

/// Assembles the operators of a formulation on a cloud, as on a line: the row of particle i holds the weights
/// that `rule` gives for its neighbourhood, columns in increasing order.
/// \param rows particles that have a row
/// \throws InvalidInput unless there is one smoothing length, or one for each particle
/// \throws FailedComputation where a neighbourhood is too small or singular or its weights are not finite,
///         naming the formulation, the particle, its position, its neighbours and a remedy
template <int dim>
Operators<double, dim> assemble(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                const Requirement& required, const CloudRule<dim>& rule, const Range& rows) {
    detail::check_rows(rows, cloud.size());
    smoothing.require_lengths_of(cloud.size());
    const std::vector<std::vector<int>> near = all_within_reach(cloud, smoothing, rows);
    for (Index i = rows.first; i < rows.last; ++i)
        require_neighbours(cloud, smoothing, i, near[static_cast<std::size_t>(i)], required, rule);
    std::array<Operator<double>, dim + second_derivatives<dim>> all;
    for (Operator<double>& D : all) {
        Operator<double> allocated = banded::allocated(near, rows);
        D.swap(allocated);
    }

    for_each_index(rows.size(), [&](Index row) {
        const Index i = rows.first + row;
        const std::vector<int>& near_i = near[static_cast<std::size_t>(i)];
        const Index own = std::lower_bound(near_i.begin(), near_i.end(), i) - near_i.begin();
        const double per_h = 1 / smoothing.h(i);
        try {
            const Derivatives<double, dim> weights = rule(neighbourhood(cloud, smoothing, i, near_i));
            if (weights.second.size() == 0)
                throw InvalidInput(
                    std::string(required.formulation) +
                    " has given no weights of second derivatives, which a cloud's operators need");
            for (int axis = 0; axis < dim; ++axis)
                banded::set_row(all[static_cast<std::size_t>(axis)], row, near_i, own,
                                weights.first.col(axis), per_h);
            for (int pair = 0; pair < second_derivatives<dim>; ++pair)
                banded::set_row(all[static_cast<std::size_t>(dim) + static_cast<std::size_t>(pair)], row,
                                near_i, own, weights.second.col(pair), per_h * per_h);
        } catch (const FailedComputation& failed) {
            throw FailedComputation(neighbours_in_words(cloud, smoothing, i, near_i, required) + ", but " +
                                    failed.what() + "; " + remedy(cloud, smoothing, i, required, rule));
        }
    });

    Operators<double, dim> operators;
    if constexpr (dim == 1) {
        operators.D.swap(all[0]);
        operators.D2.swap(all[1]);
    } else {
        for (std::size_t k = 0; k < all.size(); ++k)
            (k < dim ? operators.D[k] : operators.D2[k - dim]).swap(all[k]);
    }
    return operators;
}

// Compiled once for each dimension, in operators.cpp.
extern template Operators<double, 1> assemble(const Cloud<1>&, const Smoothing<double, 1>&,
                                              const Requirement&, const CloudRule<1>&, const Range&);
extern template Operators<double, 2> assemble(const Cloud<2>&, const Smoothing<double, 2>&,
                                              const Requirement&, const CloudRule<2>&, const Range&);
extern template Operators<double, 3> assemble(const Cloud<3>&, const Smoothing<double, 3>&,
                                              const Requirement&, const CloudRule<3>&, const Range&);

/// \param weights a pure function of a Neighbourhood, which returns Derivatives
template <int dim, class Weights>
Operators<double, dim> assemble(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                const Requirement& required, const Weights& weights, const Range& rows) {
    static_assert(std::is_same_v<std::invoke_result_t<Weights, const Neighbourhood<double, dim>&>,
                                 Derivatives<double, dim>>,
                  "a rule on a cloud returns Derivatives, the weights of the first and the second ones");
    return assemble(cloud, smoothing, required, CloudRule<dim>(weights), rows);
}

/// The same for all particles of the cloud.
template <int dim, class Weights>
Operators<double, dim> assemble(const Cloud<dim>& cloud, const Smoothing<double, dim>& smoothing,
                                const Requirement& required, const Weights& weights) {
    return assemble(cloud, smoothing, required, weights, Range{0, cloud.size()});
}

}  // namespace particles
