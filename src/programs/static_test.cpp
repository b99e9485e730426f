#include "asprone2010/section_5_2_static_test.hpp"

#include <optional>
#include <string>
#include <vector>

#include "command_line/formulations.hpp"
#include "command_line/options.hpp"
#include "expressions/parser.hpp"

namespace {

using namespace asprone2010;

/// The reader's displacement, or the paper's.
template <class Scalar>
base::Smooth<Scalar> exact_displacement(const std::optional<std::string>& text) {
    if (!text) return static_test::exponential_load<Scalar>();
    return expressions::smooth<Scalar>("--displacement", *text);
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Section 5.2 of Asprone et al. (2010): displacement error of an elastic rod, -u'' = exp, u(0) = "
        "u'(1) = 0.",
        "static_test",
        "Example: static_test --formulation modified_fpm,second_order_fpm --particles 160,320,640\n"
        "Another: static_test --displacement \"x*exp(-x)+sin(3*x)\" --particles 53");
    command_line::Options options;
    options.particles = command_line::four_a_doubling();
    options.figure = {"asprone2010/figure_2.gp"};
    command_line::add_options(app, options);

    std::string end;
    app.add_option("--end", end,
                   "formulation whose first derivative is imposed at x = 1 (default: each its own)")
        .type_name("NAME");

    std::optional<std::string> displacement;
    app.add_option("--displacement", displacement,
                   "the exact displacement u, smooth on [0, 1] (default -exp(x)+e*x+1), from which the load "
                   "and the end values follow; of " +
                       expressions::vocabulary())
        .type_name("TEXT");

    int corrections = static_test::most_corrections;
    app.add_option("--corrections", corrections,
                   "of the solution by the solution for its residual, at most so many (default " +
                       std::to_string(corrections) + ", fewer where they no longer help)")
        .type_name("K")
        .within(0, static_test::most_corrections);

    command_line::add_precision(app, options);

    return command_line::run(app, argc, argv, options, [&] {
        report::Table table;
        table.comments = {
            "Asprone et al. (2010), Section 5.2, Figure 2: infinity norm of the displacement's error, (45) "
            "with " +
            (displacement ? "u = " + *displacement : "f = exp")};
        for (const std::string& comment : command_line::described(options)) table.comments.push_back(comment);
        if (!end.empty()) table.comments.push_back("derivative at x = 1 by " + end);
        if (corrections < static_test::most_corrections)
            table.comments.push_back("corrections of the solution: at most " + std::to_string(corrections));
        // What is not corrected is round-off on long lines, of which the size alone is reproducible.
        table.columns = {
            {"error_displacement", {corrections < static_test::most_corrections ? 0.9 : 1e-6, 5e-10}}};
        command_line::in_precision(options.precision, [&](auto zero) {
            using Scalar = decltype(zero);
            const auto exact = exact_displacement<Scalar>(displacement);
            command_line::tabulate(
                table, options, [&](const command_line::Case& of) -> std::vector<report::Cell> {
                    return {static_cast<double>(static_test::error(
                        command_line::formulation_named<Scalar>(of.formulation),
                        command_line::formulation_named<Scalar>(end.empty() ? of.formulation : end),
                        command_line::discretise<Scalar>(options, of), exact, corrections))};
                });
        });
        return table;
    });
}
