#include "batra2008/basis_at.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "particles/close_pair.hpp"
#include "particles/layers.hpp"
#include "particles/spacing.hpp"

namespace batra2008::ssph_basis {

namespace {

/// The particles in the kernel's support around a place.
template <int dim>
particles::Support<dim> support_at(const particles::Cloud<dim>& cloud,
                                   const particles::TruncatedGaussian<dim>& kernel, const Point<dim>& x,
                                   double h, const std::vector<int>& among) {
    return particles::support_at(cloud, particles::reach<double>(kernel), x, h, among);
}

/// The basis from the particles of a support; no volumes weigh it.
template <int m, int dim>
Basis<dim, m> basis_on(particles::Support<dim> support, const particles::TruncatedGaussian<dim>& kernel,
                       double h, Slopes slopes) {
    Neighbourhood<double, dim> near{std::move(support.r), {}, {}, {}};
    near.W = kernel.at(particles::squared_lengths(near.r));
    if (slopes == Slopes::known)  // inside the support, ∂W/∂s = −2 s (W + edge)
        near.DW = near.r.colwise() * (-2 * (near.W + kernel.edge()));
    return Basis<dim, m>(std::move(near), std::move(support.particle), h);
}

/// Whether these particles of a cloud determine the monomials.
template <int m, int dim>
bool determined(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                const Point<dim>& x, double h, const std::vector<int>& among) {
    try {
        basis_on<m>(support_at(cloud, kernel, x, h, among), kernel, h, Slopes::none);
        return true;
    } catch (const particles::SingularNeighbourhood&) {
        return false;
    }
}

/// R of the derivatives of order k at a place; infinite where the particles do not determine them.
template <int m, int dim>
double quality_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                  const Point<dim>& x, double h, int k) {
    if (k < 0) return 0;  // no derivative is wanted
    const std::vector<int> around = cloud.around(x, kernel.rho() * h);
    particles::Support<dim> support = support_at(cloud, kernel, x, h, around);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (support.particle.size() < static_cast<std::size_t>(terms<dim, m>)) return infinite;
    try {
        return quality(basis_on<m>(std::move(support), kernel, 1, Slopes::none), k);
    } catch (const particles::SingularNeighbourhood&) {
        return infinite;
    }
}

/// The monomials as a remedy sees them. Their degree is not part of the type, so that remedies are compiled
/// once for each dimension.
template <int dim>
struct Monomials {
    int degree;
    Index number;
    /// R of the derivatives of order k at a place of a cloud: a function of the cloud, ρ, h, the place and k.
    std::function<double(const particles::Cloud<dim>&, double, double, const Point<dim>&, int)> quality;
};

template <int m, int dim>
Monomials<dim> monomials_of_degree() {
    return {m, terms<dim, m>,
            [](const particles::Cloud<dim>& cloud, double rho, double h, const Point<dim>& x, int k) {
                return quality_at<m>(cloud, particles::TruncatedGaussian<dim>(rho), x, h, k);
            }};
}

/// What a remedy must serve: a place, and with it all particles or none.
template <int dim>
struct Needs {
    Point<dim> x;
    double h = 0;                                           ///< at the place [length]
    int k = 0;                                              ///< order of the derivative there
    Column<double> lengths{};                               ///< smoothing length of each particle
    std::vector<int> derivative{};                          ///< order of the derivative of each particle
    double most = std::numeric_limits<double>::infinity();  ///< R must be less

    /// Order of the derivative of a particle; zero where none is said.
    [[nodiscard]] int k_of(Index j) const {
        return derivative.empty() ? 0 : derivative[static_cast<std::size_t>(j)];
    }
};

/// The particles whose neighbours are the farthest, at most a thousand.
std::vector<Index> loneliest(const Column<double>& distance) {
    std::vector<Index> all(static_cast<std::size_t>(distance.size()));
    std::iota(all.begin(), all.end(), 0);
    std::sort(all.begin(), all.end(), [&](Index j, Index k) { return distance[j] > distance[k]; });
    all.resize(std::min<std::size_t>(all.size(), 1000));
    return all;
}

/// Whether a choice of ρ and h serves a particle and, within h of it, the places on the way to the nearest
/// others: there the weak forms and the user ask for the field.
/// \param h smoothing length of each particle; a single one serves all
template <int dim>
bool serves(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials, double rho,
            const Column<double>& h, const Needs<dim>& needs, Index j) {
    const auto h_of = [&](Index i) { return h[h.size() == 1 ? 0 : i]; };
    const Point<dim> x = cloud.x().col(j);
    if (needs.k_of(j) < 0) return true;
    if (!(monomials.quality(cloud, rho, h_of(j), x, needs.k_of(j)) < needs.most)) return false;
    const Index neighbours = std::min<Index>(4 * dim, cloud.size() - 1);
    const double near = 1.01 * particles::distance_to_nearest(cloud, j, neighbours);
    const std::vector<int> around = cloud.within(x, near);
    return std::all_of(around.begin(), around.end(), [&](int i) {
        const Point<dim> to = cloud.x().col(i) - x;
        const double within_h = h_of(j) / std::max(to.norm(), h_of(j));
        return std::ranges::all_of(std::array{0.25, 0.5, 0.75, 1.0}, [&](double part) {
            return monomials.quality(cloud, rho, h_of(j), x + part * within_h * to, 0) < needs.most;
        });
    });
}

/// "--smoothing-from 0.053": one length for the whole cloud, with which each particle has as many neighbours
/// as there are monomials. Empty if the cloud is graded, so that this is far too large for some, or if it is
/// not enough.
template <int dim>
std::string smoothing_remedy(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials, double rho,
                             const Needs<dim>& needs) {
    constexpr double graded = 4;  // the sides of stretched cells differ as much
    if (cloud.size() <= monomials.number) return "";
    const Column<double> to_nth = particles::spacing(cloud, particles::Spacing::to_nearest(monomials.number));
    const double least = to_nth.maxCoeff();
    if (least > graded * to_nth.minCoeff()) return "";
    const std::vector<Index> hardest = loneliest(to_nth);
    const auto enough = [&](double h) {
        return monomials.quality(cloud, rho, h, needs.x, needs.k) < needs.most &&
               std::all_of(hardest.begin(), hardest.end(), [&](Index j) {
                   return serves(cloud, monomials, rho, Column<double>::Constant(1, h), needs, j);
               });
    };
    for (double h = least; h < 2 * least; h *= 1.1) {
        const std::string shown = base::shown(1.005 * h, 3);  // rounded, but not down
        if (enough(std::stod(shown))) return "--smoothing-from " + shown;
    }
    return "";
}

/// "--smoothing-from 3-nearest": the smallest number of nearest particles whose distance is long enough.
/// Empty if none is found.
template <int dim>
std::string nearest_remedy(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials, double rho,
                           const Needs<dim>& needs) {
    const Column<double> to_nth =
        particles::spacing(cloud, particles::Spacing::to_nearest(monomials.number - 1));
    for (Index K = 2; K < monomials.number; ++K) {
        const Column<double> h = particles::spacing(cloud, particles::Spacing::to_nearest(K));
        const std::vector<Index> hardest = loneliest(to_nth / h);
        if (monomials.quality(cloud, rho, h[cloud.nearest(needs.x)], needs.x, needs.k) < needs.most &&
            std::all_of(hardest.begin(), hardest.end(),
                        [&](Index j) { return serves(cloud, monomials, rho, h, needs, j); }))
            return "--smoothing-from " + std::to_string(K) + "-nearest";
    }
    return "";
}

/// "--scaling 2.5": the smallest of the larger scaling factors that is enough, in steps of a tenth; or empty.
template <int dim>
std::string scaling_remedy(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials, double rho,
                           const Needs<dim>& needs) {
    const Index n = monomials.number;
    Column<double> distance = (cloud.x().colwise() - needs.x).colwise().norm().transpose();
    std::nth_element(distance.begin(), distance.begin() + (n - 1), distance.end());
    double needed = distance[n - 1] / needs.h;
    std::vector<Index> hardest;
    if (needs.lengths.size() > 0) {
        const Column<double> of_each =
            particles::spacing(cloud, particles::Spacing::to_nearest(n - 1)) / needs.lengths;
        needed = std::max(needed, of_each.maxCoeff());
        hardest = loneliest(of_each);
    }
    const double reaching_n = std::floor(10 * needed * (1 + 1e-6) + 1);
    const double first = std::max(reaching_n, std::ceil(10 * rho + 5));
    const auto enough = [&](double scaling) {
        return monomials.quality(cloud, scaling, needs.h, needs.x, needs.k) < needs.most &&
               std::all_of(hardest.begin(), hardest.end(), [&](Index j) {
                   return serves(cloud, monomials, scaling, needs.lengths, needs, j);
               });
    };
    for (int more = 0; more < 50; ++more) {
        const double scaling = (first + more) / 10;
        if (enough(scaling)) return "--scaling " + base::shown(scaling);
    }
    return "";
}

/// "particles 3 and 7 lie 0.001 apart, the next one 0.1; leave one of them out", where that helps.
template <int dim>
std::string fewer_particles(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials, double rho,
                            const Needs<dim>& needs) {
    const Index i = cloud.nearest(needs.x);
    const auto pair = particles::close_pair(cloud, i);
    if (!pair || cloud.size() <= monomials.number) return "";
    const Index k = pair->first == i ? pair->second : pair->first;
    const particles::Cloud<dim> rest = particles::without(cloud, k);
    Needs<dim> left = needs;
    const Column<double> lengths =
        needs.lengths.size() > 0 ? needs.lengths : Column<double>::Constant(cloud.size(), needs.h);
    left.lengths = particles::spacing_without(lengths, cloud, rest, k);
    left.h = left.lengths[i < k ? i : i - 1];
    if (!needs.derivative.empty()) left.derivative.erase(left.derivative.begin() + k);
    std::vector<Index> hardest;
    if (needs.lengths.size() > 0)
        hardest = loneliest(particles::spacing(rest, particles::Spacing::to_nearest(monomials.number - 1)) /
                            left.lengths);
    const bool helps = monomials.quality(rest, rho, left.h, left.x, left.k) < left.most &&
                       std::all_of(hardest.begin(), hardest.end(), [&](Index j) {
                           return serves(rest, monomials, rho, left.lengths, left, j);
                       });
    return helps ? pair->advice() : "";
}

template <int dim>
std::string remedy(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials, double rho,
                   const Needs<dim>& needs) {
    const Point<dim>& x = needs.x;
    if (std::string more = particles::more_particles(cloud, monomials.number, monomials.degree);
        !more.empty())
        return more;
    const std::string larger_h = smoothing_remedy(cloud, monomials, rho, needs);
    if (const std::string fewer = fewer_particles(cloud, monomials, rho, needs); !fewer.empty())
        return fewer + (larger_h.empty() ? "" : ", or try " + larger_h);
    const std::string larger_rho = scaling_remedy(cloud, monomials, rho, needs);
    const std::string both = larger_rho + (larger_rho.empty() || larger_h.empty() ? "" : " or ") + larger_h;
    if (!both.empty()) return "try " + both;
    if (const std::string nearest = nearest_remedy(cloud, monomials, rho, needs); !nearest.empty())
        return "try " + nearest;
    const bool far = ((x - cloud.x().rowwise().maxCoeff()).array() > cloud.spacing()).any() ||
                     ((cloud.x().rowwise().minCoeff() - x).array() > cloud.spacing()).any();
    return far ? "take a place nearer to the particles" : "take other particles";
}

/// "ssph_basis: at (0.1, 0.2) there are 5 particles within 2h = 0.1 for the 6 monomials of degree 2; try
/// --scaling 2.5"
/// \param found number of particles in the support
/// \param why what is wrong with them, if there are enough
template <int dim>
base::FailedComputation refusal(const particles::Cloud<dim>& cloud, const Monomials<dim>& monomials,
                                double rho, const Needs<dim>& needs, std::size_t found,
                                const std::string& why) {
    const auto [x, h] = std::pair(needs.x, needs.h);
    return base::FailedComputation(
        "ssph_basis: at " + particles::shown_point(x) +
        (found == 1 ? " there is 1 particle within "
                    : " there are " + std::to_string(found) + " particles within ") +
        base::shown(rho) + "h = " + base::shown(rho * h, 3) + " for the " + std::to_string(monomials.number) +
        " monomials of degree " + std::to_string(monomials.degree) + why + "; " +
        remedy(cloud, monomials, rho, needs));
}

/// Refuses a place whose particles do not determine the monomials.
/// \param needs what the remedy must serve, formed where there is a refusal
template <int m, int dim, class NeedsOf>
Basis<dim, m> basis_or_refusal(const particles::Cloud<dim>& cloud,
                               const particles::TruncatedGaussian<dim>& kernel, const Point<dim>& x, double h,
                               const std::vector<int>& among, Slopes slopes, const NeedsOf& needs) {
    particles::Support<dim> support = support_at(cloud, kernel, x, h, among);
    const std::size_t found = support.particle.size();
    const auto refused = [&](const std::string& why) {
        return refusal(cloud, monomials_of_degree<m, dim>(), kernel.rho(), needs(), found, why);
    };
    if (found < static_cast<std::size_t>(terms<dim, m>)) throw refused("");
    try {
        return basis_on<m>(std::move(support), kernel, h, slopes);
    } catch (const particles::SingularNeighbourhood& singular) {
        throw refused(std::string(", which they do not determine: ") + singular.what());
    }
}

/// ", and a second derivative from them may err by R h |D3f| with R = 2.3e+04, where 1000 is the most".
std::string may_err(int k, int degree, double R) {
    const int p = degree + 1 - k;
    return std::string(", and a ") + (k == 1 ? "first" : "second") + " derivative from them may err by R h" +
           (p == 1 ? "" : "^" + std::to_string(p)) + " |D" + std::to_string(degree + 1) +
           "f| with R = " + base::shown(R, 3) + ", where " + base::shown(most) +
           " is the most for a solution";
}

}  // namespace

template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, const std::vector<int>& among, Slopes slopes,
                       const Column<double>& lengths) {
    return basis_or_refusal<m>(cloud, kernel, x, h, among, slopes, [&] {
        return Needs<dim>{x, h, 0, lengths};
    });
}

template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, Slopes slopes, const Column<double>& lengths) {
    return basis_at<m>(cloud, kernel, x, h, cloud.around(x, kernel.rho() * h), slopes, lengths);
}

template <int m, int dim>
particles::WorstRow require_quality(const particles::Cloud<dim>& cloud,
                                    const particles::TruncatedGaussian<dim>& kernel, const Column<double>& h,
                                    const std::vector<int>& derivative) {
    const auto k = [&](Index j) { return derivative[static_cast<std::size_t>(j)]; };
    Column<double> R(cloud.size());
    base::for_each_index(cloud.size(), [&](Index j) {
        R[j] = quality_at<m, dim>(cloud, kernel, cloud.x().col(j), h[j], k(j));
    });
    const Index refused =
        std::find_if(R.begin(), R.end(), [](double of) { return !(of <= most); }) - R.begin();
    if (refused < R.size()) {
        const Needs<dim> needs{cloud.x().col(refused), h[refused], k(refused), h, derivative, most / 10};
        const auto around = cloud.around(needs.x, kernel.rho() * needs.h);
        const auto basis = basis_or_refusal<m>(cloud, kernel, needs.x, needs.h, around, Slopes::none,
                                               [&]() -> const Needs<dim>& { return needs; });
        throw refusal(cloud, monomials_of_degree<m, dim>(), kernel.rho(), needs, basis.particle().size(),
                      may_err(needs.k, m, R[refused]));
    }
    particles::WorstRow worst;
    worst.R = R.maxCoeff(&worst.particle);
    worst.derivative = k(worst.particle);
    return worst;
}

template <int m, int dim>
std::vector<int> nearest_that_determine(const particles::Cloud<dim>& cloud,
                                        const particles::TruncatedGaussian<dim>& kernel, Index particle,
                                        double h, Index enough) {
    const Point<dim> x = cloud.x().col(particle);
    for (double rho = 1.5; rho < kernel.rho(); rho *= 1.1) {
        std::vector<int> among = cloud.within(x, rho * h);
        if (static_cast<Index>(among.size()) >= enough && determined<m>(cloud, kernel, x, h, among))
            return among;
    }
    return cloud.within(x, kernel.rho() * h);
}

// The functions of this file for a dimension and a degree.
#define BATRA2008_BASIS_AT(dim, m)                                                                          \
    template Basis<dim, m> basis_at(const particles::Cloud<dim>&, const particles::TruncatedGaussian<dim>&, \
                                    const Point<dim>&, double, const std::vector<int>&, Slopes,             \
                                    const Column<double>&);                                                 \
    template Basis<dim, m> basis_at(const particles::Cloud<dim>&, const particles::TruncatedGaussian<dim>&, \
                                    const Point<dim>&, double, Slopes, const Column<double>&);              \
    template particles::WorstRow require_quality<m>(const particles::Cloud<dim>&,                           \
                                                    const particles::TruncatedGaussian<dim>&,               \
                                                    const Column<double>&, const std::vector<int>&);        \
    template std::vector<int> nearest_that_determine<m>(                                                    \
        const particles::Cloud<dim>&, const particles::TruncatedGaussian<dim>&, Index, double, Index);
BATRA2008_BASIS_AT(1, 1)
BATRA2008_BASIS_AT(1, 2)
BATRA2008_BASIS_AT(1, 3)
BATRA2008_BASIS_AT(2, 1)
BATRA2008_BASIS_AT(2, 2)
BATRA2008_BASIS_AT(2, 3)
BATRA2008_BASIS_AT(3, 1)
BATRA2008_BASIS_AT(3, 2)
BATRA2008_BASIS_AT(3, 3)
#undef BATRA2008_BASIS_AT

}  // namespace batra2008::ssph_basis
