#include "command_line/quality.hpp"

#include <string>
#include <tuple>

#include "asprone2010/in_quad.hpp"
#include "base/text.hpp"
#include "command_line/formulations.hpp"

namespace command_line {

using asprone2010::numerical_tests::Particles;
using asprone2010::quality::Row;
using asprone2010::quality::RowsOf;
using base::shown;
using particles::Operators;
using report::Cell;

void add_quality(CommandLine& app, Options& options) {
    app.add_flag(
        "--quality", options.quality,
        "add a column with R of the worst row: its error is at most R delta^p times a derivative of the function");
}

template <class Scalar>
Row require_quality(const Options& options, const Case& one, const Particles<Scalar>& discrete,
                    const Operators<Scalar>& operators, const TestRows& used) {
    const auto& second = formulation_named(one.formulation);
    const auto& first = used.end.empty() ? second : formulation_named(used.end);
    const asprone2010::quality::Source source{first, second};
    const auto worst = asprone2010::quality::worst(operators, source.exact(), discrete, used.rows);
    if (!asprone2010::quality::worth_a_table(worst))
        throw asprone2010::quality::refusal(worst, source, line_of(options, one), used.rows, used.finer);
    return worst.by_error;
}

template <class Scalar>
std::vector<Cell> Quality::cells(const Case& one, const Particles<Scalar>& discrete,
                                 const Operators<Scalar>& operators, const std::string& end) {
    const Row worst = require_quality(options_, one, discrete, operators, {rows_, end, true});
    if (!options_.quality) return {};
    const auto key = [](const Row& of, const Case& asked) {  // the same on any number of threads
        return std::tuple(-of.R, asked.formulation, asked.particles, asked.perturbation, asked.seed);
    };
#pragma omp critical(worst_quality)
    if (!case_ || key(worst, one) < key(worst_, *case_)) {
        case_ = one;
        worst_ = worst;
    }
    return {worst.R};
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

template Row require_quality(const Options&, const Case&, const Particles<double>&, const Operators<double>&,
                             const TestRows&);
template std::vector<Cell> Quality::cells(const Case&, const Particles<double>&, const Operators<double>&,
                                          const std::string&);
template std::vector<Cell> Quality::cells(const Case&, const Particles<long double>&,
                                          const Operators<long double>&, const std::string&);
template std::vector<Cell> Quality::cells(const Case&, const Particles<base::Quad>&,
                                          const Operators<base::Quad>&, const std::string&);

}  // namespace command_line
