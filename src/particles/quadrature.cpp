#include "particles/quadrature.hpp"

#include <gsl/gsl_integration.h>

#include <memory>
#include <new>
#include <string>

#include "base/errors.hpp"

namespace particles {

GaussRule gauss_rule(Index n, double a, double b) {
    if (n < 1) throw InvalidInput("a quadrature rule needs at least 1 point, got " + std::to_string(n));
    const auto points = static_cast<std::size_t>(n);
    const std::unique_ptr<gsl_integration_glfixed_table, void (*)(gsl_integration_glfixed_table*)> table(
        gsl_integration_glfixed_table_alloc(points), gsl_integration_glfixed_table_free);
    if (!table) throw std::bad_alloc();
    GaussRule rule{Column<double>(n), Column<double>(n)};
    for (Index k = 0; k < n; ++k)
        gsl_integration_glfixed_point(a, b, static_cast<std::size_t>(k), &rule.x[k], &rule.w[k], table.get());
    return rule;
}

}  // namespace particles
