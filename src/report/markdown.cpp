#include "report/markdown.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace report {

std::string replaced(std::string text, const std::string& part, const std::string& with) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + with.size()))
        text.replace(at, part.size(), with);
    return text;
}

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
}

std::string head(const std::vector<std::string>& names) {
    return row(names) + row(std::vector<std::string>(names.size(), "---"));
}

std::string escaped(std::string text) {
    for (const char* mark : {"\\", "|", "#", "@", "*", "_", "<", ">"})
        text = replaced(text, mark, std::string("\\") + mark);
    return text;
}

std::string with_part(const std::string& text, const std::string& key, const std::string& part,
                      const std::string& where) {
    const std::string first = "<!-- the " + key + " below is written by make claims -->\n",
                      last = "<!-- end of the " + key + " -->";
    const std::size_t from = text.find(first), to = text.find(last);
    if (from == std::string::npos || to == std::string::npos)
        throw base::FailedComputation(where + " has lost the marks of the " + key);
    return text.substr(0, from + first.size()) + part + text.substr(to);
}

std::string measured(const std::string& quantity, const std::string& number) {
    if (!quantity.starts_with("order") || number.empty()) return number;
    return base::shown(std::round(1000 * base::number(number)) / 1000 + 0.0);  // no minus zero
}

}  // namespace report
