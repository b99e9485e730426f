#pragma once

#include <string>
#include <vector>

#include "bodies/judgement.hpp"
#include "command_line/body_quantities.hpp"

namespace command_line {

/// noise, missed_loads, load1:NAME, reaction1:NAME, volume1 and the defect: those that are finite.
template <int dim, int n>
std::vector<Quantity<dim>> quantities(const bodies::Judgement<n>& judged);

/// What remarks() judges beside a judgement.
template <int dim>
struct Particles {
    double quality = 0;           ///< the largest of a solution's rows
    bodies::Point<dim> worst;     ///< its place
    bodies::Index across = 0;     ///< how many have neighbours across a gap, bodies::across_gaps()
    bodies::Point<dim> one = {};  ///< the place of one of those
};

template <int dim, int n>
Particles<dim> particles_of(const SolvedBody<dim, n>& solved);

/// That stresses or fluxes may be round-off, a sentence, if they are so small, as in a body that only moves.
template <int n>
std::vector<std::string> about_round_off(const bodies::Discretisation& how,
                                         const bodies::Judgement<n>& judged);

/// What is wrong with a solution, a sentence each: loads and reactions that leave more than 2 %, monomials of
/// a lower degree, neighbours that determine badly, stresses that miss the loads, particles with
/// neighbours across a gap, and unknowns that alternate.
/// \param how the solution was made \param degree of the monomials that was asked for
/// \param remedy for a solution out of equilibrium
/// \throws base::FailedComputation for a defect of more than 10 %, with loads and reactions and the remedy
template <int dim, int n>
std::vector<std::string> remarks(const bodies::Discretisation& how, const bodies::Judgement<n>& judged,
                                 const Particles<dim>& particles, int degree, const std::string& remedy);

}  // namespace command_line
