#include "asprone2010/local_conditions.hpp"

#include "asprone2010/formulations.hpp"
#include "tests/support/lines.hpp"

using namespace asprone2010;
using support::relative;

TEST_CASE("local_conditions: the condition number is that of the singular values, of any matrix") {
    CHECK(local_conditions::condition(Eigen::Matrix2d{{-8, 0}, {0, 2}}) == relative(4, 1e-14));
    CHECK(local_conditions::condition(Eigen::Matrix2d{{2, 1}, {1, 2}}) == relative(3, 1e-14));
    const Eigen::MatrixXd A{{0, 2, 0}, {0, 0, -100}, {8, 0, 0}};
    CHECK(local_conditions::condition(A) == relative(50, 1e-14));
}

TEST_CASE("local_conditions: the moments of the constant kernel on three particles") {
    // M = [3 0; 0 2] and [3 0 2; 0 2 0; 2 0 2], whose eigenvalues are (5 ± √17)/2 and 2.
    particles::Neighbourhood<double> near{Column<double>(3), Column<double>::Ones(3), Column<double>::Zero(3),
                                          Column<double>::Ones(3)};
    near.r << -1, 0, 1;
    CHECK(local_conditions::condition_of_correction<0, 1>(near) == relative(1.5, 1e-14));
    CHECK(local_conditions::condition_of_correction<0, 1, 2>(near) ==
          relative((5 + std::sqrt(17.0)) / (5 - std::sqrt(17.0)), 1e-13));
}

TEST_CASE("local_conditions: each formulation has the systems that it solves") {
    const auto [line, smoothing] = support::particles_of(40);
    const auto near = particles::neighbourhood(line, smoothing, 20);
    const auto count = [&](std::string_view name) {
        const auto systems = local_conditions::systems(name, near);
        for (const auto& system : systems) CHECK(system.condition >= 1);
        return systems.size();
    };
    CHECK(count("original") == 0);
    CHECK(count("chen_beraun") == 0);
    CHECK(count("rkpm_first_order") == 1);
    CHECK(count("rkpm_second_order") == 1);
    CHECK(count("fpm") == 1);
    CHECK(count("modified_fpm") == 1);
    CHECK(count("second_order_fpm") == 2);
}
