#include "particles/boxes.hpp"

#include <algorithm>
#include <numeric>

namespace particles {

std::vector<Box> boxes_around(const Region& region) {
    std::vector<Box> boxes;
    boxes.reserve(region.size());
    for (const Curve& curve : region) boxes.push_back(box(curve));
    return boxes;
}

Boxes::Boxes(const std::vector<Box>& boxes) {
    Numbers numbers(boxes.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    nodes_.reserve(2 * boxes.size());
    if (!boxes.empty()) grow(boxes, numbers.begin(), numbers.end());
}

void Boxes::grow(const std::vector<Box>& boxes, Numbers::iterator begin, Numbers::iterator end) {
    Box around;
    for (auto k = begin; k != end; ++k) around.extend(boxes[*k]);
    const std::size_t node = nodes_.size();
    nodes_.push_back({around, 0, *begin});
    if (end - begin == 1) return;
    const int axis = around.sizes()[0] > around.sizes()[1] ? 0 : 1;
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](std::size_t a, std::size_t b) {
        return boxes[a].center()[axis] < boxes[b].center()[axis];
    });
    grow(boxes, begin, middle);
    nodes_[node].second = nodes_.size();
    grow(boxes, middle, end);
}

}  // namespace particles
