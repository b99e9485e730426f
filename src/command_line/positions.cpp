#include "command_line/positions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/errors.hpp"
#include "report/file.hpp"

namespace command_line {

using base::InvalidInput;

namespace {

/// The text without the blanks around it.
std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Whether a line begins with a name. nan and inf are no names.
bool starts_header(std::string_view line) {
    const std::string_view word = line.substr(0, line.find_first_of(", \t"));
    double number = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), number).ptr == word.data() + word.size())
        return false;
    const char letter = word.front();
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_' ||
           letter == '"';
}

/// An entry as messages show it: on one line, 40 characters at most.
std::string quoted(std::string_view entry) {
    std::string text(entry.substr(0, 40));
    for (char& letter : text)
        if (letter < ' ' || letter > '~') letter = '?';
    return "'" + text + "'";
}

/// A line that is neither blank nor a comment.
struct Line {
    long number;
    std::string_view text;  ///< without comment, and without blanks at its ends
};

/// Calls `act` for each line of a text, except blank lines, comments and a header.
template <class Act>
void for_each_line(std::string_view text, const Act& act) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark of some editors
    bool first = true;
    for (long number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view content = trimmed(line.substr(0, line.find('#')));
        if (content.empty()) continue;
        if (!first || !starts_header(content)) act(Line{number, content});
        first = false;
    }
}

/// Throws an error that names the option, the file, the line and the entry.
struct Refusal {
    std::string option, path;
    [[noreturn]] void operator()(const Line& line, std::string_view entry, const std::string& why) const {
        throw InvalidInput(option + ": " + path + ", line " + std::to_string(line.number) + ": " +
                           quoted(entry) + " " + why);
    }
};

double number_in(const Line& line, std::string_view entry, const Refusal& refuse) {
    double value = 0;
    const auto [stop, error] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
    if (error != std::errc() || stop != entry.data() + entry.size() || !std::isfinite(value))
        refuse(line, entry, "is no number");
    return value;
}

}  // namespace

particles::Column<double> read_positions(const std::string& path) {
    const Refusal refuse{"--positions", path};
    const std::string text = report::read_whole(path);
    std::vector<double> x;
    Line last{};
    std::string_view before;
    for_each_line(text, [&](const Line& line) {
        const std::string_view entry = trimmed(line.text.substr(0, line.text.find(',')));
        const double value = number_in(line, entry, refuse);
        if (x.empty() && value != 0) refuse(line, entry, "is the first position; it must be 0");
        if (!x.empty() && !(value > x.back()))
            refuse(line, entry,
                   "does not lie beyond the position before it, " + std::string(before) + "; sort them");
        if (value > 1) refuse(line, entry, "lies beyond 1; scale the positions to [0, 1]");
        x.push_back(value);
        last = line;
        before = entry;
    });
    if (x.empty()) throw InvalidInput("--positions: " + path + " holds no position");
    if (x.back() != 1) refuse(last, before, "is the last position; it must be 1");
    return Eigen::Map<particles::Column<double>>(x.data(), static_cast<particles::Index>(x.size()));
}

particles::Points<2> read_points(const std::string& path) {
    const Refusal refuse{"--layout", path};
    const std::string text = report::read_whole(path);
    std::vector<double> x;
    for_each_line(text, [&](const Line& line) {
        const char* const between = line.text.find(',') == std::string_view::npos ? " \t" : ",";
        const std::size_t first = line.text.find_first_of(between);
        if (first == std::string_view::npos) refuse(line, line.text, "is not two numbers");
        const std::string_view second = trimmed(line.text.substr(first + 1));
        if (second.find_first_of(between) != std::string_view::npos)
            refuse(line, line.text, "is not two numbers");
        x.push_back(number_in(line, trimmed(line.text.substr(0, first)), refuse));
        x.push_back(number_in(line, second, refuse));
    });
    return Eigen::Map<particles::Points<2>>(x.data(), 2, static_cast<particles::Index>(x.size() / 2));
}

particles::Spacing spacing_from(const std::string& text) {
    double number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number).ptr == text.data() + text.size()) {
        if (!(std::isfinite(number) && number > 0))
            throw InvalidInput("--smoothing-from must be positive and finite, got " + text);
        return particles::Spacing(number);
    }
    if (text.find_first_of("./") == std::string::npos) return particles::spacing_named(text);
    const Refusal refuse{"--smoothing-from", text};
    const std::string content = report::read_whole(text);
    std::vector<double> lengths;
    for_each_line(content, [&](const Line& line) {
        lengths.push_back(number_in(line, line.text, refuse));
        if (!(lengths.back() > 0)) refuse(line, line.text, "is not positive");
    });
    if (lengths.empty()) throw InvalidInput("--smoothing-from: " + text + " holds no number");
    return particles::Spacing(particles::Column<double>(Eigen::Map<particles::Column<double>>(
        lengths.data(), static_cast<particles::Index>(lengths.size()))));
}

}  // namespace command_line
