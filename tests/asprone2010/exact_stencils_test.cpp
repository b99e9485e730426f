#include <ginac/ginac.h>

#include <functional>
#include <vector>

#include "tests/support.hpp"

using namespace asprone2010;
using GiNaC::ex;
using GiNaC::numeric;

/// An independent calculation of the stencils: the printed formulas in exact rationals, lengths in the unit of x, derivatives
/// symbolic. It takes the kernels that are polynomials piece by piece.
namespace {

const GiNaC::symbol offset("r");  // x − x_i

/// A kernel for h = 1 as a polynomial of the distance q: the one that holds at a given distance.
struct Pieces {
    particles::Kernel kernel;
    int support;
    std::function<ex(const ex& q, const numeric& distance)> W;
};

const std::vector<Pieces>& polynomial_kernels() {
    using GiNaC::pow;
    static const std::vector<Pieces> all{
        {particles::CubicSpline{}, 2,
         [](const ex& q, const numeric& distance) {
             return distance < 1 ? numeric(2, 3) - pow(q, 2) + pow(q, 3) / 2 : pow(2 - q, 3) / 6;
         }},
        {particles::QuinticSpline{}, 3,
         [](const ex& q, const numeric& distance) {
             ex W = pow(3 - q, 5);
             if (distance < 2) W -= 6 * pow(2 - q, 5);
             if (distance < 1) W += 15 * pow(1 - q, 5);
             return W / 120;
         }},
        {particles::WendlandC2{}, 2,
         [](const ex& q, const numeric&) { return numeric(5, 8) * pow(1 - q / 2, 3) * (1 + 3 * q / 2); }},
        {particles::WendlandC4{}, 2,
         [](const ex& q, const numeric&) {
             return numeric(3, 4) * pow(1 - q / 2, 5) * (1 + 5 * q / 2 + 2 * pow(q, 2));
         }},
    };
    return all;
}

/// Particle j as particle i sees it.
struct Neighbour {
    Neighbour(std::size_t number, const numeric& r_j, const numeric& V_j, const ex& kernel)
        : j(number), r(r_j), V(V_j), W_i(kernel), W(here(W_i)), DW(here(W_i.diff(offset))) {}

    std::size_t j;
    numeric r, V;
    ex W_i;  // around r, a polynomial of the offset
    numeric W, DW;

  private:
    [[nodiscard]] numeric here(const ex& f) const { return GiNaC::ex_to<numeric>(f.subs(offset == r)); }
};
using Near = std::vector<Neighbour>;

/// What each of N equally spaced particles sees.
std::vector<Near> lattice(const Pieces& kernel, std::size_t N, const numeric& spacing, const numeric& h,
                          particles::Volumes volumes) {
    std::vector<Near> all(N);
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            const numeric r = spacing * (numeric(static_cast<long>(j)) - numeric(static_cast<long>(i)));
            const numeric distance = GiNaC::abs(r) / h;
            if (distance >= kernel.support) continue;
            const bool half = volumes == particles::Volumes::partition && (j == 0 || j == N - 1);
            const ex W_i = kernel.W((r < 0 ? -offset : ex(offset)) / h, distance) / h;
            all[i].emplace_back(j, r, half ? spacing / 2 : spacing, W_i);
        }
    return all;
}

/// Σ_j (x_j − x_i)^k f(x_j) ΔΩ_j.
numeric moment(const Near& near, int k, numeric Neighbour::*f) {
    numeric sum = 0;
    for (const Neighbour& each : near) {
        numeric term = (each.*f) * each.V;
        for (int n = 0; n < k; ++n) term *= each.r;
        sum += term;
    }
    return sum;
}

/// The kernel times the polynomial of the given exponents with which its moments of these orders are 1, 0, 0, …
Near corrected(const Near& near, const std::vector<int>& exponents) {
    const auto n = static_cast<unsigned>(exponents.size());
    GiNaC::matrix moments(n, n), wanted(n, 1);
    for (unsigned k = 0; k < n; ++k)
        for (unsigned l = 0; l < n; ++l)
            moments(k, l) = moment(near, exponents[k] + exponents[l], &Neighbour::W);
    wanted(0, 0) = 1;
    const GiNaC::matrix c = moments.inverse().mul(wanted);
    ex C = 0;
    for (unsigned k = 0; k < n; ++k) C += c(k, 0) * GiNaC::pow(offset, exponents[k]);
    Near all;
    for (const Neighbour& each : near) all.emplace_back(each.j, each.r, each.V, C * each.W_i);
    return all;
}

using Matrix = std::vector<std::vector<numeric>>;

/// Rows of a formulation's operators; for D², where D is applied twice, all rows of D are made.
struct Stencils {
    Stencils(std::string_view formulation, const std::vector<Near>& near,
             const std::vector<std::size_t>& rows)
        : D(near.size(), std::vector<numeric>(near.size(), 0)), D2(D) {
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
    static void set_row(Matrix& of, std::size_t i, const Near& near, const numeric& a, const numeric& b) {
        for (const Neighbour& each : near) {
            const numeric weight = (a * each.W + b * each.DW) * each.V;
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
            const numeric det = W(0) * DW(1) - W(1) * DW(0);
            set_row(D, i, near, -DW(0) / det, W(0) / det);
        } else if (formulation == "chen_beraun") {  // (16), (20)
            const numeric half = W(2) / 2;
            set_row(D, i, near, 0, 1 / DW(1));
            set_row(D2, i, near, 1 / half, -W(1) / DW(1) / half);
            solves_for_both_ = true;
        } else if (formulation == "modified_fpm" || formulation == "second_order_fpm") {  // (35), (36), (43)
            const numeric det = (W(1) * DW(2) - W(2) * DW(1)) / 2;
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
double difference(const Operator<double>& D, const std::vector<numeric>& exact, Index i) {
    double largest = 0, farthest = 0;
    for (std::size_t j = 0; j < exact.size(); ++j) {
        largest = std::max(largest, std::abs(exact[j].to_double()));
        farthest = std::max(farthest, std::abs(D.coeff(i, static_cast<Index>(j)) - exact[j].to_double()));
    }
    return farthest / largest;
}

}  // namespace

TEST_CASE(
    "exact stencils: (11), (16), (20), (25), (30), (36) and (43) in exact rationals give the weights of D "
    "and D², at "
    "the end, beside it and inside") {
    const std::size_t N = 17;
    const std::vector<std::size_t> rows{0, 1, N / 2};
    for (const Pieces& kernel : polynomial_kernels())
        for (const auto& ratio : {numeric(8, 5), numeric(7, 4), numeric(9, 4)})
            for (const auto volumes : {particles::Volumes::equal, particles::Volumes::partition}) {
                const numeric spacing(1, static_cast<long>(N - 1));
                const auto near = lattice(kernel, N, spacing, ratio * spacing, volumes);
                const auto [line, smoothing] =
                    support::particles_of(static_cast<Index>(N), {volumes, kernel.kernel, ratio.to_double()});
                for (const auto& formulation : formulations<double>()) {
                    CAPTURE(particles::name(kernel.kernel));
                    CAPTURE(ratio.to_double());
                    CAPTURE(particles::name(volumes));
                    CAPTURE(formulation.name);
                    const Stencils exact(formulation.name, near, rows);
                    const auto [D, D2] = formulation.operators(line, smoothing);
                    // 1e-12 is 4500 roundings: of sums of a dozen terms, times the condition of the local systems.
                    for (const std::size_t i : rows) {
                        CAPTURE(i);
                        CHECK(difference(D, exact.D[i], static_cast<Index>(i)) < 1e-12);
                        CHECK(difference(D2, exact.D2[i], static_cast<Index>(i)) < 1e-12);
                    }
                }
            }
}
