#include "python/particles.hpp"

#include "base/errors.hpp"
#include "base/text.hpp"
#include "fpm_in_space/section_1_second_order_fpm.hpp"

namespace python {

using base::InvalidInput;
using particles::Cloud;
using particles::Smoothing;

namespace {

double checked(double smoothing) {
    if (!(std::isfinite(smoothing) && smoothing > 0))
        throw InvalidInput(
            "smoothing, the smoothing length over the spacing, must be positive and finite, got " +
            base::shown(smoothing));
    return smoothing;
}

}  // namespace

OnLine::OnLine(const py::args& how)
    : kernel(text(how[0], "kernel")),
      smoothing(number(how[1], "smoothing")),
      smoothing_from(spacing(how[2])),
      volumes(text(how[3], "volumes")) {}

InSpace::InSpace(const py::args& how)
    : scheme(text(how[0], "scheme")),
      smoothing(number(how[3], "smoothing")),
      smoothing_from(spacing(how[4])) {
    if (const py::object m = how[1]; !m.is_none()) degree = integer(m, "degree");
    if (const py::object name = how[2]; !name.is_none()) kernel = text(name, "kernel");
}

asprone2010::numerical_tests::Particles<double> OnLine::at(const Column<double>& x) const {
    asprone2010::numerical_tests::Discretisation how;
    how.volumes = particles::volumes_named(volumes);
    how.kernel = particles::kernel_named(kernel);
    how.smoothing = checked(smoothing);
    how.smoothing_from = smoothing_from;
    return asprone2010::numerical_tests::discretise<double>(how, x);
}

template <int dim>
const fpm_in_space::Formulation<double, dim>& InSpace::formulation() const {
    const bool ssph =
        base::choose<bool>("scheme", scheme, {{"fpm", false}, {"second_order_fpm", false}, {"ssph", true}});
    if (!ssph && degree)
        throw InvalidInput("degree belongs to the scheme ssph; fpm takes the monomials up to degree 3");
    if (degree && *degree != 2 && *degree != 3)
        throw InvalidInput("degree must be 2 or 3, got " + std::to_string(*degree));
    return fpm_in_space::formulation_named<double, dim>(!ssph                     ? "definite_fpm"
                                                        : degree.value_or(2) == 2 ? "ssph"
                                                                                  : "cubic_ssph");
}

template <int dim>
Smoothing<double, dim> InSpace::on(const Cloud<dim>& cloud) const {
    particles::Kernel<dim> chosen = particles::TruncatedGaussian<dim>(fpm_in_space::cut<dim>);
    if (kernel) chosen = particles::kernel_named<dim>(*kernel);
    return {chosen, particles::spacing(cloud, smoothing_from), checked(smoothing)};
}

template const fpm_in_space::Formulation<double, 2>& InSpace::formulation() const;
template const fpm_in_space::Formulation<double, 3>& InSpace::formulation() const;
template Smoothing<double, 2> InSpace::on(const Cloud<2>&) const;
template Smoothing<double, 3> InSpace::on(const Cloud<3>&) const;

}  // namespace python
