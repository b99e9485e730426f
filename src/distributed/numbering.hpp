#pragma once

#include <Eigen/Core>
#include <vector>

#include "distributed/part.hpp"
#include "distributed/petsc.hpp"
#include "distributed/processes.hpp"

namespace distributed {

/// Where particles stand in PETSc's vectors: those of each process one after another, in the order of their
/// numbers.
class Numbering {
  public:
    /// \param unknowns of each particle
    /// \throws base::InvalidInput for more unknowns than PETSc can count
    template <int dim>
    Numbering(const Processes& processes, const Part<dim>& part, int unknowns)
        : Numbering(processes, part.number, part.own, part.extent.particles, unknowns) {}

    [[nodiscard]] const Processes& processes() const { return processes_; }
    /// The place of each particle of the part.
    [[nodiscard]] const std::vector<PetscInt>& places() const { return places_; }
    /// The place of the first owned particle.
    [[nodiscard]] PetscInt first() const { return first_; }
    [[nodiscard]] PetscInt count_of_own() const { return static_cast<PetscInt>(own_.size()); }
    [[nodiscard]] bool is_own(PetscInt place) const {
        return place >= first_ && place < first_ + count_of_own();
    }

    /// Numbers at all particles of the part, from those at the owned particles of all processes.
    /// \param at_own a column for each owned particle \return a column for each particle of the part
    [[nodiscard]] Eigen::MatrixXd at_all(const Eigen::MatrixXd& at_own) const;

  private:
    Numbering(const Processes& processes, const std::vector<Index>& number, std::vector<int> own,
              Index particles, int unknowns);

    const Processes& processes_;
    std::vector<int> own_;
    PetscInt first_ = 0;
    std::vector<PetscInt> places_;
};

}  // namespace distributed
