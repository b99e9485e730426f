#pragma once

#include <string>
#include <vector>

#include "bodies/judgement.hpp"
#include "command_line/body_quantities.hpp"

namespace command_line {

/// What a solution says of itself, without a reference.
template <int n>
struct Judgement {
    double noise, missed_loads;
    bodies::Balance<n> balance;
};

template <int dim, int n>
Judgement<n> judgement(const SolvedBody<dim, n>& solved);

/// noise, missed_loads, load1:NAME, reaction1:NAME, volume1 and the defect: those that are finite.
template <int dim, int n>
std::vector<Quantity<dim>> quantities(const Judgement<n>& judged);

/// What is wrong with a solution, a sentence each: loads and reactions that leave more than 2 %, monomials of
/// a lower degree, neighbours that determine badly, stresses that miss the loads, particles that see others
/// across a gap, and unknowns that alternate.
/// \param degree of the monomials that was asked for \param remedy for a solution out of equilibrium
/// \throws base::FailedComputation for a defect of more than 10 %, with loads and reactions and the remedy
template <int dim, int n>
std::vector<std::string> remarks(const SolvedBody<dim, n>& solved, const Judgement<n>& judged, int degree,
                                 const std::string& remedy);

}  // namespace command_line
