#include <string>
#include <vector>

#include "tests/programs/run.hpp"

using namespace programs;

TEST_CASE("remedies: what a refusal names works when it is followed") {
    struct Refused {
        const char *program, *arguments, *refused, *reason, *remedied;
    };
    const char* const along_y = "take at least 4 layers of particles along x2: ";
    const std::vector<Refused> all{
        {"plate", "--method fpm ", "--particles 16x3", along_y, "--particles 16x4"},
        {"plate", "--method strong --degree 3 --scaling 4 ", "--particles 16x3", along_y, "--particles 16x4"},
        {"static_test_in_space", "--formulation definite_fpm --dimension 3 ", "--particles 3",
         "take at least 4 layers of particles along x1, x2, x3: ", "--particles 4"},
        {"static_test_in_space", "--formulation definite_fpm ", "--particles 3",
         "take at least 4 layers of particles along x1, x2: ", "--particles 4"},
        {"vibration_test_in_space", "--formulation cubic_ssph --dimension 3 ", "--particles 3",
         "take at least 4 layers of particles along x1, x2, x3: ", "--particles 4"},
        {"derivative_test_in_space", "--formulation definite_fpm --layout polar-5x5 ", "",
         "try --smoothing 1.3", "--smoothing 1.3"},
        {"derivative_test_in_space", "--formulation definite_fpm --particles 16 --smoothing-from local ",
         "--smoothing 0.3", "try --smoothing 0.63", "--smoothing 0.63"},
        {"static_test_in_space", "--formulation definite_fpm --particles 16 --smoothing-from local ",
         "--smoothing 0.3", "try --smoothing 0.63", "--smoothing 0.63"},
        {"plate", "--method fpm ", "--smoothing 0.5", "try --smoothing 0.86", "--smoothing 0.86"}};
    for (const auto& [program, arguments, refused, reason, remedied] : all) {
        const std::string command = std::string(program) + " " + arguments;
        check_refused(command + refused, 1, reason);
        const auto [code, output, errors] = run(command + remedied);
        CHECK(code == 0);
        CHECK(errors.empty());
        CHECK_FALSE(has_non_finite_cell(output));
    }
}
