#include <string>
#include <vector>

#include "command_line/cloud_table.hpp"
#include "command_line/options.hpp"

namespace {

using namespace fpm_in_space;
using command_line::CloudOptions;
using command_line::CloudTest;
using command_line::Found;
using command_line::Placed;
using particles::Column;

/// Errors of both derivatives at each particle, by place.
template <int dim>
CloudTest<dim> test(const CloudOptions& options, bool laplacian) {
    const auto find = [&options, laplacian, B = command_line::function<dim>(options)](
                          const std::string& formulation, const Placed<dim>& particles,
                          const Column<double>& spacing) {
        std::vector<particles::Range> ranges;
        for (const auto& [name, range] : particles.places) ranges.push_back(range);
        const auto errors =
            derivative_test::errors(formulation_named<double, dim>(formulation), particles.cloud,
                                    command_line::smoothing<dim>(options, spacing), spacing, B, ranges);
        std::vector<Found> all;
        for (std::size_t place = 0; place < errors.size(); ++place) {
            Found& found = all.emplace_back(Found{{particles.places[place].first}, {}, {}});
            for (const auto& at : errors[place]) {
                found.particles.push_back(at.particle);
                found.numbers.push_back({at.first, laplacian ? at.laplacian : at.second, at.R});
            }
        }
        return all;
    };
    return {"FPM in space, Section 4: largest errors of the first " +
                std::string(laplacian ? "derivatives and of the Laplacian" : "and second derivatives") +
                " by place",
            "FPM in space, Section 4: errors of the " +
                std::string(laplacian ? "first derivatives and of the Laplacian" : "derivatives") +
                " at each particle",
            {{"place"}},
            {{{"error_first", {1e-6, 1e-12}},
              {laplacian ? "error_laplacian" : "error_second", {1e-6, 2e-10}},
              {"quality", {1e-6, 1e-9}}}},
            "R, the factor in the bound of the error of second derivatives in powers of delta",
            find};
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The second-order FPM in the plane and in space, Section 4: largest errors of the first and second derivatives inside and at faces, edges and corners of the unit square or cube.",
        "derivative_test_in_space",
        "Example: derivative_test_in_space --formulation definite_fpm --particles 31,61,121 --perturb 0.25 --plot /tmp/plane.svg\n"
        "In space: derivative_test_in_space --dimension 3 --function \"sin(x+2*y)*exp(z)\" --particles 9,17\n"
        "Particles of your own: derivative_test_in_space --layout body.csv --smoothing-from local --formulation definite_fpm --states --plot /tmp/body.svg");
    CloudOptions options;
    command_line::add_options(app, options);
    bool laplacian = false;
    app.add_flag("--laplacian", laplacian,
                 "the error of the Laplacian, instead of the largest of all second derivatives");
    return command_line::run(app, argc, argv, options.threads, options.output, options.figure, [&] {
        command_line::complete(options);
        return options.dimension == 2 ? command_line::table_of(options, test<2>(options, laplacian))
                                      : command_line::table_of(options, test<3>(options, laplacian));
    });
}
