#include "batra2008/claims.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <tuple>
#include <vector>

#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "report/file.hpp"
#include "report/statistics.hpp"
#include "report/table.hpp"

namespace batra2008::claims {

namespace {

using elastostatics::Material;
using elastostatics::Plane;
using example_problems::Method;
using example_problems::Solution;
using report::Measurement;
using Computations = std::map<std::string, report::Computation>;
using Measurements = std::vector<Measurement>;

Measurements stated(double value) {
    return {{"", value}};
}

/// The same under both conventions: the claim is not about the error norm.
template <class Compute>
report::Computation either(const Compute& compute) {
    return [compute](std::size_t) { return stated(compute()); };
}

// Section 2

/// Random particles around the origin, in a cube of side 2 with h = 1/4 or less.
template <int dim>
particles::Cloud<dim> random_cloud(Index count, unsigned long seed) {
    const std::unique_ptr<gsl_rng, void (*)(gsl_rng*)> random(gsl_rng_alloc(gsl_rng_mt19937), gsl_rng_free);
    if (!random) throw std::bad_alloc();
    gsl_rng_set(random.get(), seed);
    Points<dim> x(dim, count);
    for (Index j = 0; j < count; ++j)
        for (Index axis = 0; axis < dim; ++axis) x(axis, j) = gsl_ran_flat(random.get(), -1, 1);
    return particles::Cloud<dim>(x);
}

/// Order of consistency of an estimate for m = 2: the order in h of its error, less the order of the derivative that is subtracted
/// from m + 1 in theory. The particles are random and shrink with h towards a place beside the origin; the function has no symmetries.
/// \param I entry of Q: 0 for f, 1 for the first derivative, dim + 1 for the second by x1
template <int dim>
double order_of_error(Index I) {
    const auto cloud = random_cloud<dim>(dim == 1 ? 20 : dim == 2 ? 60 : 300, 1);
    const particles::TruncatedGaussian<dim> kernel(3);
    const Point<dim> place = Point<dim>::Constant(0.05);
    const auto basis = ssph_basis::basis_at<2>(cloud, kernel, place, dim == 1 ? 0.25 : dim == 2 ? 0.3 : 0.33);
    const Column<double> weights = ssph_basis::derivative(basis, I);
    // f(x) = exp(k·x): around 0, at a scale, f and its derivatives are known.
    const Point<dim> k = Point<dim>::LinSpaced(dim, 1, 0.6);
    const double exact = I == 0 ? 1 : I == 1 ? k[0] : k[0] * k[0];
    const int derivative = I == 0 ? 0 : I == 1 ? 1 : 2;
    std::vector<double> scales, errors;
    for (const double scale : {0.04, 0.02, 0.01}) {
        double sum = 0;
        for (std::size_t j = 0; j < basis.particle().size(); ++j)
            sum += weights[static_cast<Index>(j)] *
                   std::exp(scale * k.dot(Point<dim>(cloud.x().col(basis.particle()[j]) - place)));
        scales.push_back(scale);
        errors.push_back(std::abs(sum / std::pow(scale, derivative) - exact));
    }
    return report::observed_order(scales, errors);
}

/// Largest error of the derivatives of a quadratic, all particles weighed alike.
double error_with_constant_kernel() {
    const auto cloud = random_cloud<2>(60, 2);
    Surroundings<2> near =
        particles::surroundings(cloud, particles::TruncatedGaussian<2>(3), Point<2>(0.1, 0), 0.3);
    near.W.setOnes();
    const ssph_basis::Basis<2, 2> basis(near, 0.3);
    const auto f = [](const Point<2>& x) {
        return 1 + 2 * x[0] - x[1] + 3 * x[0] * x[0] + x[0] * x[1] - 2 * x[1] * x[1];
    };
    const std::array<double, 6> exact{f({0.1, 0}), 2.6, -0.9, 6, -4, 1};
    double most = 0;
    for (Index I = 0; I < 6; ++I) {
        const Column<double> weights = ssph_basis::derivative(basis, I);
        double sum = 0;
        for (std::size_t j = 0; j < basis.particle().size(); ++j)
            sum += weights[static_cast<Index>(j)] * f(cloud.x().col(basis.particle()[j]));
        most = std::max(most, std::abs(sum - exact[static_cast<std::size_t>(I)]));
    }
    return most;
}

/// Asymmetry of the sum of \eq{B2.5} relative to its largest entry.
double asymmetry() {
    const auto cloud = random_cloud<2>(60, 3);
    const auto near =
        particles::surroundings(cloud, particles::TruncatedGaussian<2>(3), Point<2>(0.1, 0), 0.3);
    const auto H = ssph_basis::H<2, 2, double>(near.s);
    const auto C = ssph_basis::summed<6>(H, near.W);
    return (C - C.transpose()).cwiseAbs().maxCoeff() / C.cwiseAbs().maxCoeff();
}

/// Reciprocal condition of C for particles at given places of the plane, in units of h, seen from the origin with ρ = 4.
double reciprocal_condition(const std::vector<Point<2>>& at) {
    Eigen::Array<double, Eigen::Dynamic, 2> s(static_cast<Index>(at.size()), 2);
    for (std::size_t j = 0; j < at.size(); ++j) s.row(static_cast<Index>(j)) = at[j].transpose();
    const auto H = ssph_basis::H<2, 2, double>(s);
    const auto C =
        ssph_basis::summed<6>(H, particles::TruncatedGaussian<2>(4).W(s.square().rowwise().sum().eval()));
    const auto values = C.jacobiSvd().singularValues();
    return values[5] / values[0];
}

std::vector<Point<2>> ring(int count, double wobble) {
    std::vector<Point<2>> at;
    for (int j = 0; j < count; ++j) {
        const double angle = 2 * std::acos(-1.0) * j / count, r = 2 + wobble * std::cos(3 * angle);
        at.emplace_back(0.7 + r * std::cos(angle), 0.2 + r * std::sin(angle));
    }
    return at;
}

/// Reciprocal condition of the one-dimensional C for so many different particles.
double reciprocal_condition_in_1D(Index count) {
    const Eigen::Array<double, Eigen::Dynamic, 1> s =
        Eigen::Array<double, Eigen::Dynamic, 1>::LinSpaced(count, -0.7, 1.1);
    const auto H = ssph_basis::H<1, 2, double>(s);
    const auto values = ssph_basis::summed<3>(H, particles::TruncatedGaussian<1>(4).W(s.square().eval()))
                            .jacobiSvd()
                            .singularValues();
    return values[2] / values[0];
}

// Section 3

/// Largest relative error of the tractions that \eq{B3.14} gives for linear displacements, as printed or mended.
double traction_error(bool printed) {
    const auto cloud = random_cloud<2>(60, 4);
    const auto basis = ssph_basis::basis_at<2>(cloud, Kernel(3), Point<2>(0.1, 0), 0.3);
    const Material material{plate::E, plate::nu};
    const Eigen::Matrix2d gradient{{0.3, -0.2}, {0.5, 0.7}};
    Column<double> u1(static_cast<Index>(basis.particle().size())), u2 = u1;
    for (Index j = 0; j < u1.size(); ++j) {
        const Vector u = gradient * cloud.x().col(basis.particle()[static_cast<std::size_t>(j)]);
        u1[j] = u[0];
        u2[j] = u[1];
    }
    double most = 0;
    for (const Vector& n : {Vector(1, 0), Vector(0, 1), Vector(0.6, 0.8)}) {
        collocation::Block block = collocation::traction(basis, material, n);
        if (printed) {
            const double nu0 = elastostatics::nu0(material);
            block.K22 += (nu0 - 1) * elastostatics::E0(material) / (1 - nu0 * nu0) * n[1] * basis.K(2);
        }
        const Vector exact =
            elastostatics::traction(elastostatics::stress(material, elastostatics::strain(gradient)), n);
        most = std::max(most, (collocation::sums(block, u1, u2) - exact).norm() / exact.norm());
    }
    return most;
}

/// Largest error of u2 in percent on 16 × 4 particles, with the tractions of \eq{B3.14} as printed or mended.
double plate_error(bool printed) {
    const Material material{plate::E, plate::nu};
    const Problem problem = plate::problem(material);
    const Cloud<2> cloud(plate::grid(16, 4));
    const Kernel kernel(3);
    System system = collocation::system<2>(problem, cloud, kernel);
    const double nu0 = elastostatics::nu0(material);
    for (Index I = 0; printed && I < cloud.size(); ++I) {
        const auto conditions = elastostatics::conditions_at(problem, cloud.x().col(I));
        for (std::size_t row = 0; row < conditions.size(); ++row) {
            if (conditions[row].displacement || conditions[row].component == 0) continue;
            const auto basis =
                ssph_basis::basis_at<2>(cloud, kernel, Point<2>(cloud.x().col(I)), cloud.h()[I]);
            const Column<double> excess =
                (nu0 - 1) * elastostatics::E0(material) / (1 - nu0 * nu0) * conditions[row].n[1] * basis.K(2);
            for (std::size_t j = 0; j < basis.particle().size(); ++j)
                system.A.coeffRef(2 * I + static_cast<Index>(row), 2 * basis.particle()[j] + 1) +=
                    excess[static_cast<Index>(j)];
        }
    }
    const Solution solution{{Method::strong, 3}, material, solved(system)};
    return plate::largest_error_u2(cloud, solution, problem);
}

/// How many bases the weak forms evaluate for each one of collocation, on a grid of the plate.
double bases_for_one(Index nx, Index ny) {
    const Problem problem = plate::problem({plate::E, plate::nu});
    const Cloud<2> cloud(plate::grid(nx, ny));
    const particles::Region region = elastostatics::region(problem);
    double bases = 0;
    for (Index I = 0; I < cloud.size(); ++I) {
        const auto Omega = mlpg::subdomain(problem, region, cloud.x().col(I), cloud.h()[I], Kernel(1), 10);
        bases += static_cast<double>(Omega.inside.size());
        for (const auto& at : Omega.boundary) bases += at.displaced[0] || at.displaced[1] ? 1 : 0;
    }
    return bases / static_cast<double>(cloud.size());
}

// Section 4.1

struct Plate {
    Index nx = 16, ny = 4;
    Method method = Method::strong;
    double scaling = 3;
    int degree = 2;
    Index gauss = 10;
    std::array<std::string, 2> corner_1 = {"s11", "s22"}, corner_3 = {"u1", "u2"};
    double nu = plate::nu;
    Plane plane = Plane::stress;
    bool operator<(const Plate& other) const {
        const auto key = [](const Plate& of) {
            return std::tie(of.nx, of.ny, of.method, of.scaling, of.degree, of.gauss, of.corner_1,
                            of.corner_3, of.nu, of.plane);
        };
        return key(*this) < key(other);
    }
};

struct PlateResult {
    std::array<double, 2> log_error;  ///< by convention
    double error_u2;                  ///< percent
};

PlateResult computed(const Plate& of) {
    plate::Corners corners = plate::default_corners();
    corners[0] = of.corner_1;
    corners[2] = of.corner_3;
    const Material material{plate::E, of.nu, of.plane};
    const Problem problem = plate::problem(material, corners);
    const Cloud<2> cloud(plate::grid(of.nx, of.ny));
    const Solution solution = example_problems::solve(
        problem, cloud, {of.method, of.scaling, of.degree, plate::penalty(material), 1, of.gauss});
    const auto [dn, nd] = example_problems::errors(plate::mesh(of.nx, of.ny), cloud, solution, problem);
    return {{dn, nd}, plate::largest_error_u2(cloud, solution, problem)};
}

/// Solutions of the plate, each computed once.
class Plates {
  public:
    const PlateResult& operator()(const Plate& of) {
        const auto found = known_.find(of);
        return found != known_.end() ? found->second : known_.emplace(of, computed(of)).first->second;
    }

  private:
    std::map<Plate, PlateResult> known_;
};

constexpr std::array<std::array<Index, 2>, 4> grids{{{16, 4}, {31, 7}, {61, 13}, {91, 19}}};
constexpr std::array<Method, 3> methods{Method::strong, Method::weak1, Method::weak2};
const std::array<std::string, 2> top_and_right{"s11", "s12"};

/// log E of a plate.
report::Computation log_error(const std::shared_ptr<Plates>& plates, const Plate& of) {
    return [=](std::size_t convention) { return stated((*plates)(of).log_error[convention]); };
}

report::Computation error_u2(const std::shared_ptr<Plates>& plates, const Plate& of) {
    return [=](std::size_t) { return stated((*plates)(of).error_u2); };
}

/// log E of a method over scaling factors from 2.1 to 5.
struct Sweep {
    std::vector<double> scaling, log_error;
};
Sweep sweep(Plates& plates, Method method, std::size_t convention) {
    Sweep of;
    for (int k = 21; k <= 50; ++k) {
        Plate plate;
        plate.method = method;
        plate.scaling = k / 10.0;
        of.scaling.push_back(plate.scaling);
        of.log_error.push_back(plates(plate).log_error[convention]);
    }
    return of;
}

/// Rate of convergence between the coarsest and the finest grid, as in Figure 12.
double rate(Plates& plates, Method method, std::size_t convention) {
    const auto at = [&](std::size_t k) {
        Plate of{grids[k][0], grids[k][1], method, 4};
        of.corner_1 = top_and_right;
        return plates(of).log_error[convention];
    };
    return (at(0) - at(3)) / std::log10(6.0);
}

double spread_of(Plates& plates, const auto& choices, std::size_t convention, bool corner_3) {
    double least = 1e300, most = -1e300;
    for (const auto& pair : choices) {
        Plate of;
        (corner_3 ? of.corner_3 : of.corner_1) = pair;
        const double log_error = plates(of).log_error[convention];
        least = std::min(least, log_error);
        most = std::max(most, log_error);
    }
    return most - least;
}

void add_plate(Computations& of) {
    const auto plates = std::make_shared<Plates>();
    const Plate strong{}, weak1{.method = Method::weak1}, weak2{.method = Method::weak2};
    of["B01"] = log_error(plates, strong);
    of["B02"] = log_error(plates, weak1);
    of["B03"] = log_error(plates, weak2);

    char letter = 'a';
    for (const auto& pair : plate::choices_at_corner_3()) {
        Plate at = strong;
        at.corner_3 = pair;
        of[std::string("B04") + letter++] = log_error(plates, at);
    }
    letter = 'a';
    for (const auto& [nx, ny] : grids)
        for (const auto& pair : plate::choices_at_corner_1()) {
            Plate at{nx, ny};
            at.corner_1 = pair;
            of[std::string("B05") + letter++] = log_error(plates, at);
        }
    of["B05m"] = [=](std::size_t convention) {
        double most = -1e300;
        for (const auto& [nx, ny] : grids)
            for (const auto& pair : plate::choices_at_corner_1()) {
                if (pair == top_and_right) continue;
                Plate best{nx, ny}, other{nx, ny};
                best.corner_1 = top_and_right;
                other.corner_1 = pair;
                most = std::max(
                    most, (*plates)(best).log_error[convention] - (*plates)(other).log_error[convention]);
            }
        return stated(most);
    };
    of["B06a"] = error_u2(plates, strong);
    of["B06b"] = error_u2(plates, weak1);
    of["B06c"] = error_u2(plates, weak2);
    const auto with = [](Method method, double scaling, int degree) {
        return Plate{.method = method, .scaling = scaling, .degree = degree};
    };
    of["B07a"] = log_error(plates, with(Method::weak1, 4, 2));
    of["B07b"] = log_error(plates, with(Method::weak2, 4, 2));
    of["B08a"] = log_error(plates, with(Method::weak1, 4, 1));
    of["B08b"] = log_error(plates, with(Method::weak2, 4, 1));
    for (const Method method : {Method::weak1, Method::weak2})
        of[method == Method::weak1 ? "B08c" : "B08d"] = [=](std::size_t convention) {
            return stated((*plates)(with(method, 4, 1)).log_error[convention] -
                          (*plates)(with(method, 4, 2)).log_error[convention]);
        };
    of["B08e"] = [=](std::size_t convention) {
        return stated((*plates)(with(Method::weak1, 4, 1)).log_error[convention] -
                      (*plates)(with(Method::strong, 4, 2)).log_error[convention]);
    };
    const auto locking = [=](Plane plane) {
        double most = 0;
        for (const Method method : methods) {
            const Plate soft{.method = method, .plane = plane};
            Plate stiff = soft;
            stiff.nu = 0.499999;
            most = std::max(most, (*plates)(stiff).error_u2 / (*plates)(soft).error_u2);
        }
        return most;
    };
    of["B09a"] = either([=] { return locking(Plane::stress); });
    of["B09b"] = either([=] { return locking(Plane::strain); });

    const auto with_gauss = [](Method method, Index gauss) {
        return Plate{.method = method, .gauss = gauss};
    };
    const auto drop = [=](Method method, std::size_t convention) {
        const double at_10 = (*plates)(with_gauss(method, 10)).log_error[convention];
        return 100 * (at_10 - (*plates)(with_gauss(method, 32)).log_error[convention]) / std::abs(at_10);
    };
    of["B10a"] = [=](std::size_t convention) {
        return stated(
            std::max(std::abs(drop(Method::weak1, convention)), std::abs(drop(Method::weak2, convention))));
    };
    of["B10b"] = [=](std::size_t convention) { return stated(drop(Method::weak1, convention)); };
    of["B10c"] = [=](std::size_t convention) { return stated(drop(Method::weak2, convention)); };
    of["B10d"] = [=](std::size_t convention) {
        double rise = -1e300;
        for (Index gauss = 4; gauss <= 32; ++gauss)
            rise = std::max(rise, (*plates)(with_gauss(Method::weak1, gauss)).log_error[convention] -
                                      (*plates)(with_gauss(Method::weak1, gauss - 1)).log_error[convention]);
        return stated(rise);
    };
    of["B11a"] = [=](std::size_t convention) {
        double latest = 0;
        for (const Method method : methods) {
            const auto [scaling, log_error] = sweep(*plates, method, convention);
            const auto least = std::min_element(log_error.begin(), log_error.end()) - log_error.begin();
            latest = std::max(latest, scaling[static_cast<std::size_t>(least)]);
        }
        return stated(latest);
    };
    of["B11b"] = [=](std::size_t convention) {
        double widest = 0;
        for (const Method method : methods) {
            const auto [scaling, log_error] = sweep(*plates, method, convention);
            const auto from = std::find(scaling.begin(), scaling.end(), 3.5) - scaling.begin();
            const auto [least, most] = std::minmax_element(log_error.begin() + from, log_error.end());
            widest = std::max(widest, *most - *least);
        }
        return stated(widest);
    };
    of["B12a"] = [=](std::size_t convention) { return stated(rate(*plates, Method::strong, convention)); };
    of["B12b"] = [=](std::size_t convention) { return stated(rate(*plates, Method::weak1, convention)); };
    of["B12c"] = [=](std::size_t convention) { return stated(rate(*plates, Method::weak2, convention)); };
    of["B12d"] = [=](std::size_t convention) {
        const std::array<double, 3> rates{rate(*plates, Method::strong, convention),
                                          rate(*plates, Method::weak1, convention),
                                          rate(*plates, Method::weak2, convention)};
        return stated(*std::max_element(rates.begin(), rates.end()) -
                      *std::min_element(rates.begin(), rates.end()));
    };
    const auto lead = [=](Method one, Method other, std::size_t convention) {
        double most = -1e300;
        for (const auto& [nx, ny] : grids)
            most =
                std::max(most, (*plates)({nx, ny, one, 4, 2, 10, top_and_right}).log_error[convention] -
                                   (*plates)({nx, ny, other, 4, 2, 10, top_and_right}).log_error[convention]);
        return stated(most);
    };
    of["B13a"] = [=](std::size_t convention) { return lead(Method::weak1, Method::weak2, convention); };
    of["B13b"] = [=](std::size_t convention) { return lead(Method::weak2, Method::strong, convention); };
    of["B24a"] = [=](std::size_t convention) {
        return stated(spread_of(*plates, plate::choices_at_corner_3(), convention, true));
    };
    of["B24b"] = [=](std::size_t convention) {
        return stated(spread_of(*plates, plate::choices_at_corner_1(), convention, false) /
                      spread_of(*plates, plate::choices_at_corner_3(), convention, true));
    };
    of["B24c"] = [=](std::size_t convention) {
        const double essential = (*plates)(Plate{}).log_error[convention];
        double most = -1e300;
        for (const auto& pair : plate::choices_at_corner_3()) {
            Plate other;
            other.corner_3 = pair;
            if (other.corner_3 != Plate{}.corner_3)
                most = std::max(most, essential - (*plates)(other).log_error[convention]);
        }
        return stated(most);
    };
    of["B25a"] = either([] {  // σ_ij,j of (4.3) by differences, relative to the shear over the width
        const double step = 1e-4;
        double most = 0;
        for (const Point<2>& x : {Point<2>(0.1, 0.03), Point<2>(0.5, 0.17), Point<2>(0.93, 0.1)}) {
            Eigen::Matrix<double, 3, 2> gradient;
            for (Index axis = 0; axis < 2; ++axis)
                gradient.col(axis) = (plate::stress(x + step * Point<2>::Unit(axis)) -
                                      plate::stress(x - step * Point<2>::Unit(axis))) /
                                     (2 * step);
            most = std::max(most, elastostatics::imbalance(gradient, Vector::Zero()).norm());
        }
        return most / (plate::F0 / (plate::L2 * plate::L2));
    });
}

// Section 4.2

/// The rows of the family of layouts that belong to a method: the reference first.
struct Family {
    std::vector<double> values;
    [[nodiscard]] double median() const { return report::quartiles(values).median; }
};

constexpr const char* reference_radius = "0.3";

Family family(const report::Table& table, const std::string& method, const std::vector<std::string>& layouts,
              const std::string& column) {
    Family of;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.word(row, "method") != method) continue;
        const std::string layout = table.word(row, "layout");
        if (std::find(layouts.begin(), layouts.end(), layout) == layouts.end()) continue;
        const double value = std::get<double>(table.rows[row][table.column(column)]);
        const bool reference = layout == layouts.front() && table.word(row, "radius") == reference_radius &&
                               table.word(row, "draw") == "1";
        of.values.insert(reference ? of.values.begin() : of.values.end(), value);
    }
    if (of.values.empty())
        throw base::FailedComputation("data/batra2008/layouts.csv has no rows of " + method);
    return of;
}

/// The layouts with about 188 and with about 686 particles.
const std::array<std::vector<std::string>, 2> layouts{
    {{"graded-188-11", "polar-11x17"}, {"graded-686-21", "polar-21x33"}}};

/// A printed number on the reference layout, and that of the layout of the family that comes nearest.
Measurements on_layouts(const report::Table& table, Method method, std::size_t finer,
                        const std::string& column, double printed) {
    const auto values = family(table, example_problems::name(method), layouts[finer], column).values;
    const double nearest = *std::min_element(values.begin(), values.end(), [=](double a, double b) {
        return std::abs(a - printed) < std::abs(b - printed);
    });
    return {{"", values.front()},
            {"the layout that comes nearest of " + std::to_string(values.size()) + " is taken", nearest}};
}

/// A comparison of two columns of numbers on the reference layout, in the median, and on polar layouts.
Measurements compared(const report::Table& table, const std::array<Method, 2>& method,
                      const std::array<std::size_t, 2>& finer, const std::string& column) {
    const auto both = [&](auto pick) {
        const auto numbers = [&](std::size_t side) {
            return family(table, example_problems::name(method[side]), pick(finer[side]), column);
        };
        return std::array{numbers(0), numbers(1)};
    };
    const auto all = both([](std::size_t k) { return layouts[k]; });
    const auto polar = both([](std::size_t k) { return std::vector<std::string>{layouts[k].back()}; });
    return {{"", all[0].values.front() - all[1].values.front()},
            {"the median over our layouts is meant", all[0].median() - all[1].median()},
            {"the layout is polar (median)", polar[0].median() - polar[1].median()}};
}

struct Reference {
    hole::Shape shape;
    Problem problem = hole::problem({hole::E, hole::nu, Plane::strain}, shape);
    Cloud<2> cloud{hole::graded_layout(shape, 188, 11, 1)};
    std::map<Method, Solution> solutions;

    const Solution& operator()(Method method) {
        const auto found = solutions.find(method);
        if (found != solutions.end()) return found->second;
        return solutions
            .emplace(method,
                     example_problems::solve(problem, cloud, {method, 4, 2, hole::penalty(problem.material)}))
            .first->second;
    }
    /// Where a component deviates most, over the particles.
    Point<2> worst(Method method, Index component) {
        const Solution& solution = (*this)(method);
        Point<2> where = Point<2>::Zero();
        double most = -1;
        for (Index I = 0; I < cloud.size(); ++I) {
            const Point<2> x = cloud.x().col(I);
            const double deviation =
                std::abs((example_problems::state_at(cloud, solution, x).u - problem.exact.u(x))[component]);
            if (deviation > most) {
                most = deviation;
                where = x;
            }
        }
        return where;
    }
    /// Largest deviation of u2 or of σ11 along the x2-axis.
    double along_axis(Method method, bool stress) {
        double most = 0;
        for (int k = 0; k <= 100; ++k) {
            const Point<2> x(0, shape.b + (shape.side - shape.b) * k / 100.0);
            const auto state = example_problems::state_at(cloud, (*this)(method), x);
            most = std::max(most, std::abs(stress ? state.stress[0] - problem.exact.stress(x)[0]
                                                  : state.u[1] - problem.exact.u(x)[1]));
        }
        return most;
    }
};

void add_hole(Computations& of) {
    const auto reference = std::make_shared<Reference>();
    const auto table = [] { return report::parsed(report::read_whole("data/batra2008/layouts.csv")); };
    const auto error = [](std::size_t convention) {
        return convention == 0 ? "log_error_dn" : "log_error_nd";
    };
    const std::array<double, 6> concentrations{3.173, 3.002, 3.148, 3.084, 2.996, 3.037};
    const std::array<double, 6> errors{-1.926, -3.149, -2.293, -2.243, -3.260, -2.691};
    const std::array<double, 6> deviations{0.183, 0.405, 0.065, 0.047, 0.088, 0.075};
    for (std::size_t k = 0; k < 6; ++k) {
        const Method method = methods[k % 3];
        const char letter = static_cast<char>('a' + k);
        of[std::string("B14") + letter] = [=](std::size_t) {
            return on_layouts(table(), method, k / 3, "stress_concentration", concentrations[k]);
        };
        of[std::string("B15") + letter] = [=](std::size_t convention) {
            return on_layouts(table(), method, k / 3, error(convention), errors[k]);
        };
        of[std::string("B16") + letter] = [=](std::size_t) {
            return on_layouts(table(), methods[k / 2], 0, k % 2 == 0 ? "deviation_u1_mm" : "deviation_u2_mm",
                              deviations[k]);
        };
    }
    of["B16g"] = either([=] {
        return std::max({reference->worst(Method::strong, 0)[1], reference->worst(Method::weak2, 0)[1],
                         reference->worst(Method::strong, 1)[0], reference->worst(Method::weak2, 1)[0]});
    });
    of["B16h"] = either([=] {
        return std::max(reference->worst(Method::weak1, 0).norm(),
                        reference->worst(Method::weak1, 1).norm()) /
               reference->shape.b;
    });
    for (std::size_t finer : {0U, 1U}) {
        of[std::string("B17") + (finer ? 'c' : 'a')] = [=](std::size_t convention) {
            return compared(table(), {Method::weak1, Method::weak2}, {finer, finer}, error(convention));
        };
        of[std::string("B17") + (finer ? 'd' : 'b')] = [=](std::size_t convention) {
            return compared(table(), {Method::weak2, Method::strong}, {finer, finer}, error(convention));
        };
    }
    for (std::size_t k = 0; k < 3; ++k)
        of[std::string("B18") + static_cast<char>('a' + k)] = [=](std::size_t convention) {
            return compared(table(), {methods[k], methods[k]}, {1, 0}, error(convention));
        };
    for (const bool stress : {false, true})
        of[stress ? "B26b" : "B26a"] = either([=] {
            return reference->along_axis(Method::weak1, stress) /
                   std::min(reference->along_axis(Method::strong, stress),
                            reference->along_axis(Method::weak2, stress));
        });
    of["B27"] = either([] {
        double most = 0;
        for (const double nu : {0.0, 0.33, 0.49})
            most = std::max(
                most,
                std::abs(hole::along_x2_axis({hole::E, nu, Plane::strain}, {}, hole::Shape{}.b)[1] - 3));
        return most;
    });
}

Computations all() {
    Computations of;
    of["B19a"] = either(asymmetry);
    of["B19b"] = either(error_with_constant_kernel);
    of["B20a"] = either([] { return order_of_error<1>(0); });
    of["B20b"] = either([] { return order_of_error<1>(1); });
    of["B20c"] = either([] { return order_of_error<1>(2); });
    of["B20d"] = either([] { return order_of_error<2>(0); });
    of["B20e"] = either([] { return order_of_error<2>(1); });
    of["B20f"] = either([] { return order_of_error<2>(3); });
    of["B20g"] = either([] { return order_of_error<3>(0); });
    of["B20h"] = either([] { return order_of_error<3>(1); });
    of["B20i"] = either([] { return order_of_error<3>(4); });
    of["B21a"] = [](std::size_t) {
        return Measurements{
            {"", reciprocal_condition(ring(12, 0))},
            {"no curve of second degree runs through all particles", reciprocal_condition(ring(12, 0.5))}};
    };
    of["B21b"] = either([] { return reciprocal_condition_in_1D(3); });
    of["B21c"] = either([] { return reciprocal_condition_in_1D(2); });
    of["B22"] = either([] { return bases_for_one(16, 4); });
    of["B23a"] = [](std::size_t) {
        return Measurements{{"", traction_error(true)}, {"entry (2, 2) reads n2 K3J", traction_error(false)}};
    };
    of["B23b"] = [](std::size_t) {
        return Measurements{{"", plate_error(true)}, {"entry (2, 2) reads n2 K3J", plate_error(false)}};
    };
    add_plate(of);
    add_hole(of);
    return of;
}

}  // namespace

report::Ledger ledger() {
    return {"batra2008", all()};
}

}  // namespace batra2008::claims
