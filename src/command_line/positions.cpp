#include "command_line/positions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
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
    if (word.empty() ||
        std::from_chars(word.data(), word.data() + word.size(), number).ptr == word.data() + word.size())
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

/// The entries of a line: between commas if it has any, else between blanks.
std::vector<std::string_view> entries(std::string_view line) {
    const bool commas = line.find(',') != std::string_view::npos;
    std::vector<std::string_view> found;
    while (true) {
        const std::size_t end = std::min(line.find_first_of(commas ? "," : " \t"), line.size());
        found.push_back(trimmed(line.substr(0, end)));
        if (end == line.size()) return found;
        line = commas ? line.substr(end + 1) : trimmed(line.substr(end));
    }
}

/// A line that is neither blank nor a comment.
struct Line {
    long number;
    std::string_view text;  ///< without comment, and without blanks at its ends
};

/// A text without blank lines and comments.
struct Lines {
    std::string_view header;  ///< empty if there is none
    std::vector<Line> lines;
};

Lines lines_of(std::string_view text) {
    Lines found;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark of some editors
    for (long number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view content = trimmed(line.substr(0, line.find('#')));
        if (content.empty()) continue;
        if (found.header.empty() && found.lines.empty() && starts_header(content))
            found.header = content;
        else
            found.lines.push_back({number, content});
    }
    return found;
}

/// The place of a column, from 0, by its name in the header; nothing where there is none.
std::optional<std::size_t> place_named(std::string_view column, std::string_view header) {
    const std::vector<std::string_view> names = entries(header);
    for (std::size_t place = 0; place < names.size(); ++place)
        if (names[place] == column || names[place] == "\"" + std::string(column) + "\"") return place;
    return {};
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
    for (const Line& line : lines_of(text).lines) {
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
    }
    if (x.empty()) throw InvalidInput("--positions: " + path + " holds no position");
    if (x.back() != 1) refuse(last, before, "is the last position; it must be 1");
    return Eigen::Map<particles::Column<double>>(x.data(), static_cast<particles::Index>(x.size()));
}

particles::Points<2> read_points(const std::string& path) {
    const Refusal refuse{"--layout", path};
    const std::string text = report::read_whole(path);
    std::vector<double> x;
    const auto [header, lines] = lines_of(text);
    std::size_t columns = 2, first = 0, second = 1;
    for (const auto& [name, other] : {std::pair{"x1", "x2"}, std::pair{"x", "y"}})
        if (const auto named = place_named(name, header), named_other = place_named(other, header);
            named && named_other) {
            columns = entries(header).size();
            first = *named;
            second = *named_other;
        }
    for (const Line& line : lines) {
        const std::vector<std::string_view> all = entries(line.text);
        if (all.size() != columns)
            refuse(line, line.text,
                   columns == 2 ? "is not two numbers"
                                : "has " + std::to_string(all.size()) + " columns, the header " +
                                      std::to_string(columns));
        for (const std::size_t place : {first, second}) x.push_back(number_in(line, all[place], refuse));
    }
    return Eigen::Map<particles::Points<2>>(x.data(), 2, static_cast<particles::Index>(x.size() / 2));
}

namespace {

/// The place of a column, from 0, by its name in the header or by its number, from 1.
/// \return nothing where there is none
std::optional<std::size_t> place_of(std::string_view column, std::string_view header) {
    if (const auto named = place_named(column, header)) return named;
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(column.data(), column.data() + column.size(), number);
    if (error != std::errc() || stop != column.data() + column.size() || number == 0) return {};
    return number - 1;
}

/// The smoothing lengths in a column of a file; in a file of one column, if it is empty.
particles::Column<double> lengths_in(const std::string& path, const std::string& column) {
    const Refusal refuse{"--smoothing-from", path};
    const std::string content = report::read_whole(path);
    const auto [header, lines] = lines_of(content);
    if (lines.empty()) throw InvalidInput("--smoothing-from: " + path + " holds no number");
    const std::optional<std::size_t> place = column.empty() ? 0 : place_of(column, header);
    if (!place)
        throw InvalidInput("--smoothing-from: " + path + " has no column '" + column + "'" +
                           (header.empty() ? "; it has no header, take a number from 1"
                                           : "; its header is " + quoted(header)));
    particles::Column<double> lengths(static_cast<particles::Index>(lines.size()));
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const Line& line = lines[k];
        const std::vector<std::string_view> all = entries(line.text);
        if (column.empty() && all.size() > 1)
            refuse(line, line.text,
                   "has " + std::to_string(all.size()) + " columns; name one, such as " + path + ":2");
        if (*place >= all.size()) refuse(line, line.text, "has no column " + std::to_string(*place + 1));
        const double length = number_in(line, all[*place], refuse);
        if (!(length > 0)) refuse(line, all[*place], "is not positive");
        lengths[static_cast<particles::Index>(k)] = length;
    }
    return lengths;
}

bool is_file(const std::string& path) {
    std::error_code none;
    return std::filesystem::exists(path, none) && !std::filesystem::is_directory(path, none);
}

}  // namespace

NamedFile named_file(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || is_file(text)) return {text, ""};
    return {text.substr(0, colon), text.substr(colon + 1)};
}

particles::Spacing spacing_from(const std::string& text) {
    std::string_view word = trimmed(text);
    if (word.starts_with('+')) word.remove_prefix(1);
    double number = 0;
    if (!word.empty() &&
        std::from_chars(word.data(), word.data() + word.size(), number).ptr == word.data() + word.size()) {
        if (!(std::isfinite(number) && number > 0))
            throw InvalidInput("--smoothing-from must be positive and finite, got " + text);
        return particles::Spacing(number);
    }
    const auto [path, column] = named_file(text);
    const bool is_path =
        path.find('/') != std::string::npos || (path.find('.') != std::string::npos && starts_header(path));
    try {
        return particles::spacing_named(word);
    } catch (const InvalidInput& unknown) {
        if (is_path || is_file(path)) return particles::Spacing(lengths_in(path, column));
        throw InvalidInput("--smoothing-from: " + std::string(unknown.what()) + ", a length, or a file");
    }
}

void check_lengths(const particles::Spacing& spacing, const std::string& text, particles::Index N) {
    const particles::Index count = spacing.lengths.size();
    if (spacing.kind == particles::Spacing::given && count != 1 && count != N)
        throw InvalidInput("--smoothing-from " + text + " has " + std::to_string(count) + " numbers, for " +
                           std::to_string(N) + " particles");
}

}  // namespace command_line
