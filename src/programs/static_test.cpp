#include "asprone2010/section_5_2_static_test.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asprone2010/in_quad.hpp"
#include "command_line/cases.hpp"
#include "command_line/formulations.hpp"
#include "command_line/lists.hpp"
#include "command_line/quality.hpp"
#include "expressions/parser.hpp"

namespace {

using namespace asprone2010;
using command_line::Case;
using command_line::formulation_named;
using report::Cell;

/// The options of this test, and those of all numerical tests.
struct Options : command_line::Options {
    std::string end;  ///< the formulation of the derivative at x = 1; empty for each its own
    std::optional<std::string> displacement;  ///< the user's
    int corrections = static_test::most_corrections;
};

/// The user's displacement, or the paper's.
template <class Scalar>
base::Smooth<Scalar> exact_displacement(const std::optional<std::string>& text) {
    return text ? expressions::smooth<Scalar>("--displacement", *text)
                : static_test::exponential_load<Scalar>();
}

/// The formulation of the derivative at x = 1.
std::string end_of(const Options& options, const Case& one) {
    return options.end.empty() ? one.formulation : options.end;
}

template <class Scalar>
particles::Operators<Scalar> operators_of(const Options& options, const Case& one,
                                          const numerical_tests::Particles<Scalar>& discrete) {
    return static_test::operators(formulation_named<Scalar>(one.formulation),
                                  formulation_named<Scalar>(end_of(options, one)), discrete);
}

template <class Scalar>
std::vector<Cell> error(const Options& options, const Case& one, const base::Smooth<Scalar>& exact,
                        command_line::Quality& worth) {
    const auto discrete = command_line::line_of<Scalar>(options, one);
    auto operators = operators_of<Scalar>(options, one, discrete);
    std::vector<Cell> numbers = worth.cells(one, discrete, operators, end_of(options, one));
    const Scalar found = static_test::error(std::move(operators), discrete.line, exact, options.corrections);
    numbers.insert(numbers.begin(), static_cast<double>(found));
    return numbers;
}

/// x, and the displacement at each particle, computed and exact, and its error.
template <class Scalar>
std::vector<std::vector<Cell>> states(const Options& options, const Case& one,
                                      const base::Smooth<Scalar>& exact) {
    const auto discrete = command_line::line_of<Scalar>(options, one);
    const particles::Column<Scalar> u = static_test::displacement(
        operators_of<Scalar>(options, one, discrete), discrete.line, exact, options.corrections);
    std::vector<std::vector<Cell>> rows;
    for (Index i = 0; i < u.size(); ++i) {
        const Scalar x = discrete.line.x()[i], exactly = exact.f(x);
        std::vector<Cell> row;
        for (const Scalar& number : {x, u[i], exactly, Scalar(u[i] - exactly)})
            row.emplace_back(static_cast<double>(number));
        rows.push_back(std::move(row));
    }
    return rows;
}

report::Table begun(const Options& options, const std::string& about) {
    report::Table table;
    table.comments = {"Asprone et al. (2010), Section 5.2, Figure 2: " + about + ", (45) with " +
                      (options.displacement ? "u = " + *options.displacement : "f = exp")};
    for (const std::string& comment : command_line::header_comments(options))
        table.comments.push_back(comment);
    if (!options.end.empty()) table.comments.push_back("derivative at x = 1 by " + options.end);
    if (options.corrections != static_test::most_corrections)
        table.comments.push_back("corrections of the solution: at most " +
                                 std::to_string(options.corrections));
    return table;
}

/// On long lines the error of an uncorrected solution is round-off, of which only the size is reproducible.
report::Tolerance tolerance(const Options& options) {
    return {options.corrections == static_test::most_corrections ? 1e-6 : 0.9, 5e-10};
}

report::Table states_of(const Options& options) {
    report::Table table = begun(options, "displacement and its error at each particle");
    table.columns = {{"u", tolerance(options)}, {"u_exact"}, {"error_displacement", tolerance(options)}};
    command_line::in_precision(options.precision, [&](auto zero) {
        const auto exact = exact_displacement<decltype(zero)>(options.displacement);
        command_line::tabulate_states(table, options,
                                      [&](const Case& one) { return states(options, one, exact); });
    });
    return table;
}

report::Table table_of(const Options& options) {
    report::Table table = begun(options, "infinity norm of the displacement's error");
    table.columns = {{"error_displacement", tolerance(options)}};
    command_line::Quality worth(options, quality::of_static_test);
    worth.add_column(table);
    command_line::in_precision(options.precision, [&](auto zero) {
        const auto exact = exact_displacement<decltype(zero)>(options.displacement);
        command_line::tabulate(table, options,
                               [&](const Case& one) { return error(options, one, exact, worth); });
    });
    worth.add_comment(table);
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 5.2 of Asprone et al. (2010): displacement error of an elastic rod, -u'' = exp, u(0) = u'(1) = 0.",
        "static_test",
        "Example: static_test --formulation modified_fpm,second_order_fpm --particles 160,320,640\n"
        "Another: static_test --displacement \"x*exp(-x)+sin(3*x)\" --particles 53\n"
        "Where the errors lie: static_test --particles 40 --states --plot /tmp/states.svg");
    Options options;
    options.particles = command_line::four_a_doubling();
    options.figure = {"asprone2010/figure_2.gp"};
    command_line::add_options(app, options);
    command_line::add_median(app, options);
    command_line::add_plot_option(app, options.figure);
    app.add_option("--end", options.end,
                   "formulation whose first derivative is imposed at x = 1 (default: each its own)")
        .type_name("NAME");
    app.add_option(
           "--displacement", options.displacement,
           "the exact displacement u, smooth on [0, 1] (default -exp(x)+e*x+1), from which the load and the end values follow; made of " +
               expressions::vocabulary())
        .type_name("TEXT");
    app.add_option("--corrections", options.corrections,
                   "most corrections of the solution by its residual, iterative refinement (default " +
                       std::to_string(options.corrections) + "; it ends earlier where that no longer helps)")
        .type_name("K")
        .within(0, static_test::most_corrections);
    command_line::add_precision(app, options);
    command_line::add_quality(app, options);
    command_line::add_states(app, options);
    return command_line::run(app, argc, argv, options, [&] {
        if (!options.end.empty())
            command_line::of_option(
                "--end", [&] { static_cast<void>(command_line::formulation_named<double>(options.end)); });
        return command_line::errors_or_states(
            options, [&] { return table_of(options); }, [&] { return states_of(options); },
            "asprone2010/states_2.gp");
    });
}
