#include "asprone2010/section_5_1_derivative_test.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asprone2010/in_quad.hpp"
#include "command_line/cases.hpp"
#include "command_line/formulations.hpp"
#include "command_line/quality.hpp"
#include "expressions/parser.hpp"

namespace {

using namespace asprone2010;
using command_line::Case;
using command_line::Options;
using report::Cell;

/// The user's function, or the paper's.
template <class Scalar>
base::Smooth<Scalar> exact_function(const std::optional<std::string>& text) {
    return text ? expressions::smooth<Scalar>("--function", *text) : derivative_test::exponential<Scalar>();
}

template <class Scalar>
Cell cell(const std::optional<Scalar>& error) {
    return error ? Cell(static_cast<double>(*error)) : Cell();
}

template <class Scalar>
std::vector<Cell> errors(const Options& options, const Case& one, const base::Smooth<Scalar>& exact,
                         command_line::Quality& worth) {
    const auto discrete = command_line::line_of<Scalar>(options, one);
    const auto operators =
        command_line::formulation_named<Scalar>(one.formulation).operators(discrete.line, discrete.smoothing);
    const std::vector<Cell> R = worth.cells(one, discrete, operators);
    const auto found = derivative_test::errors(operators, discrete, exact);
    std::vector<Cell> numbers{cell<Scalar>(found.first), cell<Scalar>(found.second),
                              cell(found.first_interior), cell(found.second_interior)};
    numbers.insert(numbers.end(), R.begin(), R.end());
    return numbers;
}

/// x, B and its derivatives at each particle, computed and exact, and their errors.
template <class Scalar>
std::vector<std::vector<Cell>> states(const Options& options, const Case& one,
                                      const base::Smooth<Scalar>& exact) {
    const auto [line, smoothing] = command_line::line_of<Scalar>(options, one);
    const auto operators =
        command_line::formulation_named<Scalar>(one.formulation).operators(line, smoothing);
    const particles::Column<Scalar> B = line.x().unaryExpr(exact.f), DB = particles::apply(operators.D, B),
                                    D2B = particles::apply(operators.D2, B);
    std::vector<std::vector<Cell>> rows;
    for (Index i = 0; i < line.size(); ++i) {
        const Scalar x = line.x()[i], first = exact.Df(x), second = exact.D2f(x);
        std::vector<Cell> row;
        for (const Scalar& number :
             {x, B[i], DB[i], first, D2B[i], second, Scalar(DB[i] - first), Scalar(D2B[i] - second)})
            row.emplace_back(static_cast<double>(number));
        rows.push_back(std::move(row));
    }
    return rows;
}

report::Table begun(const Options& options, std::vector<std::string> about) {
    report::Table table;
    table.comments = std::move(about);
    for (const std::string& comment : command_line::header_comments(options))
        table.comments.push_back(comment);
    return table;
}

report::Table states_of(const Options& options, const std::optional<std::string>& function) {
    report::Table table =
        begun(options,
              {"Asprone et al. (2010), Section 5.1: derivatives and their errors at each particle for B = " +
               function.value_or("exp")});
    table.columns = {{"B"},
                     {"DB", {1e-6, 1e-12}},
                     {"DB_exact"},
                     {"D2B", {1e-6, 2e-10}},
                     {"D2B_exact"},
                     {"error_first", {1e-6, 1e-12}},
                     {"error_second", {1e-6, 2e-10}}};
    command_line::in_precision(options.precision, [&](auto zero) {
        const auto exact = exact_function<decltype(zero)>(function);
        command_line::tabulate_states(table, options,
                                      [&](const Case& one) { return states(options, one, exact); });
    });
    return table;
}

report::Table table_of(const Options& options, const std::optional<std::string>& function) {
    report::Table table = begun(
        options,
        {"Asprone et al. (2010), Section 5.1, Figure 1: infinity norms of the errors of DB and D2B for B = " +
             function.value_or("exp"),
         "interior: particles farther than the support's radius from both ends; empty where there are none"});
    table.columns = {{"error_first", {1e-6, 1e-12}},
                     {"error_second", {1e-6, 2e-10}},
                     {"error_first_interior", {1e-6, 1e-12}},
                     {"error_second_interior", {1e-6, 2e-10}}};
    command_line::Quality worth(options, quality::of_derivative_test);
    worth.add_column(table);
    command_line::in_precision(options.precision, [&](auto zero) {
        const auto exact = exact_function<decltype(zero)>(function);
        command_line::tabulate(table, options,
                               [&](const Case& one) { return errors(options, one, exact, worth); });
    });
    worth.add_comment(table);
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 5.1 of Asprone et al. (2010): errors of the first and second derivative of exp on [0, 1].",
        "derivative_test",
        "Example: derivative_test --formulation second_order_fpm --particles 320,640,1280\n"
        "Another: derivative_test --function \"sin(5*x)+x^2\" --particles 37\n"
        "Where the errors lie: derivative_test --particles 40 --states --plot /tmp/states.svg");
    Options options;
    options.particles = command_line::four_a_doubling();
    options.figure = {"asprone2010/figure_1.gp"};
    command_line::add_options(app, options);
    command_line::add_median(app, options);
    command_line::add_plot_option(app, options.figure);

    std::optional<std::string> function;
    app.add_option(
           "--function", function,
           "the function B of x, smooth on [0, 1] (default exp(x)); made of " + expressions::vocabulary())
        .type_name("TEXT");
    command_line::add_precision(app, options);
    command_line::add_quality(app, options);
    command_line::add_states(app, options);
    return command_line::run(app, argc, argv, options, [&] {
        return command_line::errors_or_states(
            options, [&] { return table_of(options, function); },
            [&] { return states_of(options, function); }, "asprone2010/states_1.gp");
    });
}
