#include "programs/positions.hpp"

#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <vector>

#include "particles/errors.hpp"
#include "report/file.hpp"

namespace programs {

using particles::InvalidInput;

namespace {

/// The first entry of a line, without a comment and the blanks around it.
std::string_view first_entry(std::string_view line) {
    line = line.substr(0, line.find_first_of("#,"));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// A name, and not what stands for no number or an infinite one.
bool starts_header(std::string_view entry) {
    double number = 0;
    if (std::from_chars(entry.data(), entry.data() + entry.size(), number).ptr == entry.data() + entry.size())
        return false;
    const char letter = entry.front();
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_' ||
           letter == '"';
}

/// The entry as a message shows it: in one line, not too long.
std::string quoted(std::string_view entry) {
    std::string text(entry.substr(0, 40));
    for (char& letter : text)
        if (letter < ' ' || letter > '~') letter = '?';
    return "'" + text + "'";
}

}  // namespace

particles::Column<double> read_positions(const std::string& path) {
    const std::string text = report::read_whole(path);
    std::vector<double> x;
    bool header = false;
    long number = 0;
    const auto refuse = [&](std::string_view entry, const std::string& why) {
        throw InvalidInput("--positions: " + path + ", line " + std::to_string(number) + ": " +
                           quoted(entry) + " " + why);
    };

    std::string_view rest = text, last;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // the mark that some editors write first
    long last_number = 0;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        ++number;
        const std::string_view entry = first_entry(line);
        if (entry.empty()) {
            if (line.find(',') < line.find('#')) refuse(entry, "is no position");
            continue;
        }
        if (x.empty() && !header && starts_header(entry)) {
            header = true;
            continue;
        }
        double value = 0;
        const auto [stop, error] = std::from_chars(entry.data(), entry.data() + entry.size(), value);
        if (error != std::errc() || stop != entry.data() + entry.size() || !std::isfinite(value))
            refuse(entry, "is no position");
        if (x.empty() && value != 0) refuse(entry, "is the first position; it must be 0");
        if (!x.empty() && !(value > x.back()))
            refuse(entry, "does not lie beyond the position before it, " + std::string(last) + "; sort them");
        if (value > 1) refuse(entry, "lies beyond 1; scale the positions to [0, 1]");
        x.push_back(value);
        last = entry;
        last_number = number;
    }
    if (x.empty()) throw InvalidInput("--positions: " + path + " holds no position");
    number = last_number;
    if (x.back() != 1) refuse(last, "is the last position; it must be 1");
    return Eigen::Map<particles::Column<double>>(x.data(), static_cast<particles::Index>(x.size()));
}

}  // namespace programs
