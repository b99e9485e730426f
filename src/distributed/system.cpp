#include "distributed/system.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "bodies/hats.hpp"
#include "solvers/sparse.hpp"

namespace distributed {

namespace {

using solvers::SparseRows;

/// The place in PETSc's vectors of each of a matrix's columns.
std::vector<PetscInt> places_of_columns(const Numbering& numbering, int n) {
    std::vector<PetscInt> all;
    for (const PetscInt place : numbering.places())
        for (int k = 0; k < n; ++k) all.push_back(n * place + k);
    return all;
}

/// A matrix with n rows for each particle, without room for entries.
Matrix without_entries(const Numbering& numbering, int n) {
    const PetscInt rows = n * numbering.count_of_own();
    Matrix A;
    require(MatCreate(numbering.processes().communicator(), A.made()));
    require(MatSetSizes(A, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE));
    require(MatSetType(A, MATAIJ));
    require(MatSetBlockSize(A, n));
    return A;
}

/// A matrix without entries, with room for exactly those to come.
/// \param near the neighbours of each owned particle
Matrix matrix_for(const Numbering& numbering, int n, const std::vector<std::vector<int>>& near) {
    std::vector<PetscInt> own(n * near.size(), 0), others(own);
    for (std::size_t k = 0; k < near.size(); ++k) {
        PetscInt within = 0;
        for (const int J : near[k])
            if (numbering.is_own(numbering.places()[static_cast<std::size_t>(J)])) ++within;
        for (int i = 0; i < n; ++i) {
            own[n * k + static_cast<std::size_t>(i)] = n * within;
            others[n * k + static_cast<std::size_t>(i)] =
                n * (petsc_int(static_cast<Index>(near[k].size())) - within);
        }
    }
    Matrix A = without_entries(numbering, n);
    require(MatSeqAIJSetPreallocation(A, 0, own.data()));
    require(MatMPIAIJSetPreallocation(A, 0, own.data(), 0, others.data()));
    require(MatSetOption(A, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_TRUE));
    require(MatSetOption(A, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
    return A;
}

/// Puts rows into a matrix. \param first place of the first row \param columns places_of_columns()
void put(Mat A, PetscInt first, const SparseRows& rows, const std::vector<PetscInt>& columns) {
    std::vector<PetscInt> places;
    for (Index row = 0; row < rows.rows(); ++row) {
        const int begin = rows.outerIndexPtr()[row], end = rows.outerIndexPtr()[row + 1];
        places.clear();
        for (int entry = begin; entry < end; ++entry)
            places.push_back(columns[static_cast<std::size_t>(rows.innerIndexPtr()[entry])]);
        const PetscInt place = first + petsc_int(row);
        require(
            MatSetValues(A, 1, &place, end - begin, places.data(), rows.valuePtr() + begin, INSERT_VALUES));
    }
}

/// Rows of a matrix whose length is known only when they are made.
struct Rows {
    std::vector<PetscInt> first{0}, column;
    std::vector<double> value;

    void add(const SparseRows& rows, const std::vector<PetscInt>& columns) {
        for (Index entry = 0; entry < rows.nonZeros(); ++entry) {
            column.push_back(columns[static_cast<std::size_t>(rows.innerIndexPtr()[entry])]);
            value.push_back(rows.valuePtr()[entry]);
        }
        const PetscInt before = first.back();
        for (Index row = 0; row < rows.rows(); ++row) first.push_back(before + rows.outerIndexPtr()[row + 1]);
    }

    [[nodiscard]] Matrix matrix(const Numbering& numbering, int n) const {
        Matrix A = without_entries(numbering, n);
        require(MatSeqAIJSetPreallocationCSR(A, first.data(), column.data(), value.data()));
        require(MatMPIAIJSetPreallocationCSR(A, first.data(), column.data(), value.data()));
        return A;
    }
};

/// The owned particles within some layers of cells of a particle with conditions, in increasing order.
template <int dim, int n>
std::vector<int> edge_of(const Part<dim>& part, const bodies::Conditions<dim, n>& conditions, int layers) {
    std::vector<char> chosen;
    for (const auto& here : conditions) chosen.push_back(here.empty() ? 0 : 1);
    for (; layers > 0; --layers) {
        std::vector<char> more = chosen;
        for (const auto& cell : part.body.cells)
            if (std::any_of(cell.begin(), cell.end(),
                            [&](int I) { return chosen[static_cast<std::size_t>(I)]; }))
                for (const int I : cell) more[static_cast<std::size_t>(I)] = 1;
        chosen = more;
    }
    std::vector<int> edge;
    for (const int I : part.own)
        if (chosen[static_cast<std::size_t>(I)] != 0) edge.push_back(I);
    return edge;
}

/// Factors that scale the equations of collocation to those of linear elements, to leading order in the size
/// of an element: minus the volume inside, an area (in the plane a length) for a load, 1 for a given value.
template <int dim, int n>
Eigen::VectorXd weights_of_elements(const bodies::Hats<dim, n>& hats,
                                    const bodies::Conditions<dim, n>& conditions,
                                    const std::vector<int>& rows) {
    Eigen::VectorXd weights(static_cast<Index>(n * rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double volume = hats.volume(rows[k]);
        const auto& here = conditions[static_cast<std::size_t>(rows[k])];
        for (std::size_t i = 0; i < n; ++i)
            weights[static_cast<Index>(n * k + i)] = here.empty()       ? -volume
                                                     : here[i].of_value ? 1
                                                                        : std::pow(volume, 1 - 1.0 / dim);
    }
    return weights;
}

/// A diagonal matrix of ones.
SparseRows unity(Index rows) {
    SparseRows one(rows, rows);
    one.setIdentity();
    return one;
}

void finish(const Matrix& A) {
    if (A == nullptr) return;
    require(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    require(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
}

}  // namespace

template <int dim, int n>
System assembled(const Numbering& numbering, const Part<dim>& part, const bodies::Problem<dim, n>& problem,
                 const bodies::Conditions<dim, n>& conditions,
                 const std::optional<Approximation<dim>>& approximation, bodies::Wanted wanted,
                 const std::function<void(double)>& step) {
    const Processes& processes = numbering.processes();
    const bool for_solution = wanted == bodies::Wanted::solution;
    const std::size_t own = part.own.size();
    std::vector<std::vector<int>> near(own);
    processes.together([&] {
        base::for_each_index(static_cast<Index>(own), [&](Index k) {
            const auto place = static_cast<std::size_t>(k);
            near[place] = approximation->neighbours(part.own[place]);
        });
    });
    System system;
    system.A = matrix_for(numbering, n, near);
    if (!for_solution) system.M = matrix_for(numbering, n, near);
    std::vector<std::vector<int>>().swap(near);
    require(MatCreateVecs(system.A, system.weights.made(), system.b.made()));

    std::optional<bodies::Hats<dim, n>> hats;
    processes.together([&] {
        if (approximation && for_solution) hats.emplace(problem, part.body, *approximation);
    });
    Rows elements;
    const std::vector<PetscInt> columns = places_of_columns(numbering, n);
    processes.together([&] {
        constexpr std::size_t at_once = 1U << 14U;  // the rows exist twice meanwhile
        for (std::size_t first = 0; first < own; first += at_once) {
            const std::vector<int> rows(
                part.own.begin() + static_cast<std::ptrdiff_t>(first),
                part.own.begin() + static_cast<std::ptrdiff_t>(std::min(first + at_once, own)));
            bodies::System some = bodies::collocated(problem, conditions, *approximation, wanted, rows);
            SparseRows& other = some.M;
            if (for_solution) other = unity(some.A.rows());
            solvers::scale_rows(some.A, some.b, other);
            for (Index row = 0; row < some.A.rows(); ++row)
                if (!std::isfinite(some.A.row(row).sum() + some.b[row]))
                    throw base::FailedComputation(
                        bodies::name(part.how.method) + ": the equations of the particle at " +
                        particles::shown_point(
                            Point<dim>(part.body.x.col(rows[static_cast<std::size_t>(row / n)]))) +
                        " are zero or not finite; take another smoothing length or other particles");
            const PetscInt place = n * (numbering.first() + petsc_int(static_cast<Index>(first)));
            put(system.A, place, some.A, columns);
            if (for_solution) {
                elements.add(hats->elements(conditions, rows), columns);
                const Eigen::VectorXd weights =
                    weights_of_elements(*hats, conditions, rows).cwiseQuotient(other.diagonal());
                for (Index row = 0; row < weights.size(); ++row)
                    require(VecSetValue(system.weights, place + petsc_int(row), weights[row], INSERT_VALUES));
            } else {
                put(system.M, place, other, columns);
            }
            for (Index row = 0; row < some.b.size(); ++row)
                require(VecSetValue(system.b, place + petsc_int(row), some.b[row], INSERT_VALUES));
            if (step) step(static_cast<double>(first + rows.size()) / static_cast<double>(own));
        }
    });
    finish(system.A);
    finish(system.M);
    if (!for_solution) return system;
    system.elements = elements.matrix(numbering, n);
    for (const int I : edge_of(part, conditions, 2))
        for (PetscInt k = 0; k < n; ++k)
            system.edge.push_back(n * numbering.places()[static_cast<std::size_t>(I)] + k);
    require(VecAssemblyBegin(system.b));
    require(VecAssemblyEnd(system.b));
    require(VecAssemblyBegin(system.weights));
    require(VecAssemblyEnd(system.weights));
    return system;
}

template System assembled(const Numbering&, const Part<2>&, const bodies::Problem<2, 1>&,
                          const bodies::Conditions<2, 1>&, const std::optional<Approximation<2>>&,
                          bodies::Wanted, const std::function<void(double)>&);
template System assembled(const Numbering&, const Part<3>&, const bodies::Problem<3, 1>&,
                          const bodies::Conditions<3, 1>&, const std::optional<Approximation<3>>&,
                          bodies::Wanted, const std::function<void(double)>&);
template System assembled(const Numbering&, const Part<2>&, const bodies::Problem<2, 2>&,
                          const bodies::Conditions<2, 2>&, const std::optional<Approximation<2>>&,
                          bodies::Wanted, const std::function<void(double)>&);
template System assembled(const Numbering&, const Part<3>&, const bodies::Problem<3, 3>&,
                          const bodies::Conditions<3, 3>&, const std::optional<Approximation<3>>&,
                          bodies::Wanted, const std::function<void(double)>&);

}  // namespace distributed
