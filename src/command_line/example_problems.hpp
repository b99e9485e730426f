#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batra2008/section_4_example_problems.hpp"
#include "command_line/command_line.hpp"
#include "command_line/plot.hpp"
#include "command_line/sweep.hpp"
#include "fpm_in_space/section_7_plate_and_hole.hpp"
#include "report/table.hpp"

namespace command_line {

/// The options of both example problems of batra2008.
struct ExampleOptions {
    std::vector<std::string> methods{"all"};
    std::vector<double> scaling{3}, test_scaling{1}, penalty{1}, poisson{0.33};
    std::vector<long> gauss{10}, degree{2};
    double smoothing = 1.2;
    std::string plane = "stress";
    std::optional<std::string> smoothing_from;
    std::string fpm_smoothing_from = "nearest";  ///< where --smoothing-from is not given; SSPH takes nearest
    std::string states, field;
    long points = 101;
    bool seconds = false, quality = false;
    int threads = 0;
    std::string output;
    Figure figure;  ///< the program sets the script, --plot the file
    /// Whether an option is on the command line.
    std::function<bool(const std::string& option)> given = [](const std::string&) { return false; };
};

/// Adds the options of an example problem to its command line.
/// \param places what `--states` takes beside particles and a grid
void add_options(CommandLine& app, ExampleOptions& options, const std::string& places);

/// Refuses an option that names the same file as one of the outputs. \throws base::InvalidInput
void check_apart_from_outputs(const ExampleOptions& options, const std::string& option,
                              const std::string& file);

/// Refuses particles whose matrices do not fit into memory. \throws base::InvalidInput
/// \param neighbours least number of a particle's neighbours within the support of the basis
void check_cloud(double particles, double neighbours);

/// One thing to solve: a method with its parameters, and a material.
struct ExampleCase {
    std::string method;
    batra2008::example_problems::Discretisation ssph;  ///< of strong, weak1 and weak2
    fpm_in_space::plate_and_hole::Discretisation fpm;
    batra2008::elastostatics::Material material;

    [[nodiscard]] bool is_fpm() const { return method == "fpm"; }
    /// Whether the method imposes conditions at the particles of the boundary, corners among them.
    [[nodiscard]] bool is_collocation() const { return method == "strong" || is_fpm(); }
};

/// All cases of the options, method by method.
/// \param E Young's modulus \param penalty the print's penalty parameter, which `--penalty` multiplies
/// \throws base::InvalidInput for what has no meaning, and for more cases than fit into memory
std::vector<ExampleCase> cases(
    const ExampleOptions& options, double E,
    const std::function<double(const batra2008::elastostatics::Material&)>& penalty);

/// A solution by any of the methods.
struct Solution {
    std::function<batra2008::Vector(const batra2008::Point<2>&)> displacement;
    std::function<batra2008::example_problems::State(const batra2008::Point<2>&)> state;
    std::optional<double> noise;  ///< of methods whose field need not meet the unknowns
};

/// What the example problems ask of a solution.
inline batra2008::Vector displacement_at(const batra2008::Cloud<2>& /*cloud*/, const Solution& solution,
                                         const batra2008::Point<2>& x) {
    return solution.displacement(x);
}
inline batra2008::example_problems::State state_at(const batra2008::Cloud<2>& /*cloud*/,
                                                   const Solution& solution, const batra2008::Point<2>& x) {
    return solution.state(x);
}

/// A solution with its problem and particles.
struct Solved {
    const batra2008::Problem& problem;
    const batra2008::Cloud<2>& cloud;
    const Solution& solution;
};

/// Columns that name a case, and the cells that fill them.
std::vector<report::ColumnHead> case_columns();
std::vector<report::Cell> case_cells(const ExampleCase& one);

/// Columns of displacements and stresses, computed and exact.
/// Stresses are reproducible to 10 Pa; where a material is nearly incompressible, to the stress of a strain
/// of 1e-12.
std::vector<report::ColumnHead> state_columns(const std::vector<ExampleCase>& cases);

/// The places that a set of positions holds.
std::vector<batra2008::Point<2>> places_at(const batra2008::Points<2>& x);

/// Places at equal distances on a line, its ends among them.
std::vector<batra2008::Point<2>> places_between(const batra2008::Point<2>& from,
                                                const batra2008::Point<2>& to, long count);

/// The two counts of a grid that `--states` names, such as 46x11.
/// \throws base::InvalidInput for another text, and for more places than fit into memory
std::array<long, 2> grid_of_places(const std::string& states);

/// `--field`: displacements and stresses at the particles, computed and exact. The file's name decides the
/// format: .vtk for ParaView (legacy unstructured grid, a vertex for each particle), else CSV. It is written
/// once all solutions are known.
class FieldFile {
  public:
    /// \param cases what will be added \throws base::FailedComputation for a file that could not be written
    ///         in the end
    FieldFile(std::string path, const std::vector<ExampleCase>& cases);
    /// \throws base::InvalidInput for other particles than the first
    void require_same(const batra2008::Points<2>& x);
    /// Adds a solution on these particles.
    void add(const ExampleCase& one, const Solved& solved);
    void write() const;

  private:
    std::string path_;
    report::Table table_;
    batra2008::Points<2> x_;
    std::string vtk_;
};

/// The table of an example problem: for each solution one row of errors, or with `--states` one row for each
/// place.
class ExampleTable {
  public:
    using Places = std::function<std::vector<batra2008::Point<2>>()>;
    using Errors = std::function<std::vector<report::Cell>(const Solved&)>;

    /// \param about first comment of the table \param layout columns that name the particles \param errors
    ///         columns of the errors
    ExampleTable(const ExampleOptions& options, const std::vector<ExampleCase>& cases,
                 const std::string& about, const std::vector<report::ColumnHead>& layout,
                 const std::vector<report::ColumnHead>& errors);

    /// Adds a line above the table.
    void add_comment(const std::string& words) { table_.comments.push_back(words); }

    /// Solves a problem on a cloud, and adds its rows; where that fails, one row with the reason, as Sweep
    /// says.
    /// \param layout cells of the columns that name the particles \param places those of `--states` other
    ///         than the particles \param errors cells of the columns of the errors
    void add(const ExampleCase& one, const batra2008::Problem& problem, const batra2008::Cloud<2>& cloud,
             const std::vector<report::Cell>& layout, const Places& places, const Errors& errors);

    /// The whole table, with a comment where solutions are noisy; the file of `--field` is written with what
    /// could be solved.
    /// \throws as Sweep::finish()
    report::Table finished();

  private:
    [[nodiscard]] std::string in_words(const std::vector<report::Cell>& named) const;
    void warn_of(double noise, const std::vector<report::Cell>& named);
    void note_quality(const particles::WorstRow& row, const std::vector<report::Cell>& named,
                      const batra2008::Cloud<2>& cloud);

    ExampleOptions options_;
    FieldFile field_;
    report::Table table_;
    Sweep sweep_;
    long noisy_ = 0;  ///< number of cases
    double most_noise_ = 0;
    std::string noisiest_;  ///< the case of it
    double largest_R_ = 0;
    std::string worst_row_;  ///< of it, with its case and its place
};

}  // namespace command_line
