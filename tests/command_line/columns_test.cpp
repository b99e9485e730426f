#include "command_line/columns.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "tests/support/folder.hpp"

using command_line::Columns;

namespace {

/// The same text in UTF-16, for letters of ASCII. \param first whether the zero byte comes first
std::string utf_16(const std::string& text, bool first) {
    std::string wide;
    for (const char letter : text) wide += first ? std::string{'\0', letter} : std::string{letter, '\0'};
    return wide;
}

}  // namespace

TEST_CASE("columns: separated by commas or blanks, found by name or number, and one comma may end a line") {
    const support::Folder folder;
    const std::string path = folder.path + "/a.csv";
    for (const char* text : {"a,b\n1,2\n3,4\n", "a b\n1 2\n3\t4", "\"a\", \"b\",\n+1, 2 ,\n\n3,4D0, # end\n",
                             "\357\273\277a,b\r\n1,2\r\n3,4\r\n", "a,b\r1,2\r3,4\r",
                             "\"a\",\"b\"\n\"1\",\"2\"\n\"3\",\"4\"\n"}) {
        CAPTURE(text);
        report::write_whole(path, text);
        const Columns file("--option", path);
        REQUIRE(file.rows().size() == 2);
        CHECK(file.names().size() == 2);
        CHECK(file.place_of("b") == 1);
        CHECK(file.place_of("2") == 1);
        CHECK(!file.place_named("c"));
        CHECK(file.number(file.rows()[0], 0) == 1);
        CHECK(file.number(file.rows()[1], 1) == 4);
    }
}

TEST_CASE("columns: one that counts the rows is recognised") {
    const support::Folder folder;
    const std::string path = folder.path + "/a.csv";
    for (const auto& [text, counts] : std::vector<std::pair<const char*, bool>>{{"0 5\n1 5\n2 5\n", true},
                                                                                {"1,5\n2,5\n3,5\n", true},
                                                                                {"2 5\n3 5\n", false},
                                                                                {"0\n0.5\n", false}}) {
        report::write_whole(path, text);
        const Columns file("--option", path);
        CHECK(file.counts_rows(0) == counts);
        CHECK(!file.counts_rows(1));
    }
}

TEST_CASE("columns: one that counts the rows needs no name in the header") {
    const support::Folder folder;
    const std::string path = folder.path + "/a.csv";
    for (const char* text : {",a,b\n0,1,2\n1,3,4\n", "\"\",a,b\n1,1,2\n2,3,4\n", "a b\n0 1 2\n1 3 4\n",
                             "\"a\" \"b\"\n\"1\" 1 2\n\"2\" 3 4\n"}) {
        CAPTURE(text);
        report::write_whole(path, text);
        const Columns file("--option", path);
        REQUIRE(file.rows().size() == 2);
        CHECK(file.names().size() == 3);
        CHECK(file.place_of("a") == 1);
        CHECK(file.place_of("b") == 2);
        CHECK(file.number(file.rows()[1], 2) == 4);
    }
}

TEST_CASE("columns: a first line of numbers in quotes, or with a number that is missing, is no header") {
    const support::Folder folder;
    const std::string path = folder.path + "/a.csv";
    report::write_whole(path, "\"1\",\"2\"\n\"3\",\"4\"\n");
    CHECK(Columns("--option", path).rows().size() == 2);
    for (const std::string first : {"NA,0.3", "x 0.3"}) {
        report::write_whole(path, first + (first[1] == 'A' ? "\n0.1,0.3\n" : "\n0.1 0.3\n"));
        CHECK_THROWS_WITH_AS(
            Columns("--option", path),
            doctest::Contains(
                ("line 1: '" + first + "' has a name and a number; correct it, or put # before it").c_str()),
            base::InvalidInput);
    }
    report::write_whole(path, "layout 1 of two\n0.1 0.3\n");
    CHECK(Columns("--option", path).rows().size() == 1);
}

TEST_CASE("columns: another encoding, decimal commas and semicolons are named, each with what to do") {
    const support::Folder folder;
    const std::string path = folder.path + "/a.csv", text = "0 1\n1 2\n";
    for (
        const auto& [content, reason] : std::vector<std::pair<std::string, std::string>>{
            {"\xFF\xFE" + utf_16(text, false),
             "a.csv is UTF-16; convert it, iconv -f UTF-16 -t UTF-8 " + path},
            {"\xFE\xFF" + utf_16(text, true),
             "a.csv is UTF-16; convert it, iconv -f UTF-16 -t UTF-8 " + path},
            {utf_16(text, true), "a.csv is UTF-16; convert it, iconv -f UTF-16BE -t UTF-8 " + path},
            {utf_16(text, false), "a.csv is UTF-16; convert it, iconv -f UTF-16LE -t UTF-8 " + path},
            {std::string("\xFF\xFE\0\0"
                         "0\0\0\0",
                         8),
             "a.csv is UTF-32; convert it, iconv -f UTF-32 -t UTF-8 " + path},
            {"0,5, 0,7\n", "has decimal commas; write points, sed 's/, / /g; s/,/./g' " + path},
            {"1 2\n0,5 0,7\n", "line 2: '0,5 0,7' has decimal commas; write points, sed 's/,/./g' " + path},
            {"0,5\t-0,7\n", "has decimal commas; write points, sed 's/,/./g' " + path},
            {"x;y\n0,5;0,7\n",
             "line 2: '0,5;0,7' has decimal commas and semicolons; write points and commas, sed 's/,/./g; s/;/,/g' " +
                 path},
            {"0.5;0.7\n", "line 1: '0.5;0.7' has semicolons; write commas, sed 's/;/,/g' " + path}}) {
        report::write_whole(path, content);
        CHECK_THROWS_WITH_AS(Columns("--option", path), doctest::Contains(reason.c_str()),
                             base::InvalidInput);
    }
    report::write_whole(path, "% a comment\n0 1\n");
    const Columns file("--option", path);
    CHECK_THROWS_WITH_AS(static_cast<void>(file.number(file.rows()[0], 0)),
                         doctest::Contains("line 1: '%' is no number; a comment begins with #"),
                         base::InvalidInput);
    CHECK_THROWS_WITH_AS(Columns("--option", "/nowhere"),
                         "--option: cannot read /nowhere: No such file or directory", base::InvalidInput);
}
