#include "command_line/positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "command_line/columns.hpp"

namespace command_line {

using base::InvalidInput;
using base::quoted;
using particles::Column;
using particles::Index;
using particles::Points;

namespace {

/// The place of the only column that holds positions: of its name or number, else of x, else the first.
std::size_t place_of_positions(const Columns& file, const std::vector<std::string>& columns) {
    if (columns.size() > 1)
        throw InvalidInput("--columns: a line of particles has one column of positions, not " +
                           std::to_string(columns.size()));
    if (!columns.empty()) return file.place_of(columns.front());
    if (const auto named = file.place_named("x")) return *named;
    if (file.rows().size() > 2 && file.rows().front().entries().size() > 1 && file.counts_rows(0))
        file.refuse(" counts its lines in the first column; name the column of positions, --columns 2");
    return 0;
}

/// Refuses a row that has more or fewer columns than the first.
void check_count(const Columns& file, const Columns::Row& row) {
    const std::size_t first = file.rows().front().entries().size(), count = row.entries().size();
    if (count != first)
        file.refuse(row, row.text,
                    "has " + std::to_string(count) + (count == 1 ? " column" : " columns") +
                        ", the first line " + std::to_string(first));
}

/// "; if its comma is decimal, write 0.25" for a line such as 0,25.
std::string advice_on_comma(std::string_view text) {
    const std::size_t comma = text.find_first_not_of("0123456789");
    if (comma == std::string_view::npos || text[comma] != ',' ||
        text.find_first_not_of("0123456789", comma + 1) != std::string_view::npos)
        return {};
    return "; if its comma is decimal, write " + std::string(text.substr(0, comma)) + "." +
           std::string(text.substr(comma + 1));
}

}  // namespace

Column<double> read_positions(const std::string& path, const std::vector<std::string>& columns) {
    const Columns file("--positions", path);
    if (file.rows().empty()) file.refuse(" holds no position");
    const std::size_t place = place_of_positions(file, columns);
    if (const std::size_t count = file.rows().front().entries().size();
        file.rows().size() == 1 && count > 2) {
        for (std::size_t k = 0; k < count; ++k) static_cast<void>(file.number(file.rows().front(), k));
        file.refuse(file.rows().front(), file.rows().front().text,
                    "has " + std::to_string(count) + " numbers; write each position on a line of its own");
    }
    std::vector<double> x;
    std::string_view before;
    for (const Columns::Row& row : file.rows()) {
        if (row.text.find(',') == std::string_view::npos && row.entries().size() > 1) check_count(file, row);
        double value = file.number(row, place);
        const std::string_view entry = row.entries()[place];
        const auto refuse = [&](const std::string& why) {
            file.refuse(row, entry, why + advice_on_comma(row.text));
        };
        if (x.empty() && std::abs(value) < end_tolerance) value = 0;
        if (&row == &file.rows().back() && std::abs(value - 1) < end_tolerance) value = 1;
        if (x.empty() && value != 0) refuse("is the first position; it must be 0");
        if (!x.empty() && value == x.back())
            refuse("coincides with the position before it; leave one of the two out");
        if (!x.empty() && value < x.back())
            refuse("does not lie beyond the position before it, " + std::string(before) + "; sort them");
        if (value > 1) refuse("lies beyond 1; scale the positions to [0, 1]");
        if (&row == &file.rows().back() && value != 1) refuse("is the last position; it must be 1");
        x.push_back(value);
        before = entry;
    }
    return Eigen::Map<Column<double>>(x.data(), static_cast<Index>(x.size()));
}

namespace {

/// The first `dim` columns that may hold positions, as --columns takes them: "a,b" or "2,3,4". Columns of
/// whole numbers are skipped; if too few are left, only a first column of particle numbers is.
std::string columns_of_positions(const Columns& file, std::size_t dim) {
    const std::vector<std::string_view> names = file.names();
    const std::size_t count = file.rows().front().entries().size();
    const bool named = names.size() == count;
    const auto is_whole = [&](std::size_t place) {
        return std::all_of(file.rows().begin(), file.rows().end(), [&](const Columns::Row& row) {
            const auto entries = row.entries();
            return place >= entries.size() || entries[place].find_first_of(".eE") == std::string_view::npos;
        });
    };
    std::vector<std::size_t> places;
    for (std::size_t place = 0; place < count; ++place)
        if (!is_whole(place)) places.push_back(place);
    if (places.size() < dim) {
        constexpr std::array<std::string_view, 7> of_numbers{"id", "ID",       "index", "number",
                                                             "no", "particle", "node"};
        const bool counted = file.counts_rows(0) || (named && std::find(of_numbers.begin(), of_numbers.end(),
                                                                        names[0]) != of_numbers.end());
        places.clear();
        for (std::size_t k = 0; k < dim; ++k) places.push_back(k + (counted ? 1 : 0));
    }
    const auto column = [&](std::size_t place) {
        const bool has_name = named && !names[place].empty() && names[place].front() != '"';
        return has_name ? std::string(names[place]) : std::to_string(place + 1);
    };
    std::string text;
    for (std::size_t k = 0; k < dim; ++k) text += (k > 0 ? "," : "") + column(places[k]);
    return text;
}

/// "x,y" or "x,y,z"
std::string coordinates(std::size_t dim) {
    return dim == 2 ? "x,y" : "x,y,z";
}

/// "two columns, x,y"
std::string columns_in_words(std::size_t dim) {
    return (dim == 2 ? "two columns, " : "three columns, ") + coordinates(dim);
}

/// Refuses a file that does not have as many columns as coordinates, with those that may be meant.
void check_columns(const Columns& file, const std::string& what, std::size_t dim) {
    const Columns::Row& row = file.rows().front();
    const std::size_t count = row.entries().size();
    if (count == dim) return;
    const bool whole = row.text.find_first_not_of("0123456789,-") == std::string_view::npos;
    const auto in_one_word = [](const std::string& names) {
        return names.find(' ') == std::string::npos ? names : '"' + names + '"';
    };
    const std::string needs = "; " + what + " needs " + coordinates(dim);
    file.refuse(row, row.text,
                count < dim ? "has " + std::to_string(count) + (count == 1 ? " column" : " columns") + needs
                            : "has " + std::to_string(count) + " columns" + needs +
                                  (count == 3 && what == "a layout in the plane"
                                       ? ": take --dimension 3, or choose two"
                                       : ": choose them") +
                                  ", such as --columns " + in_one_word(columns_of_positions(file, dim)) +
                                  (whole ? "; or, if its commas are decimal, write points" : ""));
}

/// Refuses positions in space where those of the plane are wanted: a third coordinate that varies.
void check_in_plane(const Columns& file, const std::string& what) {
    for (const std::string_view name : {"x3", "z"})
        if (const auto place = file.place_named(name))
            for (const Columns::Row& row : file.rows())
                if (row.entries().size() > *place &&
                    file.number(row, *place) != file.number(file.rows().front(), *place))
                    file.refuse(row, row.entries()[*place],
                                "is " + std::string(name) + " of a position in space, and " + what +
                                    " has two coordinates; name two columns, such as --columns x,y" +
                                    (what == "a layout" ? "" : ", or take --dimension 3"));
}

/// The coordinates in a file, particle by particle.
/// \param what the particles are, for messages: "a layout"
std::vector<double> coordinates_in(const std::string& option, const std::string& path,
                                   const std::vector<std::string>& columns, const std::string& what,
                                   std::size_t dim) {
    const Columns file(option, path);
    const std::size_t header = file.names().size();
    std::vector<std::size_t> places;
    if (!columns.empty() && columns.size() != dim)
        throw InvalidInput("--columns: " + what + " has " + columns_in_words(dim) + ", not " +
                           std::to_string(columns.size()));
    std::transform(columns.begin(), columns.end(), std::back_inserter(places),
                   [&](const std::string& column) { return file.place_of(column); });
    for (const std::array<std::string_view, 3>& names :
         {std::array<std::string_view, 3>{"x1", "x2", "x3"}, {"x", "y", "z"}}) {
        std::vector<std::size_t> named;
        for (std::size_t k = 0; k < dim; ++k)
            if (const auto place = file.place_named(names.at(k))) named.push_back(*place);
        if (places.empty() && named.size() == dim) places = named;
    }
    if (dim == 2 && columns.empty()) check_in_plane(file, what);
    const bool chosen = !places.empty();
    for (std::size_t k = 0; k < dim && !chosen; ++k) places.push_back(k);
    if (!chosen && !file.rows().empty()) check_columns(file, what, dim);
    std::vector<double> x;
    for (const Columns::Row& row : file.rows()) {
        if (!chosen) check_count(file, row);
        if (const std::size_t count = row.entries().size(); chosen && columns.empty() && count != header)
            file.refuse(row, row.text,
                        "has " + std::to_string(count) + " columns, the header " + std::to_string(header) +
                            (&row == &file.rows().front()
                                 ? "; choose " + std::string(dim == 2 ? "two" : "three") +
                                       " by number, such as --columns " + columns_of_positions(file, dim)
                                 : ""));
        for (const std::size_t place : places) x.push_back(file.number(row, place));
    }
    return x;
}

}  // namespace

Points<2> read_points(const std::string& path, const std::vector<std::string>& columns) {
    return read_points<2>("--layout", path, columns, "a layout");
}

template <int dim>
Points<dim> read_points(const std::string& option, const std::string& path,
                        const std::vector<std::string>& columns, const std::string& what) {
    std::vector<double> x = coordinates_in(option, path, columns, what, dim);
    if (x.size() < std::size_t{2} * dim)
        throw InvalidInput(option + ": " + path + " has " + (x.empty() ? "no particle" : "one particle") +
                           "; at least two are needed, each on a line");
    return Eigen::Map<Points<dim>>(x.data(), dim, static_cast<Index>(x.size()) / dim);
}

template Points<2> read_points(const std::string&, const std::string&, const std::vector<std::string>&,
                               const std::string&);
template Points<3> read_points(const std::string&, const std::string&, const std::vector<std::string>&,
                               const std::string&);

namespace {

/// The smoothing lengths in a column of a file; in a file of one column, if it is empty.
Column<double> lengths_in(const std::string& path, const std::string& column) {
    const Columns file("--smoothing-from", path);
    if (file.rows().empty()) file.refuse(" holds no number");
    const std::size_t place = column.empty() ? 0 : file.place_of(column);
    Column<double> lengths(static_cast<Index>(file.rows().size()));
    Index k = 0;
    for (const Columns::Row& row : file.rows()) {
        const auto entries = row.entries();
        if (column.empty() && entries.size() > 1)
            file.refuse(row, row.text,
                        "has " + std::to_string(entries.size()) + " columns; name one, such as " + path +
                            ":2" + advice_on_comma(row.text));
        const double length = file.number(row, place);
        if (!(length > 0)) file.refuse(row, entries[place], "is not positive");
        lengths[k++] = length;
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

namespace {

/// The length in a text; nothing for a text that does not begin like a number.
/// \throws InvalidInput for a text that begins like a number and is not one, or is not positive
std::optional<double> length_in(std::string_view text) {
    if (text.find_first_of("+-.0123456789") != 0 || text.ends_with("-nearest")) return {};
    const double length = base::number(text);
    if (!(length > 0)) throw InvalidInput(quoted(text) + " is not positive");
    return length;
}

}  // namespace

particles::Spacing spacing_from(const std::string& text) {
    const std::string_view word = base::trimmed(text);
    try {
        if (const auto length = length_in(word)) return particles::Spacing(*length);
        return particles::spacing_named(word);
    } catch (const InvalidInput& neither) {
        const auto [path, column] = named_file(text);
        if (is_file(path) || path.find('/') != std::string::npos ||
            (path.find('.') != std::string::npos && starts_with_name(path)))
            return particles::Spacing(lengths_in(path, column));
        const std::string why = neither.what();
        throw InvalidInput("--smoothing-from: " + why +
                           (why.find("choose") == std::string::npos
                                ? "; take a length, a name such as largest or 6-nearest, or a file"
                                : ", a length, or a file"));
    }
}

void check_lengths(const particles::Spacing& spacing, const std::string& text, particles::Index N) {
    const particles::Index count = spacing.lengths.size();
    if (spacing.kind == particles::Spacing::given && count != 1 && count != N)
        throw InvalidInput("--smoothing-from " + text + " has " + std::to_string(count) + " numbers, for " +
                           std::to_string(N) + " particles");
}

}  // namespace command_line
