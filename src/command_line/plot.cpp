#include "command_line/plot.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/errors.hpp"
#include "report/file.hpp"

namespace command_line {

using base::FailedComputation;

namespace {

/// A file that is removed at the end of its scope, if it was ever made.
struct Temporary {
    std::string path;
    explicit Temporary(std::string at) : path(std::move(at)) {}
    ~Temporary() { std::remove(path.c_str()); }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP are held back, so that temporary files are removed first.
class Uninterrupted {
  public:
    Uninterrupted() {
        for (std::size_t k = 0; k < signals.size(); ++k)
            if ((before_[k] = std::signal(signals[k], remember)) == SIG_IGN) std::signal(signals[k], SIG_IGN);
    }
    ~Uninterrupted() {
        for (std::size_t k = 0; k < signals.size(); ++k) std::signal(signals[k], before_[k]);
        if (received != 0) std::raise(received);
    }
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;

  private:
    static void remember(int number) { received = number; }

    static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    static inline volatile std::sig_atomic_t received = 0;
    std::array<void (*)(int), signals.size()> before_{};
};

/// A text between single quotes. \param quote what stands for a single quote within
std::string quoted(const std::string& text, std::string_view quote) {
    std::string inside;
    for (const char c : text) inside += c == '\'' ? quote : std::string_view(&c, 1);
    return "'" + inside + "'";
}
std::string for_gnuplot(const std::string& text) {
    return quoted(text, "''");
}
std::string for_shell(const std::string& text) {
    return quoted(text, "'\\''");
}

/// The words of a text on one line.
std::string on_one_line(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    for (std::string word; in >> word;) line += (line.empty() ? "" : " ") + word;
    return line;
}

struct Ended {
    int code;
    std::string complaints;
};

/// Runs gnuplot in the folder of the sources, with the locale of the repository's figures.
/// \throws base::FailedComputation where there is no gnuplot
Ended gnuplot(const std::string& arguments, const std::string& folder) {
    const std::string command = "cd " + for_shell(folder) + " && GNUTERM=svg LC_ALL=C.UTF-8 gnuplot " +
                                arguments + " 2>&1 >/dev/null </dev/null";
    std::FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw FailedComputation(std::string("cannot run gnuplot: ") + std::strerror(errno));
    std::string complaints;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        complaints.append(buffer.data(), count);
    const int status = pclose(pipe), code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    constexpr int not_found = 127;  // as shells say it
    if (code == not_found)
        throw FailedComputation("gnuplot is needed for --plot; install it (apt-get install gnuplot-nox)");
    return {code, complaints};
}

}  // namespace

std::string source_folder() {
    return SOURCE_FOLDER;  // the Makefile says which
}

void add_plot_option(CommandLine& app, Figure& figure) {
    app.add_option("--plot", figure.path, "draw the figure of this table too (needs gnuplot)")
        .type_name("FILE.svg");
}

void check_plot(const Figure& figure, const std::string& folder) {
    const std::string &script = figure.script, &path = figure.path;
    if (path.empty()) return;
    if (!path.ends_with(".svg"))
        throw base::InvalidInput("--plot draws an SVG; '" + path + "' does not end in .svg");
    if (const std::string needed = folder + "/figures/" + script; !std::filesystem::exists(needed))
        throw FailedComputation("--plot needs " + needed + " of the source tree, which is not there");
    report::check_writable(path);
    gnuplot("--version", folder);
}

void plot(const Figure& figure, const report::Table& table) {
    const std::string &script = figure.script, &path = figure.path;
    if (path.empty()) return;
    const Uninterrupted while_drawing;
    const Temporary numbers(report::temporary_beside(path, ".csv")),
        drawing(report::temporary_beside(path, ".svg"));
    report::write_whole(numbers.path, report::csv(table));
    const std::string variables =
        "table=" + for_gnuplot(numbers.path) + "; output=" + for_gnuplot(drawing.path);
    const auto [code, complaints] =
        gnuplot("-d -e " + for_shell(variables) + " " + for_shell("figures/" + script), source_folder());
    if (code != 0 || !complaints.empty())
        throw FailedComputation("cannot draw " + path + ": gnuplot ended with code " + std::to_string(code) +
                                " and said: " + on_one_line(complaints));
    const std::string svg = report::read_whole(drawing.path);
    if (svg.find("\n</svg>\n") == std::string::npos)  // gnuplot does not complain about a full disk
        throw FailedComputation("cannot draw " + path + ": gnuplot left it unfinished; is the disk full?");
    report::write_whole(path, svg);
}

}  // namespace command_line
