// Layouts around the hole, damaged as files are: rounded, shifted, scaled, with particles removed, doubled or
// moved. Each is solved as with the true flags of the boundary, or refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "batra2008/section_3_1_collocation.hpp"
#include "batra2008/section_4_2_hole.hpp"
#include "tests/support/relative.hpp"

using namespace batra2008;

namespace {

const hole::Shape shape{0.3, 3};
const Problem problem = hole::problem({hole::E, hole::nu, elastostatics::Plane::strain}, shape);
const particles::Region boundary = elastostatics::region(problem);
const example_problems::Discretisation strong{.method = example_problems::Method::strong, .scaling = 4};

/// The parts of the boundary on which a place lies, a bit for each.
unsigned parts_at(const Point<2>& x) {
    unsigned parts = 0;
    for (std::size_t k = 0; k < boundary.size(); ++k)
        if (particles::lies_on(boundary[k], x, problem.size)) parts |= 1U << k;
    return parts;
}

/// Particles, and where each of them was meant to lie.
struct Layout {
    Points<2> x, meant;
};

/// The solution by collocation where each particle has the conditions of the place where it was meant to lie.
example_problems::Solution solved_as_meant(const Layout& layout) {
    const Cloud<2> cloud(layout.x);
    const Kernel kernel(strong.scaling);
    const Column<double> h = example_problems::smoothing_lengths(cloud, strong);
    std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud.size()));
    for (Index I = 0; I < cloud.size(); ++I)
        near[static_cast<std::size_t>(I)] = cloud.within(cloud.x().col(I), kernel.rho() * h[I]);
    return {strong, problem.material, h, solved(assembled(near, [&](Index I) {
                const Point<2> x = cloud.x().col(I), meant = layout.meant.col(I);
                const auto basis =
                    ssph_basis::basis_at<2>(cloud, kernel, x, h[I], near[static_cast<std::size_t>(I)]);
                Equations equations =
                    collocation::equations_at(problem, parts_at(x) == parts_at(meant) ? x : meant, basis);
                const auto conditions = elastostatics::conditions_at(problem, meant);
                if (parts_at(x) != parts_at(meant) && !conditions.empty())
                    equations.f = {elastostatics::value(problem, conditions[0], x),
                                   elastostatics::value(problem, conditions[1], x)};
                return equations;
            }))};
}

/// What a user gets who follows the message of a refusal once.
struct Outcome {
    bool refused = false;
    double deviation = 0;  ///< largest relative one of displacements and concentration from those meant
};

Outcome outcome(Layout layout) {
    example_problems::Solution found;
    try {
        try {
            found = example_problems::solve(problem, Cloud<2>(layout.x), strong);
        } catch (const base::InvalidInput& refused) {
            const std::string why = refused.what();
            const auto remedy = why.find("try --snap ");
            if (remedy == std::string::npos) return {true};
            layout.x = particles::snapped(layout.x, boundary, std::stod(why.substr(remedy + 11))).x;
            found = example_problems::solve(problem, Cloud<2>(layout.x), strong);
        }
    } catch (const std::exception&) {
        return {true};
    }
    const example_problems::Solution meant = solved_as_meant(layout);
    const Cloud<2> cloud(layout.x);
    const double concentration = hole::stress_concentration(cloud, meant, shape);
    return {false, std::max((found.u - meant.u).norm() / meant.u.norm(),
                            std::abs(hole::stress_concentration(cloud, found, shape) / concentration - 1))};
}

/// Draws of particles and of distances that range over powers of ten.
class Draw {
  public:
    explicit Draw(unsigned long seed) : random_(seed) {}
    Index below(Index N) { return std::min(static_cast<Index>(random_.uniform(0, double(N))), N - 1); }
    double power_of_ten(double from, double to) { return std::pow(10, random_.uniform(from, to)); }
    Point<2> direction() {
        const double angle = random_.uniform(0, 2 * std::acos(-1.0));
        return {std::cos(angle), std::sin(angle)};
    }
    /// A particle that lies on the boundary, or inside.
    Index particle(const Points<2>& x, bool on_boundary) {
        Index j = below(x.cols());
        while ((parts_at(x.col(j)) != 0) != on_boundary) j = below(x.cols());
        return j;
    }

  private:
    base::Random random_;
};

/// Four graded layouts and a polar one, in turn.
Layout whole(int k) {
    static const std::vector<Points<2>> layouts = [] {
        std::vector<Points<2>> all{hole::polar_layout(shape, 11, 17)};
        for (unsigned long draw = 1; draw <= 4; ++draw)
            all.push_back(hole::graded_layout(shape, 188, 11, draw));
        return all;
    }();
    const Points<2>& x = layouts[static_cast<std::size_t>(k) % layouts.size()];
    return {x, x};
}

/// Solves layouts that one kind of damage has made of whole ones.
/// \param damage changes a layout, in the k-th way \return how many were solved; others were refused
template <class Damage>
int solved_of(int count, const Damage& damage) {
    int solutions = 0;
    for (int k = 0; k < count; ++k) {
        Layout layout = whole(k);
        damage(layout, k);
        const Outcome result = outcome(layout);
        CAPTURE(k);
        if (result.refused) continue;
        ++solutions;
        CHECK(result.deviation < 0.05);
    }
    return solutions;
}

}  // namespace

TEST_CASE("damaged layouts: rounded to 3 to 12 digits, in any direction, those of 6 and more are solved") {
    using Round = double (*)(double);
    const std::array<Round, 3> ways{std::round, std::floor, std::ceil};
    for (const int digits : {3, 4, 5, 6, 7, 9, 12}) {
        CAPTURE(digits);
        const double unit = std::pow(10, digits);
        const int count = 6,
                  solutions = solved_of(count, [&](Layout&layout, int k) {
                      const Round round = ways[static_cast<std::size_t>(k) % 3];
                      layout.x =
                          layout.x.unaryExpr([&](double number) { return round(number * unit) / unit; });
                  });
        if (digits >= 6) CHECK(solutions == count);
    }
}

TEST_CASE("damaged layouts: shifted and scaled ones are solved as meant, or refused") {
    Draw draw(1);
    CHECK(solved_of(16, [&](Layout& layout, int) {
              layout.x.colwise() += Point<2>(draw.power_of_ten(-12, -1) * draw.direction());
          }) > 8);
    CHECK(solved_of(16, [&](Layout& layout, int k) {
              layout.x *= 1 + (k % 2 == 0 ? 1 : -1) * draw.power_of_ten(-12, -1);
          }) > 8);
}

TEST_CASE("damaged layouts: without some particles they are solved as meant, without inner ones always") {
    Draw draw(2);
    for (const bool on_boundary : {false, true}) {
        const int solutions = solved_of(16, [&](Layout& layout, int k) {
            for (int gone = 0; gone <= k % 4; ++gone) {
                const Index j = draw.particle(layout.x, on_boundary), after = layout.x.cols() - 1 - j;
                layout.x.middleCols(j, after) = layout.x.rightCols(after).eval();
                layout.x.conservativeResize(2, layout.x.cols() - 1);
            }
            layout.meant = layout.x;
        });
        if (on_boundary)
            CHECK(solutions > 8);
        else
            CHECK(solutions == 16);
    }
}

TEST_CASE("damaged layouts: two particles that nearly coincide are solved as meant, or refused") {
    Draw draw(3);
    for (const bool on_boundary : {false, true})
        solved_of(16, [&](Layout& layout, int) {
            const Index j = draw.particle(layout.x, on_boundary);
            const double away = draw.power_of_ten(-12, -0.5) * Cloud<2>(layout.x).apart()[j];
            for (Points<2>* points : {&layout.x, &layout.meant}) {
                points->conservativeResize(2, points->cols() + 1);
                points->rightCols(1) = points->col(j);
            }
            layout.x.rightCols(1) += away * draw.direction();
        });
}

TEST_CASE("damaged layouts: with a particle moved off a side they are solved as meant, or refused") {
    Draw draw(4);
    CHECK(solved_of(32, [&](Layout& layout, int k) {
              const Index j = draw.particle(layout.x, true);
              const double away = draw.power_of_ten(-12, -1) * Cloud<2>(layout.x).apart()[j];
              for (const particles::Curve& curve : boundary)
                  if (particles::lies_on(curve, layout.meant.col(j), problem.size))
                      layout.x.col(j) =
                          layout.meant.col(j) +
                          (k % 2 == 0 ? away : -away) * particles::normal_at(curve, layout.meant.col(j));
          }) > 28);
}

TEST_CASE("damaged layouts: with inner particles moved they are solved") {
    Draw draw(5);
    CHECK(solved_of(24, [&](Layout& layout, int k) {
              for (int moved = 0; moved <= k % 8; ++moved) {
                  const Index j = draw.particle(layout.meant, false);
                  layout.x.col(j) +=
                      draw.power_of_ten(-12, -1) * Cloud<2>(layout.x).apart()[j] * draw.direction();
              }
              layout.meant = layout.x;
          }) == 24);
}
