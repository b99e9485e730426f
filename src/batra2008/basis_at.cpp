#include "batra2008/basis_at.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/text.hpp"

namespace batra2008::ssph_basis {

namespace {

/// Whether these particles of a cloud determine the monomials.
template <int m, int dim>
bool determined(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                const Point<dim>& x, double h, const std::vector<int>& among) {
    try {
        const Basis<dim, m> basis(particles::surroundings(cloud, kernel, x, h, among), h);
        return true;
    } catch (const particles::SingularNeighbourhood&) {
        return false;
    }
}

/// "try --scaling 2.5": the smallest of the larger scaling factors that is enough, in steps of a tenth.
template <int m, int dim>
std::string remedy(const particles::Cloud<dim>& cloud, double rho, const Point<dim>& x, double h) {
    constexpr Index n = terms<dim, m>;
    if (cloud.size() < n) return "take at least " + std::to_string(n) + " particles";
    Column<double> distance = (cloud.x().colwise() - x).colwise().norm().transpose();
    std::nth_element(distance.begin(), distance.begin() + (n - 1), distance.end());
    const double reaching_n = std::floor(10 * distance[n - 1] / h * (1 + 1e-6) + 1);
    const double first = std::max(reaching_n, std::ceil(10 * rho + 5));
    for (int more = 0; more < 50; ++more) {
        const double scaling = (first + more) / 10;
        const particles::TruncatedGaussian<dim> larger(scaling);
        if (determined<m>(cloud, larger, x, h, cloud.around(x, scaling * h)))
            return "try --scaling " + base::shown(scaling);
    }
    return "take other particles";
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
                       const Point<dim>& x, double h, const std::vector<int>& among) {
    Surroundings<dim> near = particles::surroundings(cloud, kernel, x, h, among);
    const std::size_t found = near.particle.size();
    if (found < static_cast<std::size_t>(terms<dim, m>)) refuse<m>(cloud, kernel.rho(), x, h, found, "");
    try {
        return Basis<dim, m>(std::move(near), h);
    } catch (const particles::SingularNeighbourhood& singular) {
        refuse<m>(cloud, kernel.rho(), x, h, found,
                  std::string(", which they do not determine: ") + singular.what());
    }
}

template <int m, int dim>
Basis<dim, m> basis_at(const particles::Cloud<dim>& cloud, const particles::TruncatedGaussian<dim>& kernel,
                       const Point<dim>& x, double h) {
    return basis_at<m>(cloud, kernel, x, h, cloud.around(x, kernel.rho() * h));
}

template <int m, int dim>
std::vector<int> nearest_that_determine(const particles::Cloud<dim>& cloud,
                                        const particles::TruncatedGaussian<dim>& kernel, Index particle,
                                        Index enough) {
    const Point<dim> x = cloud.x().col(particle);
    const double h = cloud.h()[particle];
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
                                    const Point<dim>&, double, const std::vector<int>&);                    \
    template Basis<dim, m> basis_at(const particles::Cloud<dim>&, const particles::TruncatedGaussian<dim>&, \
                                    const Point<dim>&, double);                                             \
    template std::vector<int> nearest_that_determine<m>(                                                    \
        const particles::Cloud<dim>&, const particles::TruncatedGaussian<dim>&, Index, Index);
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
