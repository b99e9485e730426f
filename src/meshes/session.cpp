#include "meshes/session.hpp"

#include <fcntl.h>
#include <gmsh.h>
#include <omp.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>
#include <vector>

#include "base/errors.hpp"

namespace meshes {

using base::InvalidInput;

namespace {

/// The file that Gmsh runs as a script: the command Exit in it ends the program.
std::string running;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void say_where_it_ended() {
    if (running.empty()) return;
    std::cerr << running << " says Exit, which ends the program that reads it; remove that line\n";
    std::_Exit(2);
}

void be_silent() {
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.AbortOnError", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
}

}  // namespace

Quiet::Quiet() : output_((std::fflush(stdout), dup(STDOUT_FILENO))) {
    const int nowhere = open("/dev/null", O_WRONLY);  // NOLINT(cppcoreguidelines-pro-type-vararg)
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
}

Quiet::~Quiet() {
    std::fflush(stdout);
    dup2(output_, STDOUT_FILENO);
    close(output_);
}

Session::Session(std::string path) : path_(std::move(path)), threads_(omp_get_max_threads()) {
    static const int registered = std::atexit(say_where_it_ended);
    static_cast<void>(registered);
    gmsh::initialize(0, nullptr, false);
    be_silent();
    gmsh::logger::start();
}

Session::~Session() {
    gmsh::logger::stop();
    gmsh::finalize();
    omp_set_num_threads(threads_);
}

void Session::open() const {
    running = path_;
    gmsh::open(path_);
    running.clear();
    be_silent();  // whatever a script says
    check("Gmsh cannot read it");
}

void Session::check(const std::string& what) const {
    std::vector<std::string> lines;
    gmsh::logger::get(lines);
    for (const std::string& line : lines)
        for (const std::string label : {"Error: ", "Fatal: "})
            if (line.starts_with(label))
                throw InvalidInput(path_ + ": " + what + ": " + line.substr(label.size()) +
                                   "; correct it there, gmsh " + path_ + " shows it");
}

void check_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InvalidInput(path + " is a folder; name a file in it");
    if (std::FILE* const file = std::fopen(path.c_str(), "r")) {
        std::fclose(file);
        return;
    }
    throw InvalidInput("cannot read " + path + ": " + std::strerror(errno));
}

}  // namespace meshes
