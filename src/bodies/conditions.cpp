#include "bodies/conditions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <string>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "particles/points.hpp"

namespace bodies {

namespace {

/// Sine of the angle below which two directions count as one.
constexpr double parallel = 0.02;

/// What is given at a particle by one of its sides.
template <int dim, int n>
struct Here {
    const Given<dim, n>* given;  ///< null for a free side
    const std::string* side;
    Point<dim> normal;
    int from;  ///< place in Problem::given
};

/// Whether the side of one was named before that of another; free sides come last.
template <int dim, int n>
bool named_before(const Here<dim, n>& one, const Here<dim, n>& other) {
    if (one.given == nullptr || other.given == nullptr) return other.given == nullptr && one.given != nullptr;
    return one.from < other.from;
}

/// The order in which sides are asked for a load.
template <int dim, int n>
int rank(const Here<dim, n>& here) {
    if (here.given == nullptr) return 1;
    return here.given->symmetry ? 2 : 0;
}

template <int dim, int n>
bool gives_load_along(const Here<dim, n>& here, const Values<n>& d) {
    if (here.given == nullptr) return true;
    for (int i = 0; i < n; ++i)
        if (here.given->value[static_cast<std::size_t>(i)] && std::abs(d[i]) > parallel) return false;
    if constexpr (n == dim)
        if (here.given->symmetry && std::abs(d.dot(here.normal)) > parallel) return false;
    return true;
}

/// The part of a direction that is orthogonal to others, which are orthonormal.
template <int n>
Values<n> rest(Values<n> d, const std::vector<Values<n>>& others) {
    for (int twice = 0; twice < 2; ++twice)
        for (const Values<n>& other : others) d -= d.dot(other) * other;
    return d;
}

/// Adds a direction unless it is a combination of the others.
template <int n>
bool spans_more(std::vector<Values<n>>& span, const Values<n>& d) {
    const Values<n> left = rest(d, span);
    if (left.norm() <= parallel) return false;
    span.push_back(left.normalized());
    return true;
}

template <int dim, int n>
double finite(double value, const char* what, const Here<dim, n>& here, const Point<dim>& x) {
    if (!std::isfinite(value))
        throw base::FailedComputation(std::string(what) + " on the side " + *here.side +
                                      " is not finite at " + particles::shown_point(x));
    return value;
}

template <int dim, int n>
Condition<dim, n> value_along(const Here<dim, n>& here, const Point<dim>& x, int component) {
    const auto& value = here.given->value[static_cast<std::size_t>(component)];
    return {true,        Values<n>::Unit(component),
            here.normal, finite(value(x), "the given value", here, x),
            0,           here.from};
}

template <int dim, int n>
Condition<dim, n> load_along(const Here<dim, n>& here, const Point<dim>& x, const Values<n>& d) {
    Condition<dim, n> condition{false, d, here.normal, 0, 0, here.from};
    if (here.given == nullptr) return condition;
    for (const Load<dim, n>& load : here.given->loads)
        condition.given += finite(load(x, here.normal).dot(d), "the load", here, x);
    if (here.given->exchange) {
        condition.exchange = finite(here.given->exchange(x), "the convection", here, x);
        condition.given +=
            condition.exchange * finite(here.given->surroundings(x), "the surroundings", here, x);
    }
    return condition;
}

/// The directions in which loads are given: the axes as far as values leave them free.
template <int n>
std::vector<Values<n>> complement(std::vector<Values<n>> span) {
    std::vector<Values<n>> left;
    while (span.size() < static_cast<std::size_t>(n)) {
        Values<n> most = Values<n>::Zero();
        for (int i = 0; i < n; ++i)
            if (const Values<n> d = rest<n>(Values<n>::Unit(i), span); d.norm() > most.norm() + 1e-12)
                most = d;
        left.push_back(most.normalized());
        span.push_back(left.back());
    }
    return left;
}

template <int dim, int n>
std::vector<Condition<dim, n>> by_rule(const std::vector<Here<dim, n>>& all, const Point<dim>& x) {
    std::vector<Condition<dim, n>> found;
    std::vector<Values<n>> span;
    for (const Here<dim, n>& here : all) {
        if (here.given == nullptr) continue;
        for (int i = 0; i < n; ++i)
            if (here.given->value[static_cast<std::size_t>(i)] && spans_more<n>(span, Values<n>::Unit(i)))
                found.push_back(value_along(here, x, i));
        if constexpr (n == dim)
            if (here.given->symmetry && spans_more<n>(span, here.normal))
                found.push_back({true, here.normal, here.normal, 0, 0, here.from});
    }
    for (const Values<n>& d : complement<n>(span)) {
        const Here<dim, n>* best = nullptr;
        for (const Here<dim, n>& here : all)
            if (gives_load_along(here, d) && (best == nullptr || rank(here) < rank(*best))) best = &here;
        found.push_back(load_along(best != nullptr ? *best : all.front(), x, d));
    }
    return found;
}

template <int dim, int n>
std::vector<Condition<dim, n>> by_choice(const Corner& corner, const std::vector<Here<dim, n>>& all,
                                         const Point<dim>& x) {
    std::vector<Condition<dim, n>> found;
    for (int i = 0; i < n; ++i) {
        const std::string& side = corner.by_component[static_cast<std::size_t>(i)];
        const auto here =
            std::find_if(all.begin(), all.end(), [&](const auto& one) { return *one.side == side; });
        if (here->given != nullptr && here->given->value[static_cast<std::size_t>(i)])
            found.push_back(value_along(*here, x, i));
        else
            found.push_back(load_along(*here, x, Values<n>(Values<n>::Unit(i))));
    }
    return found;
}

template <int dim, int n>
void check(const Problem<dim, n>& problem, const Body<dim>& body) {
    for (const Given<dim, n>& given : problem.given)
        if (problem.given_on(side_named(body, given.side)) != &given)
            throw base::InvalidInput("the side " + given.side + " is given twice");
    for (const Corner& corner : problem.corners) {
        for (const std::string& side : corner.sides) static_cast<void>(side_named(body, side));
        if (corner.by_component.size() != n)
            throw base::InvalidInput("the corner of " + corner.sides[0] + " and " + corner.sides[1] +
                                     " needs " + std::to_string(n) + " sides, one for each component, got " +
                                     std::to_string(corner.by_component.size()));
        for (const std::string& side : corner.by_component)
            if (side != corner.sides[0] && side != corner.sides[1])
                throw base::InvalidInput("the corner of " + corner.sides[0] + " and " + corner.sides[1] +
                                         " takes its conditions from one of them, not from " + side);
    }
}

}  // namespace

template <int dim, int n>
Conditions<dim, n> conditions(const Problem<dim, n>& problem, const Body<dim>& body) {
    check(problem, body);
    std::vector<std::vector<Here<dim, n>>> met(static_cast<std::size_t>(body.x.cols()));
    for (const Side<dim>& side : body.sides) {
        const Given<dim, n>* given = problem.given_on(side);
        const int from = given == nullptr ? -1 : static_cast<int>(given - problem.given.data());
        for (const auto& [particle, normal] : side.places)
            met[static_cast<std::size_t>(particle)].push_back({given, &side.name, normal, from});
    }
    Conditions<dim, n> all(met.size());
    for (std::size_t I = 0; I < met.size(); ++I) {
        std::vector<Here<dim, n>>& here = met[I];
        if (here.empty()) continue;
        std::stable_sort(here.begin(), here.end(), named_before<dim, n>);
        const Point<dim> x = body.x.col(static_cast<Index>(I));
        const auto meets = [&](const std::string& side) {
            return std::any_of(here.begin(), here.end(), [&](const auto& one) { return *one.side == side; });
        };
        const auto chosen = std::find_if(
            problem.corners.begin(), problem.corners.end(),
            [&](const Corner& corner) { return meets(corner.sides[0]) && meets(corner.sides[1]); });
        all[I] = chosen == problem.corners.end() ? by_rule(here, x) : by_choice(*chosen, here, x);
    }
    return all;
}

namespace {

/// The particles of each connected part of a body; a body without cells counts as one.
template <int dim>
std::vector<std::vector<int>> parts(const Body<dim>& body) {
    std::vector<int> root(static_cast<std::size_t>(body.x.cols()));
    std::iota(root.begin(), root.end(), 0);
    if (body.cells.empty()) return {root};
    const auto top = [&root](int k) {
        while (root[static_cast<std::size_t>(k)] != k) {
            int& next = root[static_cast<std::size_t>(k)];
            next = root[static_cast<std::size_t>(next)];
            k = next;
        }
        return k;
    };
    for (const auto& cell : body.cells)
        for (const int k : cell) {
            const int a = top(k), b = top(cell[0]);
            root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        }
    std::map<int, std::vector<int>> by_root;
    for (int k = 0; k < static_cast<int>(root.size()); ++k) by_root[top(k)].push_back(k);
    std::vector<std::vector<int>> all;
    all.reserve(by_root.size());
    for (auto& [first, particles] : by_root) all.push_back(std::move(particles));
    return all;
}

/// A rigid-body motion that the conditions leave free, in words; empty if there is none.
template <int dim>
std::string free_motion(const Body<dim>& body, const std::vector<int>& part,
                        const Conditions<dim, dim>& conditions) {
    constexpr int motions = dim * (dim + 1) / 2;
    using Motions = Eigen::Matrix<double, motions, 1>;
    Point<dim> centre = Point<dim>::Zero();
    for (const int I : part) centre += body.x.col(I) / static_cast<double>(part.size());
    double size = 0;
    for (const int I : part) size = std::max(size, (body.x.col(I) - centre).norm());
    Eigen::Matrix<double, motions, motions> gram = Eigen::Matrix<double, motions, motions>::Zero();
    for (const int I : part)
        for (const Condition<dim, dim>& one : conditions[static_cast<std::size_t>(I)]) {
            if (!one.of_value) continue;
            const Point<dim> s = (body.x.col(I) - centre) / size, d = one.direction;
            Motions row;
            row.template head<dim>() = d;
            int k = dim;
            for (int a = 0; a < dim; ++a)
                for (int b = a + 1; b < dim; ++b) row[k++] = d[b] * s[a] - d[a] * s[b];
            gram += row * row.transpose();
        }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, motions, motions>> solver(gram);
    if (solver.eigenvalues()[0] > 1e-10 * static_cast<double>(motions)) return "";
    const Motions motion = solver.eigenvectors().col(0);
    Index axis = 0;
    const double shift = motion.template head<dim>().cwiseAbs().maxCoeff(&axis);
    return shift > 0.9 ? "move along x" + std::to_string(axis + 1) : "turn as a whole";
}

}  // namespace

template <int dim, int n>
void require_held(const Problem<dim, n>& problem, const Body<dim>& body,
                  const Conditions<dim, n>& conditions) {
    if (problem.equation.c != 0) return;
    for (const std::vector<int>& part : parts(body)) {
        const std::string where =
            "the part of the body at " + particles::shown_point(body.x.col(part.front())) + " ";
        if constexpr (n == 1) {
            const auto known = [&](int I) {
                return std::any_of(conditions[static_cast<std::size_t>(I)].begin(),
                                   conditions[static_cast<std::size_t>(I)].end(),
                                   [](const auto& one) { return one.of_value || one.exchange != 0; });
            };
            if (std::none_of(part.begin(), part.end(), known))
                throw base::InvalidInput(
                    where +
                    "has no given value, no convection and no reaction: its solution is known up to a constant; give a value on a side");
        } else if (const std::string motion = free_motion<dim>(body, part, conditions); !motion.empty()) {
            throw base::InvalidInput(where + "is not held: it can " + motion +
                                     "; fix a side, or add a plane of symmetry");
        }
    }
}

template <int dim, int n>
void require_corners(const Problem<dim, n>& problem, const Body<dim>& body) {
    const auto particles_of = [&](const std::string& side) {
        std::vector<int> particles;
        for (const Place<dim>& place : side_named(body, side).places) particles.push_back(place.particle);
        std::sort(particles.begin(), particles.end());
        return particles;
    };
    for (const Corner& corner : problem.corners) {
        const std::vector<int> one = particles_of(corner.sides[0]), other = particles_of(corner.sides[1]);
        std::vector<int> both;
        std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
        if (corner.sides[0] == corner.sides[1] || both.empty())
            throw base::InvalidInput("the sides " + corner.sides[0] + " and " + corner.sides[1] +
                                     " have no corner: they meet at no particle");
    }
}

template void require_corners(const Problem<2, 1>&, const Body<2>&);
template void require_corners(const Problem<3, 1>&, const Body<3>&);
template void require_corners(const Problem<2, 2>&, const Body<2>&);
template void require_corners(const Problem<3, 3>&, const Body<3>&);
template void require_held(const Problem<2, 1>&, const Body<2>&, const Conditions<2, 1>&);
template void require_held(const Problem<3, 1>&, const Body<3>&, const Conditions<3, 1>&);
template void require_held(const Problem<2, 2>&, const Body<2>&, const Conditions<2, 2>&);
template void require_held(const Problem<3, 3>&, const Body<3>&, const Conditions<3, 3>&);

template Conditions<2, 1> conditions(const Problem<2, 1>&, const Body<2>&);
template Conditions<3, 1> conditions(const Problem<3, 1>&, const Body<3>&);
template Conditions<2, 2> conditions(const Problem<2, 2>&, const Body<2>&);
template Conditions<3, 3> conditions(const Problem<3, 3>&, const Body<3>&);

}  // namespace bodies
