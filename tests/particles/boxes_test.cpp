#include "particles/boxes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/support/clouds.hpp"

using namespace particles;

TEST_CASE("boxes: a search finds all rectangles that meet another one, each once") {
    support::Draws draw(1);
    const auto random_box = [&](double size) {
        const Point<2> low = draw.point<2>();
        return Box(low, low + size * (draw.point<2>() + Point<2>::Ones()));
    };
    for (const int n : {0, 1, 2, 3, 10, 500}) {
        std::vector<Box> all;
        for (int k = 0; k < n; ++k) all.push_back(random_box(k % 10 == 0 ? 1 : 0.05));
        const Boxes boxes(all);
        for (int k = 0; k < 20; ++k) {
            const Box other = random_box(0.2);
            std::vector<std::size_t> found, expected;
            boxes.for_each_meeting(other, [&](std::size_t each) { found.push_back(each); });
            for (std::size_t each = 0; each < all.size(); ++each)
                if (all[each].intersects(other)) expected.push_back(each);
            std::sort(found.begin(), found.end());
            CHECK(found == expected);
        }
    }
}

TEST_CASE("boxes: of the nearest things the first one is found, also among equal ones") {
    support::Draws draw(2);
    std::vector<Box> all;
    for (int k = 0; k < 200; ++k) all.emplace_back(Point<2>(draw.point<2>()));
    all.insert(all.end(), all.begin(), all.begin() + 200);
    const Boxes boxes(all);
    for (int k = 0; k < 100; ++k) {
        const Point<2> x = 2 * draw.point<2>();
        const auto distance = [&](std::size_t each) { return (all[each].min() - x).norm(); };
        std::size_t nearest = 0;
        for (std::size_t each = 1; each < all.size(); ++each)
            if (distance(each) < distance(nearest)) nearest = each;
        CHECK(boxes.nearest(x, distance) == nearest);
    }
}
