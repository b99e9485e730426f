#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "asprone2010/limit_stencils.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace asprone2010;
using base::Quad;

/// What the stencil at the end x = 1 says of the error of D²B for B = exp.
struct Prediction {
    double exponent, constant;  ///< truncation |C| e δ^p
    double amplification;  ///< round-off: e times sum of |weights| times half the scalar's epsilon, over δ²

    [[nodiscard]] double truncation(double spacing) const { return constant * std::pow(spacing, exponent); }
    [[nodiscard]] double round_off(double spacing, double epsilon) const {
        return amplification * epsilon / 2 / (spacing * spacing);
    }
    /// Where the sum of both is least: p · truncation = 2 · round-off.
    [[nodiscard]] double best_spacing(double epsilon) const {
        return std::pow(amplification * epsilon / (exponent * constant), 1 / (exponent + 2));
    }
};

Prediction predicted(const std::string& formulation) {
    const auto [line, smoothing] = limit_stencils::right_end<Quad>({}, 0, 1);
    const auto of_line = command_line::formulation_named<Quad>(formulation).operators(line, smoothing);
    const auto end = limit_stencils::row<Quad>(of_line.D2, line, line.size() - 1, 1, 2);
    const auto [exponent, constant] = limit_stencils::leading_error(end, 2);
    const double e = std::exp(1.0);
    return {static_cast<double>(exponent), e * std::abs(static_cast<double>(constant)),
            e * static_cast<double>(limit_stencils::amplification(end))};
}

struct Case {
    std::string formulation, precision;
    Index N;
};

template <class Scalar>
double error(const Case& of) {
    const auto discrete = numerical_tests::discretise<Scalar>({}, of.N, 1);
    return static_cast<double>(
        derivative_test::errors(command_line::formulation_named<Scalar>(of.formulation), discrete,
                                derivative_test::exponential<Scalar>())
            .second);
}

/// Two numbers of particles a decade, 1 and 3, up to the most.
std::vector<Index> numbers(Index most) {
    std::vector<Index> all;
    for (Index N = 10; N <= most; N *= 10) {
        all.push_back(N);
        if (3 * N <= most) all.push_back(3 * N);
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The floor of each precision: measured errors of D2B for exp, beside the truncation and the "
        "round-off that the "
        "stencil at the end predicts.",
        "roundoff", "Example: roundoff --formulation second_order_fpm --most 1000000 --most-quad 100000");
    std::vector<std::string> wanted{"modified_fpm", "second_order_fpm"};
    long most = 1000000, most_quad = 10000;
    int threads = 0;
    std::string output;
    app.add_list("--formulation", wanted, "of order 1 or 2 (default modified_fpm,second_order_fpm)");
    app.add_option("--most", most, "particles at most in double and long precision (default 1000000)")
        .type_name("N")
        .within(10, 10000000);
    app.add_option("--most-quad", most_quad, "particles at most in quad precision (default 10000)")
        .type_name("N")
        .within(10, 10000000);
    app.add_threads(threads);
    app.add_output(output);

    command_line::Figure figure{"asprone2010/figure_precision.gp"};
    command_line::add_plot_option(app, figure);

    return command_line::run(app, argc, argv, threads, output, figure, [&] {
        if (!figure.path.empty() && wanted != std::vector<std::string>{"modified_fpm", "second_order_fpm"})
            throw base::InvalidInput(
                "--plot draws the two formulations of the default; leave --formulation out");
        std::vector<Case> cases;
        std::vector<Prediction> predictions;
        report::Table table;
        table.comments = {
            "Beyond Asprone et al. (2010), Section 5.1: error of D2B for B = exp, measured and predicted "
            "from the "
            "stencil at x = 1, kernel gaussian, h/delta 1, volumes equal",
            "predicted: truncation C delta^p, round-off sum of |weights| * e * epsilon / 2 / delta^2"};
        for (const std::string& formulation : wanted) {
            const Prediction of = predicted(formulation);
            if (of.exponent < 1)
                throw base::InvalidInput(
                    "the error of " + formulation +
                    " does not fall with delta: no precision limits it; choose one of order "
                    "1 or 2");
            for (const char* precision : {"double", "long", "quad"}) {
                const double epsilon = command_line::in_precision(precision, [](auto zero) {
                    return static_cast<double>(std::numeric_limits<decltype(zero)>::epsilon());
                });
                const double best = of.best_spacing(epsilon);
                table.comments.push_back(formulation + ", " + precision + ": best error predicted " +
                                         base::shown(of.truncation(best) + of.round_off(best, epsilon), 3) +
                                         " at " + base::shown(1 + 1 / best, 3) + " particles");
                for (const Index N : numbers(std::string(precision) == "quad" ? most_quad : most)) {
                    cases.push_back({formulation, precision, N});
                    predictions.push_back(of);
                }
            }
        }
        table.columns = {{"formulation"},
                         {"precision"},
                         {"particles"},
                         {"spacing"},
                         {"error_second", {0.5, 0}},
                         {"predicted_truncation", {1e-9, 0}},
                         {"predicted_roundoff", {1e-9, 0}}};
        table.rows.resize(cases.size());
        command_line::Progress progress(cases.size());
        base::for_each_index(static_cast<Index>(cases.size()), [&](Index k) {
            const auto at = static_cast<std::size_t>(k);
            const Case& of = cases[at];
            const double spacing = 1 / static_cast<double>(of.N - 1);
            command_line::in_precision(of.precision, [&](auto zero) {
                using Scalar = decltype(zero);
                const auto epsilon = static_cast<double>(std::numeric_limits<Scalar>::epsilon());
                table.rows[at] = {of.formulation,
                                  of.precision,
                                  static_cast<long>(of.N),
                                  spacing,
                                  error<Scalar>(of),
                                  predictions[at].truncation(spacing),
                                  predictions[at].round_off(spacing, epsilon)};
            });
            progress.step();
        });
        return table;
    });
}
