#include "particles/neighbourhood.hpp"

#include <optional>

namespace particles {

namespace {

/// How many of the particles that follow one another are reached, in each lane; nothing where that is not
/// known after the most steps. Steps are taken by four, since those beyond the reach add nothing.
/// \param reached whether the k-th particle is, k = 1, 2, …
template <class Reached>
std::optional<Pack::Mask> counted(Index most_steps, const Reached& reached) {
    Pack::Mask count{};
    for (Index k = 1; k <= most_steps; ++k) {
        const Pack::Mask holds = reached(k);
        count -= holds;  // where it holds, a lane is -1
        if (k % 4 == 0 && base::everywhere(holds == 0)) return count;
    }
    return {};
}

}  // namespace

bool within_reach_of_pack(const Line<double>& line, const Smoothing<double>& smoothing, Index i,
                          Range* near) {
    const Index behind = line.size() - i - Pack::lanes;
    if (behind < 0) return false;
    const double* const x = line.x().data() + i;
    const Pack x_i = Pack::from(x), reach = smoothing.pack_of_reaches(i), least = x_i - reach,
               most = x_i + reach;
    const auto left = counted(i, [&](Index k) { return Pack::from(x - k) > least; });
    const auto right = counted(behind, [&](Index k) { return Pack::from(x + k) < most; });
    if (!left || !right) return false;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        near[lane] = {i + lane - static_cast<Index>((*left)[lane]),
                      i + lane + 1 + static_cast<Index>((*right)[lane])};
    return true;
}

Neighbourhood<Pack> neighbourhoods(const Line<double>& line, const Smoothing<double>& smoothing, Index i,
                                   Index left, Index right) {
    const Index size = left + 1 + right;
    const double *const x = line.x().data() + i, *const V = line.V().data() + i;
    const Pack per_h = 1 / smoothing.pack_of_h(i), reach = smoothing.pack_of_reaches(i);
    const Pack x_i = Pack::from(x), least = x_i - reach, most = x_i + reach;
    Neighbourhood<Pack> all{Column<Pack>(size), Column<Pack>(size), Column<Pack>(size), Column<Pack>(size)};
    std::visit(
        [&](const auto& kernel) {
            for (Index k = 0; k < size; ++k) {
                const Pack x_j = Pack::from(x + k - left), V_j = Pack::from(V + k - left);
                const Pack r = (x_j - x_i) * per_h, W = kernel.W(r);
                const auto reached = (x_j > least) & (x_j < most);
                all.r[k] = r;
                all.W[k] = chosen(reached, W, Pack(0));
                all.DW[k] = chosen(reached, detail::derivative(kernel, r, W), Pack(0));
                all.V[k] = chosen(reached, V_j * per_h, Pack(0));
            }
        },
        smoothing.kernel());
    return all;
}

template Neighbourhood<double> neighbourhood(const Line<double>&, const Smoothing<double>&, Index,
                                             const Range&);
template Neighbourhood<double, 1> neighbourhood(const Cloud<1>&, const Kernel<1>&, const Point<1>&, double,
                                                const std::vector<int>&);
template Neighbourhood<double, 2> neighbourhood(const Cloud<2>&, const Kernel<2>&, const Point<2>&, double,
                                                const std::vector<int>&);
template Neighbourhood<double, 3> neighbourhood(const Cloud<3>&, const Kernel<3>&, const Point<3>&, double,
                                                const std::vector<int>&);

}  // namespace particles
