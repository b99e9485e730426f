#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "particles/banded_rows.hpp"

namespace particles {

using base::for_each_index;
using base::Index;
using base::InvalidInput;

/// A discrete derivative, a sparse matrix: row i holds the weights \f$D_{ij}\f$ of particle i on the values
/// at its neighbours, \f$DB(x_i) \cong \sum_j D_{ij}\,B(x_j)\f$. [1/length^k for the k-th derivative]
template <class Scalar = double>
using Operator = banded::Rows<Scalar>;

namespace detail {

/// Calls `work(i)` for each of so many rows, whose work is short: a block of them after the other, in
/// parallel.
template <class Work>
void for_each_row(Index rows, const Work& work) {
    constexpr Index block = 256;
    for_each_index((rows + block - 1) / block, [&](Index b) {
        for (Index i = b * block; i < std::min((b + 1) * block, rows); ++i) work(i);
    });
}

}  // namespace detail

/// The operator applied through differences, \f$DB(x_i) = \sum_j D_{ij}\,[B(x_j) - B(x_i)]\f$: exact on
/// constants, and without round-off of the size of B.
/// \throws InvalidInput unless B has a value for each column of D
template <class Scalar>
Column<Scalar> apply(const Operator<Scalar>& D, const Column<Scalar>& B) {
    if (B.size() != D.cols())
        throw InvalidInput("an operator on " + std::to_string(D.cols()) +
                           " particles needs as many values, got " + std::to_string(B.size()));
    Column<Scalar> DB(D.rows());
    detail::for_each_row(D.rows(), [&](Index i) { DB[i] = banded::on_differences(D, i, B.data()); });
    return DB;
}

/// Sets each diagonal entry to minus the sum of the row's others, \f$D_{ii} = -\sum_{j \ne i} D_{ij}\f$: the
/// row then annihilates constants to the last bit, whatever the round-off of its weights.
/// \throws InvalidInput for a range of rows, whose diagonal is not known, and for a row that stores no
///         diagonal entry
template <class Scalar>
void annihilate_constants(Operator<Scalar>& D) {
    if (D.rows() != D.cols())
        throw InvalidInput("an operator with " + std::to_string(D.rows()) + " of " +
                           std::to_string(D.cols()) + " rows does not say where its diagonal is");
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
/// \param memory another operator, whose memory becomes the product's
template <class Scalar>
Operator<Scalar> product(const Operator<Scalar>& A, const Operator<Scalar>& B,
                         Operator<Scalar>&& memory = {}) {
    return banded::product(A, B, std::move(memory));
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

/// The rows and the columns of some particles alone, as where the others are fixed.
template <class Scalar>
Operator<Scalar> among(const Operator<Scalar>& D, const Range& some) {
    const auto entries = [&](Index row) -> Range {
        const int* const column = D.innerIndexPtr();
        const int *const first = column + D.outerIndexPtr()[row], *const last =
                                                                      column + D.outerIndexPtr()[row + 1];
        return {std::lower_bound(first, last, some.first) - column,
                std::lower_bound(first, last, some.last) - column};
    };
    Operator<Scalar> K;
    banded::shape(K, some.size(), some.size(), [&](int* size) {
        detail::for_each_row(some.size(),
                             [&](Index i) { size[i] = static_cast<int>(entries(some.first + i).size()); });
    });
    detail::for_each_row(some.size(), [&](Index i) {
        const Range from = entries(some.first + i);
        const Index to = K.outerIndexPtr()[i];
        std::copy(D.valuePtr() + from.first, D.valuePtr() + from.last, K.valuePtr() + to);
        std::transform(D.innerIndexPtr() + from.first, D.innerIndexPtr() + from.last, K.innerIndexPtr() + to,
                       [&](int column) { return column - static_cast<int>(some.first); });
    });
    return K;
}

}  // namespace particles
