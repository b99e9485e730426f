#include <array>
#include <map>
#include <string>
#include <vector>

#include "asprone2010/formulations.hpp"
#include "tests/support/lines.hpp"

using namespace asprone2010;

namespace {

/// \f$\sum_j w_j (x_j - x_i)^k / k!\f$ of a row, in units of δ.
double moment(const Operator<double>& D, Index i, int derivative, int k) {
    const Index N = D.rows();
    const double delta = 1 / static_cast<double>(N - 1);
    double sum = 0;
    for (Operator<double>::InnerIterator entry(D, i); entry; ++entry) {
        double term = entry.value() * std::pow(delta, derivative);
        for (int power = 1; power <= k; ++power) term *= static_cast<double>(entry.col() - i) / power;
        sum += term;
    }
    return sum;
}

/// The moments at an end and inside.
struct Moments {
    std::string formulation;
    int derivative, k;
    double end, inside;
};

}  // namespace

TEST_CASE("moments: those with which each section says why its formulation holds or fails") {
    const std::vector<Moments> said{{"original", 1, 1, 0.499, 0.998},
                                    {"chen_beraun", 1, 1, 1, 1},
                                    {"chen_beraun", 1, 2, 0.585, 0},
                                    {"chen_beraun", 2, 2, -0.072, 1},
                                    {"rkpm_second_order", 1, 1, 0.17, 0.98},
                                    {"rkpm_first_order", 1, 1, 0.302, 0.998},
                                    {"fpm", 1, 1, 1, 1},
                                    {"fpm", 1, 2, 0.600, 0},
                                    {"fpm", 2, 2, 0.526, 1},
                                    {"modified_fpm", 2, 2, 1, 1},
                                    {"modified_fpm", 2, 3, 1.014, 0},
                                    {"second_order_fpm", 2, 2, 1, 1},
                                    {"second_order_fpm", 2, 3, 0, 0},
                                    {"second_order_fpm", 2, 4, -0.920, 0.126}};
    for (const Index N : {41, 161}) {
        const auto discrete = support::particles_of(N);
        for (const Moments& row : said) {
            CAPTURE(row.formulation);
            CAPTURE(row.k);
            const auto& [name, derivative, k, end, inside] = row;
            const auto [D, D2] = formulation_named<double>(name).operators(discrete.line, discrete.smoothing);
            const Operator<double>& rows = derivative == 1 ? D : D2;
            CHECK(std::abs(moment(rows, 0, derivative, k) - end) < 6e-4);
            CHECK(std::abs(moment(rows, N / 2, derivative, k) - inside) < 6e-4);
        }
    }
}
