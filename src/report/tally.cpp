#include "report/tally.hpp"

namespace report {

Tally tally(const std::vector<std::string>& verdicts) {
    Tally count;
    for (const std::string& verdict : verdicts)
        ++(verdict == "reproduced"          ? count.reproduced
           : verdict == "by definition"     ? count.definitions
           : verdict == "cannot tell"       ? count.undecided
           : verdict.starts_with("differs") ? count.differ
                                            : count.conditional);
    return count;
}

Tally tally(const Table& verdicts) {
    std::vector<std::string> all;
    for (std::size_t row = 0; row < verdicts.rows.size(); ++row) all.push_back(verdicts.word(row, "verdict"));
    return tally(all);
}

Tally tally(const Table& verdicts, const std::string& section) {
    std::vector<std::string> some;
    for (std::size_t row = 0; row < verdicts.rows.size(); ++row)
        if (verdicts.word(row, "section") == section) some.push_back(verdicts.word(row, "verdict"));
    return tally(some);
}

Tally operator+(const Tally& one, const Tally& other) {
    return {one.reproduced + other.reproduced, one.conditional + other.conditional, one.differ + other.differ,
            one.undecided + other.undecided, one.definitions + other.definitions};
}

std::string in_full(const Tally& tally) {
    return std::to_string(tally.claims()) + " claims: " + std::to_string(tally.reproduced) + " reproduced, " +
           std::to_string(tally.conditional) + " hold under a condition, " + std::to_string(tally.differ) +
           " differ, " + std::to_string(tally.undecided) + " cannot tell, " +
           std::to_string(tally.definitions) + " by definition";
}

std::string in_brief(const Tally& tally) {
    const auto& [reproduced, conditional, differ, undecided, definitions] = tally;
    if (tally.claims() + definitions == 0) return "";
    std::string text = std::to_string(reproduced) + " of " + std::to_string(tally.claims()) + " reproduced";
    if (conditional > 0) text += ", " + std::to_string(conditional) + " under a condition";
    if (differ > 0) text += ", " + std::to_string(differ) + (differ == 1 ? " differs" : " differ");
    if (undecided > 0) text += ", " + std::to_string(undecided) + " undecided";
    if (definitions > 0) text += ", " + std::to_string(definitions) + " by definition";
    return text;
}

std::string in_a_sentence(const Tally& tally, bool own) {
    const auto& [reproduced, conditional, differ, undecided, definitions] = tally;
    const std::string count = std::to_string(tally.claims());
    return (own ? "Of the " + count + " statements of our own text, "
                : "Of the papers' " + count + " testable statements, ") +
           std::to_string(reproduced) + (reproduced == 1 ? " is" : " are") + " reproduced, " +
           std::to_string(conditional) + (conditional == 1 ? " holds" : " hold") +
           " under a condition, and " + std::to_string(differ) + (differ == 1 ? " differs" : " differ") +
           (undecided > 0 ? "; " + std::to_string(undecided) + " could not be decided" : "") +
           (definitions > 0 ? "; " + std::to_string(definitions) + " more hold by definition." : ".");
}

}  // namespace report
