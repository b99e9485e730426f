#include "tests/support/properties.hpp"

#include <map>

#include "batra2008/section_3_1_collocation.hpp"
#include "batra2008/section_4_example_problems.hpp"
#include "solvers/spectrum.hpp"
#include "tests/batra2008/bases.hpp"
#include "tests/batra2008/elastic.hpp"

using namespace batra2008;
using support::Bases;
using support::Draw;

namespace {

/// Particles around a place.
struct Case {
    int dim, m;
    Eigen::MatrixXd x;
    Eigen::VectorXd place;
    double rho, h;
    double factor;  // by which a test stretches it

    [[nodiscard]] Bases bases() const { return support::bases(m, x, rho, place, h); }

    [[nodiscard]] Case mirrored(Index axis) const {
        Case given = *this;
        given.x.row(axis) = 1 - x.row(axis).array();
        given.place[axis] = 1 - place[axis];
        return given;
    }
    [[nodiscard]] Case stretched(double a) const { return {dim, m, x * a, place * a, rho, h * a, factor}; }
};

/// A random case: a grid in the unit cube whose particles are moved, seen from one of them or from another
/// place.
Case random_case(std::uint64_t seed) {
    Draw draw(seed);
    Case given;
    given.dim = draw.one_of({1, 2, 3});
    given.m = draw.one_of({1, 2, 3});
    const Index across = draw.between(Index{given.m + 4}, Index{given.dim == 1   ? 40
                                                                : given.dim == 2 ? 12
                                                                                 : 8});
    const double spacing = 1 / static_cast<double>(across - 1), amplitude = draw.between(0.0, 0.35);
    const auto N = static_cast<Index>(std::lround(std::pow(static_cast<double>(across), given.dim)));
    given.x.resize(given.dim, N);
    for (Index j = 0; j < N; ++j)
        for (Index axis = 0, rest = j; axis < given.dim; ++axis, rest /= across)
            given.x(axis, j) =
                spacing * (static_cast<double>(rest % across) + draw.between(-amplitude, amplitude));
    given.x = support::on_lattice(given.x);
    given.place = given.x.col(draw.between(Index{0}, N - 1));
    if (draw.between(Index{0}, Index{1}) == 0)
        for (double& coordinate : given.place) coordinate = draw.between(0.0, 1.0);
    given.place = support::on_lattice(given.place);
    given.h = spacing * draw.between(1.0, 1.5);
    given.rho = draw.between(given.m + 1.5, given.m + 2.5) * spacing / given.h;
    given.factor = draw.factor();
    return given;
}

/// Calls `check(case, its bases)` for the random case of each seed.
template <class Check>
void for_each_case(const Check& check) {
    const support::Threads one(1);
    support::for_each_seed([&](std::uint64_t seed) {
        const Case given = random_case(seed);
        CAPTURE(given.dim);
        CAPTURE(given.m);
        CAPTURE(given.x.cols());
        CAPTURE(given.rho);
        CAPTURE(given.h);
        check(given, given.bases());
    });
}

/// x^a. \param x a column for each particle
Eigen::ArrayXd monomial(const Eigen::MatrixXd& x, const support::Powers& a) {
    Eigen::ArrayXd product = Eigen::ArrayXd::Ones(x.cols());
    for (Index axis = 0; axis < x.rows(); ++axis)
        product *= x.row(axis).transpose().array().pow(a[static_cast<std::size_t>(axis)]);
    return product;
}

int order(const support::Powers& a) {
    return a[0] + a[1] + a[2];
}

/// Bound on the round-off error of each weight of K, to first order: the sums in C have a term for each
/// particle, the terms carry the rounding errors of a lowered Gaussian, and the solutions of C K = D those of
/// the Cholesky factors. These do not depend on the size of the monomials: condition and inverse are those of
/// C with a unit diagonal.
/// \return a row for each particle, a column for each entry of Q
Eigen::ArrayXXd round_off(const Case& given, const Bases& bases) {
    const Eigen::MatrixXd s = (given.x(Eigen::all, bases.particle).colwise() - given.place) / given.h;
    const Eigen::ArrayXd gaussian = (-s.colwise().squaredNorm().transpose().array()).exp();
    const double edge = std::exp(-given.rho * given.rho);
    const auto n = static_cast<Index>(bases.exponents.size());
    Eigen::MatrixXd H(s.cols(), n);
    for (Index I = 0; I < n; ++I) H.col(I) = monomial(s, bases.exponents[static_cast<std::size_t>(I)]);
    const Eigen::MatrixXd C = H.transpose() * (gaussian - edge).matrix().asDiagonal() * H;
    const Eigen::VectorXd unit = C.diagonal().cwiseSqrt().cwiseInverse();
    const auto lambda = solvers::symmetric_eigenvalues(unit.asDiagonal() * C * unit.asDiagonal(),
                                                       Eigen::MatrixXd::Identity(n, n));
    const double terms = static_cast<double>(s.cols() + 10 * n) + 2 * given.rho * given.rho;
    const double amplified =
        std::numeric_limits<double>::epsilon() * terms * lambda.back() / (lambda[0] * lambda[0]);
    const Eigen::ArrayXd of_particle =
        amplified * (gaussian + edge) * (H * unit.asDiagonal()).rowwise().norm().array();
    Eigen::ArrayXXd of_weight(s.cols(), n);
    for (Index I = 0; I < n; ++I)
        of_weight.col(I) =
            of_particle * unit[I] * std::pow(given.h, -order(bases.exponents[static_cast<std::size_t>(I)]));
    return of_weight;
}

/// K of another basis of the same particles, with its rows in the order of the first basis.
Eigen::ArrayXXd in_order_of(const Bases& first, const Bases& other) {
    REQUIRE(other.particle.size() == first.particle.size());
    std::map<int, Index> row;
    for (const int particle : other.particle) row.emplace(particle, static_cast<Index>(row.size()));
    Eigen::ArrayXXd K(other.K.rows(), other.K.cols());
    Index k = 0;
    for (const int particle : first.particle) {
        REQUIRE(row.count(particle) == 1);
        K.row(k++) = other.K.row(row[particle]);
    }
    return K;
}

}  // namespace

TEST_CASE(
    "properties: the bounds on round-off are small beside the weights, so that the tests below can fail") {
    for_each_case([](const Case& given, const Bases& bases) {
        CHECK((round_off(given, bases).colwise().sum() / bases.K.abs().colwise().sum()).maxCoeff() < 1e-4);
    });
}

TEST_CASE("properties: K gives a monomial's own entry of Q and no other; rows for derivatives sum to zero") {
    for_each_case([](const Case& given, const Bases& bases) {
        const Eigen::ArrayXXd error = round_off(given, bases);
        const Eigen::MatrixXd offset = given.x(Eigen::all, bases.particle).colwise() - given.place;
        double largest = 0;
        for (std::size_t a = 0; a < bases.exponents.size(); ++a) {
            const Eigen::ArrayXd power = monomial(offset, bases.exponents[a]);
            for (Index I = 0; I < bases.K.cols(); ++I) {
                const double left = (bases.K.col(I) * power).sum() - (I == static_cast<Index>(a) ? 1 : 0);
                largest = std::max(largest, std::abs(left) / (error.col(I) * power.abs()).sum());
            }
        }
        CHECK(largest <= 2);
    });
}

TEST_CASE(
    "properties: on mirrored particles K changes its sign with the derivatives that are odd in that direction") {
    for_each_case([](const Case& given, const Bases& bases) {
        const Eigen::ArrayXXd error = round_off(given, bases);
        for (Index axis = 0; axis < given.dim; ++axis) {
            const Bases mirrored = given.mirrored(axis).bases();
            Eigen::ArrayXXd K = in_order_of(bases, mirrored);
            for (Index I = 0; I < K.cols(); ++I)
                if (bases.exponents[static_cast<std::size_t>(I)][static_cast<std::size_t>(axis)] % 2 == 1)
                    K.col(I) *= -1;
            CHECK(((K - bases.K).abs() / error).maxCoeff() <= 2);
        }
    });
}

TEST_CASE(
    "properties: a times the length divides K by a to the order of the derivative; a power of two changes no bit") {
    for_each_case([](const Case& given, const Bases& bases) {
        const auto unstretched = [&](const Bases& stretched, double a) {
            Eigen::ArrayXXd K = in_order_of(bases, stretched);
            for (Index I = 0; I < K.cols(); ++I)
                K.col(I) *= std::pow(a, order(bases.exponents[static_cast<std::size_t>(I)]));
            return K;
        };
        const double a = given.factor;
        CAPTURE(a);
        CHECK(((unstretched(given.stretched(a).bases(), a) - bases.K).abs() / round_off(given, bases))
                  .maxCoeff() <= 2);
        for (const double two : {0x1p-30, 0.5, 0x1p20}) {
            const Bases stretched = given.stretched(two).bases();
            CHECK((unstretched(stretched, two) == bases.K).all());
            CHECK((stretched.slopes[0] * two == bases.slopes[0]).all());
        }
    });
}

TEST_CASE(
    "properties: a plate's system and its displacements have the same bytes on one, two and three threads") {
    using namespace example_problems;
    const Problem problem = plate::problem({plate::E, plate::nu});
    const support::Threads one(1);
    support::for_each_seed([&](std::uint64_t seed) {
        Draw draw(seed);
        const Index ny = draw.between(Index{4}, Index{6}), nx = 5 * (ny - 1) + 1;
        const double amplitude = draw.between(0.0, 0.1);
        Discretisation how;
        how.method = draw.one_of({Method::strong, Method::weak1, Method::weak2});
        how.scaling = draw.between(3.5, 4.0);
        how.penalty = plate::penalty(problem.material);
        how.gauss = 3;
        CAPTURE(nx);
        CAPTURE(amplitude);
        CAPTURE(name(how.method));
        CAPTURE(how.scaling);
        const Cloud<2> cloud(support::moved_grid(nx, ny, amplitude, seed));
        const System alone = system(problem, cloud, how);
        const Eigen::VectorXd u = solved(System(alone));
        for (const int several : {2, 3}) {
            CAPTURE(several);
            const support::Threads together_on(several);
            const System together = system(problem, cloud, how);
            REQUIRE(together.A.nonZeros() == alone.A.nonZeros());
            CHECK(std::equal(alone.A.valuePtr(), alone.A.valuePtr() + alone.A.nonZeros(),
                             together.A.valuePtr()));
            CHECK(together.b == alone.b);
            CHECK(solved(System(together)) == u);
        }
    });
}
