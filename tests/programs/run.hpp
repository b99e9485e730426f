#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "report/file.hpp"
#include "tests/folder.hpp"

/// Runs the programs that lie beside the test runner, as a user's shell does.
namespace programs {

struct Outcome {
    int code;
    std::string output, errors;
};

using support::Folder;

/// The folder of the programs and of the test runner.
inline std::string bin() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

/// \param command a program's name and its options
inline Outcome run(const std::string& command) {
    const Folder folder;
    const std::string line = "PATH='" + bin() + "':$PATH; " + command + " >'" + folder.path + "/output' 2>'" +
                             folder.path + "/errors'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, report::read_whole(folder.path + "/output"),
            report::read_whole(folder.path + "/errors")};
}

/// A failure as users should see it: this exit code, one line on standard error that names the program, no output.
/// \param by what runs the command, where it is not the shell
inline void check_refused(const std::string& command, int code, const std::string& reason,
                          const std::string& by = "") {
    CAPTURE(command);
    const Outcome outcome = run(by + command);
    const std::string& errors = outcome.errors;
    CAPTURE(errors);
    CHECK(outcome.code == code);
    CHECK(outcome.output.empty());
    CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    CHECK(errors.starts_with(command.substr(0, command.find(' ')) + ": "));
    CHECK(errors.find(reason) != std::string::npos);
}

}  // namespace programs
