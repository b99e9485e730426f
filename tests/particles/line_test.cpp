#include "particles/line.hpp"

#include <doctest/doctest.h>

#include <limits>
#include "tests/support/relative.hpp"

using namespace particles;

namespace {

Column<double> column(std::initializer_list<double> numbers) {
    Column<double> x(static_cast<Index>(numbers.size()));
    std::copy(numbers.begin(), numbers.end(), x.begin());
    return x;
}
Line<double> at(std::initializer_list<double> positions) {
    return line_at<double>(column(positions), Volumes::equal);
}

}  // namespace

TEST_CASE("line: uniform positions carry both ends and equal distances") {
    const auto x = uniform_positions<double>(11);
    CHECK(x[0] == 0);
    CHECK(x[10] == 1);
    for (Index j = 0; j < 10; ++j) CHECK(x[j + 1] - x[j] == support::relative(0.1, 1e-14));
}

TEST_CASE("line: perturbed positions stay in order, near their place, and the ends stay") {
    const Index N = 1000;
    const double delta = 1.0 / (N - 1), a = 0.25;
    const Column<double> uniform = uniform_positions<double>(N);
    const Column<double> x = perturbed_positions<double>(N, a, 7);
    CHECK(x[0] == 0);
    CHECK(x[N - 1] == 1);
    const Column<double> moved = (x - uniform) / delta;
    CHECK(moved.abs().maxCoeff() <= a * (1 + 1e-9));
    CHECK(moved.abs().maxCoeff() > 0.99 * a);
    CHECK(std::abs(moved.mean()) < 0.02);
    CHECK(moved.square().mean() == support::relative(a * a / 3, 0.1));
    CHECK_NOTHROW(line_at<double>(x, Volumes::partition));
}

TEST_CASE("line: a seed determines the positions") {
    CHECK((perturbed_positions<double>(50, 0.25, 3) == perturbed_positions<double>(50, 0.25, 3)).all());
    CHECK((perturbed_positions<double>(50, 0.25, 3) != perturbed_positions<double>(50, 0.25, 4)).any());
    CHECK((perturbed_positions<double>(50, 0, 3) == uniform_positions<double>(50)).all());
}

TEST_CASE(
    "line: equal volumes are the mean spacing; those of the partition are cells that add up to the length") {
    const auto x = column({0, 0.3, 0.4, 1});
    const auto equal = line_at<double>(x, Volumes::equal);
    for (Index j = 0; j < 4; ++j) CHECK(equal.V()[j] == 1.0 / 3);
    const auto partition = line_at<double>(x, Volumes::partition);
    CHECK(partition.V()[0] == support::relative(0.15, 1e-15));
    CHECK(partition.V()[1] == support::relative(0.2, 1e-15));
    CHECK(partition.V()[2] == support::relative(0.35, 1e-15));
    CHECK(partition.V()[3] == support::relative(0.3, 1e-15));
    CHECK(partition.V().sum() == support::relative(partition.length(), 1e-15));
}

TEST_CASE("line: names of volume conventions") {
    for (const Volumes volumes : {Volumes::equal, Volumes::partition})
        CHECK(volumes_named(name(volumes)) == volumes);
    CHECK_THROWS_WITH_AS(volumes_named("half"),
                         "there is no volume convention 'half'; choose one of equal, partition",
                         InvalidInput);
}

TEST_CASE("line: what is no line is refused with the particle's number") {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(at({}), "a line needs at least 2 particles, got 0", InvalidInput);
    CHECK_THROWS_WITH_AS(at({0.5}), "a line needs at least 2 particles, got 1", InvalidInput);
    CHECK_THROWS_WITH_AS(at({0, nan, 1}), "particle 1 is not at a finite position", InvalidInput);
    CHECK_THROWS_WITH_AS(at({0, 0.5, inf}), "particle 2 is not at a finite position", InvalidInput);
    CHECK_THROWS_WITH_AS(at({0, 0.5, 0.5, 1}), "particle 2 coincides with the particle before it (x = 0.5)",
                         InvalidInput);
    CHECK_THROWS_WITH_AS(at({0, 0.5, 0.25, 1}),
                         "particle 2 lies before its predecessor; sort the positions (x = 0.25)",
                         InvalidInput);
    CHECK_THROWS_WITH_AS(Line<double>(column({0, 1}), column({0.5, -0.5})),
                         "particle 1 has a volume that is negative or not finite", InvalidInput);
    CHECK_THROWS_WITH_AS(Line<double>(column({0, 1}), column({nan, 0.5})),
                         "particle 0 has a volume that is negative or not finite", InvalidInput);
    CHECK_THROWS_WITH_AS(Line<double>(column({0, 1}), column({0.5})),
                         "2 particles need as many volumes, got 1", InvalidInput);
    CHECK_THROWS_AS(uniform_positions<double>(1), InvalidInput);
    CHECK_THROWS_AS(uniform_positions<double>(-5), InvalidInput);
    for (const double a : {-0.1, 0.5, 2.0, nan})
        CHECK_THROWS_AS(perturbed_positions<double>(10, a, 1), InvalidInput);
}
