#include "particles/triangle_rule.hpp"

#include <algorithm>
#include <cstddef>

namespace particles {

std::array<TrianglePoint, 13> triangle_rule() {
    // Two coordinates of one point of each orbit; the permutations of the three coordinates are its other
    // points: 1, 3, 3 and 6.
    struct Orbit {
        double a, b, weight;
    };
    constexpr std::array<Orbit, 4> orbits{{{1.0 / 3, 1.0 / 3, -0.149570044467670},
                                           {0.260345966079038, 0.260345966079038, 0.175615257433204},
                                           {0.065130102902216, 0.065130102902216, 0.053347235608839},
                                           {0.048690315425316, 0.312865496004875, 0.077113760890257}}};
    std::array<TrianglePoint, 13> rule{};
    std::size_t count = 0;
    for (const auto& [a, b, weight] : orbits) {
        std::array<double, 3> coordinates{a, b, 1 - a - b};
        if (a == 1.0 / 3) coordinates = {a, a, a};  // one point, despite the rounding of 1 − a − b
        std::sort(coordinates.begin(), coordinates.end());
        do rule[count++] = {coordinates, weight};
        while (std::next_permutation(coordinates.begin(), coordinates.end()));
    }
    return rule;
}

}  // namespace particles
