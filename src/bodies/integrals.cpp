#include "bodies/integrals.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "particles/boundary.hpp"
#include "particles/quadrature.hpp"
#include "particles/region_check.hpp"
#include "particles/region_rules.hpp"

namespace bodies {

namespace {

double length_of(const Piece<2>& piece) {
    if (const auto* side = std::get_if<particles::Segment>(&piece)) return (side->to - side->from).norm();
    const auto& arc = std::get<particles::Arc>(piece);
    return arc.radius * (arc.to - arc.from);
}

/// The place on a piece at a share of the way from its start.
Point<2> at_share(const Piece<2>& piece, double share) {
    if (const auto* side = std::get_if<particles::Segment>(&piece))
        return side->from + share * (side->to - side->from);
    const auto& arc = std::get<particles::Arc>(piece);
    const double angle = arc.from + share * (arc.to - arc.from);
    return arc.centre + arc.radius * Point<2>(std::cos(angle), std::sin(angle));
}

void add_rule(std::vector<IntegrationPoint<2>>& rule, const Piece<2>& piece, double spacing) {
    const double length = length_of(piece);
    const auto parts = static_cast<Index>(std::ceil(std::clamp(length / spacing, 1.0, 1e6)));
    const particles::GaussRule gauss = particles::gauss_rule(3);
    for (Index part = 0; part < parts; ++part)
        for (Index k = 0; k < 3; ++k) {
            const Point<2> x =
                at_share(piece, (static_cast<double>(part) + gauss.x[k]) / static_cast<double>(parts));
            rule.push_back(
                {x, gauss.w[k] * length / static_cast<double>(parts), particles::normal_at(piece, x)});
        }
}

void add_rule(std::vector<IntegrationPoint<3>>& rule, const Piece<3>& piece, double /*spacing*/) {
    const auto& [a, b, c] = piece.corners;
    const Point<3> area = Point<3>(b - a).cross(Point<3>(c - a)) / 2;
    for (const Point<3>& corner : piece.corners)
        rule.push_back({corner / 2 + (a + b + c) / 6, area.norm() / 3, area.normalized()});
}

/// Points of a body without cells.
std::vector<IntegrationPoint<2>> polar(const Body<2>& body) {
    particles::Region region;
    for (const Side<2>& side : body.sides)
        region.insert(region.end(), side.pieces.begin(), side.pieces.end());
    const double size = (body.x.rowwise().maxCoeff() - body.x.rowwise().minCoeff()).norm();
    const particles::Boundary boundary(particles::checked(region, size));
    std::vector<IntegrationPoint<2>> rule;
    for (const auto& point : particles::polar_rule(boundary, body.x.col(0), 1.01 * size, 40, 160))
        rule.push_back({point.x, point.weight});
    return rule;
}
std::vector<IntegrationPoint<3>> polar(const Body<3>& /*body*/) {
    throw base::InvalidInput("an integral over a body in space needs its cells");
}

}  // namespace

template <int dim>
std::vector<IntegrationPoint<dim>> rule_on(const Side<dim>& side, double spacing) {
    std::vector<IntegrationPoint<dim>> rule;
    for (const Piece<dim>& piece : side.pieces) add_rule(rule, piece, spacing);
    return rule;
}

template <int dim>
std::vector<IntegrationPoint<dim>> rule_in(const Body<dim>& body) {
    if (body.cells.empty()) return polar(body);
    std::vector<IntegrationPoint<dim>> rule;
    for (const auto& cell : body.cells) {
        Eigen::Matrix<double, dim, dim> edges;
        Point<dim> sum = body.x.col(cell[0]);
        for (int k = 0; k < dim; ++k) {
            const Point<dim> corner = body.x.col(cell[static_cast<std::size_t>(k) + 1]);
            edges.col(k) = corner - body.x.col(cell[0]);
            sum += corner;
        }
        rule.push_back({sum / (dim + 1), std::abs(edges.determinant()) / (dim == 2 ? 2 : 6)});
    }
    return rule;
}

template std::vector<IntegrationPoint<2>> rule_on(const Side<2>&, double);
template std::vector<IntegrationPoint<3>> rule_on(const Side<3>&, double);
template std::vector<IntegrationPoint<2>> rule_in(const Body<2>&);
template std::vector<IntegrationPoint<3>> rule_in(const Body<3>&);

}  // namespace bodies
