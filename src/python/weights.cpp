#include <vector>

#include "command_line/formulations.hpp"
#include "particles/quality.hpp"
#include "python/functions.hpp"
#include "python/particles.hpp"

namespace python {

using particles::Cloud;
using particles::Exponents;
using particles::Offsets;
using particles::Operator;

namespace {

constexpr auto about_weights = R"(A row of each operator: the weights of one particle.

particles  numbers of the neighbours, the particle itself among them, shape (n,)
offsets    of the neighbours, shape (n,) or (n, dim) [length]
weights    by derivative: weights on the values, shape (n,) [1/length^k for a k-th derivative]
moments    by derivative and by monomial r^a: sum of w r^a/a! over the neighbours [length^(|a|-k)], up to
           degree 6, in the plane and in space 4. It is 1 for the derivative's own a. By Taylor's expansion
           the others are the factors of the derivatives of B in the error.
quality    by derivative: R, the factor in the bound of the error, |error| <= R d^(m+1-k) max|B^(m+1)|, where
           polynomials of degree m are exact and d is the spacing of smoothing_from
)";

/// Copies for Python.
struct Weights {
    py::object particles, offsets;
    py::dict weights, moments, quality;
};

/// All multi-indices up to a degree, by degree; the first coordinate's largest exponent comes first.
template <int dim>
std::vector<Exponents<dim>> up_to_degree(int most) {
    std::vector<Exponents<dim>> all;
    for (int degree = 0; degree <= most; ++degree) {
        if constexpr (dim == 1) {
            all.push_back({degree});
        } else {
            for (int first = degree; first >= 0; --first) {
                if constexpr (dim == 2)
                    all.push_back({first, degree - first});
                else
                    for (int second = degree - first; second >= 0; --second)
                        all.push_back({first, second, degree - first - second});
            }
        }
    }
    return all;
}

/// \f$\sum_j w_j\,r_j^a/a!\f$
template <int dim>
double moment(const Column<double>& w, const Offsets<double, dim>& r, const Exponents<dim>& a) {
    Column<double> term = w / particles::factorial<dim>(a);
    for (std::size_t axis = 0; axis < dim; ++axis)
        for (int k = 0; k < a[axis]; ++k) term *= r.col(static_cast<Index>(axis));
    return term.sum();
}

/// The row of a derivative, with its moments and its quality.
/// \param unit δ, in which R is measured [length] \param exact degree of exactness
template <int dim>
void add(Weights& all, const Exponents<dim>& a, const Column<double>& w, const Offsets<double, dim>& r,
         double unit, int exact) {
    const py::object derivative = key<dim>(a);
    all.weights[derivative] = array_of(w);
    py::dict moments;
    for (const Exponents<dim>& monomial : up_to_degree<dim>(dim == 1 ? 6 : 4))
        moments[key<dim>(monomial)] = moment<dim>(w, r, monomial);
    all.moments[derivative] = moments;
    const double per_unit = std::pow(unit, particles::order<dim>(a));
    all.quality[derivative] = particles::quality<double, dim>(w * per_unit, r / unit, exact);
}

void require_particle(Index number, Index N) {
    if (number < 0 || number >= N)
        throw base::InvalidInput("there is no particle " + std::to_string(number) + "; choose 0 to " +
                                 std::to_string(N - 1));
}

/// Columns and values of a row.
struct Row {
    Eigen::ArrayXi columns;
    Column<double> values;
};
Row row_of(const Operator<double>& D, Index row) {
    const int* const start = D.outerIndexPtr() + row;
    const Index size = start[1] - start[0];
    return {Eigen::Map<const Eigen::ArrayXi>(D.innerIndexPtr() + start[0], size),
            Eigen::Map<const Column<double>>(D.valuePtr() + start[0], size)};
}

template <int dim>
py::object array_of_offsets(const Offsets<double, dim>& r) {
    if constexpr (dim == 1) {
        return array_of(r);
    } else {
        const Eigen::Array<double, Eigen::Dynamic, dim, Eigen::RowMajor> rows = r;
        return array_of(rows.data(), {rows.rows(), dim});
    }
}

py::object array_of_numbers(const Eigen::ArrayXi& numbers) {
    return py::array_t<int>(numbers.size(), numbers.data());
}

Weights on_a_line(const py::object& formulation, const py::object& x, const py::object& of,
                  const py::args& keywords) {
    const auto& chosen = command_line::formulation_named<double>(text(formulation, "formulation"));
    const OnLine how(keywords);
    const Index number = integer(of, "number");
    const Column<double> positions = column(x, "x");
    require_particle(number, positions.size());
    const auto [found, delta] = while_others_run([&] {
        const auto [line, smoothed] = how.at(positions);
        return std::pair(chosen.operators(line, smoothed), smoothed.h(number) / how.smoothing);
    });
    // Where D is applied twice, the row of D² is the wider one.
    const Row first = row_of(found.D, number), second = row_of(found.D2, number);
    const Column<double> r = positions(second.columns) - positions[number];
    Column<double> w = Column<double>::Zero(r.size());
    w.segment(first.columns[0] - second.columns[0], first.columns.size()) = first.values;
    Weights all{array_of_numbers(second.columns), array_of_offsets<1>(r), {}, {}, {}};
    add<1>(all, {1}, w, r, delta, chosen.exact.first);
    add<1>(all, {2}, second.values, r, delta, chosen.exact.second);
    return all;
}

template <int dim>
Weights in_space(const particles::Points<dim>& points, Index number, const InSpace& how) {
    const auto& chosen = how.formulation<dim>();
    require_particle(number, points.cols());
    const auto [found, delta] = while_others_run([&] {
        const Cloud<dim> cloud(points);
        const auto smoothing = how.on(cloud);
        return std::pair(particles::assemble(cloud, smoothing, how.required<dim>(),
                                             particles::CloudRule<dim>(chosen.weights), {number, number + 1}),
                         smoothing.h(number) / how.smoothing);
    });
    const Eigen::ArrayXi near = row_of(found.D[0], 0).columns;
    Offsets<double, dim> r(near.size(), dim);
    for (Index k = 0; k < near.size(); ++k) r.row(k) = (points.col(near[k]) - points.col(number)).transpose();
    Weights all{array_of_numbers(near), array_of_offsets<dim>(r), {}, {}, {}};
    static constexpr auto known = particles::monomials<dim, 2>();
    for (std::size_t k = 1; k < known.size(); ++k)
        add<dim>(all, known[k], row_of(particles::derivative(found, known[k]), 0).values, r, delta,
                 k <= dim ? chosen.exact.first : chosen.exact.second);
    return all;
}

}  // namespace

void define_weights(py::module_& module) {
    py::class_<Weights>(module, "Weights", about_weights)
        .def_readonly("particles", &Weights::particles)
        .def_readonly("offsets", &Weights::offsets)
        .def_readonly("weights", &Weights::weights)
        .def_readonly("moments", &Weights::moments)
        .def_readonly("quality", &Weights::quality)
        .def("__repr__", [](const Weights& row) {
            return "Weights of the particles " + std::string(py::str(row.particles));
        });
    module.def("weights_on_a_line", &on_a_line);
    module.def("weights_in_space",
               [](const py::object& points, const py::object& of, const py::args& keywords) {
                   const InSpace how(keywords);
                   const Index number = integer(of, "number");
                   return in_its_dimension(points, [&](const auto& x) { return in_space(x, number, how); });
               });
}

}  // namespace python
