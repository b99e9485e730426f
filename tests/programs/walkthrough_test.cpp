#include "tests/programs/run.hpp"

using programs::run;

namespace {

/// Runs walkthrough in a copy of the project in which a shell command has changed something.
programs::Outcome in_changed_copy(const std::string& change, const std::string& options) {
    const programs::Folder folder;
    const std::string copy =
        "cp -r paper src tests data README.md '" + folder.path + "' && cd '" + folder.path + "' && ";
    return run("sh -c \"" + copy + change + " && walkthrough " + options + "\"");
}

}  // namespace

TEST_CASE("walkthrough: every equation is indexed, and pages are written for equations, claims and tests") {
    const auto [code, output, errors] = in_changed_copy(
        "true", "--pages pages && grep -c '^| .*anchor index_A' pages/equations.md && ls pages");
    CHECK(code == 0);
    CHECK(errors.empty());
    CHECK(
        output ==
        "52 equations indexed, 0 without code or test\n52\nchoices.md\nclaims.md\nequations.md\ntests.md\n");
}

TEST_CASE("walkthrough: an equation without code, without test, or without a row is red") {
    const auto without_code =
        in_changed_copy("sed -i 's/.defeq{A16}//' src/asprone2010/section_3_2_chen_beraun.hpp", "");
    CHECK(without_code.code == 1);
    CHECK(without_code.errors.find("equation A16 must stand once above its code in src/asprone2010/") !=
          std::string::npos);
    const auto without_test =
        in_changed_copy("sed -i 's/(16)/sixteen/' tests/asprone2010/section_3_2_chen_beraun_test.cpp", "");
    CHECK(without_test.code == 1);
    CHECK(without_test.errors.find("equation A16 is named by no test case") != std::string::npos);
    const auto without_row = in_changed_copy("sed -i '/^A16,/d' paper/equations.csv", "");
    CHECK(without_row.code == 1);
    CHECK(without_row.errors.find("equation A16 of src/asprone2010/") != std::string::npos);
    CHECK(without_row.errors.find("has no row") != std::string::npos);
}

TEST_CASE("walkthrough: a claim without a verdict is red") {
    const auto [code, output, errors] =
        in_changed_copy("sed -i '/^A16,/d' data/asprone2010/claims.csv", "--pages pages");
    CHECK(code == 1);
    CHECK(errors.find("has no verdict yet; run make claims") != std::string::npos);
}

TEST_CASE("walkthrough: a stale table in the README is found, and written anew") {
    const std::string stale = "sed -i 's/ reproduced/ refuted/' README.md";
    CHECK(in_changed_copy("true", "--check-readme").code == 0);
    const auto found = in_changed_copy(stale, "--check-readme");
    CHECK(found.code == 1);
    CHECK(found.errors.find("the table of README.md is stale; run make claims") != std::string::npos);
    CHECK(in_changed_copy(stale, "--write-readme && walkthrough --check-readme").code == 0);
}
