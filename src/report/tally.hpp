#pragma once

#include <string>
#include <vector>

#include "report/table.hpp"

namespace report {

/// How many claims have which verdict. What holds by definition is counted apart, for it tests nothing.
struct Tally {
    int reproduced = 0, conditional = 0, differ = 0, undecided = 0, definitions = 0;
    [[nodiscard]] int claims() const { return reproduced + conditional + differ + undecided; }
};

/// The tally of some verdicts, each as decided() says it.
Tally tally(const std::vector<std::string>& verdicts);

/// The tally of a table of verdicts, data/asprone2010/claims.csv.
Tally tally(const Table& verdicts);

/// The tally of a section's claims in such a table.
Tally tally(const Table& verdicts, const std::string& section);

/// In all: claims of several papers together.
Tally operator+(const Tally& one, const Tally& other);

/// "74 claims: 66 reproduced, 3 hold under a condition, 5 differ, 0 cannot tell, 3 by definition"
std::string in_full(const Tally& tally);

/// "5 of 7 reproduced, 1 under a condition, 1 differs", where there are claims
std::string in_brief(const Tally& tally);

/// "Of the papers' 171 testable statements, 135 are reproduced, 21 hold under a condition, and 15 differ."
/// \param own whether they are "the 171 statements of our own text"
std::string in_a_sentence(const Tally& tally, bool own = false);

}  // namespace report
