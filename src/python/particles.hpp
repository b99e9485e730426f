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

/// How the module's functions are asked for a line: the keywords beside the positions.
struct OnLine {
    std::string kernel;
    double smoothing;  ///< h/δ
    py::object smoothing_from;
    std::string volumes;

    /// The line with its kernel. \throws base::InvalidInput where a name or a number has no meaning
    [[nodiscard]] asprone2010::numerical_tests::Particles<double> at(const py::handle& x) const;
};

/// The same in the plane and in space.
struct InSpace {
    std::string scheme;
    std::optional<int> degree;
    std::optional<std::string> kernel;  ///< none for the Gaussian that is lowered to zero
    double smoothing;                   ///< h/δ
    py::object smoothing_from;

    /// The formulation. \throws base::InvalidInput for another scheme than fpm and ssph, and another degree
    template <int dim>
    [[nodiscard]] const fpm_in_space::Formulation<double, dim>& formulation() const;

    /// The kernel with its smoothing length, and the distance δ of each particle.
    template <int dim>
    [[nodiscard]] std::pair<particles::Smoothing<double, dim>, Column<double>> on(
        const particles::Cloud<dim>& cloud) const;
};

/// Calls `compute` with the cloud of some positions, of two or three dimensions.
template <class Compute>
auto in_its_dimension(const py::handle& points, const Compute& compute) {
    const auto [rows, dim] = positions(points, "points");
    return dim == 2 ? compute(particles::Cloud<2>(points_of<2>(rows)))
                    : compute(particles::Cloud<3>(points_of<3>(rows)));
}

}  // namespace python
