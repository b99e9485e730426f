#include "python/arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace python {

using base::InvalidInput;
using particles::Operator;

namespace {

std::string shown(const py::handle& any) {
    return py::str(any);
}

/// An array of any type. \throws base::InvalidInput for what cannot be one, and for one with a mask
py::array any_array(const py::handle& given, const std::string& name) {
    if (py::isinstance(given, py::module_::import("numpy.ma").attr("MaskedArray")))
        throw InvalidInput(name + " has a mask, which would be lost; pass what it leaves, such as " + name +
                           ".compressed()");
    py::array any = py::array::ensure(given);
    if (!any)
        throw InvalidInput(name + " is no array, but of type " + shown(py::type::of(given).attr("__name__")));
    return any;
}

void require_shape(const py::array& any, const std::string& name, bool has_it, const std::string& shapes) {
    if (!has_it)
        throw InvalidInput(name + " must have the shape " + shapes + ", got " + shown(any.attr("shape")));
}

void require_kind(const py::array& any, const std::string& name, const std::string& kinds,
                  const std::string& what) {
    // An empty list is an array of doubles.
    if (kinds.find(any.dtype().kind()) == std::string::npos && any.size() > 0)
        throw InvalidInput(name + " must hold " + what + ", got the type " + shown(any.dtype()));
}

}  // namespace

Numbers numbers(const py::handle& given, const std::string& name, Index dimensions,
                const std::string& shapes) {
    const py::array any = any_array(given, name);
    require_kind(any, name, "fiu", "real numbers");
    require_shape(any, name, any.ndim() == dimensions, shapes);
    return {any};
}

Column<double> column(const py::handle& given, const std::string& name) {
    const Numbers all = numbers(given, name, 1, "(N,)");
    return Eigen::Map<const Column<double>>(all.data(), all.size());
}

std::pair<Numbers, int> positions(const py::handle& given, const std::string& name) {
    const std::string shapes = "(N, 2) or (N, 3), a row for each particle";
    const Numbers rows = numbers(given, name, 2, shapes);
    const auto dim = static_cast<int>(rows.shape(1));
    require_shape(rows, name, dim == 2 || dim == 3, shapes);
    return {rows, dim};
}

template <std::size_t count>
std::vector<std::array<int, count>> numbers_of_particles(const py::handle& given, const std::string& name,
                                                         Index N) {
    const py::array any = any_array(given, name);
    require_kind(any, name, "iu", "integers, the numbers of points");
    require_shape(any, name, any.ndim() == 2 && any.shape(1) == static_cast<py::ssize_t>(count),
                  "(n, " + std::to_string(count) + ")");
    const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> wide(any);
    std::vector<std::array<int, count>> all(static_cast<std::size_t>(wide.shape(0)));
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t corner = 0; corner < count; ++corner) {
            const std::int64_t number = wide.data()[k * count + corner];
            if (number < 0 || number >= N)
                throw InvalidInput(name + "[" + std::to_string(k) + ", " + std::to_string(corner) + "] is " +
                                   std::to_string(number) + ", but the points have numbers from 0 to " +
                                   std::to_string(N - 1));
            all[k][corner] = static_cast<int>(number);
        }
    return all;
}

template std::vector<std::array<int, 2>> numbers_of_particles(const py::handle&, const std::string&, Index);
template std::vector<std::array<int, 3>> numbers_of_particles(const py::handle&, const std::string&, Index);
template std::vector<std::array<int, 4>> numbers_of_particles(const py::handle&, const std::string&, Index);

namespace {

/// Whether an argument is a scalar of one of numpy's kinds.
bool is_scalar(const py::handle& given, const std::string& kinds) {
    const py::array any = py::array::ensure(given);
    return any && any.ndim() == 0 && kinds.find(any.dtype().kind()) != std::string::npos;
}

}  // namespace

bool is_number(const py::handle& given) {
    return is_scalar(given, "fiu") || (PyLong_Check(given.ptr()) != 0 && !py::isinstance<py::bool_>(given));
}
bool is_integer(const py::handle& given) {
    return is_scalar(given, "iu");
}

namespace {

[[noreturn]] void refuse(const py::handle& given, const std::string& name, const std::string& what) {
    throw InvalidInput(name + " must be " + what + ", got " + shown(py::repr(given)));
}

}  // namespace

double number(const py::handle& given, const std::string& name) {
    if (!is_number(given)) refuse(given, name, "a number");
    return py::float_(py::reinterpret_borrow<py::object>(given));
}
Index integer(const py::handle& given, const std::string& name) {
    if (!is_integer(given)) refuse(given, name, "an integer");
    return py::cast<Index>(given);
}
std::string text(const py::handle& given, const std::string& name) {
    if (!py::isinstance<py::str>(given)) refuse(given, name, "a text");
    return py::cast<std::string>(given);
}

particles::Spacing spacing(const py::handle& given) {
    const std::string name = "smoothing_from";
    if (py::isinstance<py::str>(given)) return particles::spacing_named(text(given, name));
    const Column<double> lengths =
        is_number(given) ? Column<double>::Constant(1, number(given, name)) : column(given, name);
    for (const double length : lengths)
        if (!(std::isfinite(length) && length > 0))
            throw InvalidInput(name + " must be positive and finite, got " + base::shown(length));
    return particles::Spacing(lengths);
}

py::array_t<double> array_of(const double* numbers, const std::vector<py::ssize_t>& shape) {
    return py::array_t<double>(shape, numbers);
}
py::array_t<double> array_of(const Column<double>& numbers) {
    return array_of(numbers.data(), {numbers.size()});
}

py::object csr_matrix(Operator<double>&& D) {
    auto owned = std::make_unique<Operator<double>>();
    owned->swap(D);
    Operator<double>& kept = *owned;
    const py::capsule owner(owned.release(), [](void* it) { delete static_cast<Operator<double>*>(it); });
    const auto view = [&](auto* first, Index size) {
        return py::array_t<std::remove_pointer_t<decltype(first)>>(size, first, owner);
    };
    return py::module_::import("scipy.sparse")
        .attr("csr_matrix")(py::make_tuple(view(kept.valuePtr(), kept.nonZeros()),
                                           view(kept.innerIndexPtr(), kept.nonZeros()),
                                           view(kept.outerIndexPtr(), kept.rows() + 1)),
                            py::arg("shape") = py::make_tuple(kept.rows(), kept.cols()));
}

}  // namespace python
