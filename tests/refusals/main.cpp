/// Tries every option of one program with empty, wrong, huge and hostile values. The linker (--wrap=main)
/// puts this main before the program's own, which is then called once per invocation: starting a process each
/// time would take minutes. Writes one line per invocation to standard output and one line per fault to
/// standard error.

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/file.hpp"
#include "tests/programs/outcome.hpp"
#include "tests/support/folder.hpp"

/// The program's own main.
extern "C" int __real_main(int argc, char** argv);

namespace {

using programs::Outcome;
using support::Folder;
using Words = std::vector<std::string>;

/// Other options for each program, which keep accepted runs short. choices, claims and walkthrough always
/// refuse: a run takes too long, or needs the whole tree.
const std::map<std::string, std::vector<Words>> other_options = {
    {"derivative_test", {{"--formulation", "fpm"}, {"--particles", "20"}}},
    {"static_test", {{"--formulation", "fpm"}, {"--particles", "20"}}},
    {"vibration_test", {{"--formulation", "fpm"}, {"--particles", "20"}}},
    {"stencil", {{"--formulation", "fpm"}, {"--particles", "20"}}},
    {"constants",
     {{"--formulation", "fpm"}, {"--kernel", "gaussian"}, {"--smoothing", "1"}, {"--volumes", "equal"}}},
    {"derivative_test_in_space", {{"--formulation", "ssph"}, {"--particles", "8"}}},
    {"static_test_in_space", {{"--formulation", "ssph"}, {"--particles", "8"}}},
    {"vibration_test_in_space", {{"--formulation", "ssph"}, {"--particles", "8"}, {"--lowest", "2"}}},
    {"constants_in_space", {{"--dimension", "2"}, {"--formulation", "ssph"}, {"--smoothing", "1"}}},
    {"orders", {{"--from", "1"}, {"--to", "1"}, {"--step", "1e3"}, {"--seeds", "1"}}},
    {"roundoff", {{"--formulation", "modified_fpm"}, {"--most", "100"}, {"--most-quad", "10"}}},
    {"draws", {{"--formulation", "fpm"}, {"--particles", "20"}, {"--seeds", "2"}}},
    {"plate", {{"--method", "strong"}}},
    {"hole", {{"--method", "strong"}, {"--layout", "polar-5x5"}}},
    {"choices", {{"--paper", "nobody"}}},
    {"claims", {}},
    {"walkthrough", {}},
    {"compare_tables", {}}};

/// Standard output or standard error, caught in a file without a name.
class Captured {
  public:
    explicit Captured(int descriptor) : descriptor_(descriptor), original_(dup(descriptor)) {
        dup2(fileno(file_), descriptor_);
    }

    /// Writes a line to where the descriptor led before.
    void write_through(const std::string& line) const { dprintf(original_, "%s\n", line.c_str()); }

    /// What was written since the last call.
    [[nodiscard]] std::string take() const {
        std::string text(static_cast<std::size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
        const bool read =
            pread(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
        if (!read || ftruncate(descriptor_, 0) != 0 || lseek(descriptor_, 0, SEEK_SET) != 0)
            throw std::runtime_error("cannot read the program's output");
        return text;
    }

  private:
    std::FILE* file_ = std::tmpfile();
    int descriptor_, original_;
};

const Captured output(STDOUT_FILENO), errors(STDERR_FILENO);

/// Calls the program as a shell would start it. A run of more than a minute ends this test.
Outcome run(Words words) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    omp_set_num_threads(1);
    alarm(60);
    const int code = __real_main(static_cast<int>(words.size()), argv.data());
    alarm(0);
    std::cout.flush();
    std::cout.clear();
    std::fflush(stdout);
    return {code, output.take(), errors.take()};
}

/// The options that take a value: in --help, a name in capitals follows them.
Words options_with_values(const std::string& program) {
    Words options;
    std::istringstream help(run({program, "--help"}).output);
    for (std::string line; std::getline(help, line);) {
        const std::string option = line.substr(0, line.find(' ', 2));
        if (option.starts_with("  --") && option.size() + 1 < line.size() &&
            std::isupper(line[option.size() + 1]) != 0)
            options.push_back(option.substr(2));
    }
    return options;
}

/// What is given to each option: numbers out of range, lists and pairs out of shape, control characters,
/// devices, folders, files.
Words bad_values(const Folder& files) {
    Words values = {"",
                    " ",
                    "0",
                    "1",
                    "2",
                    "3",
                    "-5",
                    "0.01",
                    "1e1",
                    "1000.5",
                    "1e18",
                    "99999999999999999999",
                    "1e400",
                    "1e-300",
                    "1e300",
                    "-1e300",
                    "nan",
                    "inf",
                    "-inf",
                    "abc",
                    "all",
                    ",",
                    "1,,2",
                    "1:2",
                    "2:1:0",
                    "1:0:2",
                    "0x0",
                    "3x-5",
                    "1e18x1e18",
                    "x",
                    "'",
                    "%s%n",
                    "a\nb",
                    "\x1b[31mred",
                    "\xff\xfe",
                    "--help",
                    "-",
                    "/dev/null",
                    "/dev/full",
                    files.path,
                    files.path + "/none",
                    files.path + "/none/none",
                    std::string(100000, '9')};
    const std::map<std::string, std::string> texts = {{"empty", ""},
                                                      {"text", "Whatever this is,\nit is no table.\n"},
                                                      {"bytes", std::string("\0\xff\n\x7f", 4)},
                                                      {"twice", "0\n0.5\n0.5\n1\n"},
                                                      {"back", "0\n0.6\n0.5\n1\n"},
                                                      {"outside", "-1 0\n0 9\n2 2\n"}};
    for (const auto& [name, text] : texts) {
        report::write_whole(files.path + "/" + name, text);
        values.push_back(files.path + "/" + name);
    }
    return values;
}

/// The arguments of all invocations: each option without a value, and with each bad value.
std::vector<Words> invocations(const std::string& program, const Words& values) {
    Words options = options_with_values(program);
    if (program == "compare_tables")
        options = {"kept", ""};  // the first of its two arguments, or the only one
    if (options.size() < 2) throw std::runtime_error(program + " --help lists fewer than two options");
    std::vector<Words> all;
    for (const std::string& option : options) {
        Words others;
        for (const Words& other : other_options.at(program))
            if (other.front() != option) others.insert(others.end(), other.begin(), other.end());
        if (option != "--output" && program != "walkthrough" && program != "compare_tables")
            others.insert(others.end(), {"--output", "kept"});
        Words with_option{program};
        if (!option.empty()) with_option.push_back(option);
        const auto add = [&](const Words& given) {
            all.push_back(with_option);
            for (const Words& more : {given, others})
                all.back().insert(all.back().end(), more.begin(), more.end());
        };
        add({});
        for (const std::string& value : values) add({value});
    }
    return all;
}

/// Runs the program in a new folder. A refusal is one line that says why, and changes no file; an accepted
/// run writes no message.
void check(const Words& words) {
    const std::string& program = words.front();
    std::string invocation;
    for (const std::string& word : words) invocation += (invocation.empty() ? "'" : " '") + word + "'";
    invocation.resize(std::min<std::size_t>(invocation.size(), 200));
    output.write_through(invocation);

    const Folder folder;
    const std::string kept = folder.path + "/kept";
    report::write_whole(kept, "a\n1\n");
    std::filesystem::current_path(folder.path);
    const Outcome outcome = run(words);
    const std::string& message = outcome.errors;
    const auto expect = [&](bool holds, const std::string& fault) {
        if (!holds) errors.write_through(invocation + ": " + fault);
    };
    if (outcome.code == 0) {
        expect(message.empty(), "writes the message: " + message);
        expect(!programs::has_non_finite_cell(outcome.output), "writes a number that is not finite");
    } else if (program != "compare_tables" || outcome.code != 1 ||
               !message.empty()) {  // else the tables differ
        expect(outcome.code == 1 || outcome.code == 2, "exit code " + std::to_string(outcome.code));
        expect(outcome.output.empty(), "writes output though it fails");
        expect(message.starts_with(program + ": ") && message.find('\n') == message.size() - 1 &&
                   message.size() < 1000,
               "writes the message: " + message);
        expect(std::count_if(message.begin(), message.end(),
                             [](unsigned char c) { return c < ' ' || c == 127; }) == 1,
               "writes control characters");
        expect(report::read_whole(kept) == "a\n1\n", "changes a file");
        expect(folder.entries() == 1, "leaves a file behind");
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path))
        expect(entry.path().string().find(".tmp.") == std::string::npos, "leaves a temporary file behind");
}

}  // namespace

extern "C" int __wrap_main(int /*argc*/, char** argv) {
    const std::string program = std::filesystem::path(argv[0]).filename();
    try {
        const Folder files;
        for (const Words& words : invocations(program, bad_values(files))) check(words);
    } catch (const std::exception& error) {
        errors.write_through(program + ": " + error.what());
        return 1;
    }
    return 0;
}
