#include "report/findings.hpp"

#include "base/errors.hpp"
#include "report/markdown.hpp"
#include "report/tally.hpp"

namespace report {

namespace {

/// The cell of a claim in a column of its verdicts; "measured" stands for that of the first convention.
std::string number(const std::string& id, const std::string& column, const std::vector<Reproduction>& all) {
    for (const Reproduction& reproduction : all)
        for (std::size_t row = 0; row < reproduction.verdicts.rows.size(); ++row)
            if (reproduction.verdicts.word(row, "id") == id) {
                const std::string name =
                    column == "measured" ? "measured_" + reproduction.paper.conventions.one.name : column;
                if (const std::string found = reproduction.verdicts.word(row, name); !found.empty())
                    return measured(reproduction.verdicts.word(row, "quantity"), found);
            }
    throw base::FailedComputation("the findings name " + id + ", of which the verdicts have no " + column +
                                  " number");
}

/// How many of the claims that begin alike are reproduced.
std::string count(const std::string& beginning, const std::vector<Reproduction>& all) {
    int claims = 0, reproduced = 0;
    for (const Reproduction& reproduction : all)
        for (std::size_t row = 0; row < reproduction.verdicts.rows.size(); ++row)
            if (reproduction.verdicts.word(row, "id").starts_with(beginning)) {
                ++claims;
                if (reproduction.verdicts.word(row, "verdict") == "reproduced") ++reproduced;
            }
    if (claims == 0)
        throw base::FailedComputation("the findings count " + beginning + ", and no claim begins so");
    return (claims == reproduced ? "all" : std::to_string(reproduced) + " of") + " " + std::to_string(claims);
}

std::string value(const std::string& of, const std::vector<Reproduction>& all) {
    if (of == "verdicts" || of == "own verdicts") {
        const std::string words = sentence(all, of == "own verdicts");
        return words.substr(0, words.find('\n'));
    }
    const std::size_t blank = of.find(' ');
    if (blank == std::string::npos) return number(of, "measured", all);
    const std::string first = of.substr(0, blank), second = of.substr(blank + 1);
    return first == "count" ? count(second, all) : number(first, second, all);
}

}  // namespace

std::string with_numbers(const std::string& text, const std::vector<Reproduction>& all) {
    std::string filled;
    std::size_t at = 0;
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', at)) {
        const std::size_t close = text.find('}', open);
        filled += text.substr(at, open - at) + value(text.substr(open + 1, close - open - 1), all);
        at = close + 1;
    }
    return filled + text.substr(at);
}

}  // namespace report
