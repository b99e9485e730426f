#include <pybind11/stl.h>

#include <utility>

#include "command_line/formulations.hpp"
#include "python/functions.hpp"
#include "python/particles.hpp"

namespace python {

using namespace pybind11::literals;
using particles::Cloud;

namespace {

constexpr auto about_line =
    R"(The first and second derivative on a line, by a formulation of Asprone et al. (2010).

Row i of a matrix holds the weights of particle i on the values B at its neighbours, so that D @ B is the
derivative at all particles.

formulation     original, chen_beraun, rkpm_first_order, rkpm_second_order, fpm, modified_fpm,
                second_order_fpm; or ssph, of Batra and Zhang (2008), and definite_fpm, our own
x               positions in increasing order, shape (N,) [length]
kernel          gaussian, cubic_spline, quintic_spline, ... (a wrong name tells all)
smoothing       smoothing length h over the spacing
smoothing_from  the spacing: mean, largest, local, nearest, K-nearest, a length, or N lengths
volumes         of the particles: equal, or partition (their cells)

Returns (D, D2), scipy.sparse.csr_matrix of shape (N, N) [1/length, 1/length^2].
Raises ValueError for arguments without meaning, RuntimeError where the neighbours do not determine the
weights, with a remedy.

>>> x = numpy.linspace(0, 1, 41)
>>> D, D2 = operators("second_order_fpm", x)
>>> abs(D2 @ numpy.exp(x) - numpy.exp(x)).max()    # 1.7e-3, and a quarter of it on 81 particles
)";

constexpr auto about_space =
    R"(The first and second derivatives in the plane or in space.

points          positions in any order, shape (N, 2) or (N, 3) [length]
scheme          fpm, the second-order FPM, or ssph, the SSPH basis of Batra and Zhang (2008)
degree          of the monomials of ssph: 2 (default) or 3
kernel          as on a line; by default a Gaussian that is lowered to zero at 3.5 h, in space at 3 h
smoothing       smoothing length h over the spacing
smoothing_from  the spacing: local, mean, largest, nearest, K-nearest, a length, or N lengths

Returns a dict from the multi-index of a derivative to its csr_matrix: with B the values at the points,
D[1, 0] @ B is dB/dx [1/length], D[1, 1] @ B is d2B/dxdy [1/length^2].
Raises as on a line.

>>> points = numpy.random.default_rng(1).random((1000, 2))
>>> D = operators(points)
>>> laplacian = D[2, 0] + D[0, 2]
)";

py::tuple on_a_line(const std::string& formulation, const py::object& x, const std::string& kernel,
                    double smoothing, const py::object& smoothing_from, const std::string& volumes) {
    const auto& chosen = command_line::formulation_named<double>(formulation);
    const auto [line, smoothed] = OnLine{kernel, smoothing, smoothing_from, volumes}.at(x);
    particles::Operators<double> found = [&, &line = line, &smoothed = smoothed] {
        const py::gil_scoped_release others_run;
        return chosen.operators(line, smoothed);
    }();
    return py::make_tuple(csr_matrix(std::move(found.D)), csr_matrix(std::move(found.D2)));
}

template <int dim>
py::dict in_space(const Cloud<dim>& cloud, const InSpace& how) {
    const auto& chosen = how.formulation<dim>();
    const auto smoothing = how.on(cloud).first;
    auto found = [&] {
        const py::gil_scoped_release others_run;
        return particles::assemble(cloud, smoothing, chosen.required(),
                                   particles::CloudRule<dim>(chosen.weights), {0, cloud.size()});
    }();
    py::dict all;
    static constexpr auto known = particles::monomials<dim, 2>();
    for (std::size_t k = 1; k < known.size(); ++k)
        all[key<dim>(known[k])] = csr_matrix(std::move(k <= dim ? found.D[k - 1] : found.D2[k - 1 - dim]));
    return all;
}

}  // namespace

void define_operators(py::module_& module) {
    module.def("operators", &on_a_line, about_line, "formulation"_a, "x"_a, py::kw_only(),
               "kernel"_a = "gaussian", "smoothing"_a = 1.0, "smoothing_from"_a = "mean",
               "volumes"_a = "equal");
    module.def(
        "operators",
        [](const py::object& points, const std::string& scheme, std::optional<int> degree,
           const std::optional<std::string>& kernel, double smoothing, const py::object& smoothing_from) {
            const InSpace how{scheme, degree, kernel, smoothing, smoothing_from};
            return in_its_dimension(points, [&](const auto& cloud) { return in_space(cloud, how); });
        },
        about_space, "points"_a, py::kw_only(), "scheme"_a = "fpm", "degree"_a = py::none(),
        "kernel"_a = py::none(), "smoothing"_a = 1.2, "smoothing_from"_a = "local");
}

}  // namespace python
