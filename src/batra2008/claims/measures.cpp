#include "batra2008/claims/measures.hpp"

#include <array>

#include "base/random.hpp"

namespace batra2008::claims {

Computation readings(const std::function<std::vector<Measurement>(Norm)>& measurements) {
    return [measurements](const report::Statement&, std::size_t convention) {
        return measurements(std::array{Norm::dn, Norm::nd}.at(convention));
    };
}

Computation readings(const std::function<std::vector<Measurement>()>& measurements) {
    return readings([measurements](Norm) { return measurements(); });
}

Computation measured(const std::function<double(Norm)>& number) {
    return readings([number](Norm norm) { return std::vector<Measurement>{{"", number(norm)}}; });
}

Computation measured(const std::function<double()>& number) {
    return measured([number](Norm) { return number(); });
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
