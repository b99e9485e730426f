#include "base/number.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"

TEST_CASE("number: a plus, blanks around it, any usual exponent, and subnormal numbers are read") {
    for (const auto& one : std::vector<std::pair<const char*, double>>{{"0.5", 0.5},
                                                                       {"+0.5", 0.5},
                                                                       {" \t0.5\r", 0.5},
                                                                       {".5", 0.5},
                                                                       {"5.", 5},
                                                                       {"-2e-1", -0.2},
                                                                       {"1.5D-3", 0.0015},
                                                                       {"1.5d+03", 1500},
                                                                       {"+1.d0", 1},
                                                                       {"1e-310", 1e-310},
                                                                       {"5e-324", 5e-324}}) {
        CAPTURE(one.first);
        CHECK(base::number(one.first) == one.second);
    }
}

TEST_CASE("number: what is none is refused with its reason and, where one is known, the remedy") {
    for (const auto& one : std::vector<std::pair<std::string, const char*>>{
             {"", "'' is no number"},
             {"abc", "'abc' is no number"},
             {"nan", "'nan' is no number"},
             {"inf", "'inf' is no number"},
             {"+-1", "'+-1' is no number"},
             {"++1", "'++1' is no number"},
             {"1 2", "'1 2' is no number"},
             {"1d", "'1d' is no number"},
             {"0x10", "'0x10' is no number"},
             {" 0.5m ", "'0.5m' is no number"},
             {"0,5", "'0,5' is no number; write a decimal comma as a point, 0.5"},
             {"-1,5D-3", "'-1,5D-3' is no number; write a decimal comma as a point, -1.5D-3"},
             {"0.5;0.7", "'0.5;0.7' is no number; write commas in place of semicolons"},
             {"\xE2\x88\x92"
              "1",
              "'???1' is no number; a long minus, say, is to be written as a hyphen"},
             {"1e400", "'1e400' is larger than a double can be, 1.8e308"},
             {"-1D400", "'-1D400' is larger than a double can be, 1.8e308"},
             {"1e-400", "'1e-400' is smaller than a double can be, 4.9e-324; write 0"},
             {std::string(400, '9'), "' is larger than a double can be, 1.8e308"}}) {
        CAPTURE(one.first);
        CHECK_THROWS_WITH_AS(static_cast<void>(base::number(one.first)), doctest::Contains(one.second),
                             base::InvalidInput);
    }
}

TEST_CASE("number: whole numbers are decimal and exact") {
    CHECK(base::whole_number("+20") == 20);
    CHECK(base::whole_number("-5") == -5);
    CHECK(base::whole_number(" 1e3 ") == 1000);
    CHECK(base::whole_number("0") == 0);
    for (const auto& one : std::vector<std::pair<const char*, const char*>>{
             {"020", "'020' begins with 0; write it in decimal"},
             {"+020", "'+020' begins with 0; write it in decimal"},
             {"0x20", "'0x20' begins with 0; write it in decimal"},
             {"2.5", "'2.5' is no whole number up to 1e15"},
             {"1e18", "'1e18' is no whole number up to 1e15"},
             {"20,5", "'20,5' is no number; write a decimal comma as a point, 20.5"}}) {
        CAPTURE(one.first);
        CHECK_THROWS_WITH_AS(static_cast<void>(base::whole_number(one.first)), doctest::Contains(one.second),
                             base::InvalidInput);
    }
}
