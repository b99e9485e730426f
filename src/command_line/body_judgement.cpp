#include "command_line/body_judgement.hpp"

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "batra2008/section_4_example_problems.hpp"

namespace command_line {

using base::FailedComputation;
using base::shown;
using batra2008::example_problems::most_noise;
using bodies::Index;
using bodies::Point;

namespace {

/// Largest quality number without a remark: above that of any grid, even with three particles on a side.
constexpr double most_quality = 150;

/// Largest Judgement::missed_loads without a remark. It is relative to the stresses.
constexpr double most_missed = 0.1;

/// "wall (0, 1000), tip (0, -1000)"
template <int n>
std::string listed(const std::vector<std::pair<std::string, bodies::Values<n>>>& forces) {
    std::string text;
    for (const auto& [side, force] : forces)
        text += (text.empty() ? "" : ", ") + side + " " + particles::shown_point(force);
    return text.empty() ? "none" : text;
}

template <int n>
bool is_round_off(const bodies::Judgement<n>& judged) {
    return judged.share_of_terms > 0 && judged.share_of_terms <= bodies::round_off_of_terms;
}

/// What is wrong with a balance; nothing up to a defect of 2 %.
/// \throws FailedComputation for a defect of more than 10 %
template <int n>
std::optional<std::string> remark(const std::string& method, const bodies::Balance<n>& balance,
                                  const std::string& remedy) {
    constexpr double small = 0.02, large = 0.1;
    if (balance.defect <= small) return {};
    if (!std::isfinite(balance.defect))
        throw FailedComputation(method + "the forces exceed double precision; take other units");
    const std::string text = method + "loads and reactions leave a defect of " +
                             shown(100 * balance.defect, 3) + " % of their sizes; loads " +
                             listed<n>(balance.loads) + ", reactions " + listed<n>(balance.reactions) +
                             ", volume " + particles::shown_point(balance.volume) + "; take " + remedy;
    if (balance.defect > large) throw FailedComputation(text);
    return text;
}

}  // namespace

template <int dim, int n>
std::vector<Quantity<dim>> quantities(const bodies::Judgement<n>& judged) {
    const auto& [noise, missed, balance, share] = judged;
    std::vector<Quantity<dim>> all;
    const auto add = [&](const std::string& name, double value, bool has_limit = false) {
        if (std::isfinite(value)) all.push_back({name, {}, value, has_limit});
    };
    add("noise", noise);
    add("missed_loads", missed);
    for (const auto& [what, sides, has_limit] :
         {std::tuple{"load", &balance.loads, false}, {"reaction", &balance.reactions, true}})
        for (const auto& [side, force] : *sides)
            for (Index i = 0; i < n; ++i) add(numbered(what, i) + ":" + side, force[i], has_limit);
    for (Index i = 0; i < n; ++i) add(numbered("volume", i), balance.volume[i]);
    add("defect", balance.defect);
    return all;
}

template <int dim, int n>
Particles<dim> particles_of(const SolvedBody<dim, n>& solved) {
    const auto& [problem, body, solution, material, at_particles] = solved;
    Particles<dim> found{solution.quality, body.x.col(solution.worst)};
    const std::vector<Index> across = bodies::across_gaps(body, solution.approximation);
    found.across = static_cast<Index>(across.size());
    if (!across.empty()) found.one = body.x.col(across.front());
    return found;
}

template <int n>
std::vector<std::string> about_round_off(const bodies::Discretisation& how,
                                         const bodies::Judgement<n>& judged) {
    if (!is_round_off(judged)) return {};
    return {bodies::name(how.method) + (n == 1 ? ": fluxes" : ": stresses") +
            " may be round-off: their size is " + shown(judged.share_of_terms, 2) +
            " of that of the terms that they sum"};
}

template <int dim, int n>
std::vector<std::string> remarks(const bodies::Discretisation& how, const bodies::Judgement<n>& judged,
                                 const Particles<dim>& particles, int degree, const std::string& remedy) {
    const auto& [quality, worst, across, one] = particles;
    const std::string method = bodies::name(how.method) + ": ", fluxes = n == 1 ? "fluxes" : "stresses";
    std::vector<std::string> all;
    const auto add = [&](bool wrong, const std::string& text) {
        if (wrong) all.push_back(method + text);
    };
    const bool moves = n == dim && is_round_off(judged);
    if (const auto out_of_balance =
            remark(method, judged.balance, moves ? "displacements less a motion of the whole body" : remedy))
        all.push_back(*out_of_balance);
    add(how.degree != degree, "monomials of degree " + std::to_string(how.degree) +
                                  ", since the particles determine those of degree " +
                                  std::to_string(degree) + " badly somewhere");
    add(quality > most_quality, "the neighbours of the particle at " + particles::shown_point(worst) +
                                    " determine its derivatives badly (quality " + shown(quality, 3) +
                                    ", limit " + shown(most_quality) + "); stresses near it may be wrong");
    add(judged.missed_loads > most_missed, "the " + fluxes + " at the boundary miss the given loads by " +
                                               shown(100 * judged.missed_loads, 3) + " % of the size of " +
                                               fluxes + ", limit " + shown(100 * most_missed) +
                                               "; do not trust those near the boundary");
    add(across > 0,
        std::to_string(across) + " particles, such as that at " + particles::shown_point(one) +
            ", have neighbours across a gap of the body; the solution near it may be wrong; take a finer mesh there");
    add(judged.noise > most_noise, "the unknowns alternate between neighbours, and " + fluxes +
                                       " may be wrong (noise " + shown(judged.noise, 3) + ", limit " +
                                       shown(most_noise) + ")");
    return all;
}

template std::vector<std::string> about_round_off(const bodies::Discretisation&, const bodies::Judgement<1>&);
template std::vector<Quantity<2>> quantities(const bodies::Judgement<1>&);
template Particles<2> particles_of(const SolvedBody<2, 1>&);
template std::vector<std::string> remarks(const bodies::Discretisation&, const bodies::Judgement<1>&,
                                          const Particles<2>&, int, const std::string&);

template std::vector<Quantity<3>> quantities(const bodies::Judgement<1>&);
template Particles<3> particles_of(const SolvedBody<3, 1>&);
template std::vector<std::string> remarks(const bodies::Discretisation&, const bodies::Judgement<1>&,
                                          const Particles<3>&, int, const std::string&);

template std::vector<std::string> about_round_off(const bodies::Discretisation&, const bodies::Judgement<2>&);
template std::vector<Quantity<2>> quantities(const bodies::Judgement<2>&);
template Particles<2> particles_of(const SolvedBody<2, 2>&);
template std::vector<std::string> remarks(const bodies::Discretisation&, const bodies::Judgement<2>&,
                                          const Particles<2>&, int, const std::string&);

template std::vector<std::string> about_round_off(const bodies::Discretisation&, const bodies::Judgement<3>&);
template std::vector<Quantity<3>> quantities(const bodies::Judgement<3>&);
template Particles<3> particles_of(const SolvedBody<3, 3>&);
template std::vector<std::string> remarks(const bodies::Discretisation&, const bodies::Judgement<3>&,
                                          const Particles<3>&, int, const std::string&);

}  // namespace command_line
