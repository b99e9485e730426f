#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

/// Benchmarks of the papers and of the text on FPM in space, and what limits them.
namespace benchmarks {

/// One piece of work on so many particles.
struct Task {
    std::string name;    ///< "assembly", "application", …
    std::string method;  ///< formulation, method of the plate, or what a limit limits
    long particles;
    int threads;
    double bytes = 0;         ///< that a particle's share of the result takes, or that it must move
    double exponentials = 0;  ///< that a particle needs
    bool once = false;        ///< too long to be repeated
    double operations = 0;    ///< that a particle needs, if they were counted
};

/// Registers a piece of work. \param prepare makes what is to be timed; it is called once, before
void add(const Task& task, const std::function<std::function<void()>()>& prepare);

/// The limits of the machine: triad bandwidth and vectorised exponentials, by threads.
void add_limits();
/// The operators and tests of Asprone et al. (2010). \param most particles at most
void add_asprone2010(long most);
/// The basis and methods of Batra and Zhang (2008).
void add_batra2008(long most);
/// The weights of the formulations in the plane and in space, with the operations that they take.
void add_fpm_in_space();

}  // namespace benchmarks
