#include <omp.h>

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/number.hpp"
#include "command_line/body_options.hpp"
#include "command_line/options.hpp"
#include "distributed/field_file.hpp"
#include "distributed/grid.hpp"
#include "distributed/table.hpp"
#include "distributed/terminal.hpp"
#include "meshes/gmsh.hpp"
#include "report/file.hpp"

namespace {

using base::InvalidInput;
using bodies::Body;
using bodies::Index;
using distributed::Grid;
using distributed::Options;
using distributed::Processes;

/// The numbers of a text such as 101x51.
std::vector<std::string> sizes(const std::string& option, const std::string& text,
                               const std::string& example) {
    std::vector<std::string> all = command_line::parts(text, 'x');
    if (all.size() != 2 && all.size() != 3)
        throw InvalidInput(option + ": " + base::quoted(text) +
                           " is not a size along each of 2 or 3 axes; write " + option + " " + example);
    return all;
}

template <int dim>
Grid<dim> grid(const Options& options, const std::vector<std::string>& counts) {
    Grid<dim> found{};
    const std::vector<std::string> lengths = sizes("--lengths", options.lengths, dim == 2 ? "2x1" : "2x1x1");
    if (lengths.size() != dim)
        throw InvalidInput("--lengths " + options.lengths + " has " + std::to_string(lengths.size()) +
                           " lengths, and --grid " + options.grid + " " + std::to_string(dim) + " numbers");
    for (std::size_t axis = 0; axis < dim; ++axis) {
        found.count[axis] = command_line::whole_number("--grid", counts[axis]);
        found.length[static_cast<Index>(axis)] = command_line::number("--lengths", lengths[axis]);
    }
    command_line::of_option("--grid", [&] { return distributed::checked_size(found); });
    return found;
}

/// A body that the first process has read.
template <int dim>
distributed::Whole<dim> whole(const Processes& processes, meshes::Model& model) {
    auto* body = processes.is_first() ? &std::get<Body<dim>>(model.body) : nullptr;
    return {processes, body != nullptr ? std::make_unique<Body<dim>>(std::move(*body)) : nullptr};
}

report::Table table_of(const distributed::Petsc& petsc, const Processes& processes, Options& options) {
    if (!options.grid.empty()) {
        const auto counts = sizes("--grid", options.grid, "101x51");
        if (options.lengths.empty()) options.lengths = counts.size() == 2 ? "1x1" : "1x1x1";
        if (counts.size() == 2)
            return distributed::table<2>(petsc, processes, options, {processes, grid<2>(options, counts)});
        return distributed::table<3>(petsc, processes, options, {processes, grid<3>(options, counts)});
    }
    meshes::Model model;
    processes.together([&] {
        if (processes.is_first()) model = meshes::read(options.mesh, options.size);
    });
    const bool in_plane = processes.from(0, static_cast<double>(model.body.index())) == 0;
    if (in_plane)
        return distributed::table<2>(petsc, processes, options, whole<2>(processes, model), model.notes);
    return distributed::table<3>(petsc, processes, options, whole<3>(processes, model), model.notes);
}

/// Refuses options that need, exclude or overwrite one another; names the methods.
void check(Options& options, int processes) {
    if (options.mesh.empty() == options.grid.empty())
        throw InvalidInput(options.mesh.empty() ? "there is no body; give --mesh FILE, or --grid 101x51"
                                                : "--mesh and --grid are two bodies; leave one out");
    if (options.size && options.mesh.empty())
        throw InvalidInput("--size belongs to a drawing, --mesh; a grid has the particles of --grid");
    if (!options.lengths.empty() && options.grid.empty())
        throw InvalidInput("--lengths belongs to --grid; leave it out beside --mesh");
    const std::vector<std::string> known{"fpm", "strong"};
    if (options.methods.empty()) options.methods = {"fpm"};
    options.methods = command_line::chosen("method", options.methods, known);
    command_line::check_methods(options, known);
    if (!options.field.empty()) distributed::check_field_path(options.field);
    const std::string why = " shows a solution, and --modes asks for eigenvalues; leave one of them out";
    if (options.modes > 0 && !options.places.empty()) throw InvalidInput(options.places.front().option + why);
    if (options.modes > 0 && options.seconds) throw InvalidInput("--seconds" + why);
    if (options.modes > 0 && !options.field.empty()) throw InvalidInput("--field" + why);
    const auto check_apart = [&](const std::string& field) {
        command_line::check_apart(
            {{"--output", options.output}, {"--field", field}, {"--mesh", options.mesh}});
    };
    check_apart(options.field);
    for (int process = 0; process < processes && !options.field.empty(); ++process)
        check_apart(distributed::piece_of(options.field, process));
}

void add_options(command_line::CommandLine& app, Options& options) {
    app.column_width(34);
    app.add_option(
           "--grid", options.grid,
           "a rectangle or a box of so many particles along each axis, its sides named left, right, bottom, top, back, front")
        .type_name("NXxNY[xNZ]");
    app.add_option("--lengths", options.lengths, "with --grid: its lengths (default 1 along each axis)")
        .type_name("LXxLY[xLZ]");
    app.add_option(
           "--mesh", options.mesh,
           "instead, a drawing or a mesh that Gmsh reads, on the first process; its physical groups name the sides")
        .type_name("FILE");
    app.add_option("--size", options.size, "size of the cells of a drawing (default: that of the drawing)")
        .type_name("D");
    command_line::add_options(app, options.problem);
    command_line::add_collocation_options(app, options);
    app.add_repeated("--at", options.places, "a place where all quantities are wanted").type_name("X,Y[,Z]");
    app.add_repeated("--along", options.places, "N places on a line, its ends among them")
        .type_name("X0,Y0:X1,Y1:N");
    app.add_option("--modes", options.modes, "the K lowest eigenvalues instead; loads count as zero")
        .type_name("K")
        .within(1, 1000);
    app.add_flag("--seconds", options.seconds, "add seconds, iterations and bytes of memory");
    app.add_option("--field", options.field,
                   "file for the fields, .pvtu for ParaView, with a piece of each process beside it")
        .type_name("FILE");
    app.add_option("--threads", options.threads, "threads of each process (default 1)")
        .type_name("N")
        .within(1, 1024);
    app.add_output(options.output);
}

}  // namespace

int main(int argc, char** argv) {
    auto [own, of_petsc] = distributed::divided(argc, argv, {"--seconds"});
    const distributed::Petsc petsc(of_petsc);
    const Processes processes(PETSC_COMM_WORLD);
    const distributed::FirstSpeaks first_speaks(processes);
    command_line::CommandLine app(
        "A body on many processes, in the plane or in space, by collocation: the table of `body`, with equations solved by PETSc and eigenvalues by SLEPc. Each process holds a part of the particles; a single process holds all.",
        "distributed",
        "PETSc's options have one dash: -ksp_rtol 1e-10, -ksp_monitor, -pc_type asm, -log_view.\n"
        "Example: mpirun -n 4 distributed --grid 1001x1001 --equation poisson --source 1 --value \"left: 0\" --at 0.5,0.5\n"
        "Another: mpirun -n 4 distributed --mesh strip.geo --size 1e-3 --young 210e9 --poisson 0.3 --symmetry middle --symmetry neck --traction \"end: 1e6, 0\" --field strip.pvtu");
    Options options;
    add_options(app, options);
    return command_line::run(app, static_cast<int>(own.size()), own.data(), [&] {
        check(options, processes.count());
        processes.together([&] {
            if (!processes.is_first()) return;
            report::check_writable(options.output);
            if (!options.field.empty()) report::check_writable(options.field);
        });
        // Each process has a core of its own.
        omp_set_num_threads(options.threads > 0 ? options.threads : 1);
        const report::Table table = table_of(petsc, processes, options);
        processes.together([&] {
            if (processes.is_first()) report::write_whole(options.output, report::csv(table));
        });
        if (!table.incomplete.empty()) throw base::FailedComputation(table.incomplete);
        return 0;
    });
}
