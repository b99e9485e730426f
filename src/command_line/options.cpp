#include "command_line/options.hpp"

#include <omp.h>

#include <filesystem>
#include <system_error>

#include "base/errors.hpp"
#include "command_line/sweep.hpp"
#include "report/file.hpp"

namespace command_line {

using base::InvalidInput;

namespace {

/// The file that an option names, in full. The table goes to the standard output, -, unless told otherwise.
std::string in_full(const std::string& option, const std::string& file) {
    if (file == "-" || file == "/dev/stdout" || (file.empty() && option == "--output")) return "-";
    std::error_code none;
    return file.empty() ? "" : std::filesystem::weakly_canonical(std::filesystem::absolute(file, none), none);
}

}  // namespace

bool is_standard_output(const std::string& output) {
    return in_full("--output", output) == "-";
}

void check_apart(const std::vector<std::pair<std::string, std::string>>& files) {
    std::error_code none;
    for (std::size_t a = 0; a < files.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const auto& [option, file] = files[a];
            const auto& [other_option, other_file] = files[b];
            const std::string full = in_full(option, file);
            if (full.empty() || full != in_full(other_option, other_file)) continue;
            if (full == "-")
                throw InvalidInput(option + " and " + other_option +
                                   " both go to the standard output; choose a file for one of them");
            if (!std::filesystem::is_other(file, none))
                throw InvalidInput(option + " and " + other_option + " name the same file, " + file +
                                   "; choose another for one of them");
        }
}

int run(CommandLine& app, int argc, char** argv, const int& threads, const std::string& output,
        const Figure& figure, const std::function<report::Table()>& compute) {
    return run(app, argc, argv, [&] {
        const bool drawn = !figure.path.empty();
        check_apart({{"--output", output}, {"--plot", figure.path}});
        report::check_writable(output);
        if (drawn) check_plot(figure);
        if (threads > 0) omp_set_num_threads(threads);
        const report::Table table = compute();
        report::write_whole(output, report::csv(table));
        if (drawn) plot(figure, without_failures(figure.table.value_or(table)));
        if (!table.incomplete.empty()) throw base::FailedComputation(table.incomplete);
        return 0;
    });
}

}  // namespace command_line
