#include "tests/programs/run.hpp"

using programs::run;

TEST_CASE("compare_tables: equal tables pass, a number beyond its tolerance fails and is named") {
    const programs::Folder folder;
    const std::string a = folder.path + "/a.csv", b = folder.path + "/b.csv";
    const std::string head = "# tolerance of error: relative 0.01, absolute 0\nname,error\n";
    report::write_whole(a, head + "first,1\n");
    report::write_whole(b, head + "first,1.005\n");
    const auto close = run("compare_tables " + a + " " + b);
    CHECK(close.code == 0);
    CHECK(close.output.ends_with(
        "1 rows, all within tolerance; largest change in row 1, error, by 0.005, 50 % of its tolerance\n"));
    CHECK(run("compare_tables " + a + " " + a).output.ends_with("no number moved\n"));
    report::write_whole(b, head + "first,1.05\n");
    const auto [code, output, errors] = run("compare_tables " + a + " " + b);
    CHECK(code == 1);
    CHECK(output.find("row 1 (first), error: 1 != 1.05") != std::string::npos);
    report::write_whole(b, "name,error\nfirst,1\n");
    CHECK(run("compare_tables " + a + " " + b).output.starts_with(a + ": the tolerance of error\n"));
    programs::check_refused("compare_tables " + a, 2, "regenerated");
    programs::check_refused("compare_tables " + a + " /nowhere", 1, "cannot read /nowhere");
}
