#include "command_line/example_problems.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.hpp"
#include "command_line/positions.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace command_line {

using namespace batra2008;
using report::Cell;

ExampleTable::ExampleTable(const ExampleOptions& options, const std::vector<ExampleCase>& cases,
                           const std::string& about, const std::vector<report::ColumnHead>& layout,
                           const std::vector<report::ColumnHead>& errors)
    : options_(options), field_(options.field, cases), sweep_(table_, case_columns().size() + layout.size()) {
    table_.comments = {
        about,
        "strong (3.12) to (3.14), weak1 (3.22) with (3.21), weak2 (3.22) with (3.26); log_error: log10 of (4.4), dn the difference of the norms, nd the norm of the difference"};
    if (std::any_of(cases.begin(), cases.end(), [](const ExampleCase& one) { return one.is_fpm(); }))
        table_.comments.push_back("fpm: (3.12) to (3.14) with (F24), h/" + options.smoothing_of_fpm_from() +
                                  " spacing " + base::shown(options.smoothing) + ", support of " +
                                  base::shown(fpm_in_space::cut<2>) + " h; between particles (F25)");
    if (options.smoothing_from.value_or("nearest") != "nearest")
        table_.comments.push_back("smoothing lengths from " + *options.smoothing_from);
    table_.columns = case_columns();
    for (const auto& column : layout) table_.columns.push_back(column);
    for (const auto& column : options.states.empty() ? errors : state_columns(cases))
        table_.columns.push_back(column);
    if (options.seconds)
        for (const char* name : {"seconds_assembly", "seconds_solution", "megabytes"})
            table_.columns.push_back({name, {1e-2, 0}});
    if (options.quality)
        for (const char* name : {"quality", "noise"}) table_.columns.push_back({name, {1e-4, 1e-6}});
}

void ExampleTable::add(const ExampleCase& one, const Problem& problem, const Cloud<2>& cloud,
                       const std::vector<Cell>& layout, const Places& places, const Errors& errors) {
    field_.require_same(cloud.x());
    std::vector<Cell> named = case_cells(one);
    named[1] = static_cast<long>(cloud.size());
    named.insert(named.end(), layout.begin(), layout.end());
    std::vector<Point<2>> at;
    if (!options_.states.empty()) at = options_.states == "particles" ? places_at(cloud.x()) : places();
    sweep_.attempt(named, [&] {
        check_lengths(one.is_fpm() ? one.fpm.smoothing_from : one.ssph.smoothing_from,
                      options_.smoothing_from.value_or(""), cloud.size());
        if (options_.seconds) give_freed_memory_back();
        About about;
        const Solution solution = solved(one, problem, cloud, about);
        const Solved found{problem, cloud, solution};
        if (solution.noise) warn_of(*solution.noise, named);
        note_quality(about.worst, named, cloud);
        std::vector<std::vector<Cell>> rows{named};
        if (!options_.states.empty()) {
            rows = state_rows(named, found, at);
        } else {
            for (const Cell& cell : errors(found)) rows[0].push_back(cell);
            if (options_.seconds)
                rows[0].insert(rows[0].end(), {about.assembly, about.solution, about.megabytes});
            if (options_.quality)
                rows[0].insert(rows[0].end(),
                               {about.worst.R, solution.noise ? Cell(*solution.noise) : Cell()});
        }
        field_.add(one, found);
        return rows;
    });
}

std::string ExampleTable::in_words(const std::vector<Cell>& named) const {
    const report::Table one{{}, table_.columns, {named}};
    std::string words = one.word(0, "method") + ", " + one.word(0, "particles") + " particles";
    if (const std::string scaling = one.word(0, "scaling"); !scaling.empty()) words += ", scaling " + scaling;
    std::vector<std::string> others{"poisson"};
    for (std::size_t k = case_columns().size(); k < named.size(); ++k)
        others.push_back(table_.columns[k].name);
    for (const std::string& name : options_.quality ? others : std::vector<std::string>{})
        if (const std::string word = one.word(0, name); !word.empty()) words += ", " + name + " " + word;
    return words;
}

void ExampleTable::warn_of(double noise, const std::vector<Cell>& named) {
    if (!(noise > example_problems::most_noise)) return;
    ++noisy_;
    if (noise <= most_noise_) return;
    most_noise_ = noise;
    noisiest_ = in_words(named);
}

void ExampleTable::note_quality(const particles::WorstRow& row, const std::vector<Cell>& named,
                                const Cloud<2>& cloud) {
    if (row.R <= largest_R_) return;
    largest_R_ = row.R;
    constexpr std::array derivatives{"value", "first derivative", "second derivative"};
    worst_row_ = base::shown(row.R, 3) + ", " + in_words(named) + ", " +
                 derivatives[static_cast<std::size_t>(row.derivative)] + " at particle " +
                 std::to_string(row.particle) +
                 " (x = " + particles::shown_point(cloud.x().col(row.particle)) + ")";
}

report::Table ExampleTable::finished() {
    sweep_.finish();
    if (options_.quality)
        table_.comments.push_back(
            "quality: R of the worst derivative at a particle of a case, the factor in the bound of its error in powers of h; the largest is " +
            worst_row_);
    if (noisy_ > 0)
        table_.comments.push_back(
            "noise: the unknowns alternate between neighbours, and stresses may be wrong, in " +
            std::to_string(noisy_) + (noisy_ == 1 ? " case: " : " cases, most of all in: ") + noisiest_ +
            " (noise " + base::shown(most_noise_, 3) + ", where " +
            base::shown(example_problems::most_noise) + " is the most)");
    field_.write();
    return std::move(table_);
}

}  // namespace command_line
