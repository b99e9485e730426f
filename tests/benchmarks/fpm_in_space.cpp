#include "fpm_in_space/section_1_second_order_fpm.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "batra2008/section_2_ssph_basis.hpp"
#include "fpm_in_space/section_4_derivative_test.hpp"
#include "tests/benchmarks/counted.hpp"
#include "tests/benchmarks/report.hpp"

namespace benchmarks {

namespace {

using namespace fpm_in_space;
template <int dim>
using All = std::vector<Neighbourhood<double, dim>>;

/// What some particles of a perturbed grid see of the others; those in space, about 1000.
template <int dim>
std::shared_ptr<const All<dim>> neighbourhoods() {
    const Index n = dim == 2 ? 31 : 13;
    const auto grid = derivative_test::body<dim>(n, 0.25, 1);
    const particles::Smoothing<double, dim> smoothing(particles::TruncatedGaussian<dim>(dim == 2 ? 3.5 : 3),
                                                      1.2 / static_cast<double>(n - 1));
    auto all = std::make_shared<All<dim>>();
    for (Index i = 0; i < std::min<Index>(grid.cloud.size(), 1000); ++i)
        all->push_back(particles::neighbourhood(grid.cloud, smoothing, i));
    return all;
}

/// Operations per particle of a formulation.
template <int dim, class Weights>
double operations(const All<dim>& all, const Weights& weights) {
    Counted::operations = 0;
    for (const auto& near : all)
        static_cast<void>(weights(
            Neighbourhood<Counted, dim>{near.r.template cast<Counted>(), near.W.template cast<Counted>(),
                                        near.DW.template cast<Counted>(), near.V.template cast<Counted>()}));
    return static_cast<double>(Counted::operations) / static_cast<double>(all.size());
}

/// \param weights of a neighbourhood of any scalar
template <int dim, class Weights>
void add_weights(const std::string& method, const Weights& weights) {
    const auto all = neighbourhoods<dim>();
    Task task{dim == 2 ? "weights in the plane" : "weights in space", method, static_cast<long>(all->size()),
              1};
    task.operations = operations<dim>(*all, weights);
    add(task, [=] {
        return [=] {
            for (const auto& near : *all) benchmark::DoNotOptimize(weights(near).second.data());
        };
    });
}

template <int dim>
void add_dimension() {
    add_weights<dim>("definite_fpm", [](const auto& near) { return second_order_fpm::derivatives(near); });
    add_weights<dim>("ssph", [](const auto& near) { return batra2008::ssph_basis::derivatives<2>(near); });
    add_weights<dim>("cubic_ssph",
                     [](const auto& near) { return batra2008::ssph_basis::derivatives<3>(near); });
}

}  // namespace

void add_fpm_in_space() {
    add_dimension<2>();
    add_dimension<3>();
}

}  // namespace benchmarks
