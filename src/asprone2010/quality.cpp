#include "asprone2010/quality.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "particles/close_pair.hpp"
#include "particles/requirement.hpp"

namespace asprone2010::quality {

using base::shown;
using numerical_tests::Particles;
using particles::Smoothing;

namespace {

/// Whether the worst row is far from what is refused.
bool good(const Formulation<double>& formulation, const Particles<double>& discrete, RowsOf rows) {
    try {
        const Row row = worst(formulation, discrete, rows);
        return row.R <= most(row) / 10;
    } catch (const base::FailedComputation&) {
        return false;
    }
}

/// The numbers of a column without that of particle i; a single number serves all.
Column<double> without(const Column<double>& all, Index i) {
    if (all.size() == 1) return all;
    Column<double> rest(all.size() - 1);
    rest << all.head(i), all.tail(all.size() - 1 - i);
    return rest;
}

/// The same line without particle i, with the same smoothing lengths.
Particles<double> left_out(const Particles<double>& discrete, Index i) {
    const auto& [line, smoothing] = discrete;
    Column<double> h(smoothing.is_local() ? line.size() : 1);
    for (Index j = 0; j < h.size(); ++j) h[j] = smoothing.h(j);
    const double ratio = smoothing.ratio().value_or(1);
    return {Line<double>(without(line.x(), i), without(line.V(), i)),
            Smoothing<double>(smoothing.kernel(), without(h / ratio, i), ratio)};
}

/// "particles 0 and 1 lie 0.001 apart, the next one 0.01; leave one of them out", where that helps.
std::string fewer_particles(const Formulation<double>& formulation, const Particles<double>& discrete,
                            Index i, RowsOf rows) {
    const std::string pair = particles::close_pair(discrete.line, i);
    if (pair.empty()) return "";
    const double apart = particles::distance_to_nearest(discrete.line, i, 1);
    const int first = particles::pair_around(discrete.line, i, apart).front();
    return good(formulation, left_out(discrete, std::max(first, 1)), rows) ? pair : "";
}

/// "--smoothing 2.2": of the larger and smaller smoothing lengths, in steps of a tenth, the closest that helps.
std::string other_smoothing(const Formulation<double>& formulation, const Particles<double>& discrete,
                            RowsOf rows) {
    const auto& [line, smoothing] = discrete;
    const double ratio = smoothing.ratio().value_or(1);
    for (int k = 1; k <= 10; ++k)
        for (const double factor : {std::pow(1.1, k), std::pow(1.1, -k)}) {
            const std::string rounded = shown(ratio * factor, 2);
            if (good(formulation, {line, smoothing.times(std::stod(rounded) / ratio)}, rows))
                return smoothing.ratio() ? "--smoothing " + rounded
                                         : "smoothing lengths " + rounded + " times as large";
        }
    return "";
}

/// "--smoothing-from local", where that helps.
std::string local_smoothing(const Formulation<double>& formulation, const Particles<double>& discrete,
                            RowsOf rows) {
    const auto& [line, smoothing] = discrete;
    if (smoothing.is_local() || !smoothing.ratio()) return "";
    const Column<double> local = particles::spacing(line, particles::Spacing::local);
    const Smoothing<double> of_each(smoothing.kernel(), local, *smoothing.ratio());
    return good(formulation, {line, of_each}, rows) ? "--smoothing-from local" : "";
}

std::string remedy(const Formulation<double>& formulation, const Particles<double>& discrete, Index i,
                   RowsOf rows) {
    const std::string fewer = fewer_particles(formulation, discrete, i, rows),
                      other = other_smoothing(formulation, discrete, rows),
                      local = local_smoothing(formulation, discrete, rows);
    const std::string tried = other + (other.empty() || local.empty() ? "" : " or ") + local;
    if (fewer.empty()) return tried.empty() ? "take other particles" : "try " + tried;
    return fewer + (tried.empty() ? "" : ", or try " + tried);
}

}  // namespace

Column<double> spacing(const Particles<double>& discrete) {
    const auto& [line, smoothing] = discrete;
    if (!smoothing.ratio()) return particles::spacing(line, particles::Spacing::mean);
    Column<double> delta(smoothing.is_local() ? line.size() : 1);
    for (Index i = 0; i < delta.size(); ++i) delta[i] = smoothing.h(i) / *smoothing.ratio();
    return delta;
}

Row worst(const Formulation<double>& formulation, const Particles<double>& discrete, RowsOf rows) {
    const Line<double>& line = discrete.line;
    const auto [D, D2] = formulation.operators(line, discrete.smoothing);
    const Column<double> delta = spacing(discrete);
    const double ratio = discrete.smoothing.h() / delta.maxCoeff();
    const auto [first, second] = rows(line.size());
    Row found;
    const auto look = [&](const Operator<double>& derivative, int k, int exact,
                          const particles::Range& some) {
        if (some.size() <= 0) return;
        const Column<double> R = particles::quality(derivative, line, k, exact, delta);
        Row row{0, 0, k, exact, ratio};
        row.R = R.segment(some.first, some.size()).maxCoeff(&row.particle);
        row.particle += some.first;
        if (row.R / most(row) > found.R / most(found)) found = row;
    };
    look(D, 1, formulation.exact.first, first);
    look(D2, 2, formulation.exact.second, second);
    return found;
}

Row require(const Formulation<double>& formulation, const Particles<double>& discrete, RowsOf rows) {
    const Row row = worst(formulation, discrete, rows);
    if (row.R <= most(row)) return row;
    throw base::FailedComputation(
        std::string(formulation.name) + ": at particle " + std::to_string(row.particle) + " (" +
        particles::position_in_words(discrete.line, row.particle) + ") the error of " +
        (row.derivative == 1 ? "DB" : "D2B") + " may reach R delta^" + std::to_string(row.p()) + " |B^(" +
        std::to_string(row.exact + 1) + ")| with R = " + shown(row.R, 3) + ", where " + shown(most(row)) +
        " is the most for a table; " + remedy(formulation, discrete, row.particle, rows));
}

}  // namespace asprone2010::quality
