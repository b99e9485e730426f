#include "command_line/plot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>
#include <variant>
#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "report/file.hpp"

namespace command_line {

using base::FailedComputation;

namespace {

/// A file that goes with its scope, if it ever came.
struct Temporary {
    std::string path;
    explicit Temporary(std::string at) : path(std::move(at)) {}
    ~Temporary() { std::remove(path.c_str()); }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
};

/// A text as gnuplot reads it literally: between single quotes nothing is expanded.
std::string quoted(const std::string& text) {
    std::string inside;
    for (const char c : text) inside += c == '\'' ? "''" : std::string(1, c);
    return "'" + inside + "'";
}

/// The words of a text on one line.
std::string on_one_line(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    for (std::string word; in >> word;) line += (line.empty() ? "" : " ") + word;
    return line;
}

/// The environment, but with the locale of the figures in the repository, and without a terminal of the user's.
std::vector<std::string> environment() {
    std::vector<std::string> all{"LC_ALL=C.UTF-8"};
    for (char** entry = environ; *entry != nullptr; ++entry)
        if (const std::string_view of(*entry); !of.starts_with("LC_ALL=") && !of.starts_with("GNUTERM="))
            all.emplace_back(*entry);
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> all(texts.size() + 1);  // the last one, which is null, ends them
    std::transform(texts.begin(), texts.end(), all.begin(), [](std::string& text) { return text.data(); });
    return all;
}

struct Said {
    int code;
    std::string complaints;
};

/// Runs gnuplot in a folder, without a shell.
Said gnuplot(std::vector<std::string> arguments, const std::string& folder) {
    arguments.insert(arguments.begin(), "gnuplot");
    std::vector<std::string> surroundings = environment();
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw FailedComputation(std::string("cannot run gnuplot: ") + std::strerror(errno));

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    pid_t child = 0;
    const int reason = posix_spawnp(&child, "gnuplot", &actions, nullptr, pointers(arguments).data(),
                                    pointers(surroundings).data());
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);

    Said said{-1, {}};
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; (count = read(ends[0], buffer.data(), buffer.size())) > 0;)
        said.complaints.append(buffer.data(), static_cast<std::size_t>(count));
    close(ends[0]);
    if (reason == ENOENT)
        throw FailedComputation("gnuplot is needed for --plot; install it (apt-get install gnuplot-nox)");
    if (reason != 0) throw FailedComputation(std::string("cannot run gnuplot: ") + std::strerror(reason));
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) said.code = WEXITSTATUS(status);
    return said;
}

bool drawable(const Figure& figure, const report::Cell& cell) {
    const double* const number = std::get_if<double>(&cell);
    return number != nullptr && (*number > 0 || !figure.logarithmic);
}

}  // namespace

std::string source_folder() {
    return SOURCE_FOLDER;  // the Makefile says which
}

void check_plot(const Figure& figure, const std::string& folder) {
    const std::string& path = figure.path;
    if (path.empty()) return;
    if (!path.ends_with(".svg"))
        throw base::InvalidInput("--plot draws an SVG; '" + path + "' does not end in .svg");
    const std::string script = folder + "/figures/" + figure.script;
    if (!std::filesystem::exists(script))
        throw FailedComputation("--plot needs " + script + " of the source tree, which is not there");
    std::error_code none;
    if (std::filesystem::is_directory(path, none))
        throw FailedComputation("cannot write " + path + ": it is a folder");
    const std::string beside = std::filesystem::absolute(path).parent_path().string();
    if (access(beside.c_str(), W_OK | X_OK) != 0)
        throw FailedComputation("cannot write " + path + ": " + std::strerror(errno));
    gnuplot({"--version"}, folder);
}

std::map<std::string, std::string> variables(const Figure& figure, const report::Table& table) {
    std::map<std::string, std::string> all = figure.told;
    const auto listed = [&](const char* name, const std::string& column, std::size_t row) {
        std::string& list = all[name];
        const std::string word = table.word(row, column);
        if ((" " + list + " ").find(" " + word + " ") == std::string::npos)
            list += (list.empty() ? "" : " ") + word;
    };
    const auto number = [&](const report::Cell& cell) {
        const long* const whole = std::get_if<long>(&cell);
        return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(cell);
    };
    std::vector<double> x, y;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto& cells = table.rows[row];
        if (!drawable(figure, cells[table.column(figure.y)])) continue;
        x.push_back(number(cells[table.column(figure.x)]));
        y.push_back(number(cells[table.column(figure.y)]));
        listed("curves", figure.curve, row);
        listed("values", figure.x, row);
        for (const auto& column : table.columns)
            if (column.name == "perturbation") listed("perturbations", column.name, row);
    }
    for (const auto& column : table.columns)
        all["columns"] += (all["columns"].empty() ? "" : " ") + column.name;
    if (y.empty()) throw FailedComputation("there is nothing to draw: no " + figure.y + " is positive");
    const auto [x_least, x_most] = std::minmax_element(x.begin(), x.end());
    const auto [y_least, y_most] = std::minmax_element(y.begin(), y.end());
    const auto tell = [&](const char* name, double value) { all[name] = base::shown(value, 17); };
    tell("x_least", *x_least);
    tell("x_most", *x_most);
    tell("y_least", *y_least);
    tell("y_most", *y_most);
    return all;
}

void plot(const Figure& figure, const report::Table& table) {
    const std::string& path = figure.path;
    if (path.empty()) return;
    const std::string beside = std::filesystem::absolute(path).string() + ".tmp." + std::to_string(getpid());
    const report::Uninterrupted uninterrupted;
    const Temporary numbers(beside + ".csv"), drawing(beside + ".svg");
    report::write_whole(numbers.path, report::csv(table));
    std::string told = "table = " + quoted(numbers.path) + "; output = " + quoted(drawing.path);
    for (const auto& [name, value] : variables(figure, table)) told += "; " + name + " = " + quoted(value);
    const auto [code, complaints] = gnuplot({"-d", "-e", told, "figures/" + figure.script}, source_folder());
    if (code != 0 || !complaints.empty())
        throw FailedComputation("cannot draw " + path + ": gnuplot ended with code " + std::to_string(code) +
                                " and said: " + on_one_line(complaints));
    const std::string svg = report::read_whole(drawing.path);
    if (svg.find("\n</svg>\n") == std::string::npos)  // of a full disk gnuplot says nothing
        throw FailedComputation("cannot draw " + path + ": gnuplot left it unfinished; is the disk full?");
    report::write_whole(path, svg);
}

}  // namespace command_line
