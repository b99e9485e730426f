#include "distributed/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace distributed {

namespace {

template <int dim>
using Place = std::array<Index, static_cast<std::size_t>(dim)>;

/// A box of grid indices: first inclusive, end exclusive.
template <int dim>
struct Box {
    Place<dim> first{}, end{};

    [[nodiscard]] bool has(const Place<dim>& at) const {
        for (std::size_t axis = 0; axis < dim; ++axis)
            if (at[axis] < first[axis] || at[axis] >= end[axis]) return false;
        return true;
    }
    [[nodiscard]] Index size() const {
        Index product = 1;
        for (std::size_t axis = 0; axis < dim; ++axis) product *= end[axis] - first[axis];
        return product;
    }
    /// The number of a place, the first axis running fastest.
    [[nodiscard]] Index number(const Place<dim>& at) const {
        Index number = 0;
        for (std::size_t axis = dim; axis-- > 0;)
            number = number * (end[axis] - first[axis]) + at[axis] - first[axis];
        return number;
    }
    [[nodiscard]] Place<dim> place(Index number) const {
        Place<dim> at{};
        for (std::size_t axis = 0; axis < dim; ++axis) {
            at[axis] = first[axis] + number % (end[axis] - first[axis]);
            number /= end[axis] - first[axis];
        }
        return at;
    }
};

/// The box of a process, by recursive bisection of the longest side.
template <int dim>
Box<dim> box_of(const Grid<dim>& grid, int processes, int process) {
    Box<dim> box{{}, grid.count};
    while (processes > 1) {
        std::size_t longest = 0;
        for (std::size_t axis = 1; axis < dim; ++axis)
            if (box.end[axis] - box.first[axis] > box.end[longest] - box.first[longest]) longest = axis;
        const Index middle =
            box.first[longest] + share_of_first_half(box.end[longest] - box.first[longest], processes);
        const int half = processes / 2;
        if (process < half) {
            box.end[longest] = middle;
            processes = half;
        } else {
            box.first[longest] = middle;
            processes -= half;
            process -= half;
        }
    }
    return box;
}

template <int dim>
Box<dim> with_layers(Box<dim> box, const Place<dim>& layers, const Grid<dim>& grid) {
    for (std::size_t axis = 0; axis < dim; ++axis) {
        box.first[axis] = std::max(box.first[axis] - layers[axis], Index{0});
        box.end[axis] = std::min(box.end[axis] + layers[axis], grid.count[axis]);
    }
    return box;
}

/// The coordinate of the i-th particle along an axis.
template <int dim>
double coordinate(const Grid<dim>& grid, std::size_t axis, Index i) {
    const double length = grid.length[static_cast<Index>(axis)];
    const Index last = grid.count[axis] - 1;
    return i == last ? length : static_cast<double>(i) * length / static_cast<double>(last);
}

/// Distance of particles along an axis.
template <int dim>
double spacing(const Grid<dim>& grid, std::size_t axis) {
    return grid.length[static_cast<Index>(axis)] / static_cast<double>(grid.count[axis] - 1);
}

/// The largest distance to a nearest particle, bit for bit that of a Cloud.
template <int dim>
double largest_spacing(const Grid<dim>& grid) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < dim; ++axis) {
        const auto gap = [&](Index i) {  // after the i-th particle
            const double d = coordinate(grid, axis, i + 1) - coordinate(grid, axis, i);
            return std::sqrt(d * d);
        };
        double largest = 0;
        for (Index i = 0; i < grid.count[axis]; ++i)
            largest = std::max(largest, i == 0                      ? gap(0)
                                        : i == grid.count[axis] - 1 ? gap(i - 1)
                                                                    : std::min(gap(i - 1), gap(i)));
        least = std::min(least, largest);
    }
    return least;
}

/// The spacing, with mean and largest replaced by their lengths: a part does not know the whole grid.
template <int dim>
particles::Spacing of_whole(const particles::Spacing& spacing, const Grid<dim>& grid) {
    if (spacing.kind == particles::Spacing::mean)
        return particles::Spacing(particles::spacing_of_grid<dim>(grid.length, checked_size(grid)));
    if (spacing.kind == particles::Spacing::largest) return particles::Spacing(largest_spacing(grid));
    return spacing;
}

/// Kuhn's triangulation of a grid cell: a simplex for each order of the axes. \param steps to the next
/// particle
template <std::size_t corners, class Work>
void for_each_simplex(std::array<Index, corners - 1> steps, const Work& work) {
    std::sort(steps.begin(), steps.end());
    do {
        std::array<Index, corners> offsets{};
        for (std::size_t k = 1; k < corners; ++k) offsets[k] = offsets[k - 1] + steps[k - 1];
        work(offsets);
    } while (std::next_permutation(steps.begin(), steps.end()));
}

bodies::Piece<2> facet(const std::array<Point<2>, 2>& x, const Point<2>& normal) {
    const Point<2> along = x[1] - x[0], right(along[1], -along[0]);
    return right.dot(normal) > 0 ? particles::Segment{x[0], x[1]} : particles::Segment{x[1], x[0]};
}
bodies::Piece<3> facet(const std::array<Point<3>, 3>& x, const Point<3>& normal) {
    const Point<3> area = Point<3>(x[1] - x[0]).cross(Point<3>(x[2] - x[0]));
    return area.dot(normal) > 0 ? bodies::Triangle{{x[0], x[1], x[2]}} : bodies::Triangle{{x[0], x[2], x[1]}};
}

/// A part with the particles of a box and some layers.
template <int dim>
Part<dim> with_halo(const Grid<dim>& grid, const Box<dim>& own, const Place<dim>& layers) {
    static constexpr std::array<std::array<const char*, 2>, 3> names{
        {{"left", "right"}, {"bottom", "top"}, {"back", "front"}}};
    constexpr auto axes = static_cast<std::size_t>(dim);
    const Box<dim> all{{}, grid.count};
    Part<dim> part;
    for (std::size_t axis = 0; axis < axes; ++axis)
        for (const char* name : names[axis]) part.body.sides.push_back({name, {}, {}});
    part.extent = {Point<dim>::Zero(), grid.length, checked_size(grid)};
    if (own.size() == 0) return part;
    const Box<dim> held = with_layers(own, layers, grid);
    part.body.x.resize(dim, held.size());
    Place<dim> step{};  // to the next particle along each axis
    for (std::size_t axis = 0; axis < axes; ++axis)
        step[axis] = axis == 0 ? 1 : step[axis - 1] * (held.end[axis - 1] - held.first[axis - 1]);
    for (Index k = 0; k < held.size(); ++k) {
        const Place<dim> place = held.place(k);
        for (std::size_t axis = 0; axis < axes; ++axis)
            part.body.x(static_cast<Index>(axis), k) = coordinate(grid, axis, place[axis]);
        part.number.push_back(all.number(place));
        if (own.has(place)) part.own.push_back(static_cast<int>(k));
    }
    const auto is_last = [&](const Place<dim>& place, std::size_t axis) {
        return place[axis] == grid.count[axis] - 1;
    };
    for (std::size_t axis = 0; axis < axes; ++axis)
        for (Index k = 0; k < held.size(); ++k) {
            const Place<dim> place = held.place(k);
            if (place[axis] != 0 && !is_last(place, axis)) continue;
            const std::size_t end = place[axis] == 0 ? 0 : 1;
            bodies::Side<dim>& side = part.body.sides[2 * axis + end];
            const Point<dim> normal = (end == 0 ? -1 : 1) * Point<dim>::Unit(static_cast<Index>(axis));
            side.places.push_back({static_cast<int>(k), normal});
            std::array<Index, axes - 1> steps{};
            bool begins = own.has(place);  // a cell of the side
            for (std::size_t other = 0, next = 0; other < axes; ++other) {
                if (other == axis) continue;
                steps[next++] = step[other];
                begins = begins && !is_last(place, other);
            }
            if (begins)
                for_each_simplex<axes>(steps, [&](const auto& offsets) {
                    std::array<Point<dim>, axes> corners;
                    for (std::size_t c = 0; c < axes; ++c) corners[c] = part.body.x.col(k + offsets[c]);
                    side.pieces.push_back(facet(corners, normal));
                });
        }
    for (const bool of_own : {true, false}) {
        for (Index k = 0; k < held.size(); ++k) {
            const Place<dim> place = held.place(k);
            bool begins = own.has(place) == of_own;
            for (std::size_t axis = 0; axis < axes; ++axis)
                begins = begins && place[axis] + 1 < held.end[axis];
            if (!begins) continue;
            for_each_simplex<axes + 1>(step, [&](const auto& offsets) {
                std::array<int, axes + 1> cell{};
                for (std::size_t c = 0; c <= axes; ++c) cell[c] = static_cast<int>(k + offsets[c]);
                if (of_own ||
                    std::any_of(cell.begin(), cell.end(), [&](int I) { return own.has(held.place(I)); }))
                    part.body.cells.push_back(cell);
            });
        }
        if (of_own) part.own_cells = static_cast<Index>(part.body.cells.size());
    }
    return part;
}

}  // namespace

template <int dim>
Index checked_size(const Grid<dim>& grid) {
    double product = 1;
    for (std::size_t axis = 0; axis < dim; ++axis) {
        if (grid.count[axis] < 2)
            throw base::InvalidInput("a grid needs at least 2 particles along each axis, got " +
                                     std::to_string(grid.count[axis]));
        const double length = grid.length[static_cast<Index>(axis)];
        if (!(std::isfinite(length) && length > 0))
            throw base::InvalidInput("the lengths of a grid must be positive and finite, got " +
                                     base::shown(length));
        product *= static_cast<double>(grid.count[axis]);
    }
    if (product > 1e15)
        throw base::InvalidInput("a grid of " + base::shown(product, 3) + " particles is too large");
    return Box<dim>{{}, grid.count}.size();
}

template <int dim>
Body<dim> body_of(const Grid<dim>& grid) {
    return with_halo<dim>(grid, {{}, grid.count}, {}).body;
}

template <int dim>
Part<dim> part_of(const Grid<dim>& grid, const Discretisation& how, int processes, int process) {
    // Layers for pieces and cells whose nearest particle belongs to another process.
    constexpr Index more = 2;
    const Box<dim> own = box_of(grid, processes, process);
    Place<dim> layers{};
    const particles::Spacing given = of_whole(how.spacing, grid);
    const Index wanted = given.kind == particles::Spacing::nearest ? given.k + 1 : 2;
    for (Index more_layers = 2 + more; own.size() > 0; more_layers *= 2) {
        layers.fill(more_layers);
        const Index held = with_layers(own, layers, grid).size();
        if (held >= wanted || held == checked_size(grid)) break;
    }
    const double to_spacing = how.method == bodies::Method::fpm ? 1 / how.smoothing : 1;
    while (true) {
        Part<dim> part = with_halo(grid, own, layers);
        part.how = how;
        part.how.spacing = given;
        if (part.own.empty()) return part;
        if (Column<double>& lengths = part.how.spacing.lengths; lengths.size() > 1) {
            lengths.resize(static_cast<Index>(part.number.size()));
            for (Index k = 0; k < lengths.size(); ++k)
                lengths[k] = given.lengths[part.number[static_cast<std::size_t>(k)]];
        }
        const Approximation<dim> approximation = approximation_of(part);
        double reach = 0;
        for (const int I : part.own)
            reach = std::max({reach, approximation.reach(I), to_spacing * approximation.h()[I]});
        Place<dim> needed{};
        bool enough = true;
        for (std::size_t axis = 0; axis < dim; ++axis) {
            const double rows = std::ceil(reach / spacing(grid, axis));
            needed[axis] = more + static_cast<Index>(std::min(rows, static_cast<double>(grid.count[axis])));
            enough = enough && (needed[axis] <= layers[axis] || layers[axis] >= grid.count[axis]);
            layers[axis] = std::max(layers[axis], needed[axis]);
        }
        if (enough) return part;
    }
}

template Index checked_size(const Grid<2>&);
template Index checked_size(const Grid<3>&);
template Body<2> body_of(const Grid<2>&);
template Body<3> body_of(const Grid<3>&);
template Part<2> part_of(const Grid<2>&, const Discretisation&, int, int);
template Part<3> part_of(const Grid<3>&, const Discretisation&, int, int);

}  // namespace distributed
