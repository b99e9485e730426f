#pragma once

#include <string>
#include <variant>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "fpm_in_space/formulations.hpp"
#include "particles/cloud.hpp"
#include "python/arrays.hpp"

namespace python {

/// A derivative as a key: its order on a line, its multi-index in the plane and in space.
template <int dim>
py::object key(const particles::Exponents<dim>& a) {
    if constexpr (dim == 1)
        return py::int_(a[0]);
    else if constexpr (dim == 2)
        return py::make_tuple(a[0], a[1]);
    else
        return py::make_tuple(a[0], a[1], a[2]);
}

/// The keywords of the module's functions on a line, beside the positions.
struct OnLine {
    /// \param how kernel, smoothing, smoothing_from, volumes
    explicit OnLine(const py::args& how);

    std::string kernel;
    double smoothing;  ///< h/δ
    particles::Spacing smoothing_from;
    std::string volumes;

    /// The line with its kernel. \throws base::InvalidInput where a name or a number has no meaning
    [[nodiscard]] asprone2010::numerical_tests::Particles<double> at(const Column<double>& x) const;
};

/// The same in the plane and in space.
struct InSpace {
    /// \param how scheme, degree, kernel, smoothing, smoothing_from
    explicit InSpace(const py::args& how);

    std::string scheme;
    std::optional<Index> degree;
    std::optional<std::string> kernel;  ///< none for the Gaussian that is lowered to zero
    double smoothing;                   ///< h/δ
    particles::Spacing smoothing_from;

    /// The formulation. \throws base::InvalidInput for another scheme than fpm and ssph, and another degree
    template <int dim>
    [[nodiscard]] const fpm_in_space::Formulation<double, dim>& formulation() const;

    /// How many particles it needs, in messages under the name of the scheme.
    template <int dim>
    [[nodiscard]] particles::Requirement required() const {
        return {scheme, formulation<dim>().particles};
    }

    /// The kernel with its smoothing length.
    template <int dim>
    [[nodiscard]] particles::Smoothing<double, dim> on(const particles::Cloud<dim>& cloud) const;
};

/// What `compute` returns, while other threads of Python run: it must not touch Python's objects.
template <class Compute>
auto while_others_run(const Compute& compute) {
    const py::gil_scoped_release others_run;
    return compute();
}

/// Calls `compute` with positions of two or three dimensions, a column for each particle.
template <class Compute>
auto in_its_dimension(const py::handle& points, const Compute& compute) {
    const auto [rows, dim] = positions(points, "points");
    return dim == 2 ? compute(points_of<2>(rows)) : compute(points_of<3>(rows));
}

}  // namespace python
