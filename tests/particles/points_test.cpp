#include "particles/points.hpp"

#include <doctest/doctest.h>

#include <type_traits>

using namespace particles;

TEST_CASE("points: a point is shown by its coordinates") {
    CHECK(shown_point(Point<3>(1, -0.5, 2e-7)) == "(1, -0.5, 2e-07)");
    CHECK(shown_point(Point<1>(0.1)) == "(0.1)");
}

TEST_CASE("points: offsets on a line are a column, those of a Pack lie on the stack") {
    static_assert(std::is_same_v<Offsets<double>, Column<double>>);
    static_assert(Offsets<double, 2>::MaxRowsAtCompileTime == Eigen::Dynamic);
    static_assert(Column<Pack>::MaxRowsAtCompileTime == most_in_pack);
    CHECK(Offsets<double, 3>(7, 3).size() == 21);
}

TEST_CASE("points: squared lengths are those of each row, to the last bit") {
    const Offsets<double, 3> s = Offsets<double, 3>::Random(101, 3);
    const Column<double> q = squared_lengths(s);
    for (Index k = 0; k < s.rows(); ++k) CHECK(q[k] == Point<3>(s.row(k).matrix().transpose()).squaredNorm());
}
