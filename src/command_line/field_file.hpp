#pragma once

#include <string>
#include <vector>

#include "command_line/example_cases.hpp"
#include "command_line/timed_solutions.hpp"
#include "particles/points.hpp"
#include "report/table.hpp"

namespace command_line {

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

}  // namespace command_line
