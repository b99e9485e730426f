#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/index.hpp"
#include "base/text.hpp"
#include "particles/close_pair.hpp"
#include "particles/layers.hpp"
#include "particles/neighbourhood.hpp"
#include "particles/spacing.hpp"

namespace particles {

using base::FailedComputation;
using base::Index;
using base::shown;

/// How many particles a formulation needs in each neighbourhood, the particle itself included.
struct Requirement {
    std::string_view formulation;
    Index particles;
};

/// "x = 0.5" on a line, "x = (0.5, 0.2)" in a cloud.
template <class Scalar>
std::string position_in_words(const Line<Scalar>& line, Index i) {
    return "x = " + shown(static_cast<double>(line.x()[i]));
}
template <int dim>
std::string position_in_words(const Cloud<dim>& cloud, Index i) {
    return "x = " + shown_point(cloud.x().col(i));
}

/// "second_order_fpm: particle 0 (x = 0) has 2 neighbours within 2h"
/// \param points a line or a cloud \param near neighbours of particle i
template <class Points, class Scalar, int dim, class Neighbours>
std::string neighbours_in_words(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index i,
                                const Neighbours& near, const Requirement& required) {
    return std::string(required.formulation) + ": particle " + std::to_string(i) + " (" +
           position_in_words(points, i) + ") has " + std::to_string(near.size()) +
           (near.size() == 1 ? " neighbour" : " neighbours") + " within " +
           shown(static_cast<double>(support<Scalar>(smoothing.kernel())), 3) + "h";
}

/// Whether a formulation has enough neighbours that determine its weights at each particle, or at ten
/// thousand of them. The ends of a line come first, since they fail most often.
/// \param weights a function of a Neighbourhood
template <class Points, class Scalar, int dim, class Weights>
bool determined(const Points& points, const Smoothing<Scalar, dim>& smoothing, const Requirement& required,
                const Weights& weights) {
    const Index N = points.size(), step = 1 + N / 10000;
    try {
        for (Index k = 0; k <= N / 2; k += step)
            for (const Index i : {k, N - 1 - k}) {
                const auto near = within_reach(points, smoothing, i);
                if (static_cast<Index>(near.size()) < required.particles) return false;
                static_cast<void>(weights(neighbourhood(points, smoothing, i, near)));
            }
    } catch (const FailedComputation&) {
        return false;
    }
    return true;
}

/// "--smoothing 1.6": the least smoothing length, in steps of a tenth of it, with which all particles have
/// enough neighbours and are served; empty if none is found, or if the lengths of few particles only are far
/// too small. It is said as h/δ, where it was given so; else as the length [length], or in multiples of those
/// that the particles have.
/// \param required number of neighbours \param serves whether a Smoothing does
template <class Points, class Scalar, int dim, class Serves>
std::string other_smoothing(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index required,
                            const Serves& serves) {
    const Index nearest = std::max<Index>(required - 1, 0);
    // Factors of the present h with which one particle has enough neighbours, and with which all have.
    double first = std::numeric_limits<double>::infinity(), least = 0;
    for (Index i = 0; i < points.size(); ++i) {
        const auto factor = static_cast<double>(distance_to_nearest(points, i, nearest) / smoothing.reach(i));
        first = std::min(first, factor);
        least = std::max(least, factor);
    }
    if (smoothing.is_local() && least > 1000 * first) return "";
    const double unit = smoothing.ratio()      ? *smoothing.ratio()
                        : smoothing.is_local() ? 1
                                               : static_cast<double>(smoothing.h());
    constexpr int steps = 30;
    for (int k = 0; k < steps; ++k) {
        const double wanted = unit * least * (1 + 1e-6) * std::pow(1.1, k);
        if (!(std::isfinite(wanted) && wanted > 0)) break;
        const double digit = std::pow(10, std::floor(std::log10(wanted)) - 1);
        const std::string rounded = shown(std::ceil(wanted / digit) * digit);
        if (!serves(smoothing.times(std::stod(rounded) / unit))) continue;
        if (smoothing.ratio()) return "--smoothing " + rounded;
        return smoothing.is_local() ? "smoothing lengths " + rounded + " times as large" : "h = " + rounded;
    }
    return "";
}

/// "--smoothing-from local": the first of some spacings that helps, if h was given as h/δ.
/// \param helps whether a Smoothing does
template <class Points, class Scalar, int dim, class Helps>
std::string other_spacing(const Points& points, const Smoothing<Scalar, dim>& smoothing, const Helps& helps) {
    if (!smoothing.ratio()) return "";
    for (const auto& [name, kind] : {std::pair{"local", Spacing::local}, {"largest", Spacing::largest}})
        if (helps(Smoothing<Scalar, dim>(smoothing.kernel(), Column<Scalar>(spacing(points, kind)),
                                         Scalar(*smoothing.ratio()))))
            return std::string("--smoothing-from ") + name;
    return "";
}

/// "try --smoothing 1.6": another smoothing that serves, the end of a sentence.
/// \param required number of neighbours \param serves whether a Smoothing does
template <class Points, class Scalar, int dim, class Serves>
std::string another_smoothing(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index required,
                              const Serves& serves) {
    if (const std::string other = other_smoothing(points, smoothing, required, serves); !other.empty())
        return "try " + other;
    if (const std::string from = other_spacing(points, smoothing, serves); !from.empty())
        return "try " + from;
    return std::string(smoothing.ratio() ? "take " : "take another smoothing length or ") + "other particles";
}

/// What helps where there are too few particles, or too few layers of them; or nothing.
template <class Scalar>
std::string more_particles(const Line<Scalar>& line, const Requirement& required) {
    if (line.size() >= required.particles) return "";
    return "take at least " + std::to_string(required.particles) + " particles";
}
template <int dim>
std::string more_particles(const Cloud<dim>& cloud, const Requirement& required) {
    return more_particles(cloud, required.particles, degree_of<dim>(required.particles));
}

/// What helps where particle i has too few neighbours, or neighbours that do not determine the weights: the
/// end of a sentence. \param weights a function of a Neighbourhood
template <class Points, class Scalar, int dim, class Weights>
std::string remedy(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index i,
                   const Requirement& required, const Weights& weights) {
    if (std::string more = more_particles(points, required); !more.empty()) return more;
    const auto serves = [&](const Smoothing<Scalar, dim>& tried) {
        return determined(points, tried, required, weights);
    };
    const std::string fewer =
        fewer_particles(points, smoothing, i, [&](const Points& rest, const auto& smoothing_of_rest) {
            return determined(rest, smoothing_of_rest, required, weights);
        });
    if (fewer.empty()) return another_smoothing(points, smoothing, required.particles, serves);
    const std::string other = other_smoothing(points, smoothing, required.particles, serves);
    return fewer + (other.empty() ? "" : ", or try " + other);
}

/// \param near the neighbours of particle i \param weights a function of a Neighbourhood, for the remedy
/// \throws FailedComputation naming the particle and a remedy, where there are too few
template <class Points, class Scalar, int dim, class Neighbours, class Weights>
void require_neighbours(const Points& points, const Smoothing<Scalar, dim>& smoothing, Index i,
                        const Neighbours& near, const Requirement& required, const Weights& weights) {
    if (static_cast<Index>(near.size()) < required.particles)
        throw FailedComputation(neighbours_in_words(points, smoothing, i, near, required) + ", needs " +
                                std::to_string(required.particles) + "; " +
                                remedy(points, smoothing, i, required, weights));
}

}  // namespace particles
