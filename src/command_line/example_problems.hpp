#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "batra2008/section_4_example_problems.hpp"
#include "command_line/command_line.hpp"
#include "command_line/lists.hpp"
#include "report/file.hpp"
#include "report/table.hpp"

namespace command_line {

/// What both example problems of batra2008 can be asked. Lists are texts such as 3,3.5,4 or ranges such as 2:0.1:4.
struct ExampleOptions {
    std::vector<std::string> methods{"all"};
    std::string scaling, poisson, plane;
    std::string test_scaling = "1", gauss = "10", degree = "2", penalty;
    std::string states, field;
    long points = 101;
    bool seconds = false;
    int threads = 0;
    std::string output;
};

/// \param places what `--states` knows beside particles and a grid
void add_options(CommandLine& app, ExampleOptions& options, const std::string& places);

/// Refuses particles and places of states whose matrices and rows cannot be held. \throws base::InvalidInput
/// \param neighbours of a particle at the least, within the support of the basis
void check_cloud(double particles, double neighbours);
void check_states(double places);

/// One thing to solve: a method with its parameters, and a material.
struct ExampleCase {
    batra2008::example_problems::Discretisation how;
    batra2008::elastostatics::Material material;
};

/// All cases that the options ask for, method by method.
/// \param E Young's modulus \param penalty the print's penalty parameter, for `--penalty` is a factor to it
/// \throws base::InvalidInput for what has no meaning, and for more cases than can be held
std::vector<ExampleCase> cases(
    const ExampleOptions& options, double E,
    const std::function<double(const batra2008::elastostatics::Material&)>& penalty);

/// What a solution took.
struct Cost {
    double assembly = 0, solution = 0;  ///< [s]
    double megabytes = 0;               ///< most memory held meanwhile
};

/// The solution of a problem, timed.
batra2008::example_problems::Solution solved(const batra2008::Problem& problem,
                                             const batra2008::Cloud<2>& cloud,
                                             const batra2008::example_problems::Discretisation& how,
                                             Cost& cost);

/// `--seconds`: columns of the cost, and their cells.
void add_cost_columns(report::Table& table);
void add_cost(std::vector<report::Cell>& row, const Cost& cost);

/// A solution together with what it belongs to.
struct Solved {
    const batra2008::Problem& problem;
    const batra2008::Cloud<2>& cloud;
    const batra2008::example_problems::Solution& solution;
};

/// Columns that name a case, and the cells that fill them.
std::vector<report::ColumnHead> case_columns();
std::vector<report::Cell> case_cells(const ExampleCase& of);

/// Columns of a state, computed and exact, and their cells at some places: one row each, behind the cells that name the case.
/// Stresses are reproducible to 10 Pa, and where a material is nearly incompressible, to what a strain of 1e-12 makes of stress.
std::vector<report::ColumnHead> state_columns(const std::vector<ExampleCase>& cases);
void add_states(report::Table& table, const std::vector<report::Cell>& of, const Solved& solved,
                const std::vector<batra2008::Point<2>>& places);

/// `--field`: displacements and stresses at the particles, computed and exact. The file's name decides: .vtk for ParaView (legacy
/// format), else CSV. It is written once all solutions are known.
class FieldFile {
  public:
    /// \param cases what will be added \throws base::FailedComputation for a file that could not be written in the end
    FieldFile(std::string path, const std::vector<ExampleCase>& cases);
    /// \throws base::InvalidInput for solutions on other particles than the first
    void add(const ExampleCase& of, const Solved& solved);
    void write() const;

  private:
    std::string path_;
    report::Table table_;
    batra2008::Points<2> x_;
    std::string vtk_;
};

}  // namespace command_line
