#include "command_line/layouts.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "tests/support/folder.hpp"

using command_line::Layouts;

namespace {

const particles::QuarterWithHole shape;

}  // namespace

TEST_CASE("layouts: names give counts of particles; another draw gives another graded layout only") {
    const Layouts layouts({"graded-188-11", "polar-11x17"}, {}, 0, 4);
    const auto graded = layouts.around(shape, "graded-188-11", 1);
    CHECK(graded.x.cols() == 188);
    CHECK(graded.drawn);
    CHECK(graded.x != layouts.around(shape, "graded-188-11", 2).x);
    const auto polar = layouts.around(shape, "polar-11x17", 1);
    CHECK(polar.x.cols() == 11 * 17);
    CHECK_FALSE(polar.drawn);
    CHECK(polar.x == layouts.around(shape, "polar-11x17", 2).x);
}

TEST_CASE("layouts: the particles of a file stay in place, or are moved onto the boundary as is said") {
    const support::Folder folder;
    const std::string file = folder.path + "/quarter.csv";
    report::write_whole(file, "x1,x2\n0.3,0\n3,0\n2.999999,1\n3,3\n0,3\n");
    const auto as_given = Layouts({file}, {}, 0, 4).around(shape, file, 1);
    CHECK(as_given.x(0, 2) == 2.999999);
    CHECK(as_given.about.empty());
    const auto moved = Layouts({file}, {"x1", "x2"}, 1e-5, 4).around(shape, file, 1);
    CHECK(moved.x(0, 2) == 3);
    CHECK(moved.about == file + ": 1 particles moved onto the boundary, by 1e-06 m at most");
}

TEST_CASE(
    "layouts: a name that is not known, another unit, columns without a file, and no distance are refused") {
    const support::Folder folder;
    const std::string file = folder.path + "/quarter.csv";
    report::write_whole(file, "300 0\n3000 0\n3000 3000\n");
    const auto refuses = [](const std::vector<std::string>& names, const std::vector<std::string>& columns,
                            double snap, const std::string& reason) {
        CHECK_THROWS_WITH_AS(Layouts(names, columns, snap, 4), doctest::Contains(reason.c_str()),
                             base::InvalidInput);
    };
    refuses({"graded-188"}, {}, 0,
            "there is no layout 'graded-188'; choose graded-N-A, polar-AxR, or a file");
    refuses({"polar-1234567x3"}, {}, 0, "there is no layout");
    refuses({file}, {}, 0, "reaches to 3000, as the quarter does in mm; write its positions in m");
    refuses({"polar-11x17"}, {"x", "y"}, 0, "--columns belongs to a --layout FILE");
    refuses({"polar-11x17"}, {}, -1, "--snap must be a distance, got -1");
    CHECK_THROWS_AS(Layouts({"polar-99999x99999"}, {}, 0, 4).around(shape, "polar-99999x99999", 1),
                    base::InvalidInput);
}
