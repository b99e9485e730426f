#include "batra2008/claims/measures.hpp"

#include <array>

#include "base/random.hpp"

namespace batra2008::claims {

Computation measured(const std::function<double(Norm)>& number) {
    return [number](const report::Statement&, std::size_t convention) {
        return std::vector<Measurement>{{"", number(std::array{Norm::dn, Norm::nd}.at(convention))}};
    };
}

Computation measured(const std::function<double()>& number) {
    return measured([number](Norm) { return number(); });
}

Computation readings(const std::function<std::vector<Measurement>()>& measurements) {
    return [measurements](const report::Statement&, std::size_t) { return measurements(); };
}

template <int dim>
particles::Cloud<dim> random_cloud(Index count, unsigned long seed) {
    base::Random random(seed);
    Points<dim> x(dim, count);
    for (Index j = 0; j < count; ++j)
        for (Index axis = 0; axis < dim; ++axis) x(axis, j) = random.uniform(-1, 1);
    return particles::Cloud<dim>(x);
}

template particles::Cloud<1> random_cloud(Index, unsigned long);
template particles::Cloud<2> random_cloud(Index, unsigned long);
template particles::Cloud<3> random_cloud(Index, unsigned long);

}  // namespace batra2008::claims
