#include <limits>
#include <string>
#include <vector>

#include "asprone2010/in_quad.hpp"
#include "asprone2010/round_off.hpp"
#include "asprone2010/section_5_1_derivative_test.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"
#include "command_line/sweep.hpp"

namespace {

using namespace asprone2010;
using base::Quad;
using limit_stencils::ErrorModel;

/// What is measured and predicted.
struct Choice {
    std::vector<std::string> formulations{"modified_fpm", "second_order_fpm"};
    long most = 1000000;     ///< particles in double and long double precision
    long most_quad = 10000;  ///< particles in quadruple precision
};

/// A formulation in a precision on a line of particles, with what is predicted.
struct Case {
    std::string formulation, precision;
    Index N;
    ErrorModel model;
};

/// Two numbers of particles a decade, 1 and 3, up to the most.
std::vector<Index> numbers(Index most) {
    std::vector<Index> all;
    for (Index N = 10; N <= most; N *= 10) {
        all.push_back(N);
        if (3 * N <= most) all.push_back(3 * N);
    }
    return all;
}

ErrorModel model_of(const std::string& formulation) {
    const ErrorModel model = limit_stencils::error_model(command_line::formulation_named<Quad>(formulation));
    if (model.exponent < 1)
        throw base::InvalidInput(
            "the error of " + formulation +
            " does not fall with delta: no precision limits it; choose one of order 1 or 2");
    return model;
}

std::vector<Case> cases(const Choice& choice) {
    std::vector<Case> all;
    for (const std::string& formulation : choice.formulations) {
        const ErrorModel model = model_of(formulation);
        for (const char* precision : {"double", "long", "quad"})
            for (const Index N : numbers(std::string(precision) == "quad" ? choice.most_quad : choice.most))
                all.push_back({formulation, precision, N, model});
    }
    return all;
}

/// The best error of a formulation in each precision, as predicted.
std::vector<std::string> best_errors(const std::string& formulation) {
    const ErrorModel model = model_of(formulation);
    std::vector<std::string> lines;
    for (const char* precision : {"double", "long", "quad"}) {
        const double epsilon = command_line::in_precision(precision, [](auto zero) {
            return static_cast<double>(std::numeric_limits<decltype(zero)>::epsilon());
        });
        const double best = model.best_spacing(epsilon);
        const double error = model.truncation(best) + model.round_off(best, epsilon);
        lines.push_back(formulation + ", " + precision + ": best error predicted " + base::shown(error, 3) +
                        " at " + base::shown(1 + 1 / best, 3) + " particles");
    }
    return lines;
}

template <class Scalar>
double measured_error(const Case& line) {
    const auto discrete = numerical_tests::discretise<Scalar>({}, line.N, 1);
    const auto& formulation = command_line::formulation_named<Scalar>(line.formulation);
    return static_cast<double>(
        derivative_test::errors(formulation, discrete, derivative_test::exponential<Scalar>()).second);
}

/// The cells that name a case.
std::vector<report::Cell> named(const Case& line) {
    return {line.formulation, line.precision, static_cast<long>(line.N)};
}

std::vector<report::Cell> row(const Case& line) {
    const double spacing = 1 / static_cast<double>(line.N - 1);
    return command_line::in_precision(line.precision, [&](auto zero) -> std::vector<report::Cell> {
        using Scalar = decltype(zero);
        const auto epsilon = static_cast<double>(std::numeric_limits<Scalar>::epsilon());
        return {line.formulation,
                line.precision,
                static_cast<long>(line.N),
                spacing,
                measured_error<Scalar>(line),
                line.model.truncation(spacing),
                line.model.round_off(spacing, epsilon)};
    });
}

report::Table errors(const Choice& choice) {
    report::Table table;
    table.comments = {
        "Beyond Asprone et al. (2010), Section 5.1: error of D2B for B = exp, measured and predicted from the stencil at x = 1, kernel gaussian, h/delta 1, volumes equal",
        "predicted: truncation C delta^p, round-off sum of |weights| * e * epsilon / 2 / delta^2"};
    for (const std::string& formulation : choice.formulations)
        for (const std::string& line : best_errors(formulation)) table.comments.push_back(line);
    table.columns = {{"formulation"},
                     {"precision"},
                     {"particles"},
                     {"spacing"},
                     {"error_second", {0.5, 0}},
                     {"predicted_truncation", {1e-9, 0}},
                     {"predicted_roundoff", {1e-9, 0}}};
    const std::vector<Case> all = cases(choice);
    const auto attempts = command_line::attempts_in_parallel(all, row);
    command_line::Sweep sweep(table, 3);
    for (std::size_t k = 0; k < all.size(); ++k)
        if (const auto& [numbers, failure] = attempts[k]; failure)
            sweep.add_failed(named(all[k]), *failure);
        else
            sweep.add({numbers});
    sweep.finish();
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The smallest error that each precision can reach: measured errors of D2B for exp, beside the truncation and the round-off that the stencil at the end predicts.",
        "roundoff", "Example: roundoff --formulation second_order_fpm --most 1000000 --most-quad 100000");
    Choice choice;
    int threads = 0;
    std::string output;
    app.add_list("--formulation", choice.formulations,
                 "which formulations, of order 1 or 2 (default modified_fpm,second_order_fpm)");
    app.add_option("--most", choice.most,
                   "largest number of particles in double and long precision (default 1000000)")
        .type_name("N")
        .within(10, 10000000);
    app.add_option("--most-quad", choice.most_quad,
                   "largest number of particles in quad precision (default 10000)")
        .type_name("N")
        .within(10, 10000000);
    app.add_threads(threads);
    app.add_output(output);
    command_line::Figure figure{"asprone2010/figure_precision.gp"};
    command_line::add_plot_option(app, figure);

    return command_line::run(app, argc, argv, threads, output, figure, [&] {
        if (!figure.path.empty() && choice.formulations != Choice().formulations)
            throw base::InvalidInput(
                "--plot draws the two formulations of the default; leave --formulation out");
        return errors(choice);
    });
}
