#include "particles/multi_index.hpp"

#include <doctest/doctest.h>
#include <algorithm>

using namespace particles;

TEST_CASE("multi-index: the monomials of the plane and of space, pure powers of a degree first") {
    constexpr auto line = monomials<1, 3>();
    CHECK(line == std::array<Exponents<1>, 4>{{{0}, {1}, {2}, {3}}});
    constexpr auto plane = monomials<2, 3>();
    CHECK(plane == std::array<Exponents<2>, 10>{
                       {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {0, 2}, {1, 1}, {3, 0}, {0, 3}, {2, 1}, {1, 2}}});
    constexpr auto space = monomials<3, 2>();
    CHECK(space == std::array<Exponents<3>, 10>{{{0, 0, 0},
                                                 {1, 0, 0},
                                                 {0, 1, 0},
                                                 {0, 0, 1},
                                                 {2, 0, 0},
                                                 {0, 2, 0},
                                                 {0, 0, 2},
                                                 {1, 1, 0},
                                                 {0, 1, 1},
                                                 {1, 0, 1}}});
}

TEST_CASE("multi-index: each monomial up to the degree stands once, in the order of degrees") {
    constexpr auto all = monomials<3, 6>();
    CHECK(all.size() == 84);
    for (std::size_t k = 0; k < all.size(); ++k) {
        CHECK(order<3>(all[k]) <= 6);
        if (k > 0) CHECK(order<3>(all[k]) >= order<3>(all[k - 1]));
        CHECK(std::count(all.begin(), all.end(), all[k]) == 1);
    }
}

TEST_CASE("multi-index: a! is the product of the factorials") {
    CHECK(factorial<1>({4}) == 24);
    CHECK(factorial<2>({3, 2}) == 12);
    CHECK(factorial<3>({0, 1, 3}) == 6);
}
