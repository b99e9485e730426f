#include "tests/support/properties.hpp"

#include <Eigen/LU>
#include <vector>

#include "asprone2010/section_4_second_order_fpm.hpp"
#include "asprone2010/section_5_2_static_test.hpp"
#include "base/text.hpp"

using namespace asprone2010;
using particles::Kernel;
using particles::Operators;
using particles::Smoothing;
using particles::Spacing;
using particles::Volumes;
using support::Draw;

namespace {

/// Random particles, volumes, kernel and smoothing lengths.
struct Case {
    Column<double> x;
    Volumes volumes;
    Kernel<> kernel;
    Column<double> h;   ///< one length for all, or one for each particle
    double factor = 1;  ///< by which a test stretches the line

    [[nodiscard]] std::string description() const {
        const auto N = static_cast<double>(x.size() - 1);
        return std::to_string(x.size()) + " particles, " + name(kernel) + ", volumes " + name(volumes) +
               ", (N - 1) h from " + base::shown(N * h.minCoeff()) + " to " + base::shown(N * h.maxCoeff());
    }
    [[nodiscard]] Operators<double> operators(const Formulation<double>& formulation) const {
        return formulation.operators(line(), smoothing());
    }
    [[nodiscard]] Line<double> line() const { return particles::line_at<double>(x, volumes); }
    [[nodiscard]] Smoothing<double> smoothing() const { return {kernel, h}; }

    [[nodiscard]] Case mirrored() const { return with((1 - x).reverse(), h.reverse()); }
    [[nodiscard]] Case moved(double by) const { return with(x + by, h); }
    [[nodiscard]] Case stretched(double a) const { return with(x * a, h * a); }

  private:
    [[nodiscard]] Case with(const Column<double>& x_of, const Column<double>& h_of) const {
        return {x_of, volumes, kernel, h_of, factor};
    }
};

/// Positions from 0 to 1 with equal spacings, perturbed ones, or spacings that differ by a factor of up to 4.
Column<double> random_positions(Draw& draw, Index N) {
    enum Kind { equal, perturbed, random };
    const Kind kind = draw.one_of({equal, perturbed, random});
    const double amplitude = kind == perturbed ? draw.between(0.0, 0.45) : 0,
                 longest = kind == random ? draw.between(1.0, 4.0) : 1;
    Column<double> apart(N - 1), shift(N);
    for (double& each : apart) each = draw.between(1.0, longest);
    for (double& each : shift) each = draw.between(-amplitude, amplitude);
    apart = support::on_lattice(apart / apart.sum());
    shift = support::on_lattice(shift * apart.mean());
    Column<double> x(N);
    x[0] = 0;
    for (Index j = 1; j < N; ++j) x[j] = x[j - 1] + apart[j - 1];
    x.segment(1, N - 2) += shift.segment(1, N - 2);
    return x;
}

/// The smallest h/spacing at which every particle has four neighbours where the kernel is not negligible.
double least_ratio(const Column<double>& x, const Column<double>& unit, const Kernel<>& kernel) {
    const double reach = std::min(particles::support<double>(kernel), 3.0);
    double least = 0;
    for (Index i = 0; i < x.size(); ++i) {
        Column<double> distance = (x - x[i]).abs();
        std::nth_element(distance.begin(), distance.begin() + 4, distance.end());
        least = std::max(least, distance[4] / (unit[unit.size() > 1 ? i : 0] * reach));
    }
    return least;
}

/// A case with between `fewest` and `most` particles.
Case random_case(std::uint64_t seed, Index fewest, Index most) {
    Draw draw(seed);
    Case sample;
    sample.x = random_positions(draw, draw.between(fewest, most));
    sample.volumes = draw.one_of({Volumes::equal, Volumes::partition});
    sample.kernel =
        draw.one_of<Kernel<>>({particles::Gaussian{}, particles::CubicSpline{}, particles::QuinticSpline{},
                               particles::WendlandC2{}, particles::WendlandC4{}});
    const auto unit =
        particles::spacing(sample.line(), draw.one_of({Spacing::mean, Spacing::largest, Spacing::local}));
    const double ratio = least_ratio(sample.x, unit, sample.kernel) * draw.between(1.05, 2.0);
    // With equal spacings, multiples of 1/4 put particles exactly on the edge of the support.
    sample.h = unit * draw.one_of({ratio, std::ceil(4 * ratio) / 4});
    sample.factor = draw.factor();
    return sample;
}

/// Calls `check(case, formulation)` for the case of each seed and for each formulation.
template <class Check>
void for_each_case(Index fewest, Index most, const Check& check) {
    const support::Threads one(1);
    support::for_each_seed([&](std::uint64_t seed) {
        const Case sample = random_case(seed, fewest, most);
        INFO(sample.description());
        for (const auto& formulation : formulations<double>()) {
            CAPTURE(formulation.name);
            check(sample, formulation);
        }
    });
}

/// The degrees up to which a formulation's first and second derivative are exact on any particles; whether
/// its D² is D applied twice.
struct Theory {
    int first, second;
    bool twice;
};
Theory theory_of(std::string_view formulation) {
    if (formulation == "chen_beraun") return {1, 1, false};
    if (formulation == "fpm") return {1, 1, true};
    if (formulation == "modified_fpm") return {2, 2, false};
    if (formulation == "second_order_fpm") return {2, 3, false};
    return {0, 0, true};
}

/// A matrix without row i and column j.
Eigen::MatrixXd minor_of(const Eigen::MatrixXd& A, Index i, Index j) {
    return Eigen::MatrixXd::NullaryExpr(A.rows() - 1, A.cols() - 1, [&](Index k, Index l) {
        return A(k < i ? k : k + 1, l < j ? l : l + 1);
    });
}

/// The sum of the absolute values of all products in the determinant's expansion.
double permanent(const Eigen::MatrixXd& A) {
    if (A.rows() == 0) return 1;
    double sum = 0;
    for (Index j = 0; j < A.cols(); ++j) sum += std::abs(A(0, j)) * permanent(minor_of(A, 0, j));
    return sum;
}

/// Absolute values of a kernel and its derivative at the particles of a neighbourhood, and bounds of their
/// errors.
struct Known {
    Column<double> W, DW, W_error, DW_error;
};

/// First-order bounds of the round-off in the weights of a neighbourhood. `unit` bounds the relative error of
/// a sum over the neighbours of kernel values with a few roundings each; the local systems amplify it.
struct RoundOff {
    Neighbourhood<double> near;
    double unit = static_cast<double>(near.r.size() + 20) * std::numeric_limits<double>::epsilon();

    /// Error of an inverse, adjugate over determinant: from the error of A, and from the rounding of each
    /// product in both.
    template <int n>
    [[nodiscard]] Eigen::Matrix<double, n, n> of_inverse(const Eigen::Matrix<double, n, n>& A,
                                                         const Eigen::Matrix<double, n, n>& A_error) const {
        const double determinant = std::abs(A.determinant());
        Eigen::Matrix<double, n, n> size;
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < n; ++j) size(i, j) = permanent(minor_of(A, j, i)) / determinant;
        return size * A_error * size + unit * (1 + permanent(A) / determinant) * size;
    }

    [[nodiscard]] Known kernel() const {
        return {near.W, near.DW.abs(), unit * near.W, unit * near.DW.abs()};
    }

    /// The kernel times a polynomial in r with the exponents p.
    template <int... p>
    [[nodiscard]] Known corrected() const {
        const auto& [r, W, DW, V] = near;
        const Column<double> s = r.abs(), WV = W * V;
        const auto M = rkpm::moment_matrix<double, p...>(
            [&, &signed_r = r](int k) { return (signed_r.pow(k) * WV).sum(); });
        const auto M_size = rkpm::moment_matrix<double, p...>([&](int k) { return (s.pow(k) * WV).sum(); });
        const auto inverse = of_inverse<sizeof...(p)>(M, unit * M_size);
        Index k = 0;
        Column<double> C = 0 * s, DC = 0 * s;
        ((C += inverse(k, 0) * s.pow(p), DC += inverse(k, 0) * p * s.pow(std::max(p - 1, 0)), ++k), ...);
        const auto K = rkpm::corrected<p...>(near);
        return {K.W.abs(), K.DW.abs(), C * W, DC * W + C * DW.abs()};
    }

    /// Errors of the weights A⁻¹ (W, DW) ΔΩ, summed over each row: from W and DW, from the sums in A, and
    /// from the inverse.
    /// \param first, second the factors whose moments are the columns of A
    [[nodiscard]] Eigen::Vector2d of_system(const Eigen::Matrix2d& A, const Column<double>& first,
                                            const Column<double>& second, const Known& known) const {
        const Column<double> W_error = (known.W_error + unit * known.W) * near.V,
                             DW_error = (known.DW_error + unit * known.DW) * near.V;
        const Eigen::Matrix2d A_error{{(first * W_error).sum(), (second * W_error).sum()},
                                      {(first * DW_error).sum(), (second * DW_error).sum()}};
        const Eigen::Vector2d sums{(known.W * near.V).sum(), (known.DW * near.V).sum()};
        return of_inverse<2>(A, A_error) * sums +
               A.inverse().cwiseAbs() * Eigen::Vector2d(W_error.sum(), DW_error.sum());
    }

    /// Sums of the errors of a row's weights for D and, where the formulation solves for both, for D², in
    /// units of 1/h and 1/h².
    [[nodiscard]] Eigen::Vector2d of_row(std::string_view formulation) const {
        const auto& [r, W, DW, V] = near;
        const Column<double> one = Column<double>::Ones(r.size()), s = r.abs(), half_square = s * s / 2;
        if (formulation == "original") return {(kernel().DW_error * V).sum(), 0};
        if (formulation == "rkpm_first_order") return {(corrected<0, 1>().DW_error * V).sum(), 0};
        if (formulation == "rkpm_second_order") return {(corrected<0, 1, 2>().DW_error * V).sum(), 0};
        if (formulation == "fpm") return {of_system(fpm::matrix(near), one, s, kernel())[1], 0};
        if (formulation == "modified_fpm")
            return of_system(modified_fpm::matrix(near), s, half_square, kernel());
        if (formulation == "second_order_fpm")
            return of_system(modified_fpm::matrix(second_order_fpm::corrected(near)), s, half_square,
                             corrected<0, 1, 3>());
        // Chen and Beraun divide by sums without cancellation; (20) subtracts.
        const double D = (DW.abs() * V).sum() / (s * DW.abs() * V).sum();
        return 3 * unit *
               Eigen::Vector2d(D, ((W * V).sum() + 2 * (s * W * V).sum() * D) / (half_square * W * V).sum());
    }
};

/// The operators of a case as full matrices, with a bound of the sum of the errors of each row's weights.
struct Computed {
    Computed(const Case& sample, const Formulation<double>& formulation)
        : Computed(sample, formulation, sample.operators(formulation)) {}

    Eigen::MatrixXd D, D2;
    Column<double> D_error, D2_error;

  private:
    Computed(const Case& sample, const Formulation<double>& formulation, const Operators<double>& operators)
        : D(operators.D), D2(operators.D2), D_error(sample.x.size()), D2_error(sample.x.size()) {
        const auto line = sample.line();
        const auto smoothing = sample.smoothing();
        for (Index i = 0; i < sample.x.size(); ++i) {
            // Twice, since a particle's own weight is minus the sum of the others.
            const RoundOff round_off{particles::neighbourhood(line, smoothing, i)};
            const Eigen::Vector2d error = 2 * round_off.of_row(formulation.name);
            D_error[i] = error[0] / smoothing.h(i);
            D2_error[i] = error[1] / (smoothing.h(i) * smoothing.h(i));
        }
        // Each factor of the product D·D contributes, and so do the sums of the product.
        if (theory_of(formulation.name).twice)
            D2_error = 3 * D_error.maxCoeff() * D.cwiseAbs().rowwise().sum().maxCoeff();
    }
};

/// The largest ratio of a row's sum of absolute values to its bound.
double excess(const Eigen::MatrixXd& difference, const Column<double>& bound) {
    return (difference.cwiseAbs().rowwise().sum().array() / bound).maxCoeff();
}

/// The largest ratio of the error of Σ_j D_ij (x_j − x_i)^k, k ≥ 1, to its bound.
double excess_of_moment(const Eigen::MatrixXd& D, const Column<double>& bound, const Column<double>& x, int k,
                        double exact) {
    double largest = 0;
    for (Index i = 0; i < x.size(); ++i) {
        const Column<double> w = D.row(i), power = (x - x[i]).pow(k);
        const double farthest = (w != 0).select(power.abs(), 0).maxCoeff();
        largest = std::max(largest, std::abs((w * power).sum() - exact) / (bound[i] * farthest));
    }
    return largest;
}

bool same_bytes(const Operator<double>& a, const Operator<double>& b) {
    return a.nonZeros() == b.nonZeros() &&
           std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()) &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr());
}

constexpr Index few = 6, many = 80;

}  // namespace

TEST_CASE(
    "properties: the bound of a row's round-off is small beside its weights, so that the tests below can fail") {
    for_each_case(few, many, [](const Case& sample, const Formulation<double>& formulation) {
        const Computed computed(sample, formulation);
        CHECK((computed.D_error / computed.D.cwiseAbs().rowwise().sum().array()).maxCoeff() < 1e-6);
        CHECK((computed.D2_error / computed.D2.cwiseAbs().rowwise().sum().array()).maxCoeff() < 1e-6);
    });
}

TEST_CASE("properties: polynomials up to a formulation's degree are differentiated exactly, to round-off") {
    for_each_case(few, many, [](const Case& sample, const Formulation<double>& formulation) {
        const auto [first, second, twice] = theory_of(formulation.name);
        const Computed computed(sample, formulation);
        for (int k = 1; k <= first; ++k)
            CHECK(excess_of_moment(computed.D, computed.D_error, sample.x, k, k == 1 ? 1 : 0) <= 2);
        for (int k = 1; k <= second; ++k)
            CHECK(excess_of_moment(computed.D2, computed.D2_error, sample.x, k, k == 2 ? 2 : 0) <= 2);
    });
}

TEST_CASE("properties: a row sums to zero to the last bit, and a constant has no derivatives") {
    for_each_case(few, many, [](const Case& sample, const Formulation<double>& formulation) {
        const Column<double> constant = Column<double>::Constant(sample.x.size(), 1e10);
        const auto [D, D2] = sample.operators(formulation);
        for (const auto* each : {&D, &D2}) {
            double largest = 0;
            for (Index i = 0; i < each->rows(); ++i) {
                double others = 0;
                for (Operator<double>::InnerIterator entry(*each, i); entry; ++entry)
                    if (entry.col() != i) others += entry.value();
                largest = std::max(largest, std::abs(others + each->coeff(i, i)));
            }
            CHECK(largest == 0);
            CHECK((particles::apply(*each, constant) == 0).all());
        }
    });
}

TEST_CASE("properties: on mirrored particles D is reversed and changes its sign, D² is reversed") {
    for_each_case(few, many, [](const Case& sample, const Formulation<double>& formulation) {
        const Computed computed(sample, formulation), mirrored(sample.mirrored(), formulation);
        CHECK(excess(computed.D + mirrored.D.reverse(), computed.D_error) <= 2);
        CHECK(excess(computed.D2 - mirrored.D2.reverse(), computed.D2_error) <= 2);
    });
}

TEST_CASE("properties: a line that is a times as long has D/a and D²/a²") {
    for_each_case(few, many, [](const Case& sample, const Formulation<double>& formulation) {
        const double a = sample.factor;
        CAPTURE(a);
        const Computed computed(sample, formulation), stretched(sample.stretched(a), formulation);
        CHECK(excess(computed.D - a * stretched.D, computed.D_error) <= 2);
        CHECK(excess(computed.D2 - a * a * stretched.D2, computed.D2_error) <= 2);
    });
}

TEST_CASE("properties: a power of two times the length, and another place, change no bit of a weight") {
    for_each_case(few, many, [](const Case& sample, const Formulation<double>& formulation) {
        const auto [D, D2] = sample.operators(formulation);
        for (const double a : {0x1p-40, 0.5, 0x1p20}) {
            const auto stretched = sample.stretched(a).operators(formulation);
            CHECK(same_bytes(D, stretched.D * a));
            CHECK(same_bytes(D2, stretched.D2 * (a * a)));
        }
        for (const double by : {-1.0, 0.375, 100.0}) {
            const auto moved = sample.moved(by).operators(formulation);
            CHECK(same_bytes(D, moved.D));
            CHECK(same_bytes(D2, moved.D2));
        }
    });
}

TEST_CASE("properties: operators and displacements have the same bytes on one, two and three threads") {
    const auto exact = static_test::exponential_load();
    const auto& second_order = formulation_named<double>("second_order_fpm");
    const support::Threads one(1);
    support::for_each_seed([&](std::uint64_t seed) {
        const Case sample = random_case(seed, 100, 600);
        INFO(sample.description());
        const auto& formulation = formulations<double>()[seed % formulations<double>().size()];
        CAPTURE(formulation.name);
        const auto displacement = [&] {
            return static_test::displacement(second_order.operators(sample.line(), sample.smoothing()),
                                             sample.line(), exact, 2);
        };
        const auto alone = sample.operators(formulation);
        const Column<double> u = displacement();
        for (const int several : {2, 3}) {
            CAPTURE(several);
            const support::Threads together_on(several);
            const auto together = sample.operators(formulation);
            CHECK(same_bytes(alone.D, together.D));
            CHECK(same_bytes(alone.D2, together.D2));
            CHECK((displacement() == u).all());
        }
    });
}
