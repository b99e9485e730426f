#include "asprone2010/section_5_1_derivative_test.hpp"

#include <optional>

#include "programs/expression.hpp"
#include "programs/formulations.hpp"
#include "programs/options.hpp"

int main(int argc, char** argv) {
    CLI::App app(
        "Section 5.1 of Asprone et al. (2010): errors of the first and second derivative of exp on [0, 1].",
        "derivative_test");
    app.footer(
        "Example: derivative_test --formulation second_order_fpm --particles 320,640,1280\n"
        "Another: derivative_test --function \"sin(5*x)+x^2\" --particles 37");
    programs::Options options;
    options.particles = programs::four_a_doubling();
    options.figure = {"asprone2010/figure_1.gp", "formulation", "particles", "error_second"};
    programs::add_options(app, options);

    std::optional<std::string> function;
    app.add_option(
           "--function", function,
           "the function B of x, smooth on [0, 1] (default exp(x)); of " + std::string(programs::vocabulary))
        ->type_name("TEXT");

    return programs::run(app, argc, argv, options, [&] {
        using namespace asprone2010;
        derivative_test::Exact<double> exact = derivative_test::exponential<double>();
        if (function) {
            const auto [value, first, second] = programs::expression("--function", *function);
            exact = {value, first, second};
            options.figure.told["function"] = *function;
        }
        report::Table table;
        table.comments = {
            "Asprone et al. (2010), Section 5.1, Figure 1: infinity norms of the errors of DB and D2B for B "
            "= " +
                function.value_or("exp"),
            "interior: particles farther than the support's radius from both ends; empty where there are "
            "none"};
        for (const std::string& comment : programs::described(options)) table.comments.push_back(comment);
        table.columns = {{"error_first", {1e-6, 1e-12}},
                         {"error_second", {1e-6, 2e-10}},
                         {"error_first_interior", {1e-6, 1e-12}},
                         {"error_second_interior", {1e-6, 2e-10}}};
        programs::tabulate(table, options, [&](const programs::Case& of) -> std::vector<report::Cell> {
            const auto [first, second, first_interior, second_interior] = derivative_test::errors(
                programs::formulation_named(of.formulation), programs::discretise(options, of), exact);
            const auto cell = [](const std::optional<double>& error) {
                return error ? report::Cell(*error) : report::Cell();
            };
            return {first, second, cell(first_interior), cell(second_interior)};
        });
        return table;
    });
}
