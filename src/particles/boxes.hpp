#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "particles/points.hpp"
#include "particles/region.hpp"

namespace particles {

/// The rectangle around each part of a boundary.
std::vector<Box> boxes_around(const Region& region);

/// Rectangles, sorted into a tree: a node holds the box around its rectangles, and each of its two branches a
/// half of them. The time to find those near a place grows with the logarithm of their number.
class Boxes {
  public:
    explicit Boxes(const std::vector<Box>& boxes);

    /// Calls `visit(k)` for each rectangle k that meets another one.
    template <class Visit>
    void for_each_meeting(const Box& other, const Visit& visit) const {
        if (!nodes_.empty()) search(0, other, visit);
    }

    /// The number of the thing nearest to a place; the first of several at the same distance.
    /// \param distance of thing k, which its rectangle holds, from the place
    template <class Distance>
    [[nodiscard]] std::size_t nearest(const Point<2>& place, const Distance& distance) const {
        Best best;
        if (!nodes_.empty()) approach(0, place, distance, best);
        return best.thing;
    }

  private:
    /// A node; its first branch is the next node.
    struct Node {
        Box box;
        std::size_t second = 0;  // branch; none if there is one rectangle only
        std::size_t thing = 0;   // number of this one
    };
    struct Best {
        std::size_t thing = 0;
        double distance = INFINITY;
    };
    using Numbers = std::vector<std::size_t>;

    /// Adds the node of some of the rectangles.
    void grow(const std::vector<Box>& boxes, Numbers::iterator begin, Numbers::iterator end);

    template <class Visit>
    void search(std::size_t k, const Box& other, const Visit& visit) const {
        const Node& node = nodes_[k];
        if (!node.box.intersects(other)) return;
        if (node.second == 0) return visit(node.thing);
        search(k + 1, other, visit);
        search(node.second, other, visit);
    }

    template <class Distance>
    void approach(std::size_t k, const Point<2>& place, const Distance& distance, Best& best) const {
        const Node& node = nodes_[k];
        if (node.second == 0) {
            const double here = distance(node.thing);
            if (here < best.distance || (here == best.distance && node.thing < best.thing))
                best = {node.thing, here};
            return;
        }
        const auto away = [&](std::size_t branch) { return nodes_[branch].box.exteriorDistance(place); };
        const bool first_is_nearer = away(k + 1) <= away(node.second);
        for (const std::size_t branch :
             {first_is_nearer ? k + 1 : node.second, first_is_nearer ? node.second : k + 1})
            if (away(branch) <= best.distance) approach(branch, place, distance, best);
    }

    std::vector<Node> nodes_;
};

}  // namespace particles
