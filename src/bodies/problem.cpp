#include "bodies/problem.hpp"

#include <cmath>

namespace bodies {

using batra2008::elastostatics::Plane;

template <int dim>
Equation<dim, dim> elasticity(const batra2008::elastostatics::Material& material) {
    auto [E, nu, plane] = material;
    if (dim == 3) plane = Plane::strain;
    const auto known = batra2008::elastostatics::checked({E, nu, plane});
    const double E0 = batra2008::elastostatics::E0(known), nu0 = batra2008::elastostatics::nu0(known);
    const double mu = E / (2 * (1 + nu));
    const double lambda = E0 * nu0 / (1 - nu0 * nu0);
    using Coefficients = typename Equation<dim, dim>::Coefficients;
    Coefficients A = Coefficients::Zero();
    for (int i = 0; i < dim; ++i)
        for (int a = 0; a < dim; ++a) {
            A(dim * i + i, dim * a + a) += lambda;
            A(dim * i + a, dim * i + a) += mu;
            A(dim * i + a, dim * a + i) += mu;
        }
    return {[A](const Point<dim>&) { return A; }};
}

template Equation<2, 2> elasticity(const batra2008::elastostatics::Material&);
template Equation<3, 3> elasticity(const batra2008::elastostatics::Material&);

template <int dim>
Equation<dim, 1> diffusion(const Field<dim>& k, const Field<dim, Point<dim>>& grad_k) {
    using Coefficients = typename Equation<dim, 1>::Coefficients;
    using Divergence = typename Equation<dim, 1>::Divergence;
    Equation<dim, 1> equation{
        [k](const Point<dim>& x) { return Coefficients(k(x) * Coefficients::Identity()); }};
    if (grad_k) equation.div_A = [grad_k](const Point<dim>& x) { return Divergence(grad_k(x).transpose()); };
    return equation;
}

template Equation<2, 1> diffusion(const Field<2>&, const Field<2, Point<2>>&);
template Equation<3, 1> diffusion(const Field<3>&, const Field<3, Point<3>>&);

}  // namespace bodies
