#pragma once

#include <algorithm>
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
#include "particles/neighbourhood.hpp"
#include "particles/requirement.hpp"

namespace particles {

using base::FailedComputation;
using base::for_each_index;
using base::Index;
using base::InvalidInput;
using base::Pack;

/// A discrete derivative, a sparse matrix: row i holds the weights \f$D_{ij}\f$ of particle i on the values
/// at its neighbours, \f$DB(x_i) \cong \sum_j D_{ij}\,B(x_j)\f$. [1/length^k for the k-th derivative]
template <class Scalar = double>
using Operator = banded::Rows<Scalar>;

/// The first and second derivative operators of a formulation.
template <class Scalar = double>
struct Operators {
    Operator<Scalar> D, D2;
};

/// Weights on \f$B(x_j) - B(x_i)\f$ of a formulation that gives both derivatives of a neighbourhood.
template <class Scalar>
struct Derivatives {
    Column<Scalar> first, second;  ///< in units of 1/h and 1/h²
};

/// The operator applied through differences, \f$DB(x_i) = \sum_j D_{ij}\,[B(x_j) - B(x_i)]\f$: exact on
/// constants, and without round-off of the size of B.
template <class Scalar>
Column<Scalar> apply(const Operator<Scalar>& D, const Column<Scalar>& B) {
    Column<Scalar> DB(D.rows());
    for_each_index(D.rows(), [&](Index i) {
        Scalar sum(0);
        for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry)
            sum += entry.value() * (B[entry.col()] - B[i]);
        DB[i] = sum;
    });
    return DB;
}

/// Sets each diagonal entry to minus the sum of the row's others, \f$D_{ii} = -\sum_{j \ne i} D_{ij}\f$: the
/// row then annihilates constants to the last bit, whatever the round-off of its weights.
/// \throws InvalidInput for a row that stores no diagonal entry
template <class Scalar>
void annihilate_constants(Operator<Scalar>& D) {
    for_each_index(D.rows(), [&](Index i) {
        Scalar others(0);
        Scalar* own = nullptr;
        for (typename Operator<Scalar>::InnerIterator entry(D, i); entry; ++entry) {
            if (entry.col() == i)
                own = &entry.valueRef();
            else
                others += entry.value();
        }
        if (own == nullptr)
            throw InvalidInput("row " + std::to_string(i) + " of the operator stores no diagonal entry");
        *own = -others;
    });
}

/// One derivative after another, first B and then A: \f$(A B)_{ij} = \sum_k A_{ik} B_{kj}\f$. Its rows
/// annihilate constants to the last bit, too.
/// \param A, B operators whose rows store consecutive columns, as those of assemble()
template <class Scalar>
Operator<Scalar> product(const Operator<Scalar>& A, const Operator<Scalar>& B) {
    return banded::product(A, B);
}

/// Minus an operator, in its own memory.
template <class Scalar>
Operator<Scalar> minus(Operator<Scalar>&& D) {
    Operator<Scalar> negative;
    negative.swap(D);
    negative.coeffs() = -negative.coeffs();
    return negative;
}

/// The operator that leaves values as they are.
template <class Scalar>
Operator<Scalar> identity(Index N) {
    Operator<Scalar> I(N, N);
    I.setIdentity();
    return I;
}

/// The first row of one operator, the inner rows of another and the last row of a third, in the memory of the
/// second: its first and last row must store all entries that the others' have.
template <class Scalar>
Operator<Scalar> first_inner_last(const Operator<Scalar>& first, Operator<Scalar>&& inner,
                                  const Operator<Scalar>& last) {
    Operator<Scalar> A;
    A.swap(inner);
    const auto replace_row = [&](Index i, const Operator<Scalar>& other) {
        for (typename Operator<Scalar>::InnerIterator entry(A, i); entry; ++entry)
            entry.valueRef() = other.coeff(i, entry.col());
    };
    replace_row(0, first);
    replace_row(A.rows() - 1, last);
    return A;
}

namespace detail {

/// Weights as rows of D, or of D and D²: of particle i, or of a Pack of particles from i on.
/// \param near neighbours of the particle or the particles \param own place of the particle among them
template <class Scalar, class Number>
void set_rows(Operators<Scalar>& all, Index i, const Range* near, Index own, const Column<Number>& first,
              const Number& per_h) {
    banded::set_row(all.D, i, near, own, first, per_h);
}
template <class Scalar, class Number>
void set_rows(Operators<Scalar>& all, Index i, const Range* near, Index own, const Derivatives<Number>& both,
              const Number& per_h) {
    banded::set_row(all.D, i, near, own, both.first, per_h);
    banded::set_row(all.D2, i, near, own, both.second, Number(per_h * per_h));
}

}  // namespace detail

/// Assembles D and D² of a formulation: row i holds the weights that `rule` gives for the neighbourhood of
/// particle i.
///
/// Particles are independent of one another, so that they are computed in parallel, with the same bytes on
/// any number of threads. In double precision, a Pack of consecutive particles is computed at once where all
/// its neighbourhoods lie on the line; the others, and those of a Pack that fails, one by one.
/// \param rule a pure function of a Neighbourhood. It returns Derivatives, or the weights of the first
///        derivative alone. If it accepts a Neighbourhood of Packs as well, entries with W = DW = V = 0 must
///        not count
/// \param second the operator D² as a function of D, for a rule that returns the first derivative alone
/// \throws FailedComputation where a neighbourhood is too small or singular, naming the formulation, the
///         particle, its position, its neighbours and a remedy
template <class Scalar, class Rule, class Second = std::nullptr_t>
Operators<Scalar> assemble(const Line<Scalar>& line, const Smoothing<Scalar>& smoothing,
                           const Requirement& required, const Rule& rule, const Second& second = {}) {
    constexpr bool gives_both =
        std::is_same_v<std::invoke_result_t<Rule, const Neighbourhood<Scalar>&>, Derivatives<Scalar>>;
    constexpr bool takes_packs =
        std::is_same_v<Scalar, double> && std::is_invocable_v<Rule, const Neighbourhood<Pack>&>;

    const std::vector<Range> near = all_within_reach(line, smoothing);
    require_neighbours(line, smoothing, near, required);
    Operators<Scalar> all{banded::allocated<Scalar>(near),
                          gives_both ? banded::allocated<Scalar>(near) : Operator<Scalar>()};

    const auto alone = [&](Index i) {
        const Range& near_i = near[static_cast<std::size_t>(i)];
        try {
            const auto weights = rule(neighbourhood(line, smoothing, i, near_i));
            detail::set_rows(all, i, &near_i, i - near_i.first, weights, Scalar(1 / smoothing.h(i)));
        } catch (const SingularNeighbourhood& singular) {
            throw FailedComputation(neighbours_in_words(line, smoothing, i, near_i, required) + " (" +
                                    std::to_string(i - near_i.first) + " on the left, " +
                                    std::to_string(near_i.last - 1 - i) + " on the right), but " +
                                    singular.what() +
                                    "; take a larger --smoothing or particles that lie farther apart");
        }
    };
    const auto together = [&](Index i) {
        if constexpr (takes_packs) {
            const auto sides = banded::sides_of_pack(near, i);
            if (!sides) return false;
            try {
                const auto weights = rule(neighbourhoods(line, smoothing, i, sides->left, sides->right));
                detail::set_rows(all, i, near.data() + i, sides->left, weights, 1 / smoothing.pack_of_h(i));
                return true;
            } catch (const SingularNeighbourhood&) {
                return false;
            }
        }
        return false;
    };
    banded::for_each_pack(line.size(), together, alone);

    if constexpr (!gives_both) {
        Operator<Scalar> D2 = second(all.D);
        all.D2.swap(D2);  // Eigen's assignment would copy
    }
    return all;
}

}  // namespace particles
