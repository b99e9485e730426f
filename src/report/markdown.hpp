#pragma once

#include <string>
#include <vector>

namespace report {

/// A text with every occurrence of a part replaced.
std::string replaced(std::string text, const std::string& part, const std::string& with);

/// A row of a Markdown table: "| a | b |" and a line break.
std::string row(const std::vector<std::string>& cells);

/// The head of a Markdown table: the row of names and the row of dashes.
std::string head(const std::vector<std::string>& names);

/// Text for a cell of a Markdown table in Doxygen: nothing in it counts as markup.
std::string escaped(std::string text);

/// A measured number as a page shows it: an order to a thousandth, so that a zero reads as a zero, and any
/// other as it is written.
/// \param quantity in words: "order of D²B at an end" \param number empty, or as text
std::string measured(const std::string& quantity, const std::string& number);

/// A text with the part between its two marks replaced: the line "<!-- the KEY below is written by make
/// claims -->", and "<!-- end of the KEY -->". \param where the text's file, for the message
/// \throws base::FailedComputation where a mark is missing
std::string with_part(const std::string& text, const std::string& key, const std::string& part,
                      const std::string& where);

}  // namespace report
