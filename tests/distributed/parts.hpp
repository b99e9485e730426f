#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "bodies/collocation.hpp"
#include "distributed/part.hpp"
#include "tests/support/bodies.hpp"

namespace support {

/// The rows of a matrix as they are stored: for each row, factors by the number of the column.
using StoredRows = std::vector<std::map<bodies::Index, double>>;

/// \param number of each particle that has columns \param n unknowns of each
inline StoredRows stored(const solvers::SparseRows& A, const std::vector<bodies::Index>& number, int n) {
    StoredRows rows(static_cast<std::size_t>(A.rows()));
    for (bodies::Index row = 0; row < A.rows(); ++row)
        for (solvers::SparseRows::InnerIterator entry(A, row); entry; ++entry)
            rows[static_cast<std::size_t>(row)]
                [n * number[static_cast<std::size_t>(entry.col() / n)] + entry.col() % n] = entry.value();
    return rows;
}

/// The rows of the own particles of a part, and where they are in the whole body.
template <int dim, int n>
void check_rows_are_those_of(const bodies::Problem<dim, n>& problem, const bodies::Body<dim>& body,
                             const bodies::Discretisation& how, const distributed::Part<dim>& part) {
    if (part.own.empty()) return;
    const bodies::Approximation<dim> whole(bodies::Cloud<dim>(body.x), how);
    const bodies::Approximation<dim> of_part = distributed::approximation_of(part);
    const auto wanted = bodies::Wanted::eigenvalues;
    std::vector<int> rows;
    for (const int I : part.own) rows.push_back(static_cast<int>(part.number[static_cast<std::size_t>(I)]));
    std::vector<bodies::Index> all;
    for (bodies::Index I = 0; I < body.x.cols(); ++I) all.push_back(I);
    const auto expected = bodies::collocated(problem, bodies::conditions(problem, body), whole, wanted, rows);
    const auto found =
        bodies::collocated(problem, bodies::conditions(problem, part.body), of_part, wanted, part.own);
    CHECK(stored(found.A, part.number, n) == stored(expected.A, all, n));
    CHECK(stored(found.M, part.number, n) == stored(expected.M, all, n));
    CHECK((found.b.array() == expected.b.array()).all());
}

/// Each particle, piece and cell of a body belongs to one part.
template <int dim>
void check_parts_are_of(const bodies::Body<dim>& body, const std::vector<distributed::Part<dim>>& parts) {
    std::vector<bodies::Index> own;
    std::size_t pieces = 0, cells = 0, all_pieces = 0;
    for (const auto& part : parts) {
        CHECK(std::is_sorted(part.number.begin(), part.number.end()));
        for (const int I : part.own) own.push_back(part.number[static_cast<std::size_t>(I)]);
        for (const auto& side : part.body.sides) pieces += side.pieces.size();
        cells += static_cast<std::size_t>(part.own_cells);
        for (bodies::Index k = 0; k < part.body.x.cols(); ++k)
            CHECK(part.body.x.col(k) == body.x.col(part.number[static_cast<std::size_t>(k)]));
    }
    std::sort(own.begin(), own.end());
    CHECK(static_cast<bodies::Index>(own.size()) == body.x.cols());
    CHECK(std::adjacent_find(own.begin(), own.end()) == own.end());
    for (const auto& side : body.sides) all_pieces += side.pieces.size();
    CHECK(pieces == all_pieces);
    CHECK(cells == body.cells.size());
}

/// Poisson's equation with a varying conductivity, values on the left and fluxes elsewhere.
template <int dim>
bodies::Problem<dim, 1> heat() {
    bodies::Problem<dim, 1> problem{bodies::diffusion<dim>(
        [](const bodies::Point<dim>& x) { return 1 + x[0]; },
        [](const bodies::Point<dim>&) { return bodies::Point<dim>(bodies::Point<dim>::Unit(0)); })};
    problem.equation.b = [](const bodies::Point<dim>& x) { return bodies::Values<1>(1 + x[1]); };
    problem.given = {{"left", {[](const bodies::Point<dim>& x) { return x[1]; }}}, {"right"}};
    problem.given[1].loads.push_back(
        [](const bodies::Point<dim>& x, const bodies::Point<dim>&) { return bodies::Values<1>(x[1]); });
    return problem;
}

/// An elastic body that is held on the left, with loads on the right and in the volume.
template <int dim>
bodies::Problem<dim, dim> pulled() {
    bodies::Problem<dim, dim> problem{bodies::elasticity<dim>({1, 0.3})};
    const auto zero = [](const bodies::Point<dim>&) { return 0.0; };
    problem.given = {{"left"}, {"right"}};
    problem.given[0].value.fill(zero);
    problem.equation.b = [](const bodies::Point<dim>& x) {
        return bodies::Values<dim>(0.1 * x[0] * bodies::Values<dim>::Unit(1));
    };
    problem.given[1].loads.push_back([](const bodies::Point<dim>& x, const bodies::Point<dim>&) {
        return bodies::Values<dim>(x[1] * bodies::Values<dim>::Unit(0));
    });
    return problem;
}

}  // namespace support
