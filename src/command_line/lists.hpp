#pragma once

#include <array>
#include <string>
#include <vector>

namespace command_line {

/// The names of a list such as strong,weak1.
std::vector<std::string> names(const std::string& list);

/// The numbers of a list such as 3,3.5,4 or 2:0.1:4, a range from:step:to whose ends belong to it. Parts may
/// be mixed.
/// \param option the option that the list belongs to, for the message
/// \throws base::InvalidInput showing the part that is neither a number nor a range of at most 10000 steps
std::vector<double> numbers(const std::string& option, const std::string& list);

/// The same for whole numbers up to 10¹⁵. \throws base::InvalidInput also for a number that begins with 0, as
/// in 010
std::vector<long> whole_numbers(const std::string& option, const std::string& list);

/// The pair of whole numbers of a text such as 16x4. \throws base::InvalidInput showing the text
std::array<long, 2> pair_of(const std::string& option, const std::string& text);

/// The names that an option asks for; "all" alone stands for all that are known.
/// \param what the names name, such as "formulation"
/// \throws base::InvalidInput for a name that is not known, and for "all" beside another
std::vector<std::string> chosen(const std::string& what, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& known);

/// Words separated by commas, such as those that a message lists.
std::string joined(const std::vector<std::string>& words);

}  // namespace command_line
