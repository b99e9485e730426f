#include "bodies/mesh_normals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bodies {

namespace {

/// Cosines of three angles: 40°, up to which pieces meet smoothly; 20°, up to which normals of a side are
/// merged; 60°, up to which the normal of the shape may differ from that of a piece.
const double smooth = std::cos(std::acos(-1.0) * 40 / 180), alike = std::cos(std::acos(-1.0) * 20 / 180),
             plausible = 0.5;

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

/// The facets of one side that meet at a node.
template <int dim>
class Meeting {
  public:
    Meeting(const Mesh<dim>& mesh, std::vector<Outer<dim>>& outer, std::vector<FacetCorner> corners)
        : mesh_(mesh), outer_(outer), corners_(std::move(corners)) {}

    /// Sets the normals of the shape at the facets' corners here.
    /// \return the normals, similar ones merged
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
    std::vector<FacetCorner> corners_;
};

}  // namespace

template <int dim>
std::vector<Point<dim>> normals_at(const Mesh<dim>& mesh, std::vector<Outer<dim>>& outer,
                                   const std::vector<FacetCorner>& corners) {
    return Meeting<dim>(mesh, outer, corners).normals();
}

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

template std::vector<Point<2>> normals_at(const Mesh<2>&, std::vector<Outer<2>>&,
                                          const std::vector<FacetCorner>&);
template std::vector<Point<3>> normals_at(const Mesh<3>&, std::vector<Outer<3>>&,
                                          const std::vector<FacetCorner>&);
template double gap_at(const Mesh<2>&, const Outer<2>&);
template double gap_at(const Mesh<3>&, const Outer<3>&);

}  // namespace bodies
