#include "particles/banded_rows.hpp"

#include <algorithm>
#include <mutex>

#include "tests/support/lines.hpp"

using namespace particles;
using asprone2010::formulations;
using support::particles_of;

TEST_CASE(
    "banded rows: the product is that of dense matrices, for rows of any length and bands of two widths") {
    for (const double smoothing : {0.7, 1.0, 4.0, 9.0})
        for (const auto from : {Spacing::mean, Spacing::local})
            for (const Index N : {9, 64, 65, 211}) {
                const auto wide = particles_of(N, {Volumes::equal, Gaussian{}, smoothing, 0.4, from});
                const auto narrow = particles_of(N, {Volumes::equal, CubicSpline{}, 1.3, 0.4});
                const auto A = formulations<double>()[0].operators(wide.line, wide.smoothing).D;
                const auto B = formulations<double>()[0].operators(narrow.line, narrow.smoothing).D;
                for (const auto* first : {&A, &B})
                    for (const auto* second : {&A, &B}) {
                        const Eigen::MatrixXd a(*first), b(*second), ab = a * b;
                        CHECK((Eigen::MatrixXd(banded::product(*first, *second)) - ab).cwiseAbs().maxCoeff() <
                              1e-13 * ab.cwiseAbs().maxCoeff());
                    }
            }
}

TEST_CASE("banded rows: a pack needs neighbours on the line, and no more than its columns hold") {
    std::vector<Range> near(200);
    for (Index i = 0; i < 200; ++i)
        near[static_cast<std::size_t>(i)] = {std::max<Index>(i - 3, 0), std::min<Index>(i + 5, 200)};
    const auto sides_of = [&](Index i) { return banded::sides_of_pack(near.data() + i, i, 200); };
    const auto inside = sides_of(96);
    REQUIRE(inside.has_value());
    CHECK(inside->left == 3);
    CHECK(inside->right == 4);
    CHECK(sides_of(3).has_value());
    CHECK(sides_of(200 - 4 - Pack::lanes).has_value());
    CHECK_FALSE(sides_of(200 - 3 - Pack::lanes).has_value());
    CHECK_FALSE(sides_of(200 - Pack::lanes + 1).has_value());
    near[97] = {97 - 30, 97 + 1 + 33};
    CHECK(sides_of(96).has_value());
    near[97] = {97 - 30, 97 + 60};
    CHECK_FALSE(sides_of(96).has_value());
}

TEST_CASE("banded rows: each pack of a block is tried once, and its rows alone where it fails") {
    const Index N = 19 * Pack::lanes + 1;
    std::vector<int> together(static_cast<std::size_t>(N)), alone = together;
    banded::for_each_block({0, N}, N, [&](const Range& block) {
        banded::for_each_pack(
            block, {0, N},
            [&](Index i) {
                ++together[static_cast<std::size_t>(i)];
                return i / Pack::lanes % 2 == 0;
            },
            [&](Index i) { ++alone[static_cast<std::size_t>(i)]; });
    });
    for (Index i = 0; i < N; ++i) {
        CHECK(together[static_cast<std::size_t>(i)] == (i % Pack::lanes == 0 ? 1 : 0));
        CHECK(alone[static_cast<std::size_t>(i)] == (i / Pack::lanes % 2 == 0 ? 0 : 1));
    }
}

TEST_CASE("banded rows: of some rows, whole packs are tried, and only the rows themselves alone") {
    constexpr Index lanes = Pack::lanes;
    const Range rows{lanes + 1, 3 * lanes + 1};
    std::vector<Index> tried, alone;
    std::mutex one_at_a_time;
    banded::for_each_block(rows, 10 * lanes, [&](const Range& block) {
        CHECK(block.first % lanes == 0);
        banded::for_each_pack(
            block, rows,
            [&](Index i) {
                const std::lock_guard lock(one_at_a_time);
                tried.push_back(i);
                return false;
            },
            [&](Index i) {
                const std::lock_guard lock(one_at_a_time);
                alone.push_back(i);
            });
    });
    std::sort(tried.begin(), tried.end());
    std::sort(alone.begin(), alone.end());
    CHECK(tried == std::vector<Index>{lanes, 2 * lanes, 3 * lanes});
    REQUIRE(static_cast<Index>(alone.size()) == rows.size());
    CHECK(alone.front() == rows.first);
    CHECK(alone.back() == rows.last - 1);
}

TEST_CASE(
    "banded rows: of many entries a few more are kept, which fill large pages, and no more than a page") {
    for (const Index entries : {0, 1, 1000, 200000}) CHECK(banded::in_large_pages(entries) == entries);
    for (const Index entries : {300000, 524272, 524273, 12000000}) {
        const Index kept = banded::in_large_pages(entries);
        CHECK(kept >= entries);
        CHECK(kept - entries < 524288);
        CHECK((kept + 16) * 4 % (1 << 21) == 0);
    }
}

TEST_CASE(
    "banded rows: the diagonal entry and differences, of consecutive columns and of others, compressed or not") {
    Operator<double> D(3, 5);
    D.insert(0, 0) = 2;
    D.insert(0, 1) = 3;
    D.insert(1, 0) = 5;
    D.insert(1, 4) = 7;
    const Column<double> B = Column<double>::LinSpaced(5, 1, 16).square();
    for (const bool compressed : {false, true}) {
        if (compressed) D.makeCompressed();
        CHECK(banded::diagonal_entry(D, 0) == 2);
        CHECK(banded::diagonal_entry(D, 1) == 0);
        CHECK(banded::diagonal_entry(D, 2) == 0);
        CHECK(banded::on_differences(D, 0, B.data()) == 3 * (B[1] - B[0]));
        CHECK(banded::on_differences(D, 1, B.data()) == 5 * (B[0] - B[1]) + 7 * (B[4] - B[1]));
        CHECK(banded::on_differences(D, 2, B.data()) == 0);
    }
}
