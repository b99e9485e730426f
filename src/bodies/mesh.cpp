#include "bodies/mesh.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "bodies/mesh_normals.hpp"
#include "particles/cells.hpp"

namespace bodies {

using base::InvalidInput;
using particles::negligible;
using particles::shown_point;

template <int dim>
void check_cells(const Mesh<dim>& mesh) {
    if (mesh.cells.empty())
        throw InvalidInput(dim == 2 ? "it has no triangles; a body in the plane is a surface with a mesh"
                                    : "it has no tetrahedra; a body in space is a volume with a mesh");
    for (const auto& cell : mesh.cells) {
        for (const int node : cell)
            if (!at(mesh, node).allFinite())
                throw InvalidInput("a node lies at " + shown_point(at(mesh, node)) +
                                   "; positions must be finite, remesh the body");
        const Edges<dim> all = edges(mesh, cell);
        if (!(std::abs(all.determinant()) > negligible * std::pow(all.colwise().norm().maxCoeff(), dim)))
            throw InvalidInput(
                "the cell at " + shown_point(middle(mesh, cell)) + " has no " +
                (dim == 2 ? "area; remove it, or remesh the body" : "volume; remesh the body"));
    }
}

template void check_cells(const Mesh<2>&);
template void check_cells(const Mesh<3>&);

namespace {

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

    std::vector<Outer<dim>> outer = boundary_of(mesh);
    std::vector<std::string> names;
    for (const Patch<dim>& patch : mesh.patches)
        if (!patch.sides.empty() && std::find(names.begin(), names.end(), patch.sides[0]) == names.end())
            names.push_back(patch.sides[0]);
    if (names.empty()) names = {"boundary"};

    for (const std::string& name : names) {
        Side<dim> side{name, {}, {}};
        std::map<int, std::vector<FacetCorner>> meetings;
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
            for (const Point<dim>& normal : normals_at(mesh, outer, corners))
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
