#include "particles/layouts.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/random.hpp"
#include "particles/cloud.hpp"

namespace particles {

using base::for_each_index;

namespace logarithmic {

Point<2> place(const QuarterWithHole& shape, const Point<2>& at) {
    return shape.b * std::exp(at[0]) * Point<2>(std::cos(at[1]), std::sin(at[1]));
}

double edge(const QuarterWithHole& shape, double theta) {
    return std::log(shape.side / (shape.b * std::max(std::cos(theta), std::sin(theta))));
}

std::vector<Point<2>> boundary_layout(const QuarterWithHole& shape, Index on_arc) {
    const double quarter = std::acos(0.0), spacing = quarter / static_cast<double>(on_arc - 1);
    const double depth = edge(shape, 0), half_edge = std::asinh(1.0);
    const auto axis = std::max(std::lround(depth / spacing), 1L),
               outer = std::max(std::lround(half_edge / spacing), 1L);
    std::vector<Point<2>> x;
    for (Index i = 0; i < on_arc; ++i) x.emplace_back(0, spacing * static_cast<double>(i));
    for (long k = 1; k <= axis; ++k)
        for (const double theta : {0.0, quarter})
            x.emplace_back(depth * static_cast<double>(k) / static_cast<double>(axis), theta);
    for (long k = 1; k <= outer; ++k) {  // equal distances along an edge, in proportion to r
        const double theta =
            std::atan(std::sinh(half_edge * static_cast<double>(k) / static_cast<double>(outer)));
        x.emplace_back(edge(shape, theta), theta);
        if (k < outer) x.emplace_back(edge(shape, theta), quarter - theta);
    }
    return x;
}

std::vector<Point<2>> random_places(const QuarterWithHole& shape, Index count, unsigned long seed) {
    base::Random random(seed);
    std::vector<Point<2>> places;
    while (static_cast<Index>(places.size()) < count) {
        const double depth = random.uniform(0, edge(shape, std::atan(1.0)));
        const double theta = random.uniform(0, std::acos(0.0));
        if (depth < edge(shape, theta)) places.emplace_back(depth, theta);
    }
    return places;
}

}  // namespace logarithmic

namespace {

/// Positions, a column for each.
Points<2> columns(const std::vector<Point<2>>& x) {
    Points<2> all(2, static_cast<Index>(x.size()));
    for (std::size_t j = 0; j < x.size(); ++j) all.col(static_cast<Index>(j)) = x[j];
    return all;
}

}  // namespace

void add_farthest(std::vector<Point<2>>& x, const std::vector<Point<2>>& places, Index N) {
    const Cloud<2> given(columns(x));
    const Cells<2> near(columns(places));
    std::vector<double> away(places.size());  // squared distances to the nearest particle
    for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        const Point<2>& place = places[static_cast<std::size_t>(k)];
        away[static_cast<std::size_t>(k)] = (place - given.x().col(given.nearest(place))).squaredNorm();
    });
    // Distances as last seen: they only shrink, so that an outdated one goes back into the queue. Of equals
    // the first leads.
    std::priority_queue<std::pair<double, Index>> farthest;
    for (std::size_t k = 0; k < places.size(); ++k) farthest.emplace(away[k], -static_cast<Index>(k));
    while (static_cast<Index>(x.size()) < N) {
        const auto [seen, minus_k] = farthest.top();
        const auto k = static_cast<std::size_t>(-minus_k);
        farthest.pop();
        if (away[k] < seen) {
            farthest.emplace(away[k], minus_k);
            continue;
        }
        x.push_back(places[k]);
        near.for_each_within(places[k], 1.001 * std::sqrt(seen), [&](int j, double distance_squared) {
            double& least = away[static_cast<std::size_t>(j)];
            least = std::min(least, distance_squared);
        });
    }
}

namespace {

/// A particle, and its distance from another.
struct Neighbour {
    double distance;
    int particle;
};

/// The particles near each one, in the order of their distances.
/// \param reach of each particle
std::vector<std::vector<Neighbour>> neighbours(const std::vector<Point<2>>& x,
                                               const std::vector<double>& reach) {
    const Cells<2> cells(columns(x));
    std::vector<std::vector<Neighbour>> near(x.size());
    for_each_index(static_cast<Index>(x.size()), [&](Index a) {
        auto& of_a = near[static_cast<std::size_t>(a)];
        cells.for_each_within(x[static_cast<std::size_t>(a)], reach[static_cast<std::size_t>(a)],
                              [&](int b, double squared) {
                                  of_a.push_back({std::sqrt(squared), b});
                              });
        std::sort(of_a.begin(), of_a.end(),
                  [](const Neighbour& one, const Neighbour& other) { return one.distance < other.distance; });
    });
    return near;
}

/// Gives each place to the particle nearest to it, of equals the first. Such a particle is at most twice as
/// far from the old owner as the place is.
void find_owners(std::vector<int>& owners, const std::vector<Point<2>>& places,
                 const std::vector<Point<2>>& x) {
    constexpr double twice = 2.001;
    std::vector<double> away(places.size()), reach(x.size(), 0);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto owner = static_cast<std::size_t>(owners[k]);
        away[k] = (places[k] - x[owner]).norm();
        reach[owner] = std::max(reach[owner], 1.001 * twice * away[k]);
    }
    const auto near = neighbours(x, reach);
    for_each_index(static_cast<Index>(places.size()), [&](Index at) {
        const auto k = static_cast<std::size_t>(at);
        std::pair<double, int> least{(places[k] - x[static_cast<std::size_t>(owners[k])]).squaredNorm(),
                                     owners[k]};
        for (const auto& [distance, b] : near[static_cast<std::size_t>(owners[k])]) {
            if (distance > twice * away[k]) break;
            least = std::min(least, {(places[k] - x[static_cast<std::size_t>(b)]).squaredNorm(), b});
        }
        owners[k] = least.second;
    });
}

}  // namespace

void move_to_centres(std::vector<Point<2>>& x, const std::vector<Point<2>>& places, std::size_t fixed,
                     int rounds) {
    std::vector<int> owners(places.size());
    const Cloud<2> given(columns(x));
    for_each_index(static_cast<Index>(places.size()), [&](Index k) {
        owners[static_cast<std::size_t>(k)] = given.nearest(places[static_cast<std::size_t>(k)]);
    });
    for (int round = 0; round < rounds; ++round) {
        if (round > 0) find_owners(owners, places, x);
        std::vector<Point<2>> sum(x.size(), Point<2>::Zero());
        std::vector<int> count(x.size(), 0);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const auto owner = static_cast<std::size_t>(owners[k]);
            sum[owner] += places[k];
            ++count[owner];
        }
        for (std::size_t j = fixed; j < x.size(); ++j)
            if (count[j] > 0) x[j] = sum[j] / count[j];
    }
}

Points<2> graded_layout(const QuarterWithHole& shape, Index N, Index on_arc, unsigned long seed) {
    if (on_arc < 3) throw InvalidInput("a graded layout needs at least 3 particles on the hole");
    std::vector<Point<2>> x = logarithmic::boundary_layout(shape, on_arc);
    const std::size_t fixed = x.size();
    if (static_cast<Index>(fixed) + 1 > N)
        throw InvalidInput("a graded layout with " + std::to_string(on_arc) + " particles on the hole has " +
                           std::to_string(fixed) + " on the boundary; take more than " +
                           std::to_string(fixed) + " particles in all");
    const std::vector<Point<2>> places = logarithmic::random_places(shape, 60 * N, seed);
    add_farthest(x, places, N);
    move_to_centres(x, places, fixed, 60);
    Points<2> layout(2, N);
    for (Index j = 0; j < N; ++j) layout.col(j) = logarithmic::place(shape, x[static_cast<std::size_t>(j)]);
    return layout;
}

Points<2> polar_layout(const QuarterWithHole& shape, Index rays, Index rings) {
    if (rays < 3 || rings < 3 || rays % 2 == 0)
        throw InvalidInput("a polar layout needs at least 3 rings, and an odd number of rays from 3 on");
    Points<2> x(2, rays * rings);
    for (Index i = 0; i < rays; ++i)
        for (Index k = 0; k < rings; ++k) {
            const double theta = std::acos(0.0) * static_cast<double>(i) / static_cast<double>(rays - 1);
            const double depth =
                logarithmic::edge(shape, theta) * static_cast<double>(k) / static_cast<double>(rings - 1);
            x.col(i * rings + k) = logarithmic::place(shape, {depth, theta});
        }
    return x;
}

}  // namespace particles
