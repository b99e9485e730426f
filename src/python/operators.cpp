#include <utility>

#include "command_line/formulations.hpp"
#include "python/functions.hpp"
#include "python/particles.hpp"

namespace python {

using particles::Cloud;

namespace {

py::tuple on_a_line(const py::object& formulation, const py::object& x, const py::args& keywords) {
    const auto& chosen = command_line::formulation_named<double>(text(formulation, "formulation"));
    const OnLine how(keywords);
    particles::Operators<double> found = while_others_run([&, at = column(x, "x")] {
        const auto [line, smoothing] = how.at(at);
        return chosen.operators(line, smoothing);
    });
    return py::make_tuple(csr_matrix(std::move(found.D)), csr_matrix(std::move(found.D2)));
}

template <int dim>
py::dict in_space(const particles::Points<dim>& points, const InSpace& how) {
    const auto& chosen = how.formulation<dim>();
    auto found = while_others_run([&] {
        const Cloud<dim> cloud(points);
        return particles::assemble(cloud, how.on(cloud), how.required<dim>(),
                                   particles::CloudRule<dim>(chosen.weights), {0, cloud.size()});
    });
    py::dict all;
    static constexpr auto known = particles::monomials<dim, 2>();
    for (std::size_t k = 1; k < known.size(); ++k)
        all[key<dim>(known[k])] = csr_matrix(std::move(k <= dim ? found.D[k - 1] : found.D2[k - 1 - dim]));
    return all;
}

}  // namespace

void define_operators(py::module_& module) {
    module.def("operators_on_a_line", &on_a_line);
    module.def("operators_in_space", [](const py::object& points, const py::args& keywords) {
        const InSpace how(keywords);
        return in_its_dimension(points, [&](const auto& x) { return in_space(x, how); });
    });
}

}  // namespace python
