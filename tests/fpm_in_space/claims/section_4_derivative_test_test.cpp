#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "report/read_table.hpp"
#include "tests/support/claims.hpp"

namespace {

/// What a claim measures, on the tables of the figures.
std::vector<report::Measurement> measured(const std::string& id) {
    static const auto all = fpm_in_space::claims::section_4();
    return all.at(id)(support::claim(id), 0);
}

}  // namespace

TEST_CASE(
    "claims on the quality number: it orders errors of derivatives with the size of the fourth derivatives") {
    const auto alone_and_with_size = measured("F-4-quality");
    REQUIRE(alone_and_with_size.size() == 2);
    CHECK(alone_and_with_size[0].value > 0);
    CHECK(alone_and_with_size[1].value > support::expected("F-4-quality"));
    CHECK(measured("F-4-quality-size").front().value > 0);
}

TEST_CASE(
    "claims on the quality number: the noise says more of a solution's error than R, which is alike on all layouts") {
    const double by_R = measured("F-4-quality-solution").front().value,
                 by_noise = measured("F-4-noise-solution").front().value;
    CHECK(std::abs(by_R) < by_noise / 2);
    const report::Table layouts = report::read_table("data/fpm_in_space/layouts.csv");
    std::vector<double> R;
    for (const auto& row : layouts.rows) R.push_back(std::get<double>(row[layouts.column("quality")]));
    const auto [least, most] = std::minmax_element(R.begin(), R.end());
    CHECK(*most < 1.5 * *least);
}
