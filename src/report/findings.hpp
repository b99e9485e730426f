#pragma once

#include <string>
#include <vector>

#include "report/walkthrough.hpp"

namespace report {

/// A text with numbers from the verdicts in the place of what stands between braces:
///
/// | between braces | becomes |
/// | --- | --- |
/// | `A-5.1-perturbed` | what was measured for this claim, under the first convention |
/// | `A-5.1-perturbed conditional` | the same with the condition of its verdict |
/// | `A-5.1-perturbed verdict` | its verdict |
/// | `count B-4.1-table-1` | "all 6", if all claims whose ids begin so are reproduced; else "5 of 6" |
/// | `verdicts` | the verdicts on all papers in one sentence |
/// | `own verdicts` | those on texts of our own |
///
/// \throws base::FailedComputation for a claim that no paper has, and for an empty number
std::string with_numbers(const std::string& text, const std::vector<Reproduction>& all);

}  // namespace report
