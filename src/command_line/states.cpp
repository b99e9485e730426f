#include "command_line/states.hpp"

#include <algorithm>
#include <utility>

#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "command_line/lists.hpp"

namespace command_line {

using namespace batra2008;
using report::Cell;

std::vector<report::ColumnHead> state_columns(const std::vector<ExampleCase>& cases) {
    constexpr report::Tolerance length{1e-6, 1e-10};
    report::Tolerance pressure{1e-6, 10};
    for (const ExampleCase& one : cases)
        pressure.absolute = std::max(pressure.absolute, 1e-12 * elastostatics::D(one.material)(0, 0));
    std::vector<report::ColumnHead> columns{{"x1"}, {"x2"}};
    for (const char* name : {"u1", "u2"}) columns.push_back({name, length});
    for (const char* name : {"s11", "s22", "s12"}) columns.push_back({name, pressure});
    for (const char* name : {"u1_exact", "u2_exact"}) columns.push_back({name, length});
    for (const char* name : {"s11_exact", "s22_exact", "s12_exact"}) columns.push_back({name, pressure});
    return columns;
}

std::vector<std::vector<Cell>> state_rows(const std::vector<Cell>& named, const Solved& solved,
                                          const std::vector<Point<2>>& places) {
    const Problem& problem = solved.problem;
    std::vector<example_problems::State> states(places.size());
    base::for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        const auto at = static_cast<std::size_t>(k);
        states[at] = solved.solution.state(places[at]);
    });
    std::vector<std::vector<Cell>> rows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        std::vector<Cell> row = named;
        const Vector u = problem.exact.u(places[k]);
        const Stress stress = problem.exact.stress(places[k]);
        for (const double number : places[k]) row.emplace_back(number);
        for (const double number : states[k].u) row.emplace_back(number);
        for (const double number : states[k].stress) row.emplace_back(number);
        for (const double number : u) row.emplace_back(number);
        for (const double number : stress) row.emplace_back(number);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<Point<2>> places_at(const Points<2>& x) {
    std::vector<Point<2>> places;
    for (Index I = 0; I < x.cols(); ++I) places.emplace_back(x.col(I));
    return places;
}

std::vector<Point<2>> places_between(const Point<2>& from, const Point<2>& to, long count) {
    std::vector<Point<2>> places;
    for (long k = 0; k < count; ++k)
        places.emplace_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1));
    return places;
}

std::array<long, 2> grid_of_places(const std::string& states) {
    const std::array<long, 2> counts = pair_of("--states", states);
    const double places = static_cast<double>(counts[0]) * static_cast<double>(counts[1]);
    const auto columns = static_cast<double>(case_columns().size() + state_columns({}).size());
    base::require_memory(base::shown(places, 12) + " places of --states", places * columns * sizeof(Cell),
                         "take fewer");
    return counts;
}

}  // namespace command_line
