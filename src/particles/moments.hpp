#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "base/index.hpp"
#include "base/pack.hpp"
#include "particles/multi_index.hpp"
#include "particles/points.hpp"

namespace particles {

using base::Index;
using base::Pack;

/// Rows of coefficients, or of weights on the neighbours. Stored by rows, so that loops over the neighbours
/// run through memory in order. Sizes are not part of the type: all dimensions and degrees share it, which
/// halves the time to compile.
template <class Scalar>
using Table = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace detail {

/// The monomials up to degree m, once for all uses.
template <int dim, int m>
inline constexpr auto all_monomials = monomials<dim, m>();

/// The exponents of a monomial up to degree m as the digits of a number of base m + 1.
template <int dim, int m>
constexpr std::size_t digits(const Exponents<dim>& a) {
    std::size_t number = 0;
    for (const int exponent : a) number = number * (m + 1) + static_cast<std::size_t>(exponent);
    return number;
}

/// The index of a monomial by those digits; −1 where the degree is larger.
template <int dim, int m>
inline constexpr auto index_by_digits = [] {
    constexpr std::size_t base = m + 1;
    std::array<int, dim == 1 ? base : dim == 2 ? base * base : base * base * base> table{};
    table.fill(-1);
    for (std::size_t k = 0; k < all_monomials<dim, m>.size(); ++k)
        table[digits<dim, m>(all_monomials<dim, m>[k])] = static_cast<int>(k);
    return table;
}();

}  // namespace detail

/// Index of the monomial of some exponents, none above m; −1 if its degree is.
template <int dim, int m>
constexpr int monomial_of(const Exponents<dim>& a) {
    return detail::index_by_digits<dim, m>[detail::digits<dim, m>(a)];
}

/// Index of the monomial with one factor fewer of a coordinate; −1 if it has no such factor.
template <int dim, int m>
constexpr int lowered(int monomial, int axis) {
    Exponents<dim> a = detail::all_monomials<dim, m>[static_cast<std::size_t>(monomial)];
    return a[static_cast<std::size_t>(axis)]-- == 0 ? -1 : monomial_of<dim, m>(a);
}

/// A monomial as the product of an earlier one and a coordinate.
struct Factors {
    std::size_t monomial, axis;
};

/// The factors of all monomials but the first, the constant.
template <int dim, int m>
constexpr std::array<Factors, terms<dim, m>> factors_of_monomials() {
    std::array<Factors, terms<dim, m>> all{};
    for (int k = 1; k < terms<dim, m>; ++k) {
        int axis = 0;
        while (lowered<dim, m>(k, axis) < 0) ++axis;
        all[static_cast<std::size_t>(k)] = {static_cast<std::size_t>(lowered<dim, m>(k, axis)),
                                            static_cast<std::size_t>(axis)};
    }
    return all;
}

namespace detail {

/// What is computed at once: a Pack of doubles, or one number of another type.
template <class Scalar>
using Lanes = std::conditional_t<std::is_same_v<Scalar, double>, Pack, Scalar>;
template <class Scalar>
inline constexpr Index lanes = std::is_same_v<Scalar, double> ? Pack::lanes : 1;

/// Whether a neighbour may be visited with two groups.
enum class Again { no, yes };

/// Calls `visit(first, count, r, w)` for each group of neighbours. The last one may reach back into the group
/// before; otherwise it is filled with zeros.
template <Again again, int dim, class Scalar, class Visit>
void for_each_group(const Offsets<Scalar, dim>& r, const Column<Scalar>& w, const Visit& visit) {
    constexpr Index size = lanes<Scalar>;
    const Index N = w.size(), rest = N % size;
    const auto visit_group = [&](Index first, Index count, const auto& loaded) {
        std::array<Lanes<Scalar>, dim> r_group{};
        for (std::size_t axis = 0; axis < dim; ++axis)
            r_group[axis] = loaded(r.data() + static_cast<Index>(axis) * r.rows() + first);
        visit(first, count, r_group, loaded(w.data() + first));
    };
    if constexpr (size == 1) {
        for (Index first = 0; first < N; ++first)
            visit_group(first, 1, [](const Scalar* from) { return *from; });
    } else {
        const auto whole = [](const double* from) { return Pack::from(from); };
        const auto part = [rest](const double* from) { return Pack::from(from, rest); };
        for (Index first = 0; first + size <= N; first += size) visit_group(first, size, whole);
        if (rest > 0 && again == Again::yes && N > size)
            visit_group(N - size, size, whole);
        else if (rest > 0)
            visit_group(N - rest, rest, part);
    }
}

/// The monomials of offsets, each times a factor.
template <int dim, int m, class Lanes>
std::array<Lanes, terms<dim, m>> monomials_at(const std::array<Lanes, dim>& r, const Lanes& factor) {
    static constexpr auto of = factors_of_monomials<dim, m>();
    std::array<Lanes, terms<dim, m>> p{};
    p[0] = factor;
    [&]<std::size_t... k>(std::index_sequence<k...>) {
        ((p[1 + k] = p[of[1 + k].monomial] * r[of[1 + k].axis]), ...);
    }
    (std::make_index_sequence<terms<dim, m> - 1>{});
    return p;
}

template <class Scalar>
void store(const Scalar& one, Scalar* to, Index /*lanes*/) {
    *to = one;
}
inline void store(const Pack& group, double* to, Index lanes) {
    group.store(to, lanes);
}

template <class Scalar>
Scalar sum_of_lanes(const Scalar& one) {
    return one;
}
inline double sum_of_lanes(const Pack& group) {
    double sum = group[0];
    for (int lane = 1; lane < Pack::lanes; ++lane) sum += group[lane];
    return sum;
}

}  // namespace detail

/// Moments, the sums of the monomials over the neighbours. With polynomials() they are all that a local fit
/// does once for each neighbour. In double precision several neighbours are computed at once, one in each
/// lane of a Pack.
/// \f[ \mu_a = \sum_j w_j\,r_j^a, \quad |a| \le m \f]
/// \param r offsets of the neighbours \param w factor of each
/// \return one for each monomial, in the order of monomials()
template <int dim, int m, class Scalar>
std::array<Scalar, terms<dim, m>> moments(const Offsets<Scalar, dim>& r, const Column<Scalar>& w) {
    constexpr auto all = std::make_index_sequence<terms<dim, m>>{};
    using Lanes = detail::Lanes<Scalar>;
    return [&]<std::size_t... k>(std::index_sequence<k...>) {
        std::array<Lanes, terms<dim, m>> sums{(static_cast<void>(k), Lanes(0.0))...};
        detail::for_each_group<detail::Again::no, dim, Scalar>(
            r, w, [&](Index, Index, const auto& r_group, const auto& w_group) {
                const auto p = detail::monomials_at<dim, m, Lanes>(r_group, w_group);
                ((sums[k] += p[k]), ...);
            });
        return std::array<Scalar, terms<dim, m>>{detail::sum_of_lanes(sums[k])...};
    }
    (all);
}

/// The matrix of a fit of the monomials up to degree m, \f$M_{ab} = \sum_j w_j\,r_j^a\,r_j^b\f$. An entry is
/// the moment of the product \f$r^{a+b}\f$, and many products are alike: in space 84 moments fill 210
/// entries.
template <int dim, int m, class Scalar>
Eigen::Matrix<Scalar, terms<dim, m>, terms<dim, m>, Eigen::RowMajor> moment_matrix(
    const Offsets<Scalar, dim>& r, const Column<Scalar>& w) {
    constexpr std::size_t n = terms<dim, m>;
    static constexpr auto place = [] {
        const auto& all = detail::all_monomials<dim, m>;
        std::array<std::array<std::size_t, n>, n> table{};
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b) {
                Exponents<dim> product = all[a];
                for (std::size_t axis = 0; axis < dim; ++axis) product[axis] += all[b][axis];
                table[a][b] = static_cast<std::size_t>(monomial_of<dim, 2 * m>(product));
            }
        return table;
    }();
    const auto mu = moments<dim, 2 * m, Scalar>(r, w);
    Eigen::Matrix<Scalar, n, n, Eigen::RowMajor> M;
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b) M(static_cast<Index>(a), static_cast<Index>(b)) = mu[place[a][b]];
    return M;
}

namespace detail {

/// Writes polynomials at the neighbours, each w.size() numbers.
/// \param q coefficients, terms<dim, m> for each of the polynomials, one after the other
template <int dim, int m, class Scalar>
void write_polynomials(const Scalar* q, Index count, const Offsets<Scalar, dim>& r, const Column<Scalar>& w,
                       Scalar* to) {
    using Lanes = detail::Lanes<Scalar>;
    for_each_group<Again::yes, dim, Scalar>(
        r, w, [&](Index first, Index lanes, const auto& r_group, const auto& w_group) {
            const auto p = monomials_at<dim, m, Lanes>(r_group, w_group);
            for (Index row = 0; row < count; ++row) {
                const Scalar* const c = q + row * terms<dim, m>;
                Lanes sum = Lanes(c[0]) * p[0];
                [&]<std::size_t... k>(std::index_sequence<k...>) {
                    ((sum += Lanes(c[1 + k]) * p[1 + k]), ...);
                }
                (std::make_index_sequence<terms<dim, m> - 1>{});
                store(sum, to + row * w.size() + first, lanes);
            }
        });
}

}  // namespace detail

/// Polynomials at the neighbours, \f$w_j \sum_a q_a\,r_j^a\f$.
/// \param q coefficients, a row for each polynomial, in the order of monomials()
/// \param r offsets of the neighbours \param w factor of each
/// \return a row for each polynomial, a column for each neighbour
template <int dim, int m, class Coefficients, class Scalar>
Table<Scalar> polynomials(const Coefficients& q, const Offsets<Scalar, dim>& r, const Column<Scalar>& w) {
    static_assert(Coefficients::IsRowMajor);
    Table<Scalar> all(q.rows(), w.size());
    detail::write_polynomials<dim, m>(q.data(), q.rows(), r, w, all.data());
    return all;
}

/// One polynomial at the neighbours. \param q coefficients
template <int dim, int m, class Scalar>
Column<Scalar> polynomial(const Eigen::Matrix<Scalar, terms<dim, m>, 1>& q, const Offsets<Scalar, dim>& r,
                          const Column<Scalar>& w) {
    Column<Scalar> all(w.size());
    detail::write_polynomials<dim, m>(q.data(), 1, r, w, all.data());
    return all;
}

}  // namespace particles
