#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "asprone2010/in_quad.hpp"
#include "asprone2010/leading_error.hpp"
#include "asprone2010/round_off.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"

namespace {

using namespace asprone2010;
using base::Quad;
using numerical_tests::Discretisation;

/// The lists of which every combination has its rows.
struct Lists {
    std::vector<std::string> formulations{"all"}, kernels{"all"}, volumes{"equal"};
    std::vector<double> smoothings{1, 1.5, 2};

    bool operator==(const Lists&) const = default;
};

/// A row of an operator.
struct Place {
    std::string formulation, kernel, volumes;
    double smoothing;
    std::optional<Index> from_end;  ///< none for the interior
    int derivative;

    [[nodiscard]] Discretisation discretisation() const {
        return {particles::volumes_named(volumes), particles::kernel_named(kernel), smoothing};
    }
};

/// The particles at the end and in the interior, for both derivatives.
/// \throws base::InvalidInput for a name that is not known, and a smoothing length that no stencil can have
void add_places(std::vector<Place>& all, Place place) {
    limit_stencils::reach_in_spacings(place.discretisation());
    for (const int derivative : {1, 2})
        for (const std::optional<Index>& from_end : {std::optional<Index>(0), {1}, {2}, {}}) {
            place.from_end = from_end;
            place.derivative = derivative;
            all.push_back(place);
        }
}

std::vector<Place> places(const Lists& lists) {
    using command_line::chosen;
    std::vector<Place> all;
    for (const std::string& formulation :
         chosen("formulation", lists.formulations, command_line::formulation_names(),
                command_line::names_beside_all()))
        for (const std::string& kernel : chosen("kernel", lists.kernels, command_line::kernel_names()))
            for (const double smoothing : lists.smoothings)
                for (const std::string& convention : lists.volumes)
                    add_places(all, {formulation, kernel, convention, smoothing, {}, 1});
    return all;
}

/// A row, and why it has no numbers, if it has none.
struct Row {
    std::vector<report::Cell> cells;
    std::string failure{};
};

/// The leading error, as the stencil has it and as exp shows it; empty where the neighbourhood has too few
/// particles.
Row row(const Place& place) {
    std::vector<report::Cell> cells{
        place.formulation,
        place.kernel,
        place.smoothing,
        place.volumes,
        place.from_end ? std::to_string(*place.from_end) : std::string("interior"),
        static_cast<long>(place.derivative)};
    const Discretisation how = place.discretisation();
    const auto& formulation = command_line::formulation_named<Quad>(place.formulation);
    const Index from_end = place.from_end.value_or(limit_stencils::first_interior(how));
    std::optional<limit_stencils::Stencil<Quad>> stencil;
    try {
        stencil = limit_stencils::near_end(formulation, how, from_end, place.derivative);
    } catch (const base::FailedComputation& failed) {  // too few neighbours
        cells.resize(11);
        return {cells, failed.what()};
    }
    const auto [exponent, constant] = limit_stencils::leading_error(*stencil, place.derivative);
    const Quad measured =
        limit_stencils::measured_constant(formulation, how, from_end, place.derivative, exponent);
    cells.insert(cells.end(),
                 {static_cast<long>(exponent), static_cast<double>(constant), static_cast<double>(measured),
                  static_cast<double>(abs(measured / constant - 1)),
                  static_cast<double>(limit_stencils::amplification(*stencil))});
    return {cells};
}

/// "empty: second_order_fpm with wendland_c4, h/delta 1.2, volumes equal: a particle has 3 neighbours within
/// 2h, needs 4; try --smoothing 1.6", once for the rows of each formulation, kernel, h/δ and volumes.
std::vector<std::string> why_empty(const std::vector<Place>& all, const std::vector<Row>& rows) {
    std::vector<std::string> comments;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string& failure = rows[k].failure;
        if (failure.empty()) continue;
        const std::string of = "empty: " + all[k].formulation + " with " + all[k].kernel + ", h/delta " +
                               base::shown(all[k].smoothing) + ", volumes " + all[k].volumes;
        if (!comments.empty() && comments.back().starts_with(of + ": ")) continue;
        comments.push_back(of + ": a particle" + failure.substr(failure.find(" has ")));
    }
    return comments;
}

report::Table leading_errors(const Lists& lists) {
    report::Table table;
    table.comments = {
        "Beyond Asprone et al. (2010): leading errors constant * delta^exponent * B^(exponent + derivative)",
        "place: particles from the end x = 1, or interior; constant: of the stencil; measured: for exp, quadruple precision, extrapolated from six spacings; amplification: sum of |weights| * delta^derivative",
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
    const std::vector<Place> all = places(lists);
    const std::vector<Row> rows = command_line::computed_in_parallel(all, row);
    for (const Row& one : rows) table.rows.push_back(one.cells);
    // The table of everything has many such rows, for one reason; where cases were chosen, each says why.
    if (lists == Lists{}) return table;
    table.comments.pop_back();
    const std::vector<std::string> comments = why_empty(all, rows);
    table.comments.insert(table.comments.end(), comments.begin(), comments.end());
    if (std::all_of(rows.begin(), rows.end(), [](const Row& one) { return !one.failure.empty(); }))
        throw base::FailedComputation("no case has numbers; " + comments.front().substr(7));
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Leading errors C delta^p of D and D2 on particles at equal distances, from the formulations' stencils, at the end of the line and inside; beside them, what exp shows in quadruple precision.",
        "constants",
        "Example: constants --formulation second_order_fpm --kernel quintic_spline --smoothing 1,1.5");
    Lists lists;
    std::string output;
    int threads = 0;
    app.add_list("--formulation", lists.formulations, "which formulations (default all)");
    app.add_list("--kernel", lists.kernels, "which kernels (default all)");
    app.add_list("--smoothing", lists.smoothings,
                 "smoothing lengths over spacing, h/delta (default 1,1.5,2)");
    app.add_list("--volumes", lists.volumes, "equal (default), partition");
    app.add_threads(threads);
    app.add_output(output);

    return command_line::run(app, argc, argv, threads, output, {}, [&] { return leading_errors(lists); });
}
