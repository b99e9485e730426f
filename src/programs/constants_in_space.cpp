#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "command_line/formulations.hpp"
#include "command_line/lists.hpp"
#include "command_line/options.hpp"
#include "command_line/progress.hpp"
#include "fpm_in_space/section_3_error_constants.hpp"

namespace {

using namespace fpm_in_space;
using base::InvalidInput;
using base::Quad;
using base::shown;
using error_constants::Lattice;
using particles::Column;
using particles::Exponents;
using particles::Index;
using report::Cell;

/// Value of --cut for a Gaussian that is not cut.
constexpr double no_cut = std::numeric_limits<double>::infinity();

struct Options {
    std::vector<long> dimensions{2, 3};
    std::vector<std::string> formulations{"definite_fpm", "ssph", "cubic_ssph"}, kernels{"gaussian"};
    std::vector<double> smoothings{1};
    double cut = no_cut;
    bool symbol = false;
    int threads = 0;
    std::string output;
};

/// What is computed at once: a formulation at a place of a lattice.
struct Case {
    long dimension;
    std::string formulation, kernel;
    double smoothing;
    int bounded;
    double cut;

    template <int dim>
    [[nodiscard]] Lattice<dim> lattice() const {
        if (cut < no_cut) return {particles::TruncatedGaussian<dim>(cut), smoothing, bounded};
        return {particles::kernel_named<dim>(kernel), smoothing, bounded};
    }
    /// \throws base::InvalidInput for a smoothing length that no stencil can have
    void check() const {
        dimension == 2 ? error_constants::reach_in_spacings(lattice<2>())
                       : error_constants::reach_in_spacings(lattice<3>());
    }
    [[nodiscard]] std::string place() const {
        return dimension == 2 ? fpm_in_space::place<2>(bounded) : fpm_in_space::place<3>(bounded);
    }
};

/// All combinations of the options: their places, or with --symbol the inside alone.
std::vector<Case> cases(const Options& options) {
    using command_line::chosen;
    const std::vector<std::string> kernels =
        options.cut < no_cut ? std::vector<std::string>{std::string(particles::TruncatedGaussian<2>::name)}
                             : chosen("kernel", options.kernels, command_line::kernel_names());
    std::vector<Case> all;
    for (const long dimension : options.symbol ? std::vector<long>{2} : options.dimensions)
        for (const std::string& formulation :
             chosen("formulation", options.formulations, formulation_names()))
            for (const std::string& kernel : kernels)
                for (const double smoothing : options.smoothings)
                    for (int bounded = 0; bounded <= (options.symbol ? 0 : dimension); ++bounded) {
                        all.push_back({dimension, formulation, kernel, smoothing, bounded, options.cut});
                        all.back().check();
                    }
    return all;
}

/// Rows of a case, and why they have no numbers, if they have none.
struct Result {
    std::vector<std::vector<Cell>> rows;
    std::string failure{};
};

/// Relative tolerance below which a constant counts as zero: the cut of the Gaussian leaves small ones.
constexpr double negligible = 1e-9;

/// "1112", the coordinates of a derivative.
template <int dim>
std::string coordinates(const Exponents<dim>& b) {
    std::string text;
    for (std::size_t axis = 0; axis < dim; ++axis)
        text.append(static_cast<std::size_t>(b[axis]), static_cast<char>('1' + axis));
    return text;
}

/// A row for each constant of a derivative's leading error.
template <int dim>
std::vector<std::vector<Cell>> rows(const std::vector<Cell>& named,
                                    const error_constants::Stencil<Quad, dim>& stencil,
                                    const Exponents<dim>& a) {
    const auto [exponent, b, C] = error_constants::leading_error(stencil, a);
    const Column<Quad> measured = error_constants::measured_constants(stencil, a, exponent);
    const Quad largest = C.abs().maxCoeff();
    std::vector<std::vector<Cell>> all;
    for (Index k = 0; k < C.size(); ++k) {
        if (abs(C[k]) < negligible * largest && abs(measured[k]) < negligible * largest) continue;
        all.push_back(named);
        all.back().insert(all.back().end(),
                          {static_cast<long>(exponent), coordinates<dim>(b[static_cast<std::size_t>(k)]),
                           static_cast<double>(C[k]), static_cast<double>(measured[k]),
                           static_cast<double>(abs(measured[k] - C[k]) / largest),
                           static_cast<double>(error_constants::amplification(stencil))});
    }
    return all;
}

/// The leading errors of the derivatives at a place; empty where the neighbours do not determine them.
template <int dim>
Result leading_errors(const Case& one) {
    Result result;
    const auto derivatives = error_constants::different_derivatives<dim>(one.bounded);
    const auto named = [&](const Exponents<dim>& a) {
        return std::vector<Cell>{one.dimension, one.formulation, one.kernel,
                                 one.smoothing, one.place(),     coordinates<dim>(a)};
    };
    try {
        const auto all = error_constants::limit_stencils(formulation_named<Quad, dim>(one.formulation),
                                                         one.lattice<dim>());
        for (const auto& a : derivatives)
            for (auto& row : rows<dim>(named(a), error_constants::row(all, a), a))
                result.rows.push_back(std::move(row));
    } catch (const base::FailedComputation& failed) {  // too few neighbours
        result = {{}, failed.what()};
        for (const auto& a : derivatives) {
            result.rows.push_back(named(a));
            result.rows.back().resize(12);
        }
    }
    return result;
}

Result leading_errors_of(const Case& one) {
    return one.dimension == 2 ? leading_errors<2>(one) : leading_errors<3>(one);
}

/// λ of the Laplacian in the plane, for waves with phases of 0 to π in steps of π/12.
Result symbols_of(const Case& one) {
    Result result;
    try {
        const auto laplacian = error_constants::laplacian(
            error_constants::limit_stencils(formulation_named<Quad, 2>(one.formulation), one.lattice<2>()));
        for (int k = 0; k <= 12; ++k)
            for (int l = 0; l <= 12; ++l) {
                const particles::Point<2> theta(k * std::numbers::pi / 12, l * std::numbers::pi / 12);
                const auto lambda = static_cast<double>(error_constants::symbol(
                    laplacian, particles::Point<2, Quad>(theta.template cast<Quad>())));
                const double ratio = k + l == 0 ? 1 : -lambda / theta.squaredNorm();  // 1 is the limit
                result.rows.push_back({one.formulation, one.kernel, one.smoothing, theta[0], theta[1],
                                       k + l == 0 ? 0 : lambda, ratio});
            }
    } catch (const base::FailedComputation& failed) {
        result = {{{one.formulation, one.kernel, one.smoothing, {}, {}, {}, {}}}, failed.what()};
    }
    return result;
}

/// "empty: dimension 2, ssph with cubic_spline, h/delta 1, corner: a particle has 4 neighbours …"
std::string why_empty(const Case& one, const std::string& failure) {
    return "empty: dimension " + std::to_string(one.dimension) + ", " + one.formulation + " with " +
           one.kernel + ", h/delta " + shown(one.smoothing) + failure.substr(one.formulation.size());
}

/// Adds the rows of all cases, and the reasons of those that have no numbers.
/// \throws base::FailedComputation where none has
void add_rows(report::Table& table, const std::vector<Case>& all, Result (*compute)(const Case&)) {
    const std::vector<Result> results = command_line::computed_in_parallel(all, compute);
    std::size_t failed = 0;
    std::string first;
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (const auto& row : results[k].rows) table.rows.push_back(row);
        if (results[k].failure.empty()) continue;
        table.comments.push_back(why_empty(all[k], results[k].failure));
        if (failed++ == 0) first = table.comments.back();
    }
    if (failed == all.size())
        throw base::FailedComputation("no case has numbers; " + first.substr(first.find(' ') + 1));
}

report::Table table_of(const Options& options) {
    const std::vector<Case> all = cases(options);
    const std::string kernel =
        options.cut < no_cut ? ", kernel gaussian, lowered to zero at " + shown(options.cut) + " h" : "";
    report::Table table;
    if (options.symbol) {
        table.comments = {
            "FPM in space, Section 3: the symbol lambda of the Laplacian on an infinite lattice in the plane" +
                kernel,
            "theta: phases by which a wave advances from particle to particle; lambda: its eigenvalue times delta^2; ratio: -lambda / |theta|^2, exactly 1"};
        table.columns = {{"formulation"},         {"kernel"},
                         {"smoothing"},           {"theta1", {1e-9, 0}},
                         {"theta2", {1e-9, 0}},   {"lambda", {1e-9, 1e-12}},
                         {"ratio", {1e-9, 1e-12}}};
        add_rows(table, all, symbols_of);
        return table;
    }
    table.comments = {
        "FPM in space, Section 3: leading errors, sums of constant * delta^exponent * (the derivative of B along the coordinates of monomial)" +
            kernel,
        "place: of the particle on a lattice, bounded in the first coordinates; constant: of the stencil; measured: for exponentials, quadruple precision, extrapolated from six spacings",
        "relative_difference: to the largest constant of a derivative; amplification: sum of |weights| * delta^order; constants that vanish have no row, nor derivatives that symmetry makes equal to one that has"};
    table.columns = {{"dimension"},
                     {"formulation"},
                     {"kernel"},
                     {"smoothing"},
                     {"place"},
                     {"derivative"},
                     {"exponent"},
                     {"monomial"},
                     {"constant", {1e-9, 1e-12}},
                     {"measured", {1e-6, 1e-9}},
                     {"relative_difference", {1, 1e-6}},
                     {"amplification", {1e-9, 0}}};
    add_rows(table, all, leading_errors_of);
    return table;
}

/// \throws base::InvalidInput for what has no meaning
void check(const Options& options) {
    for (const long dimension : options.dimensions)
        if (dimension != 2 && dimension != 3)
            throw InvalidInput("--dimension " + std::to_string(dimension) +
                               " is neither 2, the plane, nor 3, space");
    if (!(options.cut > 0)) throw InvalidInput("--cut must be positive, got " + shown(options.cut));
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "The second-order FPM in the plane and in space, Section 3: the leading errors of first and second derivatives on lattices, inside and at faces, edges and corners, from the formulations' stencils; beside them, what exponentials show in quadruple precision.",
        "constants_in_space",
        "Example: constants_in_space --dimension 2 --formulation definite_fpm --kernel quintic_spline --smoothing 1.2,1.5\n"
        "With the kernel of derivative_test_in_space: constants_in_space --dimension 2 --cut 3.5 --smoothing 1.2\n"
        "Frequencies of waves: constants_in_space --symbol --smoothing 1,2");
    Options options;
    const auto dimension =
        app.add_list("--dimension", options.dimensions, "2, the plane, and 3, space (default 2,3)")
            .type_name("2,3");
    app.add_list("--formulation", options.formulations,
                 "formulations: all, or some of " + command_line::joined(formulation_names()) +
                     " (default definite_fpm,ssph,cubic_ssph)");
    const auto kernel =
        app.add_list("--kernel", options.kernels,
                     "kernels: all, or some of " + command_line::joined(command_line::kernel_names()) +
                         " (default gaussian)");
    app.add_list("--smoothing", options.smoothings, "smoothing lengths over spacing, h/delta (default 1)");
    app.add_option("--cut", options.cut, "the kernel is a Gaussian lowered to zero at this many h")
        .type_name("RHO")
        .excludes(kernel);
    app.add_flag("--symbol", options.symbol,
                 "instead, the symbol of the Laplacian inside: eigenvalues of waves in the plane")
        .excludes(dimension);
    app.add_threads(options.threads);
    app.add_output(options.output);
    return command_line::run(app, argc, argv, options.threads, options.output, {}, [&] {
        check(options);
        return table_of(options);
    });
}
