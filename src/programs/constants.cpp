#include <array>
#include <optional>
#include <string>
#include <vector>

#include "asprone2010/limit_stencils.hpp"
#include "base/parallel.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace asprone2010;
using base::Quad;
using numerical_tests::Discretisation;

struct Place {
    std::string formulation, kernel, volumes;
    double smoothing;
    std::optional<Index> from_end;  ///< none for the interior
    int derivative;
};

/// A row of an operator at a place, counted from the right end.
limit_stencils::Stencil<Quad> stencil(const Place& of, const Discretisation& how, const Quad& spacing) {
    const Index rows = of.from_end.value_or(limit_stencils::first_interior<Quad>(how));
    const auto [line, smoothing] = limit_stencils::right_end<Quad>(how, rows, spacing);
    const auto operators = command_line::formulation_named<Quad>(of.formulation).operators(line, smoothing);
    return limit_stencils::row<Quad>(of.derivative == 1 ? operators.D : operators.D2, line,
                                     line.size() - 1 - rows, spacing, of.derivative);
}

/// \f$\delta^{-p}\f$ times the error for \f$e^{x - x_i}\f$ at the place.
Quad scaled_error(const Place& of, const Discretisation& how, const Quad& spacing, int exponent) {
    const auto [r, w] = stencil(of, how, spacing);
    const Quad approximation = (w * ((r * spacing).exp() - 1)).sum();
    return (approximation * pow(spacing, -of.derivative) - 1) * pow(spacing, -exponent);
}

/// The same, extrapolated to no spacing from six, each half of the one before, after Romberg.
Quad measured_constant(const Place& of, const Discretisation& how, int exponent) {
    const int coarsest = exponent > 2 ? -6 : -10;  // a high power of a small spacing drowns in round-off
    std::array<Quad, 6> value;
    for (int k = 0; k < 6; ++k)
        value[static_cast<std::size_t>(k)] = scaled_error(of, how, ldexp(Quad(1), coarsest - k), exponent);
    for (std::size_t level = 1; level < 6; ++level)
        for (std::size_t k = 5; k >= level; --k)
            value[k] += (value[k] - value[k - 1]) / (ldexp(Quad(1), static_cast<int>(level)) - 1);
    return value[5];
}

std::vector<report::Cell> measured(const Place& of) {
    const Discretisation how{particles::volumes_named(of.volumes), particles::kernel_named(of.kernel),
                             of.smoothing};
    std::vector<report::Cell> row{of.formulation,
                                  of.kernel,
                                  of.smoothing,
                                  of.volumes,
                                  of.from_end ? std::to_string(*of.from_end) : std::string("interior"),
                                  static_cast<long>(of.derivative)};
    const auto at_unit_spacing = [&]() -> std::optional<limit_stencils::Stencil<Quad>> {
        try {
            return stencil(of, how, 1);
        } catch (const base::FailedComputation&) {  // too few neighbours
            return {};
        }
    }();
    row.resize(11);
    if (!at_unit_spacing) return row;
    const auto [exponent, constant] = limit_stencils::leading_error(*at_unit_spacing, of.derivative);
    const Quad shown = measured_constant(of, how, exponent);
    row[6] = static_cast<long>(exponent);
    row[7] = static_cast<double>(constant);
    row[8] = static_cast<double>(shown);
    row[9] = static_cast<double>(abs(shown / constant - 1));
    row[10] = static_cast<double>(limit_stencils::amplification(*at_unit_spacing));
    return row;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Leading errors C delta^p of D and D2 on particles at equal distances, from the formulations' "
        "stencils, at "
        "the end of the line and inside; beside them, what exp shows in quadruple precision.",
        "constants",
        "Example: constants --formulation second_order_fpm --kernel quintic_spline --smoothing 1,1.5");
    std::vector<std::string> wanted{"all"}, kernels{"all"}, volumes{"equal"};
    std::vector<double> smoothings{1, 1.5, 2};
    std::string output;
    int threads = 0;
    app.add_list("--formulation", wanted, "which formulations (default all)");
    app.add_list("--kernel", kernels, "which kernels (default all)");
    app.add_list("--smoothing", smoothings, "smoothing lengths over spacing, h/delta (default 1,1.5,2)");
    app.add_list("--volumes", volumes, "equal (default), partition");
    app.add_threads(threads);
    app.add_output(output);

    return command_line::run(app, argc, argv, threads, output, {}, [&] {
        if (wanted == std::vector<std::string>{"all"}) {
            wanted.clear();
            for (const auto& of : command_line::formulations<Quad>()) wanted.emplace_back(of.name);
        }
        if (kernels == std::vector<std::string>{"all"}) {
            kernels.clear();
            particles::for_each_kernel(
                [&](const auto& kernel) { kernels.push_back(particles::name(kernel)); });
        }
        std::vector<Place> places;
        for (const std::string& formulation : wanted) {
            command_line::formulation_named<Quad>(formulation);
            for (const std::string& kernel : kernels)
                for (const double smoothing : smoothings)
                    for (const std::string& convention : volumes) {
                        limit_stencils::reach_in_spacings<Quad>({particles::volumes_named(convention),
                                                                 particles::kernel_named(kernel), smoothing});
                        for (const int derivative : {1, 2})
                            for (const std::optional<Index>& from_end :
                                 {std::optional<Index>(0), {1}, {2}, {}})
                                places.push_back(
                                    {formulation, kernel, convention, smoothing, from_end, derivative});
                    }
        }
        report::Table table;
        table.comments = {
            "Beyond Asprone et al. (2010): leading errors constant * delta^exponent * B^(exponent + "
            "derivative)",
            "place: particles from the end x = 1, or interior; constant: of the stencil; measured: for exp, "
            "quadruple precision, extrapolated from six spacings; amplification: sum of |weights| "
            "* "
            "delta^derivative",
            "empty where the neighbourhood has too few particles"};
        table.columns = {{"formulation"},
                         {"kernel"},
                         {"smoothing"},
                         {"volumes"},
                         {"place"},
                         {"derivative"},
                         {"exponent"},
                         {"constant", {1e-9, 1e-12}},
                         {"measured", {1e-6, 1e-9}},
                         {"relative_difference", {1, 1e-6}},
                         {"amplification", {1e-9, 0}}};
        table.rows.resize(places.size());
        command_line::Progress progress(places.size());
        base::for_each_index(static_cast<Index>(places.size()), [&](Index k) {
            const auto at = static_cast<std::size_t>(k);
            table.rows[at] = measured(places[at]);
            progress.step();
        });
        return table;
    });
}
