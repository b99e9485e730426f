#include "command_line/command_line.hpp"

#include <gsl/gsl_errno.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <type_traits>

#include "base/errors.hpp"
#include "base/memory.hpp"
#include "command_line/lists.hpp"
#include "solvers/blas_threads.hpp"

namespace command_line {

namespace {

constexpr int most_threads = 1024;

}  // namespace

CommandLine::CommandLine(const std::string& about, const std::string& name, const std::string& examples)
    : app_(std::make_unique<CLI::App>(about, name)) {
    app_->footer(examples);
    app_->set_version_flag("--version", name + " of particle-methods " VERSION, "Print the version and exit");
}
CommandLine::CommandLine(CommandLine&&) noexcept = default;
CommandLine& CommandLine::operator=(CommandLine&&) noexcept = default;
CommandLine::~CommandLine() = default;

CommandLine::Option& CommandLine::Option::type_name(const std::string& shown) {
    option_->type_name(shown);
    return *this;
}
CommandLine::Option& CommandLine::Option::within(std::int64_t least, std::int64_t most) {
    option_->check([least, most, name = option_->get_name()](const std::string& text) {
        if (const long number = whole_number(name, text); number < least || number > most)
            throw base::InvalidInput(name + " must lie between " + std::to_string(least) + " and " +
                                     std::to_string(most) + ", got " + std::to_string(number));
        return std::string();
    });
    return *this;
}
CommandLine::Option& CommandLine::Option::among(const std::vector<std::string>& words) {
    option_->check([words, name = option_->get_name()](const std::string& text) {
        if (std::find(words.begin(), words.end(), text) == words.end())
            throw base::InvalidInput(name + ": there is no '" + text + "'; choose one of " + joined(words));
        return std::string();
    });
    return *this;
}
CommandLine::Option& CommandLine::Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}
CommandLine::Option& CommandLine::Option::required() {
    option_->required();
    return *this;
}

namespace {

/// Refuses an empty value, most likely of a shell variable that was never set.
CLI::Option* never_empty(CLI::Option* option) {
    option->check([name = option->get_name()](const std::string& text) {
        if (text.empty()) throw base::InvalidInput(name + " is empty; give it a value or leave it out");
        return std::string();
    });
    return option;
}

/// An option whose text `read` turns into a value or a list of values.
template <class Value, class Read>
CLI::Option* option_that_reads(CLI::App& app, const std::string& name, Value& value, const std::string& about,
                               const Read& read) {
    const auto store = [&value, name, read](const std::string& text) {
        value = static_cast<Value>(read(name, text));
    };
    return never_empty(app.add_option_function<std::string>(name, store, about));
}

}  // namespace

template <class Value>
CommandLine::Option CommandLine::add_option(const std::string& name, Value& value, const std::string& about) {
    if constexpr (std::is_integral_v<Value>)
        return Option(option_that_reads(*app_, name, value, about, whole_number));
    else if constexpr (std::is_floating_point_v<Value> || std::is_same_v<Value, std::optional<double>>)
        return Option(option_that_reads(*app_, name, value, about, number));
    else
        return Option(never_empty(app_->add_option(name, value, about)));
}
template CommandLine::Option CommandLine::add_option(const std::string&, std::string&, const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, double&, const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, int&, const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, long&, const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, unsigned long&, const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, std::optional<std::string>&,
                                                     const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, std::optional<long>&,
                                                     const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, std::optional<double>&,
                                                     const std::string&);
template CommandLine::Option CommandLine::add_option(const std::string&, std::vector<std::string>&,
                                                     const std::string&);

namespace {

/// Reads a list, and leaves out what it has already.
template <class Value>
auto each_once(std::vector<Value> (*read)(const std::string&, const std::string&)) {
    return [read](const std::string& option, const std::string& text) {
        std::vector<Value> once;
        for (const Value& value : read(option, text))
            if (std::find(once.begin(), once.end(), value) == once.end()) once.push_back(value);
        return once;
    };
}

}  // namespace

CommandLine::Option CommandLine::add_list(const std::string& name, std::vector<std::string>& values,
                                          const std::string& about) {
    return Option(
        option_that_reads(*app_, name, values, about, each_once(names))->type_name("NAME[,NAME...]"));
}
CommandLine::Option CommandLine::add_list(const std::string& name, std::vector<double>& values,
                                          const std::string& about) {
    return Option(option_that_reads(*app_, name, values, about, each_once(numbers))->type_name("LIST"));
}
CommandLine::Option CommandLine::add_list(const std::string& name, std::vector<long>& values,
                                          const std::string& about) {
    return Option(option_that_reads(*app_, name, values, about, each_once(whole_numbers))->type_name("LIST"));
}

CommandLine::Option CommandLine::add_repeated(const std::string& name, std::vector<Typed>& all,
                                              const std::string& about) {
    const auto store = [&all, name](const std::string& text) { all.push_back({name, text}); };
    return Option(
        never_empty(app_->add_option_function<std::string>(name, store, about)->trigger_on_parse()));
}

CommandLine::Option CommandLine::add_flag(const std::string& name, bool& value, const std::string& about) {
    return Option(app_->add_flag(name, value, about)->disable_flag_override());
}

void CommandLine::add_threads(int& threads) {
    add_option("--threads", threads, "number of threads (default: all)")
        .type_name("T")
        .within(1, most_threads);
}
void CommandLine::add_output(std::string& file) {
    add_option("--output", file, "CSV file to write (default: standard output)").type_name("FILE");
}

void CommandLine::column_width(std::size_t letters) {
    app_->get_formatter()->column_width(letters);
}

std::string CommandLine::name() const {
    return app_->get_name();
}

bool CommandLine::given(const std::string& option) const {
    return app_->count(option) > 0;
}

namespace {

/// What CLI11 found wrong, in words that say what to do.
std::string in_words(const CLI::ParseError& error, const CLI::App& app) {
    std::string what = error.what();
    const std::string name = what.substr(0, what.find_first_of(": "));
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        const std::string first = app.remaining().front();
        return first.starts_with('-') ? "there is no option '" + first.substr(0, first.find('=')) + "'"
                                      : "'" + first + "' was not expected";
    }
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr)
        return name + " and " + what.substr(what.rfind(' ') + 1) + " exclude each other; leave one out";
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
        return (what.ends_with("override") ? "--" : "") + name +
               (what.ends_with("missing")    ? " needs a value"
                : what.ends_with("override") ? " takes no value"
                                             : " is given twice; give it once");
    return what;
}

}  // namespace

std::optional<int> CommandLine::read(int argc, char** argv) {
    try {
        app_->parse(argc, argv);
    } catch (const CLI::Success& asked) {
        app_->exit(asked);
        return 0;
    } catch (const CLI::ParseError& error) {
        throw base::InvalidInput(in_words(error, *app_) + "; see " + name() + " --help");
    }
    return {};
}

namespace {

/// A message on one line: control characters become ?, and a long message loses its middle.
std::string on_one_line(std::string text) {
    for (char& letter : text)
        if (std::iscntrl(static_cast<unsigned char>(letter)) != 0) letter = '?';
    constexpr std::size_t first = 400, last = 200;
    if (text.size() > 2 * (first + last)) text.replace(first, text.size() - first - last, " ... ");
    return text;
}

}  // namespace

int run(CommandLine& app, int argc, char** argv, const std::function<int()>& body) {
    const auto refused = [&](int code, const std::string& why) {
        std::cerr << app.name() << ": " << on_one_line(why) << "\n";
        return code;
    };
    try {
        std::signal(SIGXFSZ, SIG_IGN);  // a file above the user's limit is an error, as a full disk is
        omp_set_num_threads(std::min(omp_get_max_threads(), most_threads));
        const std::optional<int> asked = app.read(argc, argv);
        gsl_set_error_handler_off();
        base::keep_freed_memory();
        solvers::use_one_blas_thread();
        const int code = asked ? *asked : body();
        if (!std::cout.flush()) throw base::FailedComputation("cannot write to the standard output");
        return code;
    } catch (const base::InvalidInput& error) {
        return refused(2, error.what());
    } catch (const std::bad_alloc&) {
        return refused(1, "there is not enough memory; take fewer particles or a smaller smoothing length");
    } catch (const std::exception& error) {
        return refused(1, error.what());
    }
}

}  // namespace command_line
