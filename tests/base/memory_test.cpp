#include "base/memory.hpp"

#include <sys/resource.h>

#include "base/errors.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/sanitizers.hpp"

using namespace base;
using programs::run;

TEST_CASE("room: what fits is let pass, what does not is refused with both sizes and a remedy") {
    CHECK(available_memory() > 1e8);
    CHECK_NOTHROW(require_memory("3 particles", 1000, "take fewer"));
    CHECK_THROWS_WITH_AS(require_memory("many particles", 1e18, "take fewer"),
                         doctest::Contains("many particles take at least 1e+09 GB of memory, there are "),
                         base::InvalidInput);
    CHECK_THROWS_WITH_AS(require_memory("many particles", 1e18, "take fewer"),
                         doctest::Contains("; take fewer"), base::InvalidInput);
    CHECK_THROWS_WITH_AS(
        require_memory_of_entries("3 particles", 3e9, 1, "take fewer"),
        "3 particles make a matrix of 3e+09 entries, which holds at most 2147483647; take fewer",
        base::InvalidInput);
}

// A sanitizer reserves more addresses than a limit would leave it.
constexpr bool sanitized = support::addresses_are_watched || support::threads_are_watched;

TEST_CASE("room: a limit of the shell counts" * doctest::skip(sanitized)) {
    const auto limited =
        run("{ ulimit -v 600000; derivative_test --smoothing 40 --particles 300000 --threads 1; }");
    CHECK(limited.code == 2);
    CHECK(limited.errors.find("there are 0.614 GB; take fewer particles") != std::string::npos);
}
