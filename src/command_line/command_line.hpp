#pragma once

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

/// What a program can be asked, and what `--help` says of it: a thin face over CLI11, which takes longer to compile than most
/// programs.
class CommandLine {
  public:
    /// \param about a sentence or two \param name of the program \param examples the last lines of `--help`
    CommandLine(const std::string& about, const std::string& name, const std::string& examples = "");
    CommandLine(CommandLine&& other) noexcept;
    CommandLine& operator=(CommandLine&& other) noexcept;
    ~CommandLine();

    /// One option. Each member narrows it and returns it.
    class Option {
      public:
        Option& type_name(const std::string& shown);
        Option& within(long least, long most);
        Option& among(const std::vector<std::string>& words);
        Option& excludes(const Option& other);
        Option& required();

      private:
        friend CommandLine;
        explicit Option(CLI::Option* of) : of_(of) {}
        CLI::Option* of_;
    };

    /// \param name with dashes, or without for an argument by its place
    /// \param value string, double, int, long, unsigned long, std::optional<std::string>, or a vector of strings that follow each
    ///        other; it keeps what it holds where the option is not given
    template <class Value>
    Option add_option(const std::string& name, Value& value, const std::string& about);

    /// One option with a list: names separated by commas, or numbers as numbers() and whole_numbers() read them.
    Option add_list(const std::string& name, std::vector<std::string>& values, const std::string& about);
    Option add_list(const std::string& name, std::vector<double>& values, const std::string& about);
    Option add_list(const std::string& name, std::vector<long>& values, const std::string& about);

    Option add_flag(const std::string& name, bool& value, const std::string& about);

    /// `--threads` and `--output`, which most programs have.
    void add_threads(int& threads);
    void add_output(std::string& file);

    /// Lines of the options in `--help` begin their descriptions in this column.
    void column_width(std::size_t letters);

    [[nodiscard]] std::string name() const;

    /// Reads the arguments. \return 0 to stop, where help was asked for and printed; nothing to go on
    /// \throws base::InvalidInput for what the options do not allow, and for an option with an empty value
    [[nodiscard]] std::optional<int> read(int argc, char** argv);

  private:
    std::unique_ptr<CLI::App> app_;
};

/// The body of any main: options are read, then the work is done. A message stays on one line, whatever an option holds.
/// \return what the work returns; 2 for a bad invocation; 1 for a failed computation, with one line on standard error
int run(CommandLine& app, int argc, char** argv, const std::function<int()>& body);

}  // namespace command_line
