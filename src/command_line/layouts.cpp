#include "command_line/layouts.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "command_line/example_cases.hpp"
#include "command_line/positions.hpp"
#include "particles/boundary_particles.hpp"

namespace command_line {

using base::InvalidInput;
using particles::Points, particles::QuarterWithHole;

namespace {

/// The two counts in a name such as polar-16x4; nothing for another name.
/// \param digits how many a count may have
std::optional<std::array<long, 2>> counts(const std::string& name, const std::string& before, char between,
                                          std::size_t digits) {
    const auto middle = name.find(between, before.size());
    if (!name.starts_with(before) || middle == std::string::npos) return {};
    const std::string first = name.substr(before.size(), middle - before.size()),
                      second = name.substr(middle + 1);
    for (const std::string& count : {first, second})
        if (count.empty() || count.size() > digits ||
            count.find_first_not_of("0123456789") != std::string::npos)
            return {};
    return {{std::stol(first), std::stol(second)}};
}

auto graded(const std::string& name) {
    return counts(name, "graded-", '-', 6);
}
auto polar(const std::string& name) {
    return counts(name, "polar-", 'x', 5);
}

/// Refuses positions whose largest is about that of the quarter in another unit.
void check_unit(const std::string& name, const Points<2>& x) {
    const double side = QuarterWithHole().side, largest = x.cols() == 0 ? side : x.cwiseAbs().maxCoeff();
    for (const auto& [unit, metres] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"inches", 0.0254}, {"km", 1e3}})
        if (std::abs(largest * metres / side - 1) < 0.1)
            throw InvalidInput("--layout: " + name + " reaches to " + base::shown(largest) +
                               ", as the quarter does in " + unit + "; write its positions in m");
}

/// ", such as 0.02": a smaller distance that keeps particles apart; empty if none is found.
std::string smaller_snap(const Points<2>& x, const particles::Boundary& boundary, double distance) {
    for (int k = 1; k <= 30; ++k) {
        const std::string smaller = base::shown(std::ldexp(distance, -k), 2);
        try {
            static_cast<void>(particles::Cloud<2>(particles::snapped(x, boundary, std::stod(smaller)).x));
            return ", such as " + smaller;
        } catch (const InvalidInput&) {
        }
    }
    return "";
}

/// A layout whose particles within a distance of the boundary are moved onto it.
Layout snapped(Layout layout, const QuarterWithHole& shape, double distance) {
    using namespace batra2008;
    if (distance == 0) return layout;
    const particles::Boundary boundary(elastostatics::region(hole::problem({hole::E, hole::nu}, shape)));
    static_cast<void>(particles::Cloud<2>(layout.x));  // which refuses particles that coincide in the file
    auto [there, moved, farthest] = particles::snapped(layout.x, boundary, distance);
    try {
        static_cast<void>(particles::Cloud<2>(there));
    } catch (const InvalidInput& coincide) {
        throw InvalidInput("--snap " + base::shown(distance) + ": then " + coincide.what() +
                           "; take a smaller distance" + smaller_snap(layout.x, boundary, distance));
    }
    layout.x = std::move(there);
    layout.about = layout.name + ": " + std::to_string(moved) + " particles moved onto the boundary, by " +
                   base::shown(farthest, 3) + " m at most";
    return layout;
}

}  // namespace

bool is_around_a_hole(const std::string& name) {
    return graded(name) || polar(name);
}

bool is_drawn(const std::string& name) {
    return graded(name).has_value();
}

Layouts::Layouts(const std::vector<std::string>& names, const std::vector<std::string>& columns, double snap,
                 double scaling)
    : snap_(snap), scaling_(scaling) {
    if (!(std::isfinite(snap) && snap >= 0))
        throw InvalidInput("--snap must be a distance, got " + base::shown(snap));
    for (const std::string& name : names) {
        if (is_around_a_hole(name) || files_.contains(name)) continue;
        if (name.find_first_of("./") == std::string::npos)
            throw InvalidInput("there is no layout '" + name +
                               "'; choose graded-N-A, polar-AxR, or a file (a name with a dot or a slash)");
        files_[name] = read_points(name, columns);
        check_unit(name, files_[name]);
    }
    if (files_.empty() && !columns.empty())
        throw InvalidInput("--columns belongs to a --layout FILE; name one, or leave --columns out");
}

Layout Layouts::around(const QuarterWithHole& shape, const std::string& name, unsigned long draw) const {
    if (const auto two = graded(name)) {
        const auto [N, on_arc] = *two;
        check_cloud(static_cast<double>(N), scaling_ * scaling_);
        return snapped({name, particles::graded_layout(shape, N, on_arc, draw), true}, shape, snap_);
    }
    if (const auto two = polar(name)) {
        const auto [rays, on_ray] = *two;
        check_cloud(static_cast<double>(rays * on_ray), scaling_ * scaling_);
        return snapped({name, particles::polar_layout(shape, rays, on_ray), false}, shape, snap_);
    }
    return snapped({name, files_.at(name), false}, shape, snap_);
}

}  // namespace command_line
