#include "particles/close_pair.hpp"

#include <doctest/doctest.h>

#include "particles/operators.hpp"

using namespace particles;

TEST_CASE(
    "close_pair: two particles far nearer to each other than to others are named, on a line and in clouds") {
    const auto line = line_at<double>(Column<double>{{0, 0.2, 0.401, 0.4011, 0.6, 0.8, 1}}, Volumes::equal);
    CHECK_FALSE(close_pair(line, 0));
    for (const Index i : {2, 3})
        CHECK(
            close_pair(line, i)->advice().starts_with("particles 2 and 3 lie 0.0001 apart, the next one 0."));
    const auto at_end = line_at<double>(Column<double>{{0, 0.001, 1}}, Volumes::equal);
    CHECK(close_pair(at_end, 0)->advice() ==
          "particles 0 and 1 lie 0.001 apart, the next one 1; leave one of them out");
    CHECK_FALSE(close_pair(line_at<double>(Column<double>{{0, 1}}, Volumes::equal), 0));

    Points<2> x(2, 6);
    x << 0, 1, 0, 1, 0.001, 2,  //
        0, 0, 1, 1, 0, 0;
    const Cloud<2> cloud(x);
    for (const Index i : {0, 4})
        CHECK(close_pair(cloud, i)->advice().starts_with("particles 0 and 4 lie 0.001 apart, the next one "));
    CHECK_FALSE(close_pair(cloud, 3));
}

TEST_CASE("close_pair: without a particle, the distances to it become those to the next one") {
    const auto line = line_at<double>(Column<double>{{0, 0.3, 0.301, 0.6, 1}}, Volumes::equal);
    const Smoothing<> nearest(CubicSpline{}, spacing(line, Spacing::nearest), 2);
    const Line<> rest = without(line, 2);
    CHECK(rest.x().isApprox(Column<>{{0, 0.3, 0.6, 1}}, 0));
    const Smoothing<> left = without(nearest, line, rest, 2);
    CHECK(*left.ratio() == 2);
    for (Index j = 0; j < 4; ++j)
        CHECK(left.h(j) == doctest::Approx(2 * spacing(rest, Spacing::nearest)[j]).epsilon(1e-12));

    const Smoothing<> given(CubicSpline{}, Column<>{{0.1, 0.2, 0.3, 0.4, 0.5}});
    CHECK(without(given, line, rest, 2).h(3) == 0.5);
    CHECK(without(Smoothing<>(CubicSpline{}, 0.2), line, rest, 2).h(3) == 0.2);
}

TEST_CASE("close_pair: a refused neighbourhood names it, beside another smoothing length that serves") {
    const auto weights = [](const auto& near) {
        using Number = std::decay_t<decltype(near.W[0])>;
        const Column<Number> none = Column<Number>::Zero(near.W.size());
        return Derivatives<Number>{none, none};
    };
    Column<double> x = uniform_positions(21);
    x[10] = x[11] - 1e-6;
    const auto line = line_at<double>(x, Volumes::equal);
    const Smoothing<> nearest(CubicSpline{}, spacing(line, Spacing::nearest), 1.5);
    CHECK_THROWS_WITH_AS(
        static_cast<void>(assemble(line, nearest, {"any", 3}, weights)),
        doctest::Contains(
            "particle 10 (x = 0.549999) has 2 neighbours within 2h, needs 3; particles 10 and 11 lie 1e-06 apart, the next one 0.05; leave one of them out"),
        FailedComputation);

    // Lengths of their own would have to grow a thousandfold; one for all may help.
    const auto refusal = [&](const Smoothing<>& smoothing) {
        try {
            static_cast<void>(assemble(line, smoothing, {"any", 3}, weights));
        } catch (const FailedComputation& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal(nearest).ends_with("leave one of them out"));
    CHECK(refusal({CubicSpline{}, 0.02}).ends_with("needs 3; try h = 0.051"));

    // Where leaving one out does not help, it is not said.
    Column<double> h = Column<double>::Constant(21, 0.1);
    h[10] = h[11] = 1e-6;
    CHECK(refusal({CubicSpline{}, h}).find("leave one") == std::string::npos);

    Points<1> points(1, 21);
    for (Index i = 0; i < 21; ++i) points(0, i) = x[20 - i];
    const Cloud<1> cloud(points);
    const Smoothing<> in_cloud(CubicSpline{}, spacing(cloud, Spacing::nearest), 1.5);
    CHECK_THROWS_WITH_AS(static_cast<void>(assemble(cloud, in_cloud, {"any", 3}, weights)),
                         doctest::Contains("needs 3; particles 9 and 10 lie 1e-06 apart"), FailedComputation);
}
