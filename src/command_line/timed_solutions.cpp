#include "command_line/timed_solutions.hpp"

#include <malloc.h>

#include <chrono>
#include <fstream>
#include <string>
#include <utility>

namespace command_line {

using namespace batra2008;
namespace plate_and_hole = fpm_in_space::plate_and_hole;

namespace {

/// Largest memory of this process since reset_peak(), in MB; zero where the system does not say.
double peak() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
    return 0;
}
void reset_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// The solution of a problem, timed.
/// \param assembled makes the equations \param solved solves them
template <class Assembled, class Solved>
auto timed(const Assembled& assembled, const Solved& solved, About& about) {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    reset_peak();
    const auto start = Clock::now();
    auto equations = assembled();
    const auto middle = Clock::now();
    auto solution = solved(std::move(equations));
    about.assembly = Seconds(middle - start).count();
    about.solution = Seconds(Clock::now() - middle).count();
    about.megabytes = peak();
    return solution;
}

/// What is asked of a solution, as a function of the place.
template <class AnySolution, class At>
auto of_place(const Cloud<2>& cloud, const AnySolution& solution, const At& at) {
    return [&cloud, solution, at](const Point<2>& x) { return at(cloud, solution, x); };
}

/// By the methods of the paper.
Solution solved_by_ssph(const Problem& problem, const Cloud<2>& cloud,
                        const example_problems::Discretisation& how, About& about) {
    const auto solution = timed(
        [&] {
            System system = example_problems::system(problem, cloud, how);
            about.worst = system.worst;
            return system;
        },
        [&](System&& system) {
            return example_problems::Solution{how, problem.material,
                                              example_problems::smoothing_lengths(cloud, how),
                                              batra2008::solved(std::move(system))};
        },
        about);
    return {of_place(cloud, solution, example_problems::displacement_at),
            of_place(cloud, solution, example_problems::state_at), example_problems::noise(cloud, solution)};
}

/// By the second-order FPM.
Solution solved_by_fpm(const Problem& problem, const Cloud<2>& cloud,
                       const plate_and_hole::Discretisation& how, About& about) {
    const auto solution = timed(
        [&] {
            auto equations = plate_and_hole::collocated(problem, cloud, how);
            about.worst = equations.system.worst;
            return equations;
        },
        [&](plate_and_hole::Collocated&& equations) {
            return plate_and_hole::solved(std::move(equations), problem.material);
        },
        about);
    return {of_place(cloud, solution, plate_and_hole::displacement_at),
            of_place(cloud, solution, plate_and_hole::state_at),
            {}};
}

}  // namespace

void give_freed_memory_back() {
    malloc_trim(0);
}

Solution solved(const ExampleCase& one, const Problem& problem, const Cloud<2>& cloud, About& about) {
    return one.is_fpm() ? solved_by_fpm(problem, cloud, one.fpm, about)
                        : solved_by_ssph(problem, cloud, one.ssph, about);
}

}  // namespace command_line
