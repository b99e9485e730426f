#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <vector>

#include "particles/operators.hpp"
#include "particles/points.hpp"
#include "particles/spacing.hpp"

/// The module `particle_methods` of Python: arrays in, arrays out. What is computed stands in the headers of
/// the sections.
///
/// An array that comes in may be a list, of any real type, not contiguous or read-only: it is only read. What
/// goes out owns its memory. While C++ computes, other threads of Python run.
namespace python {

namespace py = pybind11;

using particles::Column;
using particles::Index;

/// Numbers by rows.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// \param name of the argument, for messages
/// \param shapes that are possible, in words: "(N,)"
/// \throws base::InvalidInput for anything but an array of real numbers with this number of dimensions
Numbers numbers(const py::handle& given, const std::string& name, Index dimensions,
                const std::string& shapes);

/// One number for each particle. \throws base::InvalidInput as numbers()
Column<double> column(const py::handle& given, const std::string& name);

/// Positions in the plane or in space, a row for each particle.
/// \return the array, and its number of columns, 2 or 3
/// \throws base::InvalidInput as numbers(), and for another number of columns
std::pair<Numbers, int> positions(const py::handle& given, const std::string& name);

/// The same as C++ has them, a column for each particle.
template <int dim>
particles::Points<dim> points_of(const Numbers& rows) {
    return Eigen::Map<const particles::Points<dim>>(rows.data(), dim, rows.shape(0));
}

/// The numbers of particles, a row of `count` for each entry.
/// \param N number of particles
/// \throws base::InvalidInput for what is no array of integers of this shape, and for a number that no
///         particle has
template <std::size_t count>
std::vector<std::array<int, count>> numbers_of_particles(const py::handle& given, const std::string& name,
                                                         Index N);

/// Whether an argument is one number, or one integer, of Python or of numpy.
bool is_number(const py::handle& given);
bool is_integer(const py::handle& given);

/// One number, one integer or one text. \throws base::InvalidInput naming the argument
double number(const py::handle& given, const std::string& name);
Index integer(const py::handle& given, const std::string& name);
std::string text(const py::handle& given, const std::string& name);

/// A spacing: its name, a length, or a length for each particle.
/// \throws base::InvalidInput as particles::spacing_named() and column(), and for a length that is not
///         positive
particles::Spacing spacing(const py::handle& given);

/// An array that owns a copy of these numbers, in C's order.
/// \param shape with as many entries
py::array_t<double> array_of(const double* numbers, const std::vector<py::ssize_t>& shape);
py::array_t<double> array_of(const Column<double>& numbers);

/// The matrix of scipy that owns the operator's memory: data [1/length^k], indices and indptr (int32).
py::object csr_matrix(particles::Operator<double>&& D);

}  // namespace python
