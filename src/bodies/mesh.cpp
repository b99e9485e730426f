#include "bodies/mesh.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "base/errors.hpp"
#include "particles/cells.hpp"

namespace bodies {

using base::InvalidInput;
using particles::negligible;
using particles::shown_point;

namespace {

/// Cosines of the angles up to which pieces meet smoothly, normals of a side are one, and the normal of a
/// shape is believed beside that of its piece: 40, 20 and 60 degrees.
const double smooth = std::cos(std::acos(-1.0) * 40 / 180), alike = std::cos(std::acos(-1.0) * 20 / 180),
             plausible = 0.5;

template <int dim>
using Nodes = std::array<int, static_cast<std::size_t>(dim)>;

template <int dim>
auto at(const Mesh<dim>& mesh, int node) {
    return mesh.x.col(node);
}

template <int dim, std::size_t count>
Point<dim> middle(const Mesh<dim>& mesh, const std::array<int, count>& nodes) {
    Point<dim> sum = Point<dim>::Zero();
    for (const int node : nodes) sum += at(mesh, node);
    return sum / static_cast<double>(count);
}

/// Length or area of a facet times its unit normal: to the right of a segment; towards those who see the
/// corners of a triangle run counter-clockwise.
template <int dim>
Point<dim> area(const Mesh<dim>& mesh, const Nodes<dim>& facet) {
    const Point<dim> a = at(mesh, facet[1]) - at(mesh, facet[0]);
    if constexpr (dim == 2) {
        return {a[1], -a[0]};
    } else {
        return a.cross(at(mesh, facet[2]) - at(mesh, facet[0])) / 2;
    }
}

template <int dim>
using Edges = Eigen::Matrix<double, dim, dim>;

/// The way from a cell's first corner to each of the others.
template <int dim>
Edges<dim> edges(const Mesh<dim>& mesh, const Nodes<dim + 1>& cell) {
    Edges<dim> all;
    for (int k = 0; k < dim; ++k)
        all.col(k) = at(mesh, cell[static_cast<std::size_t>(k) + 1]) - at(mesh, cell[0]);
    return all;
}

template <int dim>
void check_cells(const Mesh<dim>& mesh) {
    if (mesh.cells.empty())
        throw InvalidInput(dim == 2 ? "it has no triangles; a body in the plane is a surface with a mesh"
                                    : "it has no tetrahedra; a body in space is a volume with a mesh");
    for (const auto& cell : mesh.cells) {
        for (const int node : cell)
            if (!at(mesh, node).allFinite())
                throw InvalidInput("a node lies at " + shown_point(at(mesh, node)) +
                                   "; positions must be finite, mesh it anew");
        const Edges<dim> all = edges(mesh, cell);
        if (!(std::abs(all.determinant()) > negligible * std::pow(all.colwise().norm().maxCoeff(), dim)))
            throw InvalidInput("the cell at " + shown_point(middle(mesh, cell)) + " has no " +
                               (dim == 2 ? "area" : "volume") + "; remove it, or mesh anew");
    }
}

/// The number of a place along Morton's curve, which fills the unit cube: bits of the coordinates in turn.
template <int dim>
std::uint64_t along_curve(const Point<dim>& x) {
    constexpr int bits = 62 / dim;
    const Eigen::Matrix<std::uint64_t, dim, 1> at =
        (x * (std::pow(2, bits) - 1)).template cast<std::uint64_t>();
    std::uint64_t number = 0;
    for (int bit = bits; bit-- > 0;)
        for (int axis = 0; axis < dim; ++axis) number = number << 1U | (at[axis] >> bit & 1U);
    return number;
}

/// The nodes that are corners of cells, neighbours near to each other.
template <int dim>
std::vector<int> used_nodes(const Mesh<dim>& mesh) {
    std::vector<int> used;
    for (const auto& cell : mesh.cells) used.insert(used.end(), cell.begin(), cell.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    Point<dim> low = at(mesh, used[0]), high = low;
    for (const int node : used) {
        low = low.cwiseMin(at(mesh, node));
        high = high.cwiseMax(at(mesh, node));
    }
    std::vector<std::pair<std::uint64_t, int>> order;
    order.reserve(used.size());
    for (const int node : used)
        order.emplace_back(along_curve<dim>((at(mesh, node) - low) / (high - low).maxCoeff()), node);
    std::sort(order.begin(), order.end());
    std::transform(order.begin(), order.end(), used.begin(), [](const auto& one) { return one.second; });
    return used;
}

/// \throws InvalidInput where a node lies in a cell of which it is no corner
template <int dim>
void check_apart(const Mesh<dim>& mesh, const Points<dim>& x, const std::vector<int>& used) {
    const particles::Cells<dim> near(x);
    for (const auto& cell : mesh.cells) {
        const Point<dim> centre = middle(mesh, cell);
        const Edges<dim> all = edges(mesh, cell), inverse = all.inverse();
        double reach = 0;
        for (const int node : cell) reach = std::max(reach, (at(mesh, node) - centre).norm());
        std::optional<int> found;
        near.for_each_within(centre, reach * (1 + negligible), [&](int k, double) {
            const int node = used[static_cast<std::size_t>(k)];
            if (std::find(cell.begin(), cell.end(), node) != cell.end()) return;
            const Point<dim> share = inverse * (x.col(k) - at(mesh, cell[0]));
            if (share.minCoeff() >= -negligible && share.sum() <= 1 + negligible &&
                node < found.value_or(node + 1))
                found = node;
        });
        if (!found) continue;
        const Point<dim> place = at(mesh, *found);
        const bool twice = std::any_of(cell.begin(), cell.end(), [&](int node) {
            return (at(mesh, node) - place).norm() <= negligible * reach;
        });
        throw InvalidInput(
            (twice ? "two nodes lie at " + shown_point(place)
                   : "a node lies in a cell of other nodes, at " + shown_point(place)) +
            ": parts that touch must share their nodes, and none may overlap; join them by BooleanUnion or BooleanFragments in the .geo, or by Coherence Mesh if it is a mesh");
    }
}

/// A facet of a cell, and the cell's corner opposite to it.
template <int dim>
struct Facet {
    Nodes<dim> nodes;  ///< in increasing order
    int opposite;
};

template <int dim>
bool before(const Facet<dim>& a, const Facet<dim>& b) {
    return a.nodes < b.nodes;
}

/// The facets of all cells, equal ones next to each other.
template <int dim>
std::vector<Facet<dim>> facets_of(const Mesh<dim>& mesh) {
    std::vector<Facet<dim>> all;
    all.reserve(mesh.cells.size() * (dim + 1));
    for (const auto& cell : mesh.cells)
        for (std::size_t left_out = 0; left_out <= dim; ++left_out) {
            Facet<dim> facet{{}, cell[left_out]};
            for (std::size_t k = 0, to = 0; k <= dim; ++k)
                if (k != left_out) facet.nodes[to++] = cell[k];
            std::sort(facet.nodes.begin(), facet.nodes.end());
            all.push_back(facet);
        }
    std::stable_sort(all.begin(), all.end(), before<dim>);
    return all;
}

/// A facet of the boundary, the body to its left or behind it.
template <int dim>
struct Outer {
    Nodes<dim> nodes;
    int patch = -1;                           ///< that it belongs to; -1 for none
    Edges<dim> normals = Edges<dim>::Zero();  ///< of the shape, a column for each node
};

/// Where the corner opposite to a facet lies: 1 for the side to which area() points.
template <int dim>
int side_of_cell(const Mesh<dim>& mesh, const Nodes<dim>& nodes, int opposite) {
    return area(mesh, nodes).dot(at(mesh, opposite) - at(mesh, nodes[0])) > 0 ? 1 : -1;
}

/// The facets of one cell only, by increasing nodes.
/// \throws InvalidInput for a facet with two cells on one side
template <int dim>
std::vector<Outer<dim>> outer_facets(const Mesh<dim>& mesh, const std::vector<Facet<dim>>& facets) {
    std::vector<Outer<dim>> outer;
    for (auto first = facets.begin(); first != facets.end();) {
        const auto last = std::upper_bound(first, facets.end(), *first, before<dim>);
        int sum = 0;
        for (auto each = first; each != last; ++each) sum += side_of_cell(mesh, each->nodes, each->opposite);
        if (last - first == 1) {
            outer.push_back({first->nodes});
            if (sum > 0) std::swap(outer.back().nodes[0], outer.back().nodes[1]);
        } else if (last - first > 2 || sum != 0) {
            throw InvalidInput("cells overlap beside the facet at " +
                               shown_point(middle(mesh, first->nodes)) +
                               "; remove those that are there twice, or draw the union of the parts");
        }
        first = last;
    }
    return outer;
}

const char* kind(int dim) {
    return dim == 2 ? "Curve" : "Surface";
}

/// "curve 5"
template <int dim>
std::string name(const Patch<dim>& patch) {
    return (dim == 2 ? "curve " : "surface ") + std::to_string(patch.number);
}

template <int dim>
std::string group(const Patch<dim>& patch) {
    return "the Physical " + std::string(kind(dim)) + " '" + patch.sides.front() + "'";
}

/// Says of each facet of the boundary to which patch it belongs.
/// \throws InvalidInput for names inside the body or beside it, and for two names
template <int dim>
void assign(const Mesh<dim>& mesh, const std::vector<Facet<dim>>& facets, std::vector<Outer<dim>>& outer) {
    std::map<Nodes<dim>, Outer<dim>*> sorted;
    for (Outer<dim>& one : outer) {
        Nodes<dim> key = one.nodes;
        std::sort(key.begin(), key.end());
        sorted[key] = &one;
    }
    for (std::size_t number = 0; number < mesh.patches.size(); ++number) {
        const Patch<dim>& patch = mesh.patches[number];
        for (Nodes<dim> key : patch.facets) {
            const std::string where = " at " + shown_point(middle(mesh, key));
            std::sort(key.begin(), key.end());
            const auto found = sorted.find(key);
            if (found == sorted.end()) {
                if (patch.sides.empty()) continue;
                if (std::binary_search(facets.begin(), facets.end(), Facet<dim>{key, 0}, before<dim>))
                    throw InvalidInput(group(patch) + " lies inside the body" + where +
                                       ": it has no cracks and no interfaces; take " + name(patch) +
                                       " out of this group");
                throw InvalidInput(group(patch) + " borders no cell" + where + "; take " + name(patch) +
                                   " out of this group, or add the part that it borders to the body");
            }
            std::vector<std::string> names = patch.sides;
            if (const int other = found->second->patch; other >= 0)
                for (const std::string& name : mesh.patches[static_cast<std::size_t>(other)].sides)
                    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
            if (names.size() > 1)
                throw InvalidInput(name(patch) + where + " has two names, '" + names[0] + "' and '" +
                                   names[1] + "'; leave it in one Physical " + kind(dim));
            if (!patch.sides.empty() || found->second->patch < 0)
                found->second->patch = static_cast<int>(number);
        }
    }
}

/// \throws InvalidInput for a part of the boundary without a name
template <int dim>
void check_named(const Mesh<dim>& mesh, const std::vector<Outer<dim>>& outer) {
    std::set<int> numbers;
    std::optional<Point<dim>> where;
    for (const Outer<dim>& one : outer) {
        const Patch<dim>* patch =
            one.patch < 0 ? nullptr : &mesh.patches[static_cast<std::size_t>(one.patch)];
        if (patch != nullptr && !patch->sides.empty()) continue;
        if (!where) where = middle(mesh, one.nodes);
        if (patch != nullptr) numbers.insert(patch->number);
    }
    if (!where) return;
    std::string list;
    for (const int number : numbers) list += (list.empty() ? "" : ", ") + std::to_string(number);
    const std::string group = "Physical " + std::string(kind(dim));
    throw InvalidInput(
        "the boundary at " + shown_point(*where) + " is in no " + group + "; add it to one" +
        (list.empty() ? " in the drawing" : ", such as " + group + "(\"free\") = {" + list + "};"));
}

/// Sets of the numbers 0 … count − 1 that are linked, each with its numbers in increasing order.
template <class Linked>
std::vector<std::vector<std::size_t>> linked_sets(std::size_t count, const Linked& linked) {
    std::vector<std::vector<std::size_t>> sets;
    std::vector<bool> taken(count, false);
    for (std::size_t first = 0; first < count; ++first) {
        if (taken[first]) continue;
        std::vector<std::size_t> set{first};
        taken[first] = true;
        for (std::size_t k = 0; k < set.size(); ++k)
            for (std::size_t other = 0; other < count; ++other)
                if (!taken[other] && linked(set[k], other)) {
                    taken[other] = true;
                    set.push_back(other);
                }
        std::sort(set.begin(), set.end());
        sets.push_back(set);
    }
    return sets;
}

/// A facet of the boundary and one of its corners.
struct Corner {
    std::size_t facet, corner;
};

/// The facets of one side that meet at a node.
template <int dim>
class Meeting {
  public:
    Meeting(const Mesh<dim>& mesh, std::vector<Outer<dim>>& outer, std::vector<Corner> corners)
        : mesh_(mesh), outer_(outer), corners_(std::move(corners)) {}

    /// Sets the normals of the shape at the facets' corners here.
    /// \return the normals, of which those that are alike are one
    std::vector<Point<dim>> normals() {
        std::vector<Point<dim>> found;
        const auto together = [&](std::size_t a, std::size_t b) {
            const bool known = normal_of_shape(a).has_value();
            return known == normal_of_shape(b).has_value() &&
                   (known ? facet(a).patch == facet(b).patch : meet_smoothly(a, b));
        };
        for (const auto& set : linked_sets(corners_.size(), together)) {
            const Point<dim> normal = normal_of_shape(set.front()).value_or(mean(set));
            for (const std::size_t k : set)
                facet(k).normals.col(static_cast<Index>(corners_[k].corner)) = normal;
            found.push_back(normal);
        }
        std::vector<Point<dim>> means;
        const auto are_alike = [&](std::size_t a, std::size_t b) { return found[a].dot(found[b]) > alike; };
        for (const auto& set : linked_sets(found.size(), are_alike)) {
            Point<dim> sum = Point<dim>::Zero();
            for (const std::size_t k : set) sum += found[k];
            means.push_back(sum.normalized());
        }
        return means;
    }

  private:
    Outer<dim>& facet(std::size_t k) const { return outer_[corners_[k].facet]; }
    [[nodiscard]] int node() const { return facet(0).nodes[corners_[0].corner]; }
    [[nodiscard]] Point<dim> direction(std::size_t k) const {
        return area(mesh_, facet(k).nodes).normalized();
    }

    /// The normal of the shape, outward; none where it is not known or is not near those of its facets.
    [[nodiscard]] std::optional<Point<dim>> normal_of_shape(std::size_t k) const {
        const int patch = facet(k).patch;
        if (patch < 0) return {};
        const auto& known = mesh_.patches[static_cast<std::size_t>(patch)].normals;
        const auto found = known.find(node());
        if (found == known.end() || !found->second.allFinite() || !(found->second.norm() > 0)) return {};
        Point<dim> normal = found->second.normalized();
        if (normal.dot(direction(k)) < 0) normal = -normal;
        for (std::size_t other = 0; other < corners_.size(); ++other)
            if (facet(other).patch == patch && !(normal.dot(direction(other)) > plausible)) return {};
        return normal;
    }

    /// Facets that share an edge here, in the plane the node, and of which neither turns much from the other.
    [[nodiscard]] bool meet_smoothly(std::size_t a, std::size_t b) const {
        const auto shared = std::count_if(facet(a).nodes.begin(), facet(a).nodes.end(), [&](int one) {
            return std::find(facet(b).nodes.begin(), facet(b).nodes.end(), one) != facet(b).nodes.end();
        });
        return shared >= dim - 1 && direction(a).dot(direction(b)) > smooth;
    }

    /// The mean of the facets' normals, each weighted by its area over the squares of its edges here.
    [[nodiscard]] Point<dim> mean(const std::vector<std::size_t>& set) const {
        Point<dim> sum = Point<dim>::Zero();
        for (const std::size_t k : set) {
            Point<dim> weighted = area(mesh_, facet(k).nodes);
            for (const int other : facet(k).nodes)
                if (other != node()) weighted /= (at(mesh_, other) - at(mesh_, node())).squaredNorm();
            sum += weighted;
        }
        return sum.normalized();
    }

    const Mesh<dim>& mesh_;
    std::vector<Outer<dim>>& outer_;
    std::vector<Corner> corners_;
};

/// The distance between a facet and the shape, from the turn of the shape's normal along the edges: half way
/// along an edge of length L with a turn by θ it is Lθ/8, and in the middle of a triangle 4/9 of the sum.
template <int dim>
double gap_at(const Mesh<dim>& mesh, const Outer<dim>& one) {
    double largest = 0, sum = 0;
    for (int a = 0; a < dim; ++a)
        for (int b = a + 1; b < dim; ++b) {
            const Point<dim> edge = at(mesh, one.nodes[static_cast<std::size_t>(b)]) -
                                    at(mesh, one.nodes[static_cast<std::size_t>(a)]);
            const double along_edge = (one.normals.col(b) - one.normals.col(a)).dot(edge) / 8;
            largest = std::max(largest, std::abs(along_edge));
            sum += along_edge;
        }
    return dim == 2 ? largest : std::max(largest, 4.0 / 9 * std::abs(sum));
}

template <int dim>
Piece<dim> piece_of(const Mesh<dim>& mesh, const Nodes<dim>& nodes) {
    if constexpr (dim == 2) {
        return particles::Segment{at(mesh, nodes[0]), at(mesh, nodes[1])};
    } else {
        return Triangle{{at(mesh, nodes[0]), at(mesh, nodes[1]), at(mesh, nodes[2])}};
    }
}

}  // namespace

template <int dim>
Body<dim> body_of(const Mesh<dim>& mesh) {
    check_cells(mesh);
    const std::vector<int> used = used_nodes(mesh);
    std::vector<int> particle(static_cast<std::size_t>(mesh.x.cols()), -1);
    Body<dim> body;
    body.x.resize(dim, static_cast<Index>(used.size()));
    for (std::size_t k = 0; k < used.size(); ++k) {
        particle[static_cast<std::size_t>(used[k])] = static_cast<int>(k);
        body.x.col(static_cast<Index>(k)) = at(mesh, used[k]);
    }
    check_apart(mesh, body.x, used);

    const std::vector<Facet<dim>> facets = facets_of(mesh);
    std::vector<Outer<dim>> outer = outer_facets(mesh, facets);
    assign(mesh, facets, outer);
    std::vector<std::string> names;
    for (const Patch<dim>& patch : mesh.patches)
        if (!patch.sides.empty() && std::find(names.begin(), names.end(), patch.sides[0]) == names.end())
            names.push_back(patch.sides[0]);
    if (names.empty())
        names = {"boundary"};
    else
        check_named(mesh, outer);

    for (const std::string& name : names) {
        Side<dim> side{name, {}, {}};
        std::map<int, std::vector<Corner>> meetings;
        for (std::size_t number = 0; number < outer.size(); ++number) {
            const Outer<dim>& one = outer[number];
            if (one.patch >= 0) {
                const auto& sides = mesh.patches[static_cast<std::size_t>(one.patch)].sides;
                if (!sides.empty() && sides[0] != name) continue;
            }
            side.pieces.push_back(piece_of(mesh, one.nodes));
            for (std::size_t corner = 0; corner < dim; ++corner)
                meetings[one.nodes[corner]].push_back({number, corner});
        }
        for (const auto& [node, corners] : meetings)
            for (const Point<dim>& normal : Meeting<dim>(mesh, outer, corners).normals())
                side.places.push_back({particle[static_cast<std::size_t>(node)], normal});
        body.sides.push_back(std::move(side));
    }
    for (const Outer<dim>& one : outer) body.gap = std::max(body.gap, gap_at(mesh, one));

    for (Nodes<dim + 1> cell : mesh.cells) {
        if (edges(mesh, cell).determinant() < 0) std::swap(cell[0], cell[1]);
        for (int& node : cell) node = particle[static_cast<std::size_t>(node)];
        body.cells.push_back(cell);
    }
    return body;
}

template Body<2> body_of(const Mesh<2>&);
template Body<3> body_of(const Mesh<3>&);

}  // namespace bodies
