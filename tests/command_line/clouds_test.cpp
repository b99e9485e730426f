#include "command_line/clouds.hpp"

#include <doctest/doctest.h>

#include <string>

#include "base/errors.hpp"
#include "tests/support/relative.hpp"

using namespace command_line;
using base::InvalidInput;

namespace {

/// Options that are complete.
CloudOptions completed(CloudOptions options = {}) {
    complete(options);
    return options;
}

/// The function typed has the derivatives of the one built in.
template <int dim>
void check_function() {
    CloudOptions options;
    options.dimension = dim;
    options.function = fpm_in_space::derivative_test::function_typed<dim>;
    const auto typed = function<dim>(completed(options));
    const particles::Point<dim> x = particles::Point<3>(0.3, 0.6, 0.9).head<dim>();
    for (const auto& a : particles::monomials<dim, 2>())
        CHECK(typed(x, a) ==
              support::relative(fpm_in_space::derivative_test::exponential_and_wave<dim>(x, a), 1e-12));
}

}  // namespace

TEST_CASE("clouds: a function of x, y and z has all derivatives up to the second") {
    check_function<2>();
    check_function<3>();
}

TEST_CASE("clouds: cases are drawn by seeds where another seed gives other particles") {
    CloudOptions options;
    options.perturbations = {0, 0.25};
    options.seeds = 3;
    options.seed = 7;
    options.layouts = {"grid", "graded-188-11"};
    const auto each = completed(options);
    CHECK(draws(each).size() ==
          3 + 3 * 3 + 3);  // three numbers of particles, uniform and drawn; three layouts
    options.median = true;
    const auto medians = completed(options);
    REQUIRE(draws(medians).size() == 3 + 3 + 1);
    CHECK(draws(medians)[0].seeds == 1);
    CHECK(draws(medians)[3].seeds == 3);
    CHECK(cases(draws(medians)).size() == cases(draws(each)).size());
    CHECK(cases(draws(medians)).back().seed == 9);
}

TEST_CASE("clouds: a sample takes so many particles of each place, and all of a place that has fewer") {
    CloudOptions options;
    options.sample = 10;
    const auto [cloud, places] = placed<2>(completed(options), {"grid", 0, 9, 1});
    CHECK(cloud.size() == 81);
    REQUIRE(places.size() == 3);
    CHECK(places[0].second.size() == 10);
    CHECK(places[2].first == "corner");
    CHECK(places[2].second.size() == 4);
}

TEST_CASE("clouds: the spacing of a stretched grid follows the particles, unless another one is asked for") {
    CloudOptions options;
    options.layouts = {"stretched-10"};
    const CloudCase one{"stretched-10", 0, 9, 1};
    CHECK(one.is_grid());
    const auto cloud = placed<2>(completed(options), one).cloud;
    const auto each = spacing<2>(completed(options), one, cloud);
    REQUIRE(each.size() == 81);
    // Neighbours along an axis lie between the distances that the map's slope gives at either end.
    CHECK(each.maxCoeff() / each.minCoeff() == support::relative(10, 1e-12));
    options.smoothing_from = "nearest";
    const auto nearest = spacing<2>(completed(options), one, cloud);
    CHECK((nearest == cloud.apart()).all());
}

TEST_CASE("clouds: what changes nothing, has no meaning or cannot be drawn is refused") {
    const auto check_refused = [](const std::string& reason, const auto& change) {
        CloudOptions options;
        change(options);
        try {
            complete(options);
            FAIL("accepted, not refused: " << reason);
        } catch (const InvalidInput& error) {
            CHECK(std::string(error.what()).find(reason) != std::string::npos);
        }
    };
    check_refused("--seeds changes nothing", [](CloudOptions& o) { o.seeds = 2; });
    check_refused("--seed changes nothing", [](CloudOptions& o) { o.seed = 2; });
    check_refused("--median changes nothing with --states",
                  [](CloudOptions& o) { o.median = o.states = true; });
    check_refused("--particles changes nothing without a grid", [](CloudOptions& o) {
        o.layouts = {"graded-188-11"};
        o.particles = {9};
    });
    check_refused("choose grid, stretched-G (such as stretched-4), or a file", [](CloudOptions& o) {
        o.dimension = 3;
        o.layouts = {"graded-188-11"};
    });
    check_refused("there is no layout 'gradet'", [](CloudOptions& o) { o.layouts = {"gradet"}; });
    check_refused("distances do not grow; take grid", [](CloudOptions& o) { o.layouts = {"stretched-1"}; });
    check_refused("'ten' is no number", [](CloudOptions& o) { o.layouts = {"stretched-ten"}; });
    check_refused("--cut must be positive, got -1", [](CloudOptions& o) { o.cut = "-1"; });
    check_refused("--smoothing must be positive", [](CloudOptions& o) { o.smoothing = 0; });
    check_refused("take one --formulation", [](CloudOptions& o) {
        o.states = true;
        o.figure.path = "states.svg";
    });
    check_refused("for a layout add --states", [](CloudOptions& o) {
        o.layouts = {"graded-188-11"};
        o.figure.path = "errors.svg";
    });
}
