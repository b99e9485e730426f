#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "report/file.hpp"
#include "tests/programs/outcome.hpp"
#include "tests/support/folder.hpp"

/// Runs the programs beside the test runner, as a user's shell does.
namespace programs {

using support::Folder;

/// The folder of the programs and of the test runner.
inline std::string bin() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

/// \param command a line for the shell: a program's name and its options. OpenBLAS starts no threads, which
///        takes longer than most of these runs; the programs use one in any case.
inline Outcome run(const std::string& command) {
    const Folder folder;
    const std::string line = "export OPENBLAS_NUM_THREADS=1 PATH='" + bin() + "':$PATH; " + command + " >'" +
                             folder.path + "/output' 2>'" + folder.path + "/errors'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, report::read_whole(folder.path + "/output"),
            report::read_whole(folder.path + "/errors")};
}

/// Checks a failure: this exit code, no output, and one line on standard error that begins with the program's
/// name.
/// \param prefix shell text before the command \return that line
inline std::string check_refused(const std::string& command, int code, const std::string& reason,
                                 const std::string& prefix = "") {
    CAPTURE(command);
    const Outcome outcome = run(prefix + command);
    const std::string& errors = outcome.errors;
    CAPTURE(errors);
    CHECK(outcome.code == code);
    CHECK(outcome.output.empty());
    CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    CHECK(errors.starts_with(command.substr(0, command.find(' ')) + ": "));
    CHECK(errors.find(reason) != std::string::npos);
    return errors.substr(0, errors.find('\n'));
}

}  // namespace programs
