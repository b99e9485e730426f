#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/errors.hpp"

namespace command_line {

/// What `read` returns, with the option in the message of what it refuses.
template <class Read>
decltype(auto) of_option(const std::string& option, const Read& read) {
    try {
        return read();
    } catch (const base::InvalidInput& error) {
        throw base::InvalidInput(option + ": " + error.what());
    }
}

/// A number as base::number() reads it. \throws base::InvalidInput naming the option
double number(const std::string& option, const std::string& text);

/// A whole number as base::whole_number() reads it. \throws base::InvalidInput naming the option
long whole_number(const std::string& option, const std::string& text);

/// The texts between marks.
std::vector<std::string> parts(const std::string& text, char between);

/// The names of a list such as strong,weak1. A comma may stand at the end, and blanks around each name.
/// \throws base::InvalidInput for an empty entry
std::vector<std::string> names(const std::string& option, const std::string& list);

/// The numbers of a list such as 3,3.5,4 or 2:0.1:4, a range from:step:to whose ends belong to it. Entries
/// may be mixed; a comma may stand at the end, and blanks around each number.
/// \param option the option that the list belongs to, for the message
/// \throws base::InvalidInput showing the entry that is neither a number nor a range of at most 10000 steps;
///         for a list with semicolons, how to write it
std::vector<double> numbers(const std::string& option, const std::string& list);

/// The same for whole numbers as whole_number() reads them.
std::vector<long> whole_numbers(const std::string& option, const std::string& list);

/// The pair of whole numbers of a text such as 16x4. \throws base::InvalidInput showing the text
std::array<long, 2> pair_of(const std::string& option, const std::string& text);

/// The names that an option asks for; "all" alone stands for all that are known.
/// \param what the names name, such as "formulation" \param beside names that are known, and that "all" leaves
///        out
/// \throws base::InvalidInput for a name that is not known, and for "all" beside another
std::vector<std::string> chosen(const std::string& what, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& known,
                                const std::vector<std::string>& beside = {});

/// Words separated by commas, such as those that a message lists.
std::string joined(const std::vector<std::string>& words);

}  // namespace command_line
