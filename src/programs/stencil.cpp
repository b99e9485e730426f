#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "asprone2010/local_conditions.hpp"
#include "asprone2010/quality.hpp"
#include "asprone2010/round_off.hpp"
#include "base/text.hpp"
#include "command_line/cases.hpp"
#include "command_line/formulations.hpp"

namespace {

using namespace asprone2010;
using base::shown;
using limit_stencils::Stencil;

/// The local systems that a formulation solves at a particle, with their condition numbers.
std::string conditions(const std::string& formulation, const particles::Neighbourhood<double>& near) {
    std::string text;
    for (const auto& [unknowns, condition] : local_conditions::systems(formulation, near))
        text += (text.empty() ? "condition of the system for " : "; for ") + std::string(unknowns) + ": " +
                shown(condition);
    return text.empty() ? "no local system with a matrix of this paper" : text;
}

/// The moments of a row, and the term of Taylor's expansion that each wrong moment leaves as an error.
std::vector<std::string> terms(const Stencil<double>& stencil, int derivative) {
    std::vector<std::string> lines;
    const std::string name = derivative == 1 ? "D" : "D2";
    double factorial = 1;
    for (int k = 0; k <= 6; ++k) {
        factorial *= std::max(k, 1);
        // The sum of a row vanishes by construction: weights multiply differences.
        const double moment = k == 0 ? 0 : limit_stencils::moment(stencil, k) / factorial;
        const double wanted = k == derivative ? 1 : 0;
        const double size = k == 0 ? 1 : limit_stencils::absolute_moment(stencil, k) / factorial;
        const bool right = std::abs(moment - wanted) <= 1e-10 * std::max(size, 1.0);
        lines.push_back(name + ", moment " + std::to_string(k) + " / " + std::to_string(k) +
                        "!: " + shown(moment) +
                        (right ? ", as it must be up to round-off"
                               : ": leaves " + shown(moment - wanted) + " delta^" +
                                     std::to_string(k - derivative) + " B^(" + std::to_string(k) + ")"));
    }
    return lines;
}

/// The bound of a row's error. \param exact up to which degree polynomials are differentiated exactly
std::string bound(const Stencil<double>& stencil, int derivative, int exact) {
    const std::string name = derivative == 1 ? "D" : "D2";
    const std::string R = shown(particles::quality<double, 1>(stencil.w, stencil.r, exact));
    const std::string most =
        " delta^" + std::to_string(exact + 1 - derivative) + " max|B^(" + std::to_string(exact + 1) + ")|";
    return name + ", quality R = " + R +
           (exact < derivative ? ": the sum itself is at most R" : ": the error is at most R") + most;
}

/// The one case that is asked for.
command_line::Case only_case(const command_line::Options& options) {
    const std::vector<command_line::Case> cases = command_line::cases(options);
    if (cases.size() != 1)
        throw base::InvalidInput("a stencil is that of one formulation on one line of particles, not of " +
                                 std::to_string(cases.size()) +
                                 "; name one --formulation, and one number of --particles");
    return cases.front();
}

report::Table weights(const command_line::Options& options, long particle) {
    const command_line::Case asked = only_case(options);
    const auto discrete = command_line::line_of(options, asked);
    const auto& [line, smoothing] = discrete;
    if (particle < 0 || particle >= line.size())
        throw base::InvalidInput("there is no particle " + std::to_string(particle) + "; choose 0 to " +
                                 std::to_string(line.size() - 1));
    const auto& formulation = command_line::formulation_named(asked.formulation);
    const auto [D, D2] = formulation.operators(line, smoothing);
    const auto first = limit_stencils::row<double>(D, line, particle, line.spacing(), 1);
    const auto second = limit_stencils::row<double>(D2, line, particle, line.spacing(), 2);

    report::Table table;
    table.comments = {asked.formulation + ", particle " + std::to_string(particle) + " of " +
                      std::to_string(line.size()) + ", x = " + shown(line.x()[particle])};
    const auto comment = [&](const std::vector<std::string>& lines) {
        table.comments.insert(table.comments.end(), lines.begin(), lines.end());
    };
    comment(command_line::header_comments(options));
    comment({conditions(asked.formulation, particles::neighbourhood(line, smoothing, particle))});
    comment(terms(first, 1));
    comment(terms(second, 2));
    comment({bound(first, 1, formulation.exact.first), bound(second, 2, formulation.exact.second)});
    comment({"sum of |weights|, D: " + shown(limit_stencils::amplification(first)) +
             ", D2: " + shown(limit_stencils::amplification(second))});
    table.columns = {{"particle"},
                     {"offset", {1e-9, 1e-12}},
                     {"weight_first", {1e-9, 1e-12}},
                     {"weight_second", {1e-9, 1e-12}}};
    // Where D is applied twice, the row of D² is the wider one.
    for (Operator<double>::InnerIterator entry(D2, particle); entry; ++entry)
        table.rows.push_back({static_cast<long>(entry.col()),
                              (line.x()[entry.col()] - line.x()[particle]) / line.spacing(),
                              D.coeff(particle, entry.col()) * line.spacing(),
                              entry.value() * line.spacing() * line.spacing()});
    return table;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "One particle's weights for D and D2, in units of 1/delta and 1/delta^2, their moments, and the terms of Taylor's expansion that they get wrong.",
        "stencil",
        "Example: stencil --formulation modified_fpm --particle 0\n"
        "Another: stencil --formulation second_order_fpm --particles 20 --particle 3 --perturb 0.25 --seed 7");
    command_line::Options options;
    options.particles = {50};
    command_line::add_options(app, options);
    long particle = 0;
    app.add_option("--particle", particle, "which particle, from 0 (default 0)").type_name("I");

    return command_line::run(app, argc, argv, options, [&] { return weights(options, particle); });
}
