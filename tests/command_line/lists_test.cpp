#include "command_line/lists.hpp"

#include <doctest/doctest.h>

#include "base/errors.hpp"

using namespace command_line;

TEST_CASE("lists: lists are numbers and ranges, whose ends belong to them") {
    CHECK(numbers("--x", "3,3.5,4") == std::vector<double>{3, 3.5, 4});
    CHECK(numbers("--x", "2:0.1:2.3") == std::vector<double>{2, 2.1, 2.2, 2.3});
    CHECK(numbers("--x", "1e-13:1e-13:3e-13") == std::vector<double>{1e-13, 2e-13, 3e-13});
    CHECK(numbers("--x", "0.3:1e-15:0.300000000000001").front() == 0.3);
    CHECK(numbers("--x", "0.0014:1e6:1e6").front() == 0.0014);
    CHECK(numbers("--x", "1e-12:0.1:0.3").front() == 1e-12);
    CHECK(numbers("--x", "1,2:2:7") == std::vector<double>{1, 2, 4, 6});
    CHECK(whole_numbers("--x", "3:1:5") == std::vector<long>{3, 4, 5});
    for (const char* bad :
         {"", "a", "1:2", "1:-1:3", "3:1:2", "1:1e-9:2", "nan", "1e999", "1:2:3:4", "1,,2"}) {
        CAPTURE(bad);
        CHECK_THROWS_AS((void)numbers("--x", bad), base::InvalidInput);
    }
    CHECK_THROWS_AS((void)whole_numbers("--x", "2.5"), base::InvalidInput);
}

TEST_CASE("lists: blanks, a plus and a comma at the end are read, in numbers as in names") {
    CHECK(numbers("--x", " +1, 1.5D-3 ,2,") == std::vector<double>{1, 0.0015, 2});
    CHECK(numbers("--x", "1 : 1 : +3,") == std::vector<double>{1, 2, 3});
    CHECK(whole_numbers("--x", "21:1:23 , 30,") == std::vector<long>{21, 22, 23, 30});
    CHECK(names("--x", "strong, weak1,") == std::vector<std::string>{"strong", "weak1"});
    CHECK(pair_of("--x", " 16 x 4 ") == std::array<long, 2>{16, 4});
}

TEST_CASE("lists: what is refused is shown, with how to write it") {
    struct Case {
        const char *list, *message;
    };
    for (const auto& [list, message] : std::vector<Case>{
             {",0.3", "--x: ',0.3' has an empty entry; leave the comma beside it out"},
             {"1,,2", "--x: '1,,2' has an empty entry; leave the comma beside it out"},
             {",", "--x: ',' has an empty entry; leave the comma beside it out"},
             {"1,a", "--x: 'a' is no number"},
             {"1:2", "--x: '1:2' is no range from:step:to of at most 10000 steps"},
             {"1,1e400", "--x: '1e400' is larger than a double can be, 1.8e308"},
             {"0,5;0,7", "--x: '0,5;0,7' is separated by semicolons; write points and commas, 0.5,0.7"},
             {"1;2", "--x: '1;2' is separated by semicolons; write points and commas, 1,2"}}) {
        const std::string tried = list;
        CAPTURE(tried);
        CHECK_THROWS_WITH_AS((void)numbers("--x", list), message, base::InvalidInput);
    }
    CHECK_THROWS_WITH_AS((void)names("--x", "strong,,weak1"),
                         "--x: 'strong,,weak1' has an empty entry; leave the comma beside it out",
                         base::InvalidInput);
}

TEST_CASE("lists: parts are the texts between marks, empty ones too") {
    using Texts = std::vector<std::string>;
    CHECK(command_line::parts("0,1: 2 :", ':') == Texts{"0,1", " 2 ", ""});
    CHECK(command_line::parts("", ',') == Texts{""});
}

TEST_CASE("lists: a pair of whole numbers") {
    CHECK(pair_of("--x", "16x4") == std::array<long, 2>{16, 4});
    for (const char* bad : {"16", "16x", "x4", "16x4x2", "1.5x2", "1e9x2", "axb"}) {
        CAPTURE(bad);
        CHECK_THROWS_AS((void)pair_of("--x", bad), base::InvalidInput);
    }
}

TEST_CASE("lists: whole numbers are decimal") {
    CHECK(whole_numbers("--x", "1e3,0") == std::vector<long>{1000, 0});
    for (const char* bad : {"020", "0x20", "1e18", "40,020", "1:01:3"}) {
        CAPTURE(bad);
        CHECK_THROWS_AS((void)whole_numbers("--x", bad), base::InvalidInput);
    }
}

TEST_CASE("lists: all stands for every name that is known, and alone") {
    CHECK(chosen("colour", {"all"}, {"red", "blue"}) == std::vector<std::string>{"red", "blue"});
    CHECK(chosen("colour", {"blue", "blue"}, {"red", "blue"}) == std::vector<std::string>{"blue", "blue"});
    CHECK_THROWS_WITH_AS((void)chosen("colour", {"red", "pink"}, {"red", "blue"}),
                         "there is no colour 'pink'; choose one of all, red, blue", base::InvalidInput);
    CHECK_THROWS_WITH_AS((void)chosen("colour", {"all", "red"}, {"red", "blue"}),
                         "--colour all takes no other name beside it", base::InvalidInput);
}
