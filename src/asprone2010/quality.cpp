#include "asprone2010/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/quad.hpp"
#include "base/text.hpp"
#include "particles/close_pair.hpp"
#include "particles/requirement.hpp"

namespace asprone2010::quality {

using base::shown;
using numerical_tests::Particles;
using particles::Smoothing;

namespace {

/// What makes the rows of a test worth a table, for remedies.
struct Criterion {
    const Source& source;
    RowsOf rows;
    double unit;  ///< of round-off

    /// Whether the worst rows are far from what is refused.
    [[nodiscard]] bool holds_for(const Particles<double>& discrete) const {
        try {
            Worst found = worst(source, discrete, rows);
            found.unit = unit;
            return found.by_error.R <= most(found.by_error) / 10 && found.round_off() <= most_round_off / 10;
        } catch (const base::FailedComputation&) {
            return false;
        }
    }
};

/// "--smoothing 2.2": of the larger and smaller smoothing lengths, in steps of a tenth, the closest that
/// helps.
std::string other_smoothing(const Criterion& criterion, const Particles<double>& discrete) {
    const auto& [line, smoothing] = discrete;
    const double ratio = smoothing.ratio().value_or(1);
    for (int k = 1; k <= 10; ++k)
        for (const double factor : {std::pow(1.1, k), std::pow(1.1, -k)}) {
            const std::string rounded = shown(ratio * factor, 2);
            if (criterion.holds_for({line, smoothing.times(std::stod(rounded) / ratio)}))
                return smoothing.ratio() ? "--smoothing " + rounded
                                         : "smoothing lengths " + rounded + " times as large";
        }
    return "";
}

/// "--smoothing-from local", the first of some spacings that helps.
std::string other_spacing(const Criterion& criterion, const Particles<double>& discrete) {
    return particles::other_spacing(discrete.line, discrete.smoothing,
                                    [&](const Smoothing<double>& smoothing) {
                                        return criterion.holds_for({discrete.line, smoothing});
                                    });
}

/// What helps where the row of particle i is not worth a table: the end of a sentence.
/// \param more another remedy, which was tried, or none
std::string remedy(const Criterion& criterion, const Particles<double>& discrete, Index i,
                   const std::string& more = "") {
    const std::string fewer =
        particles::fewer_particles(discrete.line, discrete.smoothing, i,
                                   [&](const Line<double>& rest, const Smoothing<double>& smoothing) {
                                       return criterion.holds_for({rest, smoothing});
                                   });
    std::string tried;
    for (const std::string& one :
         {other_smoothing(criterion, discrete), other_spacing(criterion, discrete), more})
        if (!one.empty()) tried += (tried.empty() ? "" : " or ") + one;
    if (fewer.empty()) return tried.empty() ? "take other particles" : "try " + tried;
    return fewer + (tried.empty() ? "" : ", or try " + tried);
}

/// "--precision long": the first of the finer precisions in which round-off is small.
std::string finer_precision(const Row& row) {
    const auto is_small = [&](auto unit) {
        return static_cast<double>(unit) * row.sum <= most_round_off / 10;
    };
    if (is_small(std::numeric_limits<long double>::epsilon())) return "--precision long";
    return is_small(std::numeric_limits<base::Quad>::epsilon()) ? "--precision quad" : "";
}

/// "second_order_fpm: at particle 3 (x = 0.1) "
std::string place(const Source& source, const Particles<double>& discrete, const Row& row) {
    const auto& formulation = row.derivative == 1 ? source.first : source.second;
    return std::string(formulation.name) + ": at particle " + std::to_string(row.particle) + " (" +
           particles::position_in_words(discrete.line, row.particle) + ") ";
}

std::string name(const Row& row) {
    return row.derivative == 1 ? "DB" : "D2B";
}

}  // namespace

Worst worst(const Source& source, const Particles<double>& discrete, RowsOf rows) {
    const auto& [line, smoothing] = discrete;
    particles::Operators<double> operators = source.second.operators(line, smoothing);
    if (&source.first != &source.second) operators.D = source.first.operators(line, smoothing).D;
    return worst(operators, source.exact(), discrete, rows);
}

base::FailedComputation refusal(const Worst& worst, const Source& source, const Particles<double>& discrete,
                                RowsOf rows, bool finer) {
    const Criterion criterion{source, rows, worst.unit};
    const auto& error = worst.by_error;
    const auto& round_off = worst.by_round_off;
    const std::string why =
        error.R > most(error)
            ? place(source, discrete, error) + "the error of " + name(error) + " may reach R delta^" +
                  std::to_string(error.p()) + " |B^(" + std::to_string(error.exact + 1) +
                  ")| with R = " + shown(error.R, 3) + ", where " + shown(most(error)) +
                  " is the most for a table; " + remedy(criterion, discrete, error.particle)
            : place(source, discrete, round_off) + "round-off of " + name(round_off) + " may reach " +
                  shown(worst.round_off(), 2) + " |B|, where " + shown(most_round_off) +
                  " is the most for a table; " +
                  remedy(criterion, discrete, round_off.particle, finer ? finer_precision(round_off) : "");
    base::FailedComputation refused(why);
    return refused;
}

}  // namespace asprone2010::quality
