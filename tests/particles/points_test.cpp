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
