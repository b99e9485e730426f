#include "distributed/numbering.hpp"

#include <petscao.h>
#include <petscvec.h>

#include <limits>
#include <string>

#include "base/errors.hpp"

namespace distributed {

Numbering::Numbering(const Processes& processes, const std::vector<Index>& number, std::vector<int> own,
                     Index particles, int unknowns)
    : processes_(processes), own_(std::move(own)) {
    if (particles > std::numeric_limits<PetscInt>::max() / unknowns)
        throw base::InvalidInput(std::to_string(particles) + " particles with " + std::to_string(unknowns) +
                                 " unknowns are more than PETSc counts in " +
                                 std::to_string(8 * sizeof(PetscInt)) +
                                 " bits; compile with libpetsc64-real-dev and libslepc64-real-dev");
    std::vector<PetscInt> of_own;
    for (const int I : own_) of_own.push_back(static_cast<PetscInt>(number[static_cast<std::size_t>(I)]));
    PetscInt count = count_of_own();
    MPI_Exscan(&count, &first_, 1, MPIU_INT, MPI_SUM, processes_.communicator());
    if (processes_.is_first()) first_ = 0;
    places_.assign(number.begin(), number.end());
    Owned<AO, AODestroy> order;
    require(AOCreateMemoryScalable(processes_.communicator(), count, of_own.data(), nullptr, order.made()));
    require(AOApplicationToPetsc(order, static_cast<PetscInt>(places_.size()), places_.data()));
}

Eigen::MatrixXd Numbering::at_all(const Eigen::MatrixXd& at_own) const {
    const auto rows = static_cast<PetscInt>(at_own.rows()), own = count_of_own();
    Owned<Vec, VecDestroy> from, to;
    Owned<IS, ISDestroy> where;
    Owned<VecScatter, VecScatterDestroy> scatter;
    Eigen::MatrixXd all(at_own.rows(), static_cast<Index>(places_.size()));
    require(VecCreateMPIWithArray(processes_.communicator(), rows, rows * own, PETSC_DECIDE, at_own.data(),
                                  from.made()));
    require(VecCreateSeqWithArray(PETSC_COMM_SELF, rows, static_cast<PetscInt>(all.size()), all.data(),
                                  to.made()));
    require(ISCreateBlock(PETSC_COMM_SELF, rows, static_cast<PetscInt>(places_.size()), places_.data(),
                          PETSC_USE_POINTER, where.made()));
    require(VecScatterCreate(from, where, to, nullptr, scatter.made()));
    require(VecScatterBegin(scatter, from, to, INSERT_VALUES, SCATTER_FORWARD));
    require(VecScatterEnd(scatter, from, to, INSERT_VALUES, SCATTER_FORWARD));
    return all;
}

}  // namespace distributed
