#include "command_line/body_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "command_line/columns.hpp"
#include "command_line/positions.hpp"
#include "particles/boundary.hpp"
#include "particles/boundary_particles.hpp"
#include "particles/region_check.hpp"

namespace command_line {

using base::InvalidInput;
using particles::negligible;
using particles::Point;
using particles::Segment;
using particles::shown;
using particles::shown_point;

namespace {

const std::string of_points = "--points", of_boundary = "--boundary";

/// Cosines of the angles from which a side has a corner, 40 degrees, and up to which normals are one, 20.
const double smooth = std::cos(std::acos(-1.0) * 40 / 180), alike = std::cos(std::acos(-1.0) * 20 / 180);

/// A place of a side and the normal that is given there; zero for none.
struct Vertex {
    const Columns::Row* row;
    double order;
    Point<2> x, normal;
};

/// The vertices of a side in their order.
struct Polyline {
    std::string name;
    std::vector<Vertex> vertices;
};

/// The file of sides.
class Outline {
  public:
    explicit Outline(const std::string& path) : file_(of_boundary, path) {
        if (file_.rows().empty()) file_.refuse(" has no rows; it needs name,order,x,y of each place");
        const std::size_t name = column("name"), order = column("order"), x = column("x"), y = column("y");
        const auto nx = file_.place_named("nx"), ny = file_.place_named("ny");
        if (nx.has_value() != ny.has_value()) file_.refuse(" has one of nx and ny; give both or none");
        for (const Columns::Row& row : file_.rows()) {
            const auto entries = row.entries();
            if (entries.size() <= std::max({name, order, x, y}) || entries[name].empty())
                file_.refuse(row, row.text, "needs name,order,x,y");
            Vertex vertex{&row,
                          file_.number(row, order),
                          {file_.number(row, x), file_.number(row, y)},
                          Point<2>::Zero()};
            if (nx) {
                vertex.normal = {file_.number(row, *nx), file_.number(row, *ny)};
                if (!(vertex.normal.norm() > 0)) file_.refuse(row, row.text, "has a normal without length");
                vertex.normal.normalize();
            }
            std::string_view word = entries[name];
            if (word.size() > 2 && word.front() == '"' && word.back() == '"')
                word = word.substr(1, word.size() - 2);
            side_named(std::string(word)).vertices.push_back(vertex);
        }
        for (Polyline& side : sides_) sort(side);
    }

    /// Diagonal of the bounding box of the boundary: lengths below 1e-8 of it count as zero.
    [[nodiscard]] double size() const {
        Point<2> low = sides_[0].vertices[0].x, high = low;
        for (const Polyline& side : sides_)
            for (const Vertex& vertex : side.vertices) {
                low = low.cwiseMin(vertex.x);
                high = high.cwiseMax(vertex.x);
            }
        return (high - low).norm();
    }

    /// The sides with joined ends: to the ends of other sides, or each side closed on itself.
    /// \param slack distance up to which ends meet
    std::vector<Polyline> joined(double slack) {
        std::vector<End> all;
        for (std::size_t side = 0; side < sides_.size(); ++side)
            for (const bool last : {false, true}) all.push_back({side, last});
        for (std::size_t side = 0; side < sides_.size(); ++side) {
            const std::array<End, 2> both{End{side, false}, End{side, true}};
            if (apart(both[0], both[1]) <= slack && sides_[side].vertices.size() > 2) {
                at(both[1]).x = at(both[0]).x;
                continue;
            }
            const std::array<End, 2> nearest{nearest_to(both[0], all), nearest_to(both[1], all)};
            const std::array<bool, 2> meets{apart(both[0], nearest[0]) <= slack,
                                            apart(both[1], nearest[1]) <= slack};
            for (const std::size_t k : {0U, 1U}) {
                const double way = apart(both[k], nearest[k]);
                const bool almost = nearest[k].side != side && is_slip(side, way);
                if (!meets[k] && (meets[1 - k] || almost)) refuse_open(both[k], nearest[k], way);
                if (meets[k]) at(nearest[k]).x = at(both[k]).x;
            }
            if (!meets[0] && !meets[1]) close(side);
        }
        return sides_;
    }

    /// \throws InvalidInput for a given normal that does not point to the same side as that of its piece
    void check_outward(const Vertex& vertex, const Point<2>& normal) const {
        if (!(vertex.normal.dot(normal) > 0))
            file_.refuse(*vertex.row, vertex.row->text,
                         "has a normal that points into the body or along its boundary; outward is " +
                             shown_point(normal));
    }

  private:
    /// The first or the last vertex of a side.
    struct End {
        std::size_t side;
        bool last;
    };

    [[nodiscard]] std::size_t column(const std::string& name) const {
        const auto place = file_.place_named(name);
        if (!place) file_.refuse(" has no column '" + name + "'; it needs the header name,order,x,y");
        return *place;
    }

    Polyline& side_named(const std::string& name) {
        for (Polyline& side : sides_)
            if (side.name == name) return side;
        return sides_.emplace_back(Polyline{name, {}});
    }

    void sort(Polyline& side) const {
        const auto before = [](const Vertex& a, const Vertex& b) { return a.order < b.order; };
        std::stable_sort(side.vertices.begin(), side.vertices.end(), before);
        if (side.vertices.size() == 1)
            file_.refuse(*side.vertices[0].row, side.vertices[0].row->text,
                         "is the only place of its side; a side needs two at least");
        for (std::size_t k = 1; k < side.vertices.size(); ++k) {
            const Vertex &last = side.vertices[k - 1], &next = side.vertices[k];
            const std::string other = " line " + std::to_string(last.row->line);
            if (!(last.order < next.order))
                file_.refuse(*next.row, next.row->text,
                             "has the same order as" + other + "; number the places along the side");
            if (last.x == next.x)
                file_.refuse(*next.row, next.row->text, "repeats the place of" + other + "; leave one out");
        }
    }

    [[nodiscard]] Vertex& at(const End& end) {
        std::vector<Vertex>& all = sides_[end.side].vertices;
        return end.last ? all.back() : all.front();
    }

    [[nodiscard]] double apart(const End& a, const End& b) { return (at(a).x - at(b).x).norm(); }

    /// The end of another side that is nearest to an end; the other end of its own if there is no other side.
    [[nodiscard]] End nearest_to(const End& end, const std::vector<End>& all) {
        End nearest{end.side, !end.last};
        for (const End& other : all)
            if (other.side != end.side &&
                (nearest.side == end.side || apart(end, other) < apart(end, nearest)))
                nearest = other;
        return nearest;
    }

    /// Whether a gap between ends is a slip: below 1 % of the shortest piece of the side.
    [[nodiscard]] bool is_slip(std::size_t side, double way) const {
        return way < shortest_piece(side) / 100;
    }

    [[nodiscard]] double shortest_piece(std::size_t side) const {
        const std::vector<Vertex>& all = sides_[side].vertices;
        double shortest = INFINITY;
        for (std::size_t k = 1; k < all.size(); ++k)
            shortest = std::min(shortest, (all[k].x - all[k - 1].x).norm());
        return shortest;
    }

    [[noreturn]] void refuse_open(const End& end, const End& nearest, double way) {
        const Columns::Row& row = *at(end).row;
        file_.refuse(row, row.text,
                     "is an open end of the boundary; the nearest end of another side, " +
                         sides_[nearest.side].name + ", is " + shown(way, 3) + " away, in line " +
                         std::to_string(at(nearest).row->line) + "; let them meet" +
                         (is_slip(end.side, way) ? ", or try --snap " + shown(1.1 * way, 2) : ""));
    }

    void close(std::size_t side) {
        std::vector<Vertex>& all = sides_[side].vertices;
        if (all.size() < 3)
            file_.refuse(
                *all.front().row, all.front().row->text,
                "begins a side of two places that meets no other side; add what closes the boundary");
        all.push_back(all.front());
    }

    Columns file_;
    std::vector<Polyline> sides_;
};

/// A piece of a side with the body to its left, and the normals of the side at its ends.
struct Edge {
    std::size_t side;
    Segment piece;
    std::array<Point<2>, 2> normals;
};

Point<2> normal_of(const Segment& piece) {
    return particles::normal_at(piece, piece.from);
}

double length(const Segment& piece) {
    return (piece.to - piece.from).norm();
}

/// The normals of a side where two of its pieces meet: at the end of the first, at the start of the second.
std::array<Point<2>, 2> normals_between(const Segment& before, const Segment& after) {
    const Point<2> first = normal_of(before), second = normal_of(after);
    if (!(first.dot(second) > smooth)) return {first, second};
    const Point<2> mean = (first / length(before) + second / length(after)).normalized();
    return {mean, mean};
}

/// The pieces of a side with its normals. \param pieces as checked() returns them
std::vector<Edge> edges_of(const Outline& outline, const Polyline& side, std::size_t number,
                           const std::vector<Segment>& pieces) {
    const std::size_t count = pieces.size();
    const bool closed = side.vertices.front().x == side.vertices.back().x,
               backward = (pieces[0].from - side.vertices[0].x).norm() > length(pieces[0]) / 2;
    std::vector<Edge> edges;
    std::transform(pieces.begin(), pieces.end(), std::back_inserter(edges), [&](const Segment& piece) {
        return Edge{number, piece, {normal_of(piece), normal_of(piece)}};
    });
    // Along the vertices; a piece that runs backward starts at its second one.
    const std::size_t start = backward ? 1 : 0, end = backward ? 0 : 1;
    for (std::size_t k = 0; k < count; ++k) {
        const bool last = k + 1 == count;
        if (last && !closed) continue;
        Edge &here = edges[k], &next = edges[last ? 0 : k + 1];
        const auto [a, b] =
            backward ? normals_between(next.piece, here.piece) : normals_between(here.piece, next.piece);
        here.normals[end] = backward ? b : a;
        next.normals[start] = backward ? a : b;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const std::array<const Vertex*, 2> both{&side.vertices[k], &side.vertices[k + 1]};
        for (const std::size_t which : {0U, 1U}) {
            const Vertex& vertex = *both[which];
            if (vertex.normal.norm() == 0) continue;
            outline.check_outward(vertex, normal_of(edges[k].piece));
            edges[k].normals[which == 0 ? start : end] = vertex.normal;
        }
    }
    return edges;
}

/// The normal at a place of a piece.
Point<2> normal_at(const Edge& edge, const Point<2>& x) {
    const Point<2> way = edge.piece.to - edge.piece.from;
    const double t = std::clamp((x - edge.piece.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return ((1 - t) * edge.normals[0] + t * edge.normals[1]).normalized();
}

/// Adds a particle on a piece to the places of its side: one with the normals that are alike.
void add_place(bodies::Side<2>& side, int particle, const Point<2>& normal) {
    for (auto place = side.places.rbegin(); place != side.places.rend() && place->particle == particle;
         ++place)
        if (place->normal.dot(normal) > alike) {
            place->normal = (place->normal + normal).normalized();
            return;
        }
    side.places.push_back({particle, normal});
}

/// \throws InvalidInput for two particles so near that they are one
void check_apart(const particles::Cloud<2>& cloud, double size) {
    for (particles::Index j = 0; j < cloud.size(); ++j) {
        const double apart = cloud.apart()[j];
        if (apart > negligible * size) continue;
        const std::vector<int> both = cloud.within(cloud.x().col(j), 2 * apart);
        throw InvalidInput("particles " + std::to_string(both[0]) + " and " + std::to_string(both[1]) +
                           " lie " + shown(apart, 3) + " apart at " + shown_point(cloud.x().col(j)) +
                           "; leave one of them out");
    }
}

/// Work whose errors begin with an option and its file.
template <class Work>
auto said_of(const std::string& option, const std::string& path, const Work& work) {
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw InvalidInput(option + ": " + path + ": " + error.what());
    }
}

}  // namespace

BodyFromFiles read_body(const std::string& points, const std::string& boundary, std::optional<double> snap) {
    if (snap && !(*snap > 0 && std::isfinite(*snap)))
        throw InvalidInput("--snap " + shown(*snap) + " is no distance; it must be positive and finite");
    const particles::Points<2> x = read_points<2>(of_points, points, {}, "a body in the plane");
    Outline outline(boundary);
    const double size = outline.size();
    const std::vector<Polyline> sides = outline.joined(std::max(snap.value_or(0), negligible * size));

    particles::Region pieces;
    for (const Polyline& side : sides)
        for (std::size_t k = 1; k < side.vertices.size(); ++k)
            pieces.emplace_back(Segment{side.vertices[k - 1].x, side.vertices[k].x});
    const particles::Boundary whole(
        said_of(of_boundary, boundary, [&] { return particles::checked(pieces, size); }));

    BodyFromFiles found{{x, {}}};
    bodies::Body<2>& body = found.body;
    if (snap) {
        const particles::Snapped moved = particles::snapped(x, whole, *snap);
        found = {{moved.x, {}}, moved.moved, moved.farthest};
    }
    said_of(of_points, points, [&] {
        const particles::Cloud<2> cloud(body.x);
        check_apart(cloud, size);
        particles::check_particles(cloud, whole, size);
    });

    std::vector<Edge> edges;
    for (std::size_t number = 0; number < sides.size(); ++number) {
        std::vector<Segment> own;
        for (std::size_t k = 1; k < sides[number].vertices.size(); ++k)
            own.push_back(std::get<Segment>(whole.curves()[edges.size() + k - 1]));
        body.sides.push_back({sides[number].name, {own.begin(), own.end()}, {}});
        const std::vector<Edge> more = edges_of(outline, sides[number], number, own);
        edges.insert(edges.end(), more.begin(), more.end());
    }
    for (const auto& [side, piece, normals] : edges)
        body.gap = std::max(body.gap, std::abs((normals[1] - normals[0]).dot(piece.to - piece.from)) / 8);
    for (particles::Index j = 0; j < body.x.cols(); ++j)
        for (const std::size_t k : whole.near(body.x.col(j), negligible * size))
            add_place(body.sides[edges[k].side], static_cast<int>(j), normal_at(edges[k], body.x.col(j)));
    for (const bodies::Side<2>& side : body.sides)
        if (side.places.empty())
            throw InvalidInput(of_points + ": " + points + ": the side " + side.name +
                               " has no particle on it; add some, or make it part of another side");
    return found;
}

}  // namespace command_line
