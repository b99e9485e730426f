#include "particles/operators.hpp"

#include <omp.h>

#include <array>
#include <utility>

#include "asprone2010/section_3_2_chen_beraun.hpp"
#include "asprone2010/section_4_second_order_fpm.hpp"
#include "tests/support/lines.hpp"
#include "tests/support/same_bytes.hpp"

using namespace particles;
using asprone2010::formulations;
using asprone2010::numerical_tests::Discretisation;
using support::particles_of;
using support::same_bytes;

namespace {

/// Weights of which the first one is multiplied.
struct OneWrong {
    double factor;
    bool second;  ///< of D², not of D

    template <class Scalar>
    Derivatives<Scalar> operator()(const Neighbourhood<Scalar>& near) const {
        Derivatives<Scalar> all{near.DW * near.V, near.DW * near.V};
        (second ? all.second : all.first)[0] *= Scalar(factor);
        return all;
    }
};

}  // namespace

TEST_CASE("operators: some rows of a line are those of all, packs or not") {
    const auto [line, smoothing] = particles_of(203, {Volumes::partition, Gaussian{}, 1.3, 0.25});
    const auto weights = [](const auto& near) { return asprone2010::second_order_fpm::derivatives(near); };
    const auto rule = detail::rule_of<double>(weights);
    const Requirement needed{"second_order_fpm", 4};
    const auto all = assemble(line, smoothing, needed, weights);
    for (const Range rows : {Range{0, 203}, Range{0, 5}, Range{41, 42}, Range{38, 163}, Range{199, 203}}) {
        const auto some = assemble(line, smoothing, needed, rule, rows);
        CHECK(same_bytes(some.D, Operator<double>(all.D.middleRows(rows.first, rows.size()))));
        CHECK(same_bytes(some.D2, Operator<double>(all.D2.middleRows(rows.first, rows.size()))));
    }
    Rule<double> twice =
        detail::rule_of<double>([](const auto& near) { return asprone2010::fpm::first_derivative(near); });
    twice.second = [](const Operator<double>& D, Operator<double>&& memory) {
        return product(D, D, std::move(memory));
    };
    CHECK_THROWS_WITH_AS(assemble(line, smoothing, {"fpm", 2}, twice, {0, 10}),
                         "fpm: a derivative of a derivative needs all rows", InvalidInput);
}

TEST_CASE(
    "operators: assembled again after the particles have moved, they are those of a fresh assembly, in the memory that they had") {
    const Discretisation wide{Volumes::partition, Gaussian{}, 2},
        narrow{Volumes::partition, Gaussian{}, 1.3, 0.25};
    for (const auto& formulation : formulations<double>()) {
        CAPTURE(formulation.name);
        const auto first = particles_of(3000, wide);
        auto all = formulation.operators(first.line, first.smoothing);
        const std::array values{all.D.valuePtr(), all.D2.valuePtr()};
        const std::array columns{all.D.innerIndexPtr(), all.D2.innerIndexPtr()};
        for (const auto& [N, seed] : {std::pair{3000, 1UL}, {700, 1UL}, {3000, 2UL}}) {
            const auto moved = particles_of(N, narrow, seed);
            const auto expected = formulation.operators(moved.line, moved.smoothing);
            formulation.assemble_again(all, moved.line, moved.smoothing);
            CHECK(same_bytes(all.D, expected.D));
            CHECK(same_bytes(all.D2, expected.D2));
            CHECK(values == std::array{all.D.valuePtr(), all.D2.valuePtr()});
            CHECK(columns == std::array{all.D.innerIndexPtr(), all.D2.innerIndexPtr()});
        }
    }
}

TEST_CASE("operators: the weights of a row sum to zero to the last bit, on uniform and on random particles") {
    for (const double perturbation : {0.0, 0.25, 0.45})
        for (const auto volumes : {Volumes::equal, Volumes::partition}) {
            const auto [line, smoothing] = particles_of(200, {volumes, Gaussian{}, 1, perturbation});
            for (const auto& formulation : formulations<double>()) {
                CAPTURE(formulation.name);
                const auto operators = formulation.operators(line, smoothing);
                for (const auto* D : {&operators.D, &operators.D2})
                    for (Index i = 0; i < D->rows(); ++i) {
                        double others = 0;
                        for (Operator<double>::InnerIterator entry(*D, i); entry; ++entry)
                            if (entry.col() != i) others += entry.value();
                        REQUIRE(others + D->coeff(i, i) == 0);
                    }
            }
        }
}

TEST_CASE("operators: the same bytes on any number of threads") {
    const auto [line, smoothing] = particles_of(3000, {Volumes::partition, Gaussian{}, 1.3, 0.25});
    for (const auto& formulation : formulations<double>()) {
        CAPTURE(formulation.name);
        omp_set_num_threads(1);
        const auto alone = formulation.operators(line, smoothing);
        for (const int threads : {2, 3, 7}) {
            omp_set_num_threads(threads);
            const auto together = formulation.operators(line, smoothing);
            CHECK(same_bytes(alone.D, together.D));
            CHECK(same_bytes(alone.D2, together.D2));
        }
    }
    omp_set_num_threads(omp_get_num_procs());
}

TEST_CASE(
    "operators: particles computed together in a pack have the weights that each has alone, to 2e-12 of the row's largest") {
    const auto compare = [](const auto& rule, const Discretisation& how, const Requirement& required) {
        const auto discrete = particles_of(203, how);
        const auto& line = discrete.line;
        const auto& smoothing = discrete.smoothing;
        const auto of_line = assemble(line, smoothing, required, rule);
        double worst = 0;
        for (Index i = 0; i < line.size(); ++i) {
            const Range near = within_reach(line, smoothing, i);
            const Derivatives<double> alone = rule(neighbourhood(line, smoothing, i, near));
            const auto differ = [&](const Operator<double>& rows, const Column<double>& weights, int order) {
                const Column<double> expected = weights / std::pow(smoothing.h(i), order);
                REQUIRE(rows.innerVector(i).nonZeros() == near.size());
                for (Index k = 0; k < near.size(); ++k)
                    if (near.first + k != i)
                        worst = std::max(worst, std::abs(rows.coeff(i, near.first + k) - expected[k]) /
                                                    expected.abs().maxCoeff());
            };
            differ(of_line.D, alone.first, 1);
            differ(of_line.D2, alone.second, 2);
        }
        CHECK(worst < 2e-12);
    };
    for (const Kernel<>& kernel : {Kernel<>(Gaussian{}), Kernel<>(QuinticSpline{}), Kernel<>(WendlandC4{})})
        for (const double smoothing : {1.7, 2.0, 2.6})
            for (const double perturbation : {0.0, 0.25})
                for (const auto from : {Spacing::mean, Spacing::local}) {
                    const Discretisation how{Volumes::partition, kernel, smoothing, perturbation, from};
                    CAPTURE(name(kernel));
                    CAPTURE(smoothing);
                    compare([](const auto& near) { return asprone2010::chen_beraun::derivatives(near); }, how,
                            {"chen_beraun", 3});
                    compare([](const auto& near) { return asprone2010::modified_fpm::derivatives(near); },
                            how, {"modified_fpm", 3});
                    compare([](const auto& near) { return asprone2010::second_order_fpm::derivatives(near); },
                            how, {"second_order_fpm", 4});
                }
}

TEST_CASE("operators: rows are compressed and hold the neighbours in order") {
    const auto [line, smoothing] = particles_of(60, {Volumes::equal, QuinticSpline{}, 1.5, 0.2});
    const auto D = asprone2010::formulation_named<double>("modified_fpm").operators(line, smoothing).D;
    CHECK(D.isCompressed());
    for (Index i = 0; i < D.rows(); ++i) {
        const Range near = within_reach(line, smoothing, i);
        REQUIRE(D.outerIndexPtr()[i + 1] - D.outerIndexPtr()[i] == near.size());
        for (Index k = 0; k < near.size(); ++k)
            REQUIRE(D.innerIndexPtr()[D.outerIndexPtr()[i] + k] == near.first + k);
    }
}

TEST_CASE("operators: mirrored particles give mirrored weights") {
    const Column<double> x = perturbed_positions<double>(60, 0.25, 9);
    const Column<double> mirrored = (1 - x).reverse();
    for (const auto volumes : {Volumes::equal, Volumes::partition})
        for (const auto& formulation : formulations<double>()) {
            CAPTURE(formulation.name);
            const Smoothing<double> smoothing(Gaussian{}, 1.0 / 59);
            const auto [D, D2] = formulation.operators(line_at<double>(x, volumes), smoothing);
            const auto [E, E2] = formulation.operators(line_at<double>(mirrored, volumes), smoothing);
            const Eigen::MatrixXd first(D), second(D2), first_mirrored(E), second_mirrored(E2);
            CHECK((first + first_mirrored.reverse()).cwiseAbs().maxCoeff() <
                  1e-11 * first.cwiseAbs().maxCoeff());
            CHECK((second - second_mirrored.reverse()).cwiseAbs().maxCoeff() <
                  1e-11 * second.cwiseAbs().maxCoeff());
        }
}

TEST_CASE("operators: stretching the line by a divides the k-th derivative by a to the k") {
    const Column<double> x = perturbed_positions<double>(40, 0.25, 3);
    for (const auto& formulation : formulations<double>()) {
        CAPTURE(formulation.name);
        const auto near = formulation.operators(line_at<double>(x, Volumes::equal),
                                                Smoothing<double>(Gaussian{}, 1.0 / 39));
        const auto far = formulation.operators(line_at<double>(x * 8, Volumes::equal),
                                               Smoothing<double>(Gaussian{}, 8.0 / 39));
        CHECK((Eigen::MatrixXd(near.D) - 8 * Eigen::MatrixXd(far.D)).cwiseAbs().maxCoeff() <
              1e-12 * Eigen::MatrixXd(near.D).cwiseAbs().maxCoeff());
        CHECK((Eigen::MatrixXd(near.D2) - 64 * Eigen::MatrixXd(far.D2)).cwiseAbs().maxCoeff() <
              1e-12 * Eigen::MatrixXd(near.D2).cwiseAbs().maxCoeff());
    }
}

TEST_CASE(
    "operators: neighbours that do not determine the local system are an error that says where they lie") {
    Column<double> x(9);
    x << 0, 0.1, 0.1 + 1e-12, 0.1 + 2e-12, 0.6, 0.65, 0.7, 0.75, 0.8;
    const auto line = line_at<double>(x, Volumes::equal);
    for (const char* name : {"rkpm_second_order", "modified_fpm", "second_order_fpm"}) {
        std::string error;
        try {
            static_cast<void>(asprone2010::formulation_named<double>(name).operators(
                line, Smoothing<double>(Gaussian{}, 0.05)));
        } catch (const FailedComputation& failure) {
            error = failure.what();
        }
        CAPTURE(error);
        CHECK(error.starts_with(
            std::string(name) +
            ": particle 0 (x = 0) has 4 neighbours within 6h (0 on the left, 3 on the right), but the local system is singular (reciprocal condition "));
        const std::size_t other = error.find("; try h = ");
        REQUIRE(other != std::string::npos);
        CHECK_NOTHROW(static_cast<void>(asprone2010::formulation_named<double>(name).operators(
            line, Smoothing<double>(Gaussian{}, std::stod(error.substr(other + 10))))));
    }
}

TEST_CASE("operators: more weights than an index can count are refused before they are written") {
    const auto [line, smoothing] = particles_of(50000, {Volumes::equal, Gaussian{}, 10000, 0});
    CHECK_THROWS_WITH_AS(
        static_cast<void>(asprone2010::formulation_named<double>("chen_beraun").operators(line, smoothing)),
        "an operator of 2500000000 weights is too large; take fewer particles or a smaller smoothing length",
        InvalidInput);
}

TEST_CASE("operators: a formulation that gives too few weights is refused") {
    const auto [line, smoothing] = particles_of(30, {});
    Rule<double> rule;
    rule.weights = [](const Neighbourhood<double>& near) {
        return Derivatives<double>{near.DW * near.V, Column<double>()};
    };
    CHECK_THROWS_WITH_AS(assemble(line, smoothing, {"of one derivative", 2}, rule, {0, 30}),
                         "a formulation has given 0 weights for 7 neighbours", InvalidInput);
}

TEST_CASE("operators: weights that are not finite are refused with formulation, particle and place") {
    const auto [line, smoothing] = particles_of(30, {});
    for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity()})
        for (const bool second : {false, true})
            CHECK_THROWS_WITH_AS(
                static_cast<void>(assemble(line, smoothing, {"mine", 2}, OneWrong{wrong, second})),
                doctest::Contains(
                    "mine: particle 0 (x = 0) has 7 neighbours within 6h (0 on the left, 6 on the right), but its weights are not finite; "),
                FailedComputation);
}

TEST_CASE("operators: a derivative of a derivative beyond double precision is refused with its particle") {
    const Column<double> x = 1e-160 * Column<double>::LinSpaced(12, 0, 11);
    const Line<double> line = line_at(x, Volumes::equal);
    const Smoothing<double> smoothing(Gaussian{}, line.spacing());
    for (const auto& formulation : formulations())
        CHECK_THROWS_AS(static_cast<void>(formulation.operators(line, smoothing)), FailedComputation);
    CHECK_THROWS_WITH_AS(
        static_cast<void>(asprone2010::formulation_named<double>("fpm").operators(line, smoothing)),
        "fpm: at particle 0 (x = 0) the weights of the second derivative are not finite; take another unit of length",
        FailedComputation);
}

TEST_CASE("operators: as many smoothing lengths as particles are needed, and as many values") {
    const auto [line, smoothing] = particles_of(30, {});
    const auto& formulation = asprone2010::formulation_named<double>("fpm");
    CHECK_THROWS_WITH_AS(
        static_cast<void>(formulation.operators(line, {Gaussian{}, Column<double>{{0.1, 0.1, 0.1}}})),
        "30 particles need as many smoothing lengths, or one, got 3", InvalidInput);
    const auto [D, D2] = formulation.operators(line, smoothing);
    CHECK_THROWS_WITH_AS(apply(D, Column<double>(Column<double>::Zero(10))),
                         "an operator on 30 particles needs as many values, got 10", InvalidInput);
}

TEST_CASE(
    "operators: with an h for each particle, what was exact stays exact; an equal h for all changes nothing") {
    Column<double> x(40);
    for (Index j = 0; j < 40; ++j) x[j] = std::pow(1.08, static_cast<double>(j));
    const auto line = line_at<double>(x, Volumes::partition);
    const Smoothing<double> local(Gaussian{}, spacing(line, Spacing::local));
    CHECK(local.is_local());
    CHECK(local.h() == local.h(39));
    CHECK(local.reach(0) < local.reach());
    for (const char* name : {"modified_fpm", "second_order_fpm"}) {
        const auto [D, D2] = asprone2010::formulation_named<double>(name).operators(line, local);
        const Column<double> parabola = 3 - x + 2 * x.square();
        CHECK((apply(D, parabola) / (4 * x - 1) - 1).abs().maxCoeff() < 1e-9);
        CHECK((apply(D2, parabola) - 4).abs().maxCoeff() < 1e-7);
        const double h = line.spacing();
        const auto one = asprone2010::formulation_named<double>(name).operators(
            line, Smoothing<double>(WendlandC4{}, 8 * h));
        const auto many = asprone2010::formulation_named<double>(name).operators(
            line, Smoothing<double>(WendlandC4{}, Column<double>::Constant(40, 8 * h)));
        CHECK(same_bytes(one.D2, many.D2));
    }
}
