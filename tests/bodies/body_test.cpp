#include "bodies/body.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace bodies;

namespace {

/// A body with sides of these names.
Body<2> body_with_sides(const std::vector<std::string>& names) {
    Body<2> body;
    for (const std::string& name : names) body.sides.push_back({name, {}, {}});
    return body;
}

void check_unknown(const Body<2>& body, const std::string& name, const std::string& message) {
    CHECK_THROWS_WITH_AS(static_cast<void>(side_named(body, name)), message.c_str(), base::InvalidInput);
}

}  // namespace

TEST_CASE("body: a side is found by its name, and other names are refused with those that there are") {
    const Body<2> body = body_with_sides({"wall", "", "tip"});
    CHECK(&side_named(body, "wall") == body.sides.data());
    CHECK(&side_named(body, "tip") == &body.sides[2]);
    check_unknown(body, "lid", "the body has no side 'lid'; its sides are wall, tip");
    check_unknown(body, "", "the body has no side ''; its sides are wall, tip");
    check_unknown(body_with_sides({""}), "lid",
                  "the body has no side 'lid'; name its sides, as by Physical Curve in a drawing");
}
