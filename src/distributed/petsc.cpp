#include "distributed/petsc.hpp"

#include <slepcsys.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <iostream>
#include <thread>

#include "base/errors.hpp"

namespace distributed {

namespace {

/// What PETSc says of an error.
std::string words_of(PetscErrorCode code) {
    const char* text = nullptr;
    char* specific = nullptr;
    PetscErrorMessage(code, &text, &specific);
    std::string why = text != nullptr ? text : "error " + std::to_string(code);
    if (specific != nullptr && *specific != '\0') why += std::string(": ") + specific;
    for (char& letter : why)
        if (letter == '\n') letter = ' ';
    return "PETSc: " + why;
}

/// Ends all processes, if there are several, with one line.
void end_all(const std::string& why, int exit_code) {
    int processes = 1, rank = 0;
    MPI_Comm_size(PETSC_COMM_WORLD, &processes);
    if (processes == 1) return;
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    // Where all have failed, the first one speaks and ends the others.
    if (rank > 0) std::this_thread::sleep_for(std::chrono::seconds(2));
    std::cerr.rdbuf(std::clog.rdbuf());
    std::cerr << "distributed: process " << rank << ": " << why << std::endl;
    MPI_Abort(PETSC_COMM_WORLD, exit_code);
}

}  // namespace

void require(PetscErrorCode code) {
    if (code == 0) return;
    const std::string why = words_of(code);
    end_all(why, 1);
    throw base::FailedComputation(why);
}

void require_options(PetscErrorCode code) {
    if (code == 0) return;
    const std::string why = words_of(code);
    end_all(why, 2);
    throw base::InvalidInput(why);
}

std::pair<std::vector<char*>, std::vector<std::string>> divided(int argc, char** argv,
                                                                const std::vector<std::string>& flags) {
    std::pair<std::vector<char*>, std::vector<std::string>> found{{argv[0]}, {}};
    bool needs_value = false, of_petsc = false;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        const bool is_ours = word.starts_with("--");
        const bool is_name = !needs_value && !is_ours && word.size() > 2 && word[0] == '-' &&
                             std::isalpha(static_cast<unsigned char>(word[1])) != 0;
        if (is_name || (of_petsc && !is_ours))
            found.second.push_back(word);
        else
            found.first.push_back(argv[k]);
        of_petsc = is_name;
        needs_value = is_ours && word.find('=') == std::string::npos &&
                      std::find(flags.begin(), flags.end(), word) == flags.end();
    }
    return found;
}

Petsc::Petsc(std::vector<std::string> options) : options_(std::move(options)) {
    std::vector<char*> argv{const_cast<char*>("distributed")};
    for (std::string& option : options_) argv.push_back(option.data());
    argv.push_back(nullptr);
    auto argc = static_cast<int>(argv.size()) - 1;
    char** all = argv.data();
    // No options from the file .petscrc; error codes instead of PETSc's pages about every error.
    PetscOptionsSetValue(nullptr, "-skip_petscrc", "1");
    SlepcInitialize(&argc, &all, nullptr, nullptr);
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    PetscPopSignalHandler();
}

Petsc::~Petsc() {
    SlepcFinalize();
}

void Petsc::require_used() const {
    for (const std::string& option : options_) {
        if (option.size() < 2 || option[0] != '-' ||
            (std::isalpha(static_cast<unsigned char>(option[1])) == 0))
            continue;
        PetscBool used = PETSC_FALSE;
        PetscOptionsUsed(nullptr, option.c_str() + 1, &used);  // its name without the dash
        if (used == PETSC_FALSE)
            throw base::InvalidInput("nothing used PETSc's option " + option +
                                     "; options of this program begin with two dashes");
    }
}

bool has_options(const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(), [](const std::string& name) {
        PetscBool is_set = PETSC_FALSE;
        require(PetscOptionsHasName(nullptr, nullptr, name.c_str(), &is_set));
        return is_set == PETSC_TRUE;
    });
}

void set_default(const std::string& name, const std::string& value) {
    PetscBool is_set = PETSC_FALSE;
    require(PetscOptionsHasName(nullptr, nullptr, name.c_str(), &is_set));
    if (is_set == PETSC_FALSE) require(PetscOptionsSetValue(nullptr, name.c_str(), value.c_str()));
}

}  // namespace distributed
