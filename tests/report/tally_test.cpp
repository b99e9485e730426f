#include "report/tally.hpp"

#include <doctest/doctest.h>

using namespace report;

TEST_CASE("tally: verdicts are counted, in all or of a section, and said in three ways") {
    const Table verdicts = parsed_words(
        "id,section,verdict\na,2,reproduced\nb,2,differs\nc,2.1,holds only if x\nd,2.1,reproduced\n"
        "e,3,cannot tell\nf,4,by definition\ng,5,\"differs, also if x\"\n");
    CHECK(tally(verdicts).claims() == 6);
    CHECK(in_full(tally(verdicts)) ==
          "6 claims: 2 reproduced, 1 hold under a condition, 2 differ, 1 cannot tell, 1 by definition");
    CHECK(in_full(tally(verdicts) + tally({"reproduced"})) ==
          "7 claims: 3 reproduced, 1 hold under a condition, 2 differ, 1 cannot tell, 1 by definition");
    CHECK(in_brief(tally(verdicts, "2")) == "1 of 2 reproduced, 1 differs");
    CHECK(in_brief(tally(verdicts, "2.1")) == "1 of 2 reproduced, 1 under a condition");
    CHECK(in_brief(tally(verdicts, "3")) == "0 of 1 reproduced, 1 undecided");
    CHECK(in_brief(tally(verdicts, "4")) == "0 of 0 reproduced, 1 by definition");
    CHECK(in_brief(tally(verdicts, "6")).empty());
    CHECK(in_brief(tally({"differs", "differs"})) == "0 of 2 reproduced, 2 differ");
    CHECK(
        in_a_sentence({9, 2, 1, 0}) ==
        "Of the papers' 12 testable statements, 9 are reproduced, 2 hold under a condition, and 1 differs.");
    CHECK(
        in_a_sentence({9, 2, 4, 1}) ==
        "Of the papers' 16 testable statements, 9 are reproduced, 2 hold under a condition, and 4 differ; 1 could not be decided.");
    CHECK(
        in_a_sentence({9, 2, 1, 0, 3}) ==
        "Of the papers' 12 testable statements, 9 are reproduced, 2 hold under a condition, and 1 differs; 3 more hold by definition.");
    CHECK(in_a_sentence({9, 2, 1, 0}, true) ==
          "Of the 12 statements of our own text, 9 are reproduced, 2 hold under a condition, and 1 differs.");
}
