#include "meshes/gmsh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "bodies/mesh.hpp"
#include "meshes/drawing.hpp"
#include "meshes/session.hpp"

namespace meshes {

using base::InvalidInput;
using base::shown;
using bodies::Mesh;
using bodies::Patch;
using particles::Index;
using particles::Point;

namespace {

gmsh::vectorpair entities(int dim) {
    gmsh::vectorpair all;
    gmsh::model::getEntities(all, dim);
    return all;
}

/// The elements of one type in an entity: their nodes by Gmsh's numbers, corners first.
struct Elements {
    std::string name;
    int order = 1;
    std::size_t nodes = 0, corners = 0;  ///< of each
    std::vector<std::size_t> tags;

    [[nodiscard]] std::size_t count() const { return tags.size() / nodes; }
    [[nodiscard]] std::size_t corner(std::size_t element, std::size_t k) const {
        return tags[element * nodes + k];
    }
};

std::vector<Elements> elements(int dim, int tag) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> numbers, nodes;
    gmsh::model::mesh::getElements(types, numbers, nodes, dim, tag);
    std::vector<Elements> all;
    for (std::size_t k = 0; k < types.size(); ++k) {
        Elements one;
        int dimension = 0, count = 0, corners = 0;
        std::vector<double> local;
        gmsh::model::mesh::getElementProperties(types[k], one.name, dimension, one.order, count, local,
                                                corners);
        one.nodes = static_cast<std::size_t>(count);
        one.corners = static_cast<std::size_t>(corners);
        one.tags = std::move(nodes[k]);
        all.push_back(std::move(one));
    }
    return all;
}

bool has_elements(int dim) {
    const gmsh::vectorpair all = entities(dim);
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& entity) { return !elements(dim, entity.second).empty(); });
}

/// The names of the physical groups to which an entity belongs; the number of one without name.
std::vector<std::string> groups_of(int dim, int tag) {
    std::vector<int> groups;
    gmsh::model::getPhysicalGroupsForEntity(dim, tag, groups);
    std::vector<std::string> names;
    for (const int group : groups) {
        std::string name;
        gmsh::model::getPhysicalName(dim, group, name);
        if (name.empty()) name = std::to_string(group);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

std::string in_words(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// A tangent of a circle, the derivative of the polynomial through five places from here on: exact to
/// round-off, where Gmsh's own derivative is exact to 1e-8.
Point<3> tangent_of_circle(int tag, double u) {
    std::vector<double> least, most, x;
    gmsh::model::getParametrizationBounds(1, tag, least, most);
    const double step = (most[0] - least[0]) / 4096 * (u < (least[0] + most[0]) / 2 ? 1 : -1);
    gmsh::model::getValue(1, tag, {u, u + step, u + 2 * step, u + 3 * step, u + 4 * step}, x);
    const Eigen::Map<const Eigen::Matrix<double, 3, 5>> places(x.data());
    const Eigen::Matrix<double, 5, 1> weights{-25, 48, -36, 16, -3};
    return places * weights / (12 * step);
}

/// Normals of a drawn curve or surface at its nodes, by Gmsh's numbers.
std::vector<std::pair<std::size_t, Point<3>>> normals_of(int dim, int tag) {
    std::string type;
    gmsh::model::getType(dim, tag, type);
    if (type.starts_with("Discrete")) return {};
    std::vector<std::size_t> nodes;
    std::vector<double> x, parameters, directions;
    gmsh::model::mesh::getNodes(nodes, x, parameters, dim, tag, true);
    if (parameters.size() != nodes.size() * static_cast<std::size_t>(dim)) return {};
    if (dim == 1)
        gmsh::model::getDerivative(dim, tag, parameters, directions);
    else
        gmsh::model::getNormal(tag, parameters, directions);
    if (directions.size() != 3 * nodes.size()) return {};
    std::vector<std::pair<std::size_t, Point<3>>> normals;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        Point<3> normal(directions[3 * k], directions[3 * k + 1], directions[3 * k + 2]);
        if (dim == 1) {
            if (type == "Circle") normal = tangent_of_circle(tag, parameters[k]);
            normal = {normal[1], -normal[0], 0};
        }
        normals.emplace_back(nodes[k], normal);
    }
    return normals;
}

/// The mesh that Gmsh holds.
template <int dim>
class Reader {
  public:
    Reader() {
        std::vector<std::size_t> nodes;
        std::vector<double> x, parameters;
        gmsh::model::mesh::getNodes(nodes, x, parameters, -1, -1, false, false);
        std::vector<std::pair<std::size_t, std::size_t>> order;  // Gmsh's numbers, and their places there
        for (std::size_t k = 0; k < nodes.size(); ++k) order.emplace_back(nodes[k], k);
        std::sort(order.begin(), order.end());
        x_.resize(3, static_cast<Index>(nodes.size()));
        for (std::size_t k = 0; k < order.size(); ++k) {
            number_[order[k].first] = static_cast<int>(k);
            x_.col(static_cast<Index>(k)) = Point<3>::Map(&x[3 * order[k].second]);
        }
    }

    Mesh<dim> mesh() {
        note_other_groups();
        read_cells();
        if (dim == 2) check_plane();
        mesh_.x = x_.topRows<dim>();
        read_patches();
        return std::move(mesh_);
    }

    std::vector<std::string> notes;

  private:
    [[nodiscard]] int node(std::size_t tag) const { return number_.at(tag); }

    /// Says of groups of points, and in space of curves, that they are no sides.
    void note_other_groups() {
        gmsh::vectorpair groups;
        gmsh::model::getPhysicalGroups(groups);
        for (const auto& [of_dim, group] : groups) {
            if (of_dim >= dim - 1) continue;
            std::string name;
            gmsh::model::getPhysicalName(of_dim, group, name);
            notes.push_back("The Physical " + std::string(of_dim == 0 ? "Point" : "Curve") + " '" +
                            (name.empty() ? std::to_string(group) : name) + "' is no side");
        }
    }

    void read_cells() {
        gmsh::vectorpair all = entities(dim), named;
        std::vector<std::string> names;
        for (const auto& entity : all) {
            const std::vector<std::string> groups = groups_of(dim, entity.second);
            if (!groups.empty()) named.push_back(entity);
            for (const std::string& name : groups)
                if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
        const std::string kind = dim == 2 ? "Surface" : "Volume";
        if (!named.empty() && named.size() < all.size())
            notes.push_back("What is in no Physical " + kind + " is left out");
        if (names.size() > 1) notes.push_back("Of one material: " + in_words(names));
        bool higher = false;
        for (const auto& [same, tag] : named.empty() ? all : named)
            for (const Elements& some : elements(dim, tag)) {
                higher = higher || some.order > 1;
                add_cells(some);
            }
        if (higher) notes.emplace_back("Elements of second order or higher count by their corners");
    }

    void add_cells(const Elements& some) {
        for (std::size_t k = 0; k < some.count(); ++k) {
            if (some.corners == dim + 1) {
                std::array<int, dim + 1> cell{};
                for (std::size_t corner = 0; corner <= dim; ++corner)
                    cell[corner] = node(some.corner(k, corner));
                mesh_.cells.push_back(cell);
            } else if constexpr (dim == 2) {
                add_quadrangle({node(some.corner(k, 0)), node(some.corner(k, 1)), node(some.corner(k, 2)),
                                node(some.corner(k, 3))});
            } else {
                throw InvalidInput("it has elements of the type " + some.name +
                                   "; mesh the volume by tetrahedra, without Recombine");
            }
        }
    }

    /// Cuts a quadrangle along the diagonal whose smaller triangle is the larger one.
    void add_quadrangle(const std::array<int, 4>& q) {
        const auto area = [&](int a, int b, int c) {
            const Point<3> ab = x_.col(b) - x_.col(a), ac = x_.col(c) - x_.col(a);
            return ab[0] * ac[1] - ab[1] * ac[0];
        };
        const auto [a, b, c, d] = q;
        const double sign = area(a, b, c) + area(a, c, d) < 0 ? -1 : 1;
        if (std::min(sign * area(a, b, c), sign * area(a, c, d)) >=
            std::min(sign * area(a, b, d), sign * area(b, c, d)))
            mesh_.cells.insert(mesh_.cells.end(), {{a, b, c}, {a, c, d}});
        else
            mesh_.cells.insert(mesh_.cells.end(), {{a, b, d}, {b, c, d}});
    }

    void check_plane() const {
        if (mesh_.cells.empty()) return;
        Point<3> low = x_.col(mesh_.cells[0][0]), high = low;
        for (const auto& cell : mesh_.cells)
            for (const int corner : cell) {
                low = low.cwiseMin(x_.col(corner));
                high = high.cwiseMax(x_.col(corner));
            }
        if (high[2] - low[2] > particles::negligible * (high - low).norm())
            throw InvalidInput(
                "its surface lies between z = " + shown(low[2]) + " and " + shown(high[2]) +
                "; a body in the plane has one z, and one in space is a Volume, not its surface");
    }

    void read_patches() {
        for (const auto& [codim, tag] : entities(dim - 1)) {
            Patch<dim> patch{tag, groups_of(dim - 1, tag), {}};
            for (const Elements& some : elements(dim - 1, tag))
                for (std::size_t k = 0; some.corners == dim && k < some.count(); ++k) {
                    std::array<int, dim> facet{};
                    for (std::size_t corner = 0; corner < dim; ++corner)
                        facet[corner] = node(some.corner(k, corner));
                    patch.facets.push_back(facet);
                }
            if (patch.facets.empty()) continue;
            for (const auto& [number, normal] : normals_of(dim - 1, tag))
                patch.normals[node(number)] = normal.template head<dim>();
            mesh_.patches.push_back(std::move(patch));
        }
    }

    std::unordered_map<std::size_t, int> number_;  // of a node, from its number in Gmsh
    Eigen::Matrix3Xd x_;
    Mesh<dim> mesh_;
};

template <int dim>
Model model() {
    Reader<dim> reader;
    const Mesh<dim> mesh = reader.mesh();
    return {bodies::body_of(mesh), std::move(reader.notes)};
}

}  // namespace

Model read(const std::string& path, std::optional<double> size) {
    check_file(path);
    if (size && !(*size > 0 && std::isfinite(*size)))
        throw InvalidInput("--size " + shown(*size) + " is not positive and finite");
    try {
        const Quiet quiet;
        const Session session(path);
        session.open();
        const bool is_script = path.ends_with(".geo") || path.ends_with(".geo_unrolled");
        const bool is_mesh = !is_script && has_elements(-1);
        if (is_mesh && size)
            throw InvalidInput(
                "it is a mesh, whose nodes are the particles; leave out --size, or give the drawing");
        const int dim = !is_mesh          ? gmsh::model::getDimension()
                        : has_elements(3) ? 3
                        : has_elements(2) ? 2
                                          : 1;
        if (dim < 2 && is_mesh)
            throw InvalidInput(
                "it has no triangles and no tetrahedra; of a drawing with physical groups, Gmsh writes these only: add a Physical Surface or Volume to the drawing");
        if (dim < 2)
            throw InvalidInput("it has no surface and no volume; a body needs a Plane Surface or a Volume");
        if (!is_mesh) {
            const Drawing drawing(dim);
            if (size) drawing.set_size(*size);
            drawing.mesh();
            session.check("Gmsh cannot mesh it");
        }
        return dim == 2 ? model<2>() : model<3>();
    } catch (const InvalidInput& error) {
        const std::string message = error.what();
        throw InvalidInput(message.starts_with(path) || message.starts_with("--") ? message
                                                                                  : path + ": " + message);
    } catch (const std::string& error) {  // Gmsh throws texts
        throw InvalidInput(path + ": Gmsh cannot read it: " + error + "; correct it there, gmsh " + path +
                           " shows it");
    }
}

}  // namespace meshes
