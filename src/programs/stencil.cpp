#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "asprone2010/limit_stencils.hpp"
#include "base/text.hpp"
#include "batra2008/section_2_ssph_basis.hpp"
#include "command_line/cases.hpp"
#include "command_line/formulations.hpp"

namespace {

using namespace asprone2010;
using base::shown;
using particles::Neighbourhood;

/// Ratio of the largest to the least singular value.
template <class Matrix>
double condition(const Matrix& A) {
    const auto values = Eigen::JacobiSVD<Matrix>(A).singularValues();
    return values[0] / values[values.size() - 1];
}

template <int... p>
double condition_of_correction(const Neighbourhood<double>& near) {
    return condition(
        rkpm::moment_matrix<double, p...>([&](int k) { return (near.W * near.V * near.r.pow(k)).sum(); }));
}

/// The local systems that a formulation solves at a particle, with their condition numbers.
std::string conditions(const std::string& formulation, const Neighbourhood<double>& near) {
    const auto corrected = [&](const char* unknowns, double number) {
        return "condition of the system for " + std::string(unknowns) + ": " + shown(number);
    };
    if (formulation == "rkpm_first_order") return corrected("C", condition_of_correction<0, 1>(near));
    if (formulation == "rkpm_second_order") return corrected("C", condition_of_correction<0, 1, 2>(near));
    if (formulation == "fpm") return corrected("B and DB", condition(fpm::matrix(near)));
    if (formulation == "modified_fpm") return corrected("DB and D2B", condition(modified_fpm::matrix(near)));
    if (formulation == "second_order_fpm")
        return corrected("C", condition_of_correction<0, 1, 3>(near)) + "; for DB and D2B: " +
               shown(condition(modified_fpm::matrix(second_order_fpm::corrected(near))));
    return "no local system with a matrix of this paper";
}

/// What the row leaves of Taylor's expansion, term by term.
std::vector<std::string> terms(const limit_stencils::Stencil<double>& of, int derivative) {
    std::vector<std::string> lines;
    const std::string name = derivative == 1 ? "D" : "D2";
    double factorial = 1;
    for (int k = 0; k <= 6; ++k) {
        factorial *= std::max(k, 1);
        // Row sums vanish by construction: weights stand on differences.
        const double moment = k == 0 ? 0 : limit_stencils::moment(of, k) / factorial;
        const double wanted = k == derivative ? 1 : 0;
        const double size = k == 0 ? 1 : limit_stencils::absolute_moment(of, k) / factorial;
        const bool right = std::abs(moment - wanted) <= 1e-10 * std::max(size, 1.0);
        lines.push_back(name + ", moment " + std::to_string(k) + " / " + std::to_string(k) +
                        "!: " + shown(moment) +
                        (right ? ", as it must be up to round-off"
                               : ": leaves " + shown(moment - wanted) + " delta^" +
                                     std::to_string(k - derivative) + " B^(" + std::to_string(k) + ")"));
    }
    return lines;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "One particle's weights for D and D2, in units of 1/delta and 1/delta^2, their moments, and the "
        "terms of "
        "Taylor's expansion that they get wrong.",
        "stencil",
        "Example: stencil --formulation modified_fpm --particle 0\n"
        "Another: stencil --formulation second_order_fpm --particles 20 --particle 3 --perturb 0.25 --seed "
        "7");
    command_line::Options options;
    options.particles = {50};
    command_line::add_options(app, options);
    long particle = 0;
    app.add_option("--particle", particle, "which particle, from 0 (default 0)").type_name("I");

    return command_line::run(app, argc, argv, options, [&] {
        if (!options.figure.path.empty())
            throw base::InvalidInput("a stencil has no figure; leave --plot out");
        const std::vector<command_line::Case> asked = command_line::cases(options);
        if (asked.size() != 1)
            throw base::InvalidInput(
                "a stencil is that of one formulation on one line of particles, not of " +
                std::to_string(asked.size()) + "; name one --formulation, and one number of --particles");
        const command_line::Case& of = asked.front();
        const auto discrete = command_line::line_of(options, of);
        const auto& [line, smoothing] = discrete;
        if (particle < 0 || particle >= line.size())
            throw base::InvalidInput("there is no particle " + std::to_string(particle) + "; choose 0 to " +
                                     std::to_string(line.size() - 1));
        const auto [D, D2] = command_line::formulation_named(of.formulation).operators(line, smoothing);
        const auto first = limit_stencils::row<double>(D, line, particle, line.spacing(), 1);
        const auto second = limit_stencils::row<double>(D2, line, particle, line.spacing(), 2);

        report::Table table;
        table.comments = {of.formulation + ", particle " + std::to_string(particle) + " of " +
                          std::to_string(line.size()) + ", x = " + shown(line.x()[particle])};
        for (const std::string& comment : command_line::header_comments(options))
            table.comments.push_back(comment);
        table.comments.push_back(
            conditions(of.formulation, particles::neighbourhood(line, smoothing, particle)));
        for (const int derivative : {1, 2})
            for (const std::string& text : terms(derivative == 1 ? first : second, derivative))
                table.comments.push_back(text);
        table.comments.push_back("sum of |weights|, D: " + shown(limit_stencils::amplification(first)) +
                                 ", D2: " + shown(limit_stencils::amplification(second)));
        table.columns = {{"particle"},
                         {"offset", {1e-9, 1e-12}},
                         {"weight_first", {1e-9, 1e-12}},
                         {"weight_second", {1e-9, 1e-12}}};
        // The row of D² is the wider one where D is applied twice.
        for (Operator<double>::InnerIterator entry(D2, particle); entry; ++entry)
            table.rows.push_back({static_cast<long>(entry.col()),
                                  (line.x()[entry.col()] - line.x()[particle]) / line.spacing(),
                                  D.coeff(particle, entry.col()) * line.spacing(),
                                  entry.value() * line.spacing() * line.spacing()});
        return table;
    });
}
