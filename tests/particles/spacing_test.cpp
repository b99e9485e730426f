#include "particles/spacing.hpp"

#include <doctest/doctest.h>

#include <type_traits>

#include "base/quad.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/relative.hpp"

using namespace particles;

namespace {

using OnLine = std::integral_constant<int, 1>;
using InPlane = std::integral_constant<int, 2>;
using InSpace = std::integral_constant<int, 3>;

Line<double> line_of(std::initializer_list<double> positions) {
    Column<double> x(static_cast<Index>(positions.size()));
    std::copy(positions.begin(), positions.end(), x.begin());
    return line_at<double>(x, Volumes::equal);
}

bool same(const Column<double>& a, std::initializer_list<double> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

bool close(const Column<double>& a, const Column<double>& b, double tolerance) {
    return a.size() == b.size() && ((a - b).abs() <= tolerance * b).all();
}

/// The spacing of the same line of another scalar.
template <class Scalar>
Column<double> spacing_with(const Line<double>& line, const Spacing& which) {
    const Column<Scalar> x = line.x().cast<Scalar>();
    return spacing(line_at<Scalar>(x, Volumes::equal), which).template cast<double>();
}

/// The spacings that are distances between particles.
std::vector<Spacing> distances() {
    return {Spacing::largest, Spacing::local, Spacing::nearest, Spacing::to_nearest(4),
            Spacing::to_nearest(6)};
}

template <int dim>
Column<double> by_brute_force(const Points<dim>& x, Index k) {
    Column<double> farthest(x.cols());
    for (Index i = 0; i < x.cols(); ++i) {
        Column<double> distance = (x.colwise() - x.col(i)).colwise().norm().transpose();
        std::sort(distance.begin(), distance.end());
        farthest[i] = distance[k];
    }
    return farthest;
}

}  // namespace

TEST_CASE("spacing: on a line the largest is that of the farthest neighbours, the mean that of all") {
    const auto line = line_of({0, 0.1, 0.6, 1});
    CHECK(same(spacing(line, Spacing::largest), {0.5}));
    CHECK(same(spacing(line, Spacing::mean), {line.spacing()}));
}

TEST_CASE("spacing: on a line the local one is that to the farther neighbour, the nearest to the other") {
    const auto line = line_of({0, 0.125, 0.625, 1});
    CHECK(same(spacing(line, Spacing::local), {0.125, 0.5, 0.5, 0.375}));
    CHECK(same(spacing(line, Spacing::nearest), {0.125, 0.125, 0.375, 0.375}));
    CHECK(same(spacing(line, Spacing::to_nearest(2)), {0.625, 0.5, 0.5, 0.875}));
    CHECK(same(spacing(line, Spacing::to_nearest(3)), {1, 0.875, 0.625, 1}));
    CHECK(same(spacing(line_of({0, 0.125}), Spacing::local), {0.125, 0.125}));
}

TEST_CASE("spacing: on a line it is the same with every scalar") {
    const auto line = line_of({0, 0.125, 0.625, 1});
    for (const Spacing& which : {Spacing(Spacing::mean), Spacing(Spacing::largest), Spacing(Spacing::local),
                                 Spacing(Spacing::nearest), Spacing::to_nearest(3), Spacing(0.25)}) {
        CHECK((spacing_with<long double>(line, which) == spacing(line, which)).all());
        CHECK((spacing_with<base::Quad>(line, which) == spacing(line, which)).all());
    }
}

TEST_CASE("spacing: the distances to the nearest particles of a line are those of a cloud of one dimension") {
    for (const auto& [kind, x] : support::all_kinds<1>(343)) {
        Column<double> sorted = x.transpose();
        std::sort(sorted.begin(), sorted.end());
        const auto line = line_at<double>(sorted, Volumes::equal);
        const Cloud<1> cloud(sorted.matrix().transpose());
        for (const Index k : {1, 2, 6})
            if (k < line.size())
                CHECK((distances_to_nearest(line, k) == distances_to_nearest(cloud, k)).all());
        CHECK(close(spacing(line, Spacing::mean), spacing(cloud, Spacing::mean), 1e-15));
    }
}

TEST_CASE_TEMPLATE("spacing: on a grid every one inside is the grid's, in every dimension", Dim, OnLine,
                   InPlane, InSpace) {
    constexpr int dim = Dim::value;
    for (const Index n : {3, 4, 9, 17}) {
        const Cloud<dim> cloud(support::grid_points<dim>(n));
        const double delta = 1 / static_cast<double>(n - 1);
        CHECK(spacing(cloud, Spacing::mean)[0] == support::relative(delta, 1e-14));
        CHECK(spacing(cloud, Spacing::largest)[0] == support::relative(delta, 1e-14));
        CHECK(close(spacing(cloud, Spacing::nearest), Column<double>::Constant(cloud.size(), delta), 1e-13));
        const auto local = spacing(cloud, Spacing::local);
        for (Index j = 0; j < cloud.size(); ++j)
            if ((cloud.x().col(j).array() > 0.5 * delta && cloud.x().col(j).array() < 1 - 0.5 * delta).all())
                CHECK(local[j] == support::relative(delta, 1e-13));
    }
}

TEST_CASE("spacing: the mean is exact on grids of any sides, and on a line or in a plane in space") {
    Points<3> box(3, 4 * 7 * 2), plane(3, 4 * 7), line(3, 11);
    for (Index j = 0; j < box.cols(); ++j)
        box.col(j) << static_cast<double>(j % 4), static_cast<double>(j / 4 % 7), static_cast<double>(j / 28);
    plane = box.leftCols(28);
    for (Index j = 0; j < line.cols(); ++j) line.col(j) << 5, 3 * static_cast<double>(j), 7;
    CHECK(spacing(Cloud<3>(box), Spacing::mean)[0] == support::relative(1, 1e-14));
    CHECK(spacing(Cloud<3>(plane), Spacing::mean)[0] == support::relative(1, 1e-14));
    CHECK(spacing(Cloud<3>(line), Spacing::mean)[0] == support::relative(3, 1e-14));
}

TEST_CASE_TEMPLATE("spacing: in clouds of every kind the distances are those of brute force", Dim, OnLine,
                   InPlane, InSpace) {
    constexpr int dim = Dim::value;
    for (const auto& [kind, x] : support::all_kinds<dim>(343)) {
        const Cloud<dim> cloud(x);
        const Index N = cloud.size();
        for (const Index k : {1, 4, 6})
            if (k < N) CHECK(close(spacing(cloud, Spacing::to_nearest(k)), by_brute_force<dim>(x, k), 1e-15));
        CHECK((spacing(cloud, Spacing::nearest) == spacing(cloud, Spacing::to_nearest(1))).all());
        if (dim > 1)
            CHECK(close(spacing(cloud, Spacing::local),
                        by_brute_force<dim>(x, std::min<Index>(2 * dim, N - 1)), 1e-15));
        CHECK(spacing(cloud, Spacing::largest)[0] == spacing(cloud, Spacing::nearest).maxCoeff());
    }
}

TEST_CASE("spacing: in one dimension a cloud's are those of the line, in any order of its particles") {
    const std::vector<Index> order{3, 0, 4, 1, 5, 2};
    const Column<double> x{{0, 0.25, 0.375, 1, 1.125, 2}};
    Points<1> shuffled(1, 6);
    for (Index k = 0; k < 6; ++k) shuffled(0, k) = x[order[static_cast<std::size_t>(k)]];
    const Cloud<1> cloud(shuffled);
    const auto line = line_at<double>(x, Volumes::equal);
    for (const Spacing::Kind kind : {Spacing::local, Spacing::nearest}) {
        const Column<double> of_cloud = spacing(cloud, kind), of_line = spacing(line, kind);
        for (Index k = 0; k < 6; ++k) CHECK(of_cloud[k] == of_line[order[static_cast<std::size_t>(k)]]);
    }
    CHECK(spacing(cloud, Spacing::mean)[0] == support::relative(spacing(line, Spacing::mean)[0], 1e-14));
}

TEST_CASE_TEMPLATE("spacing: with the positions it grows in proportion, to the last bit for a power of two",
                   Dim, OnLine, InPlane, InSpace) {
    constexpr int dim = Dim::value;
    const Points<dim> x = support::random_points<dim>(200, 5);
    for (const double factor : {0.125, 1024.0}) {
        const Cloud<dim> cloud(x), scaled(factor * x);
        for (const Spacing& which : distances())
            CHECK((spacing(scaled, which) == factor * spacing(cloud, which)).all());
        CHECK(spacing(scaled, Spacing::mean)[0] == factor * spacing(cloud, Spacing::mean)[0]);
    }
}

TEST_CASE_TEMPLATE("spacing: a rotation changes no distance", Dim, OnLine, InPlane, InSpace) {
    constexpr int dim = Dim::value;
    const Points<dim> x = support::random_points<dim>(200, 5);
    Points<dim> turned = -x;
    for (Index j = 0; j < x.cols(); ++j)
        for (Index axis = 0; axis + 1 < dim; ++axis) {
            const double a = turned(axis, j), b = turned(axis + 1, j);
            turned(axis, j) = 0.6 * a - 0.8 * b;
            turned(axis + 1, j) = 0.8 * a + 0.6 * b;
        }
    for (const Spacing& which : distances())
        CHECK(close(spacing(Cloud<dim>(turned), which), spacing(Cloud<dim>(x), which), 1e-11));
}

TEST_CASE_TEMPLATE("spacing: the order of the particles does not matter", Dim, OnLine, InPlane, InSpace) {
    constexpr int dim = Dim::value;
    const Points<dim> x = support::random_points<dim>(200, 5);
    const Cloud<dim> cloud(x), reversed(x.rowwise().reverse());
    for (const Spacing& which : distances())
        CHECK((spacing(reversed, which) == spacing(cloud, which).reverse()).all());
}

TEST_CASE("spacing: given lengths stay as they are, and their number is checked") {
    const auto line = line_of({0, 0.125, 0.625, 1});
    const Cloud<2> cloud(support::grid_points<2>(2));
    const Column<double> each = Column<double>::LinSpaced(4, 1, 4);
    CHECK(same(spacing(line, Spacing(0.3)), {0.3}));
    CHECK(same(spacing(cloud, Spacing(0.3)), {0.3}));
    CHECK(same(spacing(line, Spacing(each)), {1, 2, 3, 4}));
    CHECK(same(spacing(cloud, Spacing(each)), {1, 2, 3, 4}));
    const std::string message = "4 particles need as many spacings, or one, got 3";
    CHECK_THROWS_WITH_AS(spacing(line, Spacing(each.head(3))), message.c_str(), InvalidInput);
    CHECK_THROWS_WITH_AS(spacing(cloud, Spacing(each.head(3))), message.c_str(), InvalidInput);
}

TEST_CASE("spacing: more nearest particles than there are others are refused with their number") {
    const Cloud<2> cloud(support::grid_points<2>(2));
    const auto line = line_of({0, 1, 2, 3});
    for (const Index k : {4, 1000000}) {
        const std::string message = "the " + std::to_string(k) +
                                    " nearest of 4 particles are not determined; take a number from 1 to 3";
        CHECK_THROWS_WITH_AS(spacing(cloud, Spacing::to_nearest(k)), message.c_str(), InvalidInput);
        CHECK_THROWS_WITH_AS(spacing(line, Spacing::to_nearest(k)), message.c_str(), InvalidInput);
    }
    CHECK_THROWS_AS(spacing(cloud, Spacing::to_nearest(0)), InvalidInput);
    CHECK(spacing(cloud, Spacing::to_nearest(3)).isApprox(Column<double>::Constant(4, std::sqrt(2.0))));
}

TEST_CASE("spacing: names are known, others are refused with the choices") {
    CHECK(spacing_named("mean").kind == Spacing::mean);
    CHECK(spacing_named("largest").kind == Spacing::largest);
    CHECK(spacing_named("local").kind == Spacing::local);
    CHECK(spacing_named("nearest").kind == Spacing::nearest);
    CHECK(spacing_named("nearest").k == 1);
    CHECK(spacing_named("6-nearest").kind == Spacing::nearest);
    CHECK(spacing_named("6-nearest").k == 6);
    for (const std::string wrong :
         {"least", "", "given", "6", "0-nearest", "-1-nearest", "6nearest", "6-nearests",
          "99999999999999999999-nearest", "1.5-nearest", " 6-nearest"}) {
        const std::string message =
            "there is no spacing '" + wrong +
            "'; choose one of mean, largest, local, nearest, or K-nearest with a number K, such as 6-nearest";
        CHECK_THROWS_WITH_AS(spacing_named(wrong), message.c_str(), InvalidInput);
    }
}
