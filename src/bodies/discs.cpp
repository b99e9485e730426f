#include "bodies/discs.hpp"

#include <array>

#include "base/parallel.hpp"
#include "batra2008/section_3_2_mlpg.hpp"
#include "particles/boundary.hpp"
#include "particles/region_check.hpp"
#include "particles/region_rules.hpp"

namespace bodies {

namespace {

using Kernel = particles::TruncatedGaussian<2>;

/// The directions along which a side gives the value.
template <int n>
std::vector<Values<n>> directions_of_values(const Given<2, n>& given, const Point<2>& normal) {
    std::vector<Values<n>> all;
    for (int i = 0; i < n; ++i)
        if (given.value[static_cast<std::size_t>(i)]) all.push_back(Values<n>::Unit(i));
    if constexpr (n == 2)
        if (given.symmetry) all.push_back(normal);
    return all;
}

/// The given value along such a direction.
template <int n>
double given_along(const Given<2, n>& given, const Values<n>& d, const Point<2>& x) {
    for (int i = 0; i < n; ++i)
        if (const auto& value = given.value[static_cast<std::size_t>(i)]; value && d == Values<n>::Unit(i))
            return value(x);
    return 0;
}

}  // namespace

template <int n>
System on_discs(const Problem<2, n>& problem, const Body<2>& body, const Approximation<2>& approximation,
                Wanted wanted) {
    const Cloud<2>& cloud = approximation.cloud();
    const Discretisation& how = approximation.how();
    const Index N = cloud.size();
    const double size = (body.x.rowwise().maxCoeff() - body.x.rowwise().minCoeff()).norm();
    particles::Region region;
    std::vector<const Given<2, n>*> given_on;
    for (const Side<2>& side : body.sides) {
        region.insert(region.end(), side.pieces.begin(), side.pieces.end());
        given_on.insert(given_on.end(), side.pieces.size(), problem.given_on(side));
    }
    const particles::Boundary boundary(particles::checked(region, size));
    const Kernel test(how.test_scaling);
    std::vector<std::vector<int>> near(static_cast<std::size_t>(N));
    base::for_each_index(N, [&](Index I) {
        near[static_cast<std::size_t>(I)] =
            cloud.within(cloud.x().col(I), (how.scaling + how.test_scaling) * approximation.h()[I]);
    });
    System system = empty_system<n>(near, wanted, static_cast<Index>(near.size()));
    base::for_each_index(N, [&](Index I) {
        const Point<2> x_I = cloud.x().col(I);
        const double h = approximation.h()[I], reach = test.rho() * h;
        const auto& among = near[static_cast<std::size_t>(I)];
        std::array<Factors<n>, static_cast<std::size_t>(n)> K, M;
        K.fill(Factors<n>::Zero(static_cast<Index>(among.size()), n));
        M = K;
        Values<n> f = Values<n>::Zero();
        for (const auto& point : particles::polar_rule(boundary, x_I, reach, how.gauss, 4 * how.gauss)) {
            const double W = batra2008::mlpg::W<2>(test, point.x - x_I, h);
            const Point<2> DW = batra2008::mlpg::DW<2>(test, point.x - x_I, h);
            const Weights<2> at = approximation.at(point.x, h, among);
            const auto A = problem.equation.A(point.x);
            f += point.weight * W * source(problem.equation, point.x);
            for (int i = 0; i < n; ++i) {
                const Eigen::Matrix<double, n, 2> G = Values<n>::Unit(i) * DW.transpose();
                const Factors<n> mass = point.weight * W * value_along<n>(Values<n>::Unit(i), at.value);
                const auto k = static_cast<std::size_t>(i);
                add<n>(K[k], among, point.weight * work<2, n>(G, A, at.first) + problem.equation.c * mass,
                       at.particle);
                if (wanted == Wanted::eigenvalues) add<n>(M[k], among, mass, at.particle);
            }
        }
        for (const std::size_t c : boundary.near(x_I, reach)) {
            const Given<2, n>* given = given_on[c];
            if (given == nullptr) continue;
            for (const auto& point : particles::boundary_rule(boundary.curves()[c], x_I, reach, how.gauss)) {
                const double weight = point.weight * batra2008::mlpg::W<2>(test, point.x - x_I, h);
                const std::vector<Values<n>> values = directions_of_values<n>(*given, point.normal);
                Eigen::Matrix<double, n, n> loaded = Eigen::Matrix<double, n, n>::Identity();
                for (const Values<n>& d : values) loaded -= d * d.transpose();
                Values<n> t = Values<n>::Zero();
                for (const Load<2, n>& load : given->loads) t += load(point.x, point.normal);
                const double a = given->exchange ? given->exchange(point.x) : 0;
                if (a != 0) t += a * Values<n>::Constant(given->surroundings(point.x));
                f += weight * (loaded * t);
                if (values.empty() && a == 0) continue;
                const Weights<2> at = approximation.at(point.x, h, among);
                const auto A = problem.equation.A(point.x);
                for (int i = 0; i < n; ++i) {
                    auto& K_i = K[static_cast<std::size_t>(i)];
                    if (a != 0)
                        add<n>(K_i, among, weight * a * value_along<n>(loaded.row(i).transpose(), at.value),
                               at.particle);
                    for (const Values<n>& d : values) {
                        if (d[i] == 0) continue;
                        const Eigen::Matrix<double, n, 2> G = d * point.normal.transpose();
                        add<n>(K_i, among,
                               weight * d[i] *
                                   (how.penalty * value_along<n>(d, at.value) - work<2, n>(G, A, at.first)),
                               at.particle);
                        f[i] += weight * d[i] * how.penalty * given_along<n>(*given, d, point.x);
                    }
                }
            }
        }
        for (int i = 0; i < n; ++i) {
            set_row<n>(system.A, n * I + i, among, K[static_cast<std::size_t>(i)]);
            if (wanted == Wanted::eigenvalues)
                set_row<n>(system.M, n * I + i, among, M[static_cast<std::size_t>(i)]);
        }
        system.b.template segment<n>(n * I) = f;
    });
    return system;
}

template System on_discs(const Problem<2, 1>&, const Body<2>&, const Approximation<2>&, Wanted);
template System on_discs(const Problem<2, 2>&, const Body<2>&, const Approximation<2>&, Wanted);

}  // namespace bodies
