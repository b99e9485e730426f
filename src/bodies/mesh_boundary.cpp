#include "bodies/mesh_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "particles/cells.hpp"

namespace bodies {

using base::InvalidInput;
using particles::shown_point;

namespace {

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
                               "; remove duplicate cells, or draw the union of the parts");
        }
        first = last;
    }
    return outer;
}

/// \throws InvalidInput where another cell lies behind a facet of one cell only
template <int dim>
void check_uncovered(const Mesh<dim>& mesh, const std::vector<Outer<dim>>& outer) {
    constexpr double just = 1e-6;
    Points<dim> outside(dim, static_cast<Index>(outer.size()));
    for (std::size_t k = 0; k < outer.size(); ++k) {
        const Point<dim> normal = area(mesh, outer[k].nodes);
        const double size = std::pow(normal.norm(), 1.0 / (dim - 1));
        outside.col(static_cast<Index>(k)) = middle(mesh, outer[k].nodes) + just * size * normal.normalized();
    }
    const particles::Cells<dim> near(outside);
    int first = static_cast<int>(outer.size());
    for (const auto& cell : mesh.cells) {
        const Point<dim> centre = middle(mesh, cell);
        const Edges<dim> all = edges(mesh, cell), inverse = all.inverse();
        double reach = 0;
        for (const int node : cell) reach = std::max(reach, (at(mesh, node) - centre).norm());
        near.for_each_within(centre, reach, [&](int k, double) {
            const Point<dim> share = inverse * (outside.col(k) - at(mesh, cell[0]));
            if (share.minCoeff() > 0 && share.sum() < 1) first = std::min(first, k);
        });
    }
    if (first < static_cast<int>(outer.size()))
        throw InvalidInput("behind the facet at " +
                           shown_point(middle(mesh, outer[static_cast<std::size_t>(first)].nodes)) +
                           " lies a cell that does not share it: cells must fit together; remesh the body");
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
/// \throws InvalidInput for a named facet inside the body or on no cell, and for a facet with two names
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
                                       ": a body has no cracks and no interfaces; take " + name(patch) +
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

}  // namespace

template <int dim>
std::vector<Outer<dim>> boundary_of(const Mesh<dim>& mesh) {
    const std::vector<Facet<dim>> facets = facets_of(mesh);
    std::vector<Outer<dim>> outer = outer_facets(mesh, facets);
    check_uncovered(mesh, outer);
    assign(mesh, facets, outer);
    if (std::any_of(mesh.patches.begin(), mesh.patches.end(),
                    [](const Patch<dim>& patch) { return !patch.sides.empty(); }))
        check_named(mesh, outer);
    return outer;
}

template std::vector<Outer<2>> boundary_of(const Mesh<2>&);
template std::vector<Outer<3>> boundary_of(const Mesh<3>&);

}  // namespace bodies
