#include "batra2008/basis_at.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/text.hpp"

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
    if (slopes == Slopes::known)
        evaluate(kernel, near.r, near.W, near.DW);
    else
        near.W = kernel.at(support.r_squared.head(near.r.rows()));
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

/// "particles 3 and 7 lie 0.001 apart, …", where a particle's nearest neighbour is ten times as near as its second
/// nearest; else empty.
template <int dim>
std::string close_pair(const particles::Cloud<dim>& cloud, int particle) {
    if (cloud.size() < 3) return "";
    const Point<dim> x = cloud.x().col(particle);
    const double apart = cloud.apart()[particle], second = std::sqrt(cloud.cells().nearest(x, 3).back());
    if (second < 10 * apart) return "";
    std::vector<int> pair = cloud.within(x, 2 * apart);
    return "particles " + std::to_string(pair.front()) + " and " + std::to_string(pair.back()) + " lie " +
           base::shown(apart, 3) + " apart, the next one " + base::shown(second, 3) +
           "; leave one of them out";
}

/// "--smoothing-from 6-nearest": with as many neighbours as there are monomials, if that is enough.
template <int m, int dim>
std::string nearest_remedy(const particles::Cloud<dim>& cloud, double rho, const Point<dim>& x,
                           int particle) {
    constexpr Index n = terms<dim, m>;
    if (cloud.size() <= n) return "";
    const double h = std::sqrt(cloud.cells().nearest(cloud.x().col(particle), n + 1).back());
    const bool enough =
        determined<m>(cloud, particles::TruncatedGaussian<dim>(rho), x, h, cloud.around(x, rho * h));
    return enough ? "--smoothing-from " + std::to_string(n) + "-nearest" : "";
}

/// "try --scaling 2.5": the smallest of the larger scaling factors that is enough, in steps of a tenth.
template <int m, int dim>
std::string remedy(const particles::Cloud<dim>& cloud, double rho, const Point<dim>& x, double h) {
    constexpr Index n = terms<dim, m>;
    if (cloud.size() < n) return "take at least " + std::to_string(n) + " particles";
    const int particle = cloud.nearest(x);
    const std::string from_nearest = nearest_remedy<m>(cloud, rho, x, particle);
    if (const std::string pair = close_pair(cloud, particle); !pair.empty())
        return pair + (from_nearest.empty() ? "" : ", or try " + from_nearest);
    Column<double> distance = (cloud.x().colwise() - x).colwise().norm().transpose();
    std::nth_element(distance.begin(), distance.begin() + (n - 1), distance.end());
    const double reaching_n = std::floor(10 * distance[n - 1] / h * (1 + 1e-6) + 1);
    const double first = std::max(reaching_n, std::ceil(10 * rho + 5));
    for (int more = 0; more < 50; ++more) {
        const double scaling = (first + more) / 10;
        const particles::TruncatedGaussian<dim> larger(scaling);
        if (determined<m>(cloud, larger, x, h, cloud.around(x, scaling * h)))
            return "try --scaling " + base::shown(scaling) +
                   (from_nearest.empty() ? "" : " or " + from_nearest);
    }
    return from_nearest.empty() ? "take other particles" : "try " + from_nearest;
}

/// "ssph_basis: at (0.1, 0.2) there are 5 particles within 2h = 0.1 for the 6 monomials of degree 2; try
/// --scaling 2.5"
/// \param found number of particles in the support
/// \param why what is wrong with them, if there are enough
template <int m, int dim>
[[noreturn]] void refuse(const particles::Cloud<dim>& cloud, double rho, const Point<dim>& x, double h,
                         std::size_t found, const std::string& why) {
    throw base::FailedComputation("ssph_basis: at " + particles::shown_point(x) + " there are " +
                                  std::to_string(found) + " particles within " + base::shown(rho) +
                                  "h = " + base::shown(rho * h, 3) + " for the " +
                                  std::to_string(terms<dim, m>) + " monomials of degree " +
                                  std::to_string(m) + why + "; " + remedy<m>(cloud, rho, x, h));
}

}  // namespace

template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, const std::vector<int>& among, Slopes slopes) {
    particles::Support<dim> support = support_at(cloud, kernel, x, h, among);
    const std::size_t found = support.particle.size();
    if (found < static_cast<std::size_t>(terms<dim, m>)) refuse<m>(cloud, kernel.rho(), x, h, found, "");
    try {
        return basis_on<m>(std::move(support), kernel, h, slopes);
    } catch (const particles::SingularNeighbourhood& singular) {
        refuse<m>(cloud, kernel.rho(), x, h, found,
                  std::string(", which they do not determine: ") + singular.what());
    }
}

template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h, Slopes slopes) {
    return basis_at<m>(cloud, kernel, x, h, cloud.around(x, kernel.rho() * h), slopes);
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
                                    const Point<dim>&, double, const std::vector<int>&, Slopes);            \
    template Basis<dim, m> basis_at(const particles::Cloud<dim>&, const particles::TruncatedGaussian<dim>&, \
                                    const Point<dim>&, double, Slopes);                                     \
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
