#include "particles/on_values.hpp"

#include <doctest/doctest.h>

using namespace particles;

TEST_CASE("on_values: weights on differences become weights on values, whatever the own weight was") {
    Offsets<double, 2> w(4, 2);
    w << 1, 0.5,  //
        7, -3,    // the particle's own difference is zero
        -4, 2,    //
        2, 0.25;
    const Offsets<double, 2> on = on_values<double, 2>(w, 1);
    CHECK((on.row(1) == Eigen::Array2d(1, -2.75).transpose()).all());
    CHECK((on.colwise().sum() == 0).all());
    for (const base::Index j : {0, 2, 3}) CHECK((on.row(j) == w.row(j)).all());
    const Column<double> u{{0.3, 0.7, -1.1, 2.5}};
    for (const base::Index column : {0, 1}) {
        const double by_differences = (w.col(column) * (u - u[1])).sum();
        CHECK((on.col(column) * u).sum() == doctest::Approx(by_differences).epsilon(1e-14));
    }
}
