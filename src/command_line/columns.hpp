#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace command_line {

/// A file of numbers in columns, between which are commas or blanks. # starts a comment; a first line that
/// begins with a name is a header that names the columns, all or all but one that counts the rows. A comma
/// may end a line, and entries may stand in quotes.
class Columns {
  public:
    /// A line that is neither blank nor a comment.
    struct Row {
        long line;              ///< its number in the file, from 1
        std::string_view text;  ///< without comment, and without blanks at its ends

        /// What stands between the commas, or between the blanks where there is no comma.
        [[nodiscard]] std::vector<std::string_view> entries() const;
    };

    /// Reads a file. \param option that names the file, for messages
    /// \throws base::InvalidInput where it cannot be read; for UTF-16, decimal commas, semicolons, and a
    ///         first line of names and numbers, each with what to do
    Columns(std::string option, std::string path);
    Columns(const Columns&) = delete;
    Columns& operator=(const Columns&) = delete;

    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

    /// The names in the header; none where there is no header.
    [[nodiscard]] std::vector<std::string_view> names() const;

    /// The place of a column, from 0, by its name in the header; nothing where there is none of that name.
    [[nodiscard]] std::optional<std::size_t> place_named(std::string_view name) const;

    /// The place of a column, from 0, by its name or its number from 1.
    /// \throws base::InvalidInput for a name that the header does not have
    [[nodiscard]] std::size_t place_of(const std::string& column) const;

    /// The number at a place of a row. \throws base::InvalidInput naming file, line and entry
    [[nodiscard]] double number(const Row& row, std::size_t place) const;

    /// Whether the numbers at a place count the rows, two at least, from 0 or from 1.
    [[nodiscard]] bool counts_rows(std::size_t place) const;

    /// \throws base::InvalidInput "OPTION: FILE, line N: 'what' why"
    [[noreturn]] void refuse(const Row& row, std::string_view what, const std::string& why) const;

    /// \throws base::InvalidInput "OPTION: FILE why"
    [[noreturn]] void refuse(const std::string& why) const;

  private:
    void check_encoding() const;
    void check_separators(const Row& row) const;
    void check_header();

    std::string option_, path_, text_;
    std::string_view header_;
    long header_line_ = 0;
    bool numbered_ = false;  ///< the first column counts the rows, and the header does not name it
    std::vector<Row> rows_;
};

/// Whether the first entry of a line that is not empty is a name, as in a header. nan and inf are no names.
bool starts_with_name(std::string_view line);

}  // namespace command_line
