#include "report/table.hpp"
#include "tests/programs/run.hpp"

using programs::run;

TEST_CASE("claims: a claim without a computation is red, and so is a computation without a claim") {
    const programs::Folder folder;
    const std::string ledger = folder.path + "/claims.csv";
    const std::string head = "id,section,equations,claim,quantity,relation,expected,tolerance,reason,test\n";
    const std::string known = "A21,5.3,,a claim,a quantity,<,1e-12,0,a reason,a test\n";
    report::write_whole(ledger, head + "Z99,1,,a claim,a quantity,=,1,0,a reason,a test\n");
    programs::check_refused("claims --ledger " + ledger, 1, "claim Z99 has no computation that decides it");
    report::write_whole(ledger, head + known);
    programs::check_refused("claims --ledger " + ledger, 1, "every computation needs its row");
    programs::check_refused("claims --ledger " + folder.path + "/missing.csv", 1, "cannot read");
    programs::check_refused("claims --nonsense", 2, "--nonsense");
}

TEST_CASE("claims: the count of verdicts is read from the table") {
    const programs::Folder folder;
    const std::string table = folder.path + "/verdicts.csv";
    report::write_whole(
        table, "id,verdict\na,reproduced\nb,differs\nc,holds only if x\nd,reproduced\ne,cannot tell\n");
    CHECK(run("claims --count " + table).output ==
          "5 claims: 2 reproduced, 1 hold under a condition, 1 differ, 1 cannot tell\n");
}
