#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <functional>
#include <vector>

#include "tests/support/lines.hpp"

using namespace asprone2010;

/// An independent calculation of the stencils: the printed formulas in exact rationals, lengths in the unit
/// of x. It covers the kernels that are polynomials piece by piece, which it differentiates exactly.
namespace {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

/// A polynomial of the offset r = x − x_i by its coefficients, the constant first.
class Polynomial {
  public:
    Polynomial(int constant) : c_{constant} {}
    Polynomial(const Rational& constant) : c_{constant} {}
    Polynomial(const Rational& constant, const Rational& slope) : c_{constant, slope} {}
    explicit Polynomial(std::vector<Rational> coefficients) : c_(std::move(coefficients)) {}

    Rational operator()(const Rational& r) const {
        Rational value = 0;
        for (auto c = c_.rbegin(); c != c_.rend(); ++c) value = value * r + *c;
        return value;
    }

    [[nodiscard]] Polynomial derivative() const {
        std::vector<Rational> c(std::max<std::size_t>(c_.size() - 1, 1));
        for (std::size_t k = 1; k < c_.size(); ++k) c[k - 1] = Rational(k) * c_[k];
        return Polynomial(c);
    }

    friend Polynomial operator+(const Polynomial& a, const Polynomial& b) {
        std::vector<Rational> c(std::max(a.c_.size(), b.c_.size()));
        for (std::size_t k = 0; k < a.c_.size(); ++k) c[k] += a.c_[k];
        for (std::size_t k = 0; k < b.c_.size(); ++k) c[k] += b.c_[k];
        return Polynomial(c);
    }
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
        std::vector<Rational> c(a.c_.size() + b.c_.size() - 1);
        for (std::size_t k = 0; k < a.c_.size(); ++k)
            for (std::size_t l = 0; l < b.c_.size(); ++l) c[k + l] += a.c_[k] * b.c_[l];
        return Polynomial(c);
    }
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + Polynomial(-1) * b; }
    friend Polynomial operator/(const Polynomial& a, const Rational& divisor) {
        return a * Polynomial(1 / divisor);
    }

  private:
    std::vector<Rational> c_;
};

Polynomial pow(const Polynomial& a, int exponent) {
    return exponent == 0 ? Polynomial(1) : a * pow(a, exponent - 1);
}

const Polynomial offset(0, 1);

/// A kernel for h = 1 as a polynomial of the distance q: the one that holds at a given distance.
struct Pieces {
    particles::Kernel<> kernel;
    int support;
    std::function<Polynomial(const Polynomial& q, const Rational& distance)> W;
};

const std::vector<Pieces>& polynomial_kernels() {
    static const std::vector<Pieces> all{
        {particles::CubicSpline{}, 2,
         [](const Polynomial& q, const Rational& distance) {
             return distance < 1 ? Rational(2, 3) - pow(q, 2) + pow(q, 3) / 2 : pow(2 - q, 3) / 6;
         }},
        {particles::QuinticSpline{}, 3,
         [](const Polynomial& q, const Rational& distance) {
             Polynomial W = pow(3 - q, 5);
             if (distance < 2) W = W - 6 * pow(2 - q, 5);
             if (distance < 1) W = W + 15 * pow(1 - q, 5);
             return W / 120;
         }},
        {particles::WendlandC2{}, 2,
         [](const Polynomial& q, const Rational&) {
             return Rational(5, 8) * pow(1 - q / 2, 3) * (1 + 3 * q / 2);
         }},
        {particles::WendlandC4{}, 2,
         [](const Polynomial& q, const Rational&) {
             return Rational(3, 4) * pow(1 - q / 2, 5) * (1 + 5 * q / 2 + 2 * pow(q, 2));
         }},
    };
    return all;
}

/// Particle j as particle i sees it.
struct Neighbour {
    Neighbour(std::size_t number, const Rational& r_j, const Rational& V_j, const Polynomial& kernel)
        : j(number), r(r_j), V(V_j), W_i(kernel), W(W_i(r)), DW(W_i.derivative()(r)) {}

    std::size_t j;
    Rational r, V;
    Polynomial W_i;  // around r
    Rational W, DW;
};
using Near = std::vector<Neighbour>;

/// What each of N equally spaced particles sees.
std::vector<Near> lattice(const Pieces& kernel, std::size_t N, const Rational& spacing, const Rational& h,
                          particles::Volumes volumes) {
    std::vector<Near> all(N);
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            const Rational r = spacing * (Rational(j) - Rational(i));
            const Rational distance = abs(r) / h;
            if (distance >= kernel.support) continue;
            const bool half = volumes == particles::Volumes::partition && (j == 0 || j == N - 1);
            const Polynomial q(0, (r < 0 ? -1 : 1) / h);
            const Polynomial W_i = kernel.W(q, distance) / h;
            all[i].emplace_back(j, r, half ? spacing / 2 : spacing, W_i);
        }
    return all;
}

/// Σ_j (x_j − x_i)^k f(x_j) ΔΩ_j.
Rational moment(const Near& near, int k, Rational Neighbour::*f) {
    Rational sum = 0;
    for (const Neighbour& each : near) {
        Rational term = (each.*f) * each.V;
        for (int n = 0; n < k; ++n) term *= each.r;
        sum += term;
    }
    return sum;
}

using Matrix = std::vector<std::vector<Rational>>;

/// The solution of A c = (1, 0, 0, …) by elimination. \param A regular, as are its leading blocks
std::vector<Rational> first_column_of_inverse(Matrix A) {
    std::vector<Rational> c(A.size(), 0);
    c.front() = 1;
    for (std::size_t k = 0; k < A.size(); ++k)
        for (std::size_t i = 0; i < A.size(); ++i) {
            if (i == k) continue;
            const Rational factor = A[i][k] / A[k][k];
            for (std::size_t l = 0; l < A.size(); ++l) A[i][l] -= factor * A[k][l];
            c[i] -= factor * c[k];
        }
    for (std::size_t k = 0; k < A.size(); ++k) c[k] /= A[k][k];
    return c;
}

/// The kernel times the polynomial of the given exponents that makes its moments of these orders 1, 0, 0, …
Near corrected(const Near& near, const std::vector<int>& exponents) {
    Matrix moments;
    for (const int k : exponents) {
        moments.emplace_back();
        for (const int l : exponents) moments.back().push_back(moment(near, k + l, &Neighbour::W));
    }
    const std::vector<Rational> c = first_column_of_inverse(moments);
    Polynomial C(0);
    for (std::size_t k = 0; k < c.size(); ++k) C = C + c[k] * pow(offset, exponents[k]);
    Near all;
    for (const Neighbour& each : near) all.emplace_back(each.j, each.r, each.V, C * each.W_i);
    return all;
}

/// Rows of a formulation's operators; for D², where D is applied twice, all rows of D are made.
struct Stencils {
    Stencils(std::string_view formulation, const std::vector<Near>& near,
             const std::vector<std::size_t>& rows)
        : D(near.size(), std::vector<Rational>(near.size(), 0)), D2(D) {
        for (const std::size_t i : rows) set_rows(formulation, i, near[i]);
        if (solves_for_both_) return;
        for (std::size_t i = 0; i < near.size(); ++i)
            if (std::find(rows.begin(), rows.end(), i) == rows.end()) set_rows(formulation, i, near[i]);
        for (const std::size_t i : rows)  // (12), (26) and the end of Section 3.4
            for (const Neighbour& each : near[i])
                for (std::size_t k = 0; k < near.size(); ++k) D2[i][k] += D[i][each.j] * D[each.j][k];
    }

    Matrix D, D2;

  private:
    /// Weights (a W + b DW) ΔΩ on B(x_j) − B(x_i).
    static void set_row(Matrix& of, std::size_t i, const Near& near, const Rational& a, const Rational& b) {
        for (const Neighbour& each : near) {
            const Rational weight = (a * each.W + b * each.DW) * each.V;
            of[i][each.j] += weight;
            of[i][i] -= weight;
        }
    }

    void set_rows(std::string_view formulation, std::size_t i, Near near) {
        if (formulation == "rkpm_first_order") near = corrected(near, {0, 1});      // (23)
        if (formulation == "rkpm_second_order") near = corrected(near, {0, 1, 2});  // (23)
        if (formulation == "second_order_fpm") near = corrected(near, {0, 1, 3});   // (40), (42)
        const auto W = [&](int k) { return moment(near, k, &Neighbour::W); };
        const auto DW = [&](int k) { return moment(near, k, &Neighbour::DW); };
        if (formulation == "fpm") {  // (29), (30)
            const Rational det = W(0) * DW(1) - W(1) * DW(0);
            set_row(D, i, near, -DW(0) / det, W(0) / det);
        } else if (formulation == "chen_beraun") {  // (16), (20)
            const Rational half = W(2) / 2;
            set_row(D, i, near, 0, 1 / DW(1));
            set_row(D2, i, near, 1 / half, -W(1) / DW(1) / half);
            solves_for_both_ = true;
        } else if (formulation == "modified_fpm" || formulation == "second_order_fpm") {  // (35), (36), (43)
            const Rational det = (W(1) * DW(2) - W(2) * DW(1)) / 2;
            set_row(D, i, near, DW(2) / 2 / det, -W(2) / 2 / det);
            set_row(D2, i, near, -DW(1) / det, W(1) / det);
            solves_for_both_ = true;
        } else {  // (11), (25)
            set_row(D, i, near, 0, -1);
        }
    }

    bool solves_for_both_ = false;
};

/// The largest difference of a weight from the exact one, over the row's largest.
double difference(const Operator<double>& D, const std::vector<Rational>& exact, Index i) {
    double largest = 0, farthest = 0;
    for (std::size_t j = 0; j < exact.size(); ++j) {
        largest = std::max(largest, std::abs(static_cast<double>(exact[j])));
        farthest =
            std::max(farthest, std::abs(D.coeff(i, static_cast<Index>(j)) - static_cast<double>(exact[j])));
    }
    return farthest / largest;
}

}  // namespace

TEST_CASE(
    "exact stencils: (11), (16), (20), (25), (30), (36) and (43) in exact rationals give the weights of D and D², at the end, beside it and inside") {
    const std::size_t N = 17;
    const std::vector<std::size_t> rows{0, 1, N / 2};
    for (const Pieces& kernel : polynomial_kernels())
        for (const auto& ratio : {Rational(8, 5), Rational(7, 4), Rational(9, 4)})
            for (const auto volumes : {particles::Volumes::equal, particles::Volumes::partition}) {
                const Rational spacing(1, static_cast<long>(N - 1));
                const auto near = lattice(kernel, N, spacing, ratio * spacing, volumes);
                const auto [line, smoothing] = support::particles_of(
                    static_cast<Index>(N), {volumes, kernel.kernel, static_cast<double>(ratio)});
                for (const auto& formulation : formulations<double>()) {
                    CAPTURE(particles::name(kernel.kernel));
                    CAPTURE(static_cast<double>(ratio));
                    CAPTURE(particles::name(volumes));
                    CAPTURE(formulation.name);
                    const Stencils exact(formulation.name, near, rows);
                    const auto [D, D2] = formulation.operators(line, smoothing);
                    // 1e-12 is 4500 roundings: a dozen terms in each sum, times the local systems' condition.
                    for (const std::size_t i : rows) {
                        CAPTURE(i);
                        CHECK(difference(D, exact.D[i], static_cast<Index>(i)) < 1e-12);
                        CHECK(difference(D2, exact.D2[i], static_cast<Index>(i)) < 1e-12);
                    }
                }
            }
}
