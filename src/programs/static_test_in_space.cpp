#include "fpm_in_space/section_5_static_test.hpp"

#include <string>
#include <vector>

#include "command_line/cloud_table.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"

namespace {

using namespace fpm_in_space;
using command_line::CloudOptions;
using command_line::CloudTest;
using command_line::Found;
using command_line::Placed;
using particles::Column;

/// The options of the static test, and those of all tests in space.
struct Options : CloudOptions {
    std::vector<std::string> conditions{"mixed"};
};

/// Errors of values and of first derivatives at each particle, by conditions and by place.
template <int dim>
CloudTest<dim> test(const Options& options) {
    const auto find = [&options, B = command_line::function<dim>(options)](const std::string& formulation,
                                                                           const Placed<dim>& particles,
                                                                           const Column<double>& spacing) {
        const auto& cloud = particles.cloud;
        const auto rows = static_test::rows<dim>(formulation_named<double, dim>(formulation), cloud,
                                                 command_line::smoothing<dim>(options, spacing), spacing);
        std::vector<Found> all;
        for (const std::string& conditions : options.conditions) {
            const auto u =
                static_test::solution<dim>(rows, cloud, B, static_test::conditions_named(conditions));
            const auto errors = static_test::errors<dim>(rows, cloud, B, u);
            for (const auto& [place, range] : particles.places) {
                Found& found = all.emplace_back(Found{{conditions, place}, {}, {}});
                for (particles::Index i = range.first; i < range.last; ++i) {
                    const auto& [particle, value, first, R] = errors[static_cast<std::size_t>(i)];
                    found.particles.push_back(particle);
                    found.numbers.push_back({value, first, R});
                }
            }
        }
        return all;
    };
    return {
        "FPM in space, Section 5, Poisson's equation (F17), (F18): largest errors of values and first derivatives by place",
        "FPM in space, Section 5, Poisson's equation (F17), (F18): errors of values and first derivatives at each particle",
        {{"conditions"}, {"place"}},
        {{{"error_value", {1e-6, 1e-12}}, {"error_first", {1e-6, 1e-10}}, {"quality", {1e-6, 1e-9}}}},
        "R, the factor in the bound of the error of the Laplacian in powers of delta",
        find};
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The second-order FPM in the plane and in space, Section 5: Poisson's equation on the unit square or cube by collocation, with values or fluxes on its sides that follow from an exact solution B; largest errors inside and at faces, edges and corners.",
        "static_test_in_space",
        "Example: static_test_in_space --formulation definite_fpm,ssph --particles 16,31,61 --conditions mixed --plot /tmp/poisson.svg\n"
        "In space: static_test_in_space --dimension 3 --particles 9,13,17 --perturb 0.25\n"
        "A solution of your own: static_test_in_space --formulation definite_fpm --function \"sin(3*x)*exp(y)\" --layout stretched-10 --conditions neumann");
    Options options;
    options.figure.script = "fpm_in_space/errors.gp";
    options.on_square = true;
    app.add_list(
           "--conditions", options.conditions,
           "what is given on the sides, a list or all: dirichlet, values; mixed (default), fluxes on the sides x = 1, y = 1, z = 1 and values on the others; neumann, fluxes, with the reaction c = 1")
        .type_name("NAME[,...]");
    command_line::add_options(app, options);
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        options.conditions =
            command_line::chosen("condition", options.conditions, static_test::condition_names());
        if (options.conditions.size() > 1 && !options.figure.path.empty())
            throw base::InvalidInput("--plot draws one of the conditions; name one by --conditions");
        command_line::complete(options);
        return options.dimension == 2 ? command_line::table_of(options, test<2>(options))
                                      : command_line::table_of(options, test<3>(options));
    });
}
