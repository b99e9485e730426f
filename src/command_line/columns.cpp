#include "command_line/columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <system_error>
#include <utility>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "report/file.hpp"

namespace command_line {

using base::InvalidInput;
using base::quoted;
using base::trimmed;

namespace {

constexpr std::string_view blanks = " \t";

std::string read(const std::string& option, const std::string& path) {
    try {
        return report::read_whole(path);
    } catch (const base::FailedComputation& error) {
        throw InvalidInput(option + ": " + error.what());
    }
}

/// What stands between the separators of a text, without blanks around it.
std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> found;
    while (true) {
        const std::size_t end = std::min(text.find_first_of(separators), text.size());
        found.push_back(trimmed(text.substr(0, end)));
        if (end == text.size()) return found;
        text = separators == blanks ? trimmed(text.substr(end)) : text.substr(end + 1);
    }
}

/// Whether a text is a number with a decimal comma, or two whole numbers: 0,25.
bool has_decimal_comma(std::string_view text) {
    const std::size_t comma = text.find(',');
    const auto digits = [](std::string_view part) {
        return !part.empty() &&
               std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    };
    const std::size_t sign = text.find_first_not_of("+-");
    return comma != std::string_view::npos && sign < comma && digits(text.substr(sign, comma - sign)) &&
           digits(text.substr(comma + 1));
}

/// What stands between the quotes of a text, if it has any.
std::string_view unquoted(std::string_view text) {
    const bool quotes = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return quotes ? trimmed(text.substr(1, text.size() - 2)) : text;
}

bool is_number(std::string_view text) {
    double number = 0;
    return !text.empty() &&
           std::from_chars(text.data(), text.data() + text.size(), number).ptr == text.data() + text.size();
}

}  // namespace

bool starts_with_name(std::string_view line) {
    const std::size_t first = std::min(line.find_first_not_of(",; \t"), line.size());
    const std::string_view rest = line.substr(first), word = rest.substr(0, rest.find_first_of(",; \t"));
    if (word.empty() || is_number(unquoted(word))) return false;
    const auto letter = static_cast<unsigned char>(word.front());
    return std::isalpha(letter) != 0 || letter == '_' || letter == '"';
}

std::vector<std::string_view> Columns::Row::entries() const {
    const bool commas = text.find(',') != std::string_view::npos;
    std::vector<std::string_view> found = split(text, commas ? "," : blanks);
    if (commas && found.back().empty()) found.pop_back();
    return found;
}

Columns::Columns(std::string option, std::string path)
    : option_(std::move(option)), path_(std::move(path)), text_(read(option_, path_)) {
    check_encoding();
    std::string_view text = text_;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark of some editors
    const char end_of_line = text.find('\n') == std::string_view::npos ? '\r' : '\n';
    for (long number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find(end_of_line), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const Row row{number, trimmed(line.substr(0, line.find('#')))};
        if (row.text.empty()) continue;
        if (header_.empty() && rows_.empty() && starts_with_name(row.text)) {
            header_ = row.text;
            header_line_ = number;
            continue;
        }
        check_separators(row);
        rows_.push_back(row);
    }
    check_header();
}

void Columns::check_encoding() const {
    const std::string_view begin = std::string_view(text_).substr(0, 64);
    std::array<std::size_t, 2> zeros{};  // at even and at odd places
    for (std::size_t k = 0; k < begin.size(); ++k) zeros[k % 2] += begin[k] == '\0' ? 1 : 0;
    if (begin.starts_with(std::string_view("\xFF\xFE\0\0", 4)) ||
        begin.starts_with(std::string_view("\0\0\xFE\xFF", 4)))
        refuse(" is UTF-32; convert it, iconv -f UTF-32 -t UTF-8 " + path_);
    const bool marked = begin.starts_with("\xFF\xFE") || begin.starts_with("\xFE\xFF"),
               big = zeros[1] == 0 && zeros[0] == (begin.size() + 1) / 2,
               little = zeros[0] == 0 && zeros[1] == begin.size() / 2;
    if (marked || ((big || little) && begin.size() > 1))
        refuse(" is UTF-16; convert it, iconv -f UTF-16" +
               std::string(marked ? ""
                           : big  ? "BE"
                                  : "LE") +
               " -t UTF-8 " + path_);
}

void Columns::check_separators(const Row& row) const {
    const std::string_view semicolon = ";";
    const bool semicolons = row.text.find(semicolon) != std::string_view::npos;
    const std::vector<std::string_view> words = split(row.text, semicolons ? semicolon : blanks);
    const bool commas = words.size() > 1 && std::any_of(words.begin(), words.end(), has_decimal_comma);
    if (semicolons && commas)
        refuse(row, row.text,
               "has decimal commas and semicolons; write points and commas, sed 's/,/./g; s/;/,/g' " + path_);
    if (semicolons) refuse(row, row.text, "has semicolons; write commas, sed 's/;/,/g' " + path_);
    if (!commas) return;
    const bool between = row.text.find(", ") != std::string_view::npos;
    refuse(row, row.text,
           "has decimal commas; write points, sed '" + std::string(between ? "s/, / /g; " : "") +
               "s/,/./g' " + path_);
}

void Columns::check_header() {
    if (header_.empty() || rows_.empty()) return;
    const std::vector<std::string_view> all = names();
    const std::size_t count = rows_.front().entries().size();
    if (all.size() == count &&
        std::any_of(all.begin(), all.end(), [](std::string_view name) { return is_number(unquoted(name)); }))
        refuse({header_line_, header_}, header_,
               "has a name and a number; correct it, or put # before it if it is a comment");
    numbered_ = all.size() + 1 == count && counts_rows(0);
}

std::vector<std::string_view> Columns::names() const {
    if (header_.empty()) return {};
    std::vector<std::string_view> all = Row{header_line_, header_}.entries();
    if (numbered_) all.insert(all.begin(), "");
    return all;
}

std::optional<std::size_t> Columns::place_named(std::string_view name) const {
    const std::vector<std::string_view> all = names();
    for (std::size_t place = 0; place < all.size(); ++place)
        if (unquoted(all[place]) == name) return place;
    return {};
}

std::size_t Columns::place_of(const std::string& column) const {
    if (const auto named = place_named(column)) return *named;
    std::size_t number = 0;
    const auto [stop, error] = std::from_chars(column.data(), column.data() + column.size(), number);
    if (error == std::errc() && stop == column.data() + column.size() && number > 0) return number - 1;
    refuse(" has no column '" + column + "'" +
           (header_.empty() ? "; it has no header, take a number from 1"
                            : "; its header is " + quoted(header_)));
}

double Columns::number(const Row& row, std::size_t place) const {
    const std::vector<std::string_view> all = row.entries();
    if (place >= all.size()) refuse(row, row.text, "has no column " + std::to_string(place + 1));
    try {
        return base::number(unquoted(all[place]));
    } catch (const InvalidInput& error) {
        throw InvalidInput(option_ + ": " + path_ + ", line " + std::to_string(row.line) + ": " +
                           error.what() +
                           (row.text.find_first_of("%!/") == 0 ? "; a comment begins with #" : ""));
    }
}

bool Columns::counts_rows(std::size_t place) const {
    if (rows_.size() < 2) return false;
    double expected = 0;
    for (const Row& row : rows_) {
        const std::vector<std::string_view> all = row.entries();
        if (place >= all.size()) return false;
        const std::string_view entry = unquoted(all[place]);
        double found = -1;
        std::from_chars(entry.data(), entry.data() + entry.size(), found);
        if (&row == &rows_.front() && found == 1) expected = 1;
        if (found != expected++) return false;
    }
    return true;
}

void Columns::refuse(const Row& row, std::string_view what, const std::string& why) const {
    throw InvalidInput(option_ + ": " + path_ + ", line " + std::to_string(row.line) + ": " + quoted(what) +
                       " " + why);
}

void Columns::refuse(const std::string& why) const {
    throw InvalidInput(option_ + ": " + path_ + why);
}

}  // namespace command_line
