#include "particles/operator.hpp"

#include "tests/support/lines.hpp"
#include "tests/support/same_bytes.hpp"

using namespace particles;
using asprone2010::formulations;
using support::particles_of;
using support::same_bytes;

TEST_CASE("operator: applied to a constant they give zero exactly, however large it is") {
    const auto [line, smoothing] = particles_of(100, {Volumes::equal, Gaussian{}, 1, 0.3});
    for (const auto& formulation : formulations<double>()) {
        const auto [D, D2] = formulation.operators(line, smoothing);
        const Column<double> B = Column<double>::Constant(100, 1e10);
        CHECK((apply(D, B) == 0).all());
        CHECK((apply(D2, B) == 0).all());
    }
}

TEST_CASE("operator: applying through differences agrees with the matrix product") {
    const auto [line, smoothing] = particles_of(80, {Volumes::equal, Gaussian{}, 1, 0.25});
    const Column<double> B = line.x().unaryExpr(&support::Wave::B);
    for (const auto& formulation : formulations<double>()) {
        const auto [D, D2] = formulation.operators(line, smoothing);
        CHECK((apply(D, B) - (D * B.matrix()).array()).abs().maxCoeff() < 1e-11);
        CHECK((apply(D2, B) - (D2 * B.matrix()).array()).abs().maxCoeff() < 1e-8);
    }
}

TEST_CASE("operator: minus, identity, and the rows of three operators in one") {
    const auto [line, smoothing] = particles_of(40, {Volumes::equal, Gaussian{}, 1, 0.25});
    const auto both = asprone2010::formulation_named<double>("modified_fpm").operators(line, smoothing);
    const Eigen::MatrixXd D(both.D), D2(both.D2);
    CHECK(Eigen::MatrixXd(identity<double>(40)) == Eigen::MatrixXd::Identity(40, 40));
    CHECK(Eigen::MatrixXd(minus(Operator<double>(both.D))) == -D);
    const Eigen::MatrixXd rows(
        first_inner_last(identity<double>(40), minus(Operator<double>(both.D2)), both.D));
    CHECK(rows.row(0) == Eigen::MatrixXd::Identity(40, 40).row(0));
    CHECK(rows.middleRows(1, 38) == -D2.middleRows(1, 38));
    CHECK(rows.row(39) == D.row(39));
}

TEST_CASE("operator: among some particles it is the block of their rows and columns") {
    const auto [line, smoothing] = particles_of(40, {Volumes::equal, Gaussian{}, 1, 0.25});
    Operator<double> D = asprone2010::formulation_named<double>("fpm").operators(line, smoothing).D2;
    for (const bool consecutive : {true, false}) {
        if (!consecutive) D = D.pruned(0.3 * D.coeffs().abs().maxCoeff(), 1);
        for (const Range some : {Range{0, 40}, Range{1, 39}, Range{17, 20}, Range{5, 5}}) {
            const Operator<double> expected = D.block(some.first, some.first, some.size(), some.size());
            CHECK(same_bytes(among(D, some), expected));
        }
    }
}

TEST_CASE("operator: constants cannot be annihilated on a range of rows, whose diagonal is not known") {
    Operator<double> some(2, 5);
    CHECK_THROWS_WITH_AS(annihilate_constants(some),
                         "an operator with 2 of 5 rows does not say where its diagonal is", InvalidInput);
}

TEST_CASE("operator: a row without a stored diagonal entry is refused") {
    Operator<double> shift(3, 3);
    const std::vector<Eigen::Triplet<double>> entries{{0, 0, 1}, {1, 2, 1}, {2, 2, 1}};
    shift.setFromTriplets(entries.begin(), entries.end());
    CHECK_THROWS_WITH_AS(annihilate_constants(shift), "row 1 of the operator stores no diagonal entry",
                         InvalidInput);
}
