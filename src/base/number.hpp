#pragma once

#include <string>
#include <string_view>

namespace base {

/// The text without the blanks around it.
std::string_view trimmed(std::string_view text);

/// A text as messages show it: on one line, 40 characters at most.
std::string quoted(std::string_view text);

/// A number as people and programs write it: blanks around it, a plus before it, and the exponent of Fortran,
/// 1.5D-3, are read too. Numbers in options, lists and files are read by this function.
/// \throws InvalidInput with the text and the reason, and where it is known, how to write it: for a decimal
///         comma, a semicolon, a character beyond ASCII, a number outside the range of double
double number(std::string_view text);

/// The same for a whole number up to 10¹⁵, such as 1e3, or up to what a shorter long holds.
/// \throws InvalidInput also for 010, which others read as octal
long whole_number(std::string_view text);

}  // namespace base
