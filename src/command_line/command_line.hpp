#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace command_line {

/// What an option said.
struct Typed {
    std::string option, text;
};

/// The options of a program and its `--help`: a thin face over CLI11, which only command_line.cpp includes
/// because it takes six seconds to compile.
class CommandLine {
  public:
    /// \param about what the program does \param name of the program \param examples last lines of `--help`
    CommandLine(const std::string& about, const std::string& name, const std::string& examples = "");
    CommandLine(CommandLine&& other) noexcept;
    CommandLine& operator=(CommandLine&& other) noexcept;
    ~CommandLine();

    /// One option. Each member adds a condition and returns the option.
    class Option {
      public:
        Option& type_name(const std::string& shown);
        Option& within(std::int64_t least, std::int64_t most);
        Option& among(const std::vector<std::string>& words);
        Option& excludes(const Option& other);
        Option& required();

      private:
        friend CommandLine;
        explicit Option(CLI::Option* option) : option_(option) {}
        CLI::Option* option_;
    };

    /// \param name with dashes; without them, an argument that is known by its place
    /// \param value string, double, int, long, unsigned long, std::optional of string, long or double, or a
    ///        vector of strings separated by blanks; unchanged where the option is not given
    template <class Value>
    Option add_option(const std::string& name, Value& value, const std::string& about);

    /// One option with a list: names separated by commas, or numbers as numbers() and whole_numbers() read
    /// them. What it has twice counts once.
    Option add_list(const std::string& name, std::vector<std::string>& values, const std::string& about);
    Option add_list(const std::string& name, std::vector<double>& values, const std::string& about);
    Option add_list(const std::string& name, std::vector<long>& values, const std::string& about);

    /// One option that may be given several times.
    /// \param all what it and other options said, in the order of the command line
    Option add_repeated(const std::string& name, std::vector<Typed>& all, const std::string& about);

    Option add_flag(const std::string& name, bool& value, const std::string& about);

    /// `--threads` and `--output`, which most programs have.
    void add_threads(int& threads);
    void add_output(std::string& file);

    /// Column of `--help` in which the descriptions of the options begin.
    void column_width(std::size_t letters);

    [[nodiscard]] std::string name() const;

    /// Whether an option was on the command line, once it is read.
    [[nodiscard]] bool given(const std::string& option) const;

    /// Reads the arguments. \return an exit code of 0 if `--help` was printed, else nothing
    /// \throws base::InvalidInput for arguments that the options do not allow, and for an empty value
    [[nodiscard]] std::optional<int> read(int argc, char** argv);

  private:
    std::unique_ptr<CLI::App> app_;
};

/// The body of any main: reads the options, then runs `body`. An error is one line on standard error,
/// whatever an option holds.
/// \return what `body` returns; 2 for a bad invocation; 1 for a failed computation
int run(CommandLine& app, int argc, char** argv, const std::function<int()>& body);

}  // namespace command_line
