#include "bodies/approximation.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace bodies;

TEST_CASE("approximation: each method is that of its name, and other names are refused with the list") {
    for (const auto& [word, method] : methods()) {
        CHECK(name(method) == word);
        CHECK(method_named(word) == method);
    }
    CHECK_THROWS_WITH_AS(static_cast<void>(method_named("weak3")),
                         "there is no method 'weak3'; choose one of fpm, strong, weak1, weak2, hats",
                         base::InvalidInput);
}

TEST_CASE("approximation: hats need cells, and weak forms on discs the plane") {
    CHECK(works(Method::hats, 3, true));
    CHECK_FALSE(works(Method::hats, 2, false));
    for (const Method method : {Method::weak1, Method::weak2}) {
        CHECK(works(method, 2, false));
        CHECK_FALSE(works(method, 3, true));
    }
    for (const Method method : {Method::fpm, Method::strong}) CHECK(works(method, 3, false));
}
