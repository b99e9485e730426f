#include "command_line/quality.hpp"

#include <limits>
#include <string>
#include <tuple>

#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/options.hpp"

namespace command_line {

using asprone2010::quality::Precision;
using asprone2010::quality::Row;
using asprone2010::quality::RowsOf;
using base::shown;
using report::Cell;

void add_quality(CommandLine& app, Options& options) {
    app.add_flag(
        "--quality", options.quality,
        "add a column with R of the worst row: its error is at most R delta^p times a derivative of the function");
}

Row require_quality(const Options& options, const Case& one, RowsOf rows, const Precision& precision) {
    return asprone2010::quality::require(formulation_named(one.formulation), line_of(options, one), rows,
                                         precision);
}

std::vector<Cell> Quality::numbers(const Case& one, const std::function<std::vector<Cell>()>& compute) {
    const double unit = in_precision(options_.precision, [](auto zero) {
        return static_cast<double>(std::numeric_limits<decltype(zero)>::epsilon());
    });
    const Row worst = require_quality(options_, one, rows_, {unit, true});
    std::vector<Cell> numbers = compute();
    if (!options_.quality) return numbers;
    numbers.emplace_back(worst.R);
    const auto key = [](const Row& of, const Case& asked) {  // the same on any number of threads
        return std::tuple(-of.R, asked.formulation, asked.particles, asked.perturbation, asked.seed);
    };
#pragma omp critical(worst_quality)
    if (!case_ || key(worst, one) < key(worst_, *case_)) {
        case_ = one;
        worst_ = worst;
    }
    return numbers;
}

void Quality::add_column(report::Table& table) const {
    if (options_.quality) table.columns.push_back({"quality", {1e-6, 1e-9}});
}

void Quality::add_comment(report::Table& table) const {
    if (!case_) return;
    const auto [line, smoothing] = line_of(options_, *case_);
    const bool drawn = case_->perturbation != 0;
    table.comments.push_back(
        "quality: R of the worst row of a case, the factor in the bound of its error in powers of delta; the largest is " +
        shown(worst_.R, 3) + ", " + case_->formulation + ", " + (worst_.derivative == 1 ? "DB" : "D2B") +
        " at particle " + std::to_string(worst_.particle) + " of " + std::to_string(line.size()) + " (x = " +
        shown(line.x()[worst_.particle]) + ")" + (drawn ? ", seed " + std::to_string(case_->seed) : ""));
}

}  // namespace command_line
