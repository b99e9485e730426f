#include "particles/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace particles {

namespace {

/// A particle as seen from the one at the corner.
struct Seen {
    int particle;
    Point<2> r;     // offset from the corner
    double square;  // r², but for a small number of its own, which decides where four lie on a circle
};

double cross(const Point<2>& a, const Point<2>& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// Whether c lies in the circle through the corner, a and b, on whose left or right side it lies.
bool in_circle(const Seen& a, const Seen& b, const Seen& c) {
    // The plane through a and b of the paraboloid over the offsets: c is inside if it lies below.
    const double det = cross(a.r, b.r);
    const Point<2> slope((a.square * b.r[1] - b.square * a.r[1]) / det,
                         (b.square * a.r[0] - a.square * b.r[0]) / det);
    return c.square < slope.dot(c.r);
}

/// A number from [0, 1) that belongs to a particle; those of a grid's neighbours follow no straight line.
double of_its_own(Index particle) {
    const auto j = static_cast<std::uint32_t>(particle);
    return (j * j * 2654435769U) / 4294967296.0;
}

/// The corner's particles near by, with those that a triangle may have. 20 particles surround it twice.
std::vector<Seen> seen(const Cloud<2>& cloud, Index particle) {
    const Point<2> x = cloud.x().col(particle);
    const double small = 1e-6 * std::pow(cloud.apart()[particle], 2);
    std::vector<Seen> all;
    for (double reach = 2.5 * cloud.apart()[particle]; all.size() < 20; reach *= 1.5) {
        all.clear();
        cloud.cells().for_each_within(x, reach, [&](int j, double square) {
            if (j != particle)
                all.push_back(
                    {j, cloud.x().col(j) - x, square + small * (of_its_own(j) - of_its_own(particle))});
        });
        if (static_cast<Index>(all.size()) + 1 == cloud.size()) break;
    }
    return all;
}

}  // namespace

std::vector<std::array<int, 2>> triangles_at(const Cloud<2>& cloud, Index particle) {
    std::vector<Seen> all = seen(cloud, particle);
    const auto nearer = [](const Seen& a, const Seen& b) { return a.square < b.square; };
    const auto sixth = all.begin() + std::min<std::ptrdiff_t>(5, static_cast<std::ptrdiff_t>(all.size()) - 1);
    std::nth_element(all.begin(), sixth, all.end(), nearer);
    const double largest = 1.5 * sixth->r.norm();
    const Seen& nearest = *std::min_element(all.begin(), sixth + 1, nearer);

    std::vector<std::array<int, 2>> triangles;
    // From the edge to the nearest particle on to the next edge, to the left; if that ends, to the right.
    for (const int side : {1, -1}) {
        const Seen* a = &nearest;
        for (std::size_t step = 0; step < all.size(); ++step) {
            const Seen* b = nullptr;
            for (const Seen& c : all) {
                if (side * cross(a->r, c.r) <= 1e-9 * nearest.square) continue;
                if (b == nullptr || in_circle(*a, *b, c)) b = &c;
            }
            if (b == nullptr) break;
            const double area = std::abs(cross(a->r, b->r)) / 2;
            if (a->r.norm() * b->r.norm() * (a->r - b->r).norm() / (4 * area) < largest)
                triangles.push_back(side > 0 ? std::array{a->particle, b->particle}
                                             : std::array{b->particle, a->particle});
            if (b == &nearest) return triangles;
            a = b;
        }
    }
    return triangles;
}

}  // namespace particles
