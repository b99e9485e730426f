#include "particles/moments.hpp"

#include <cmath>

#include "base/quad.hpp"
#include "tests/support/relative.hpp"

using namespace particles;

namespace {

/// Offsets between −1 and 1, which no two tests of other sizes share.
template <class Scalar, int dim>
Offsets<Scalar, dim> offsets(Index N) {
    Offsets<Scalar, dim> r(N, dim);
    for (Index j = 0; j < N; ++j)
        for (int axis = 0; axis < dim; ++axis)
            r(j, axis) = Scalar(std::sin(1.0 + 7.0 * static_cast<double>(j) + 3.0 * axis * axis));
    return r;
}

template <class Scalar>
Column<Scalar> factors(Index N) {
    Column<Scalar> w(N);
    for (Index j = 0; j < N; ++j) w[j] = Scalar(1.0 + 0.5 * std::cos(5.0 * static_cast<double>(j)));
    return w;
}

/// r^a, by its definition.
template <class Scalar, int dim>
Scalar monomial(const Offsets<Scalar, dim>& r, Index j, const Exponents<dim>& a) {
    Scalar product(1);
    for (std::size_t axis = 0; axis < dim; ++axis)
        for (int k = 0; k < a[axis]; ++k) product *= r(j, static_cast<Index>(axis));
    return product;
}

/// Largest differences of moments, of the matrix and of polynomials from their definitions.
template <class Scalar, int dim, int m>
double largest_difference(Index N) {
    const auto r = offsets<Scalar, dim>(N);
    const auto w = factors<Scalar>(N);
    constexpr auto all = monomials<dim, m>();
    const auto mu = moments<dim, m>(r, w);
    const auto M = moment_matrix<dim, m>(r, w);
    Eigen::Matrix<Scalar, 2, terms<dim, m>, Eigen::RowMajor> q;
    for (Index k = 0; k < q.cols(); ++k)
        q.col(k) << Scalar(1.0 / static_cast<double>(1 + k)), Scalar(k % 3 - 1);
    const Table<Scalar> p = polynomials<dim, m>(q, r, w);
    Scalar most(0);
    using std::abs, std::max;
    for (std::size_t a = 0; a < all.size(); ++a) {
        Scalar sum(0);
        for (Index j = 0; j < N; ++j) sum += w[j] * monomial<Scalar, dim>(r, j, all[a]);
        most = max(most, Scalar(abs(sum - mu[a])));
        for (std::size_t b = 0; b < all.size(); ++b) {
            Scalar entry(0);
            for (Index j = 0; j < N; ++j)
                entry += w[j] * monomial<Scalar, dim>(r, j, all[a]) * monomial<Scalar, dim>(r, j, all[b]);
            most = max(most, Scalar(abs(entry - M(static_cast<Index>(a), static_cast<Index>(b)))));
        }
    }
    for (Index row = 0; row < 2; ++row)
        for (Index j = 0; j < N; ++j) {
            Scalar sum(0);
            for (std::size_t a = 0; a < all.size(); ++a)
                sum += q(row, static_cast<Index>(a)) * w[j] * monomial<Scalar, dim>(r, j, all[a]);
            most = max(most, Scalar(abs(sum - p(row, j))));
        }
    return static_cast<double>(most);
}

}  // namespace

TEST_CASE(
    "moments: sums, matrix and polynomials are those of the definitions, for any number of neighbours") {
    for (const Index N : {1, 2, 3, 7, 8, 9, 31}) {
        CHECK(largest_difference<double, 1, 3>(N) < 1e-13);
        CHECK(largest_difference<double, 2, 2>(N) < 1e-13);
        CHECK(largest_difference<double, 2, 3>(N) < 1e-13);
        CHECK(largest_difference<double, 3, 3>(N) < 1e-13);
    }
    CHECK(largest_difference<base::Quad, 2, 3>(9) < 1e-31);
    CHECK(largest_difference<base::Quad, 3, 2>(9) < 1e-31);
}

TEST_CASE("moments: without neighbours all sums vanish") {
    for (const double sum : moments<2, 2>(Offsets<double, 2>(0, 2), Column<double>(0))) CHECK(sum == 0);
}

TEST_CASE("moments: each monomial is an earlier one times a coordinate") {
    constexpr auto all = monomials<3, 6>();
    constexpr auto factors = factors_of_monomials<3, 6>();
    for (std::size_t k = 1; k < all.size(); ++k) {
        CHECK(factors[k].monomial < k);
        Exponents<3> product = all[factors[k].monomial];
        ++product[factors[k].axis];
        CHECK(product == all[k]);
    }
}
