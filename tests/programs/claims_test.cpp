#include "tests/programs/run.hpp"

using programs::run;

TEST_CASE("claims: a claim without a computation is red, and so is a computation without a claim") {
    const programs::Folder folder;
    const std::string ledger = folder.path + "/claims.csv";
    const std::string head =
        "id,old_id,section,equations,kind,claim,quantity,relation,expected,tolerance,reason,test\n";
    const std::string known = "A-5.3-end-conditions,A21,5.3,,,a claim,a quantity,<,1e-12,0,a reason,a test\n";
    report::write_whole(ledger, head + "A-1-none,,1,,,a claim,a quantity,=,1,0,a reason,a test\n");
    programs::check_refused("claims --ledger " + ledger, 1,
                            "claim A-1-none has no computation that decides it");
    report::write_whole(ledger, head + known);
    programs::check_refused("claims --ledger " + ledger, 1, "every computation needs its row");
    report::write_whole(ledger, head + known + "Z-1-none,,1,,,a claim,a quantity,=,1,0,a reason,a test\n");
    programs::check_refused("claims --ledger " + ledger, 1, "Z-1-none belongs to no paper");
    programs::check_refused("claims --paper nonsense", 2, "there is no paper 'nonsense'");
    programs::check_refused("claims --ledger " + folder.path + "/missing.csv", 1, "cannot read");
    programs::check_refused("claims --nonsense", 2, "--nonsense");
}

TEST_CASE("claims: the count of verdicts is read from the table, and of several with their papers") {
    const programs::Folder folder;
    const std::string first = folder.path + "/first/claims.csv", second = folder.path + "/second/claims.csv";
    for (const std::string& table : {first, second})
        std::filesystem::create_directory(std::filesystem::path(table).parent_path());
    report::write_whole(
        first, "id,verdict\na,reproduced\nb,differs\nc,holds only if x\nd,reproduced\ne,cannot tell\n");
    report::write_whole(second, "id,verdict\na,reproduced\n");
    const std::string of_first =
        "5 claims: 2 reproduced, 1 hold under a condition, 1 differ, 1 cannot tell, 0 by definition\n";
    CHECK(run("claims --count " + first).output == of_first);
    CHECK(
        run("claims --count " + first + " " + second).output ==
        "first: " + of_first +
            "second: 1 claims: 1 reproduced, 0 hold under a condition, 0 differ, 0 cannot tell, 0 by definition\n");
}
