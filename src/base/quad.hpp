#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>

namespace base {

/// A real number of quadruple precision, 113 bits or about 34 digits: a scalar for everything that is a template here. An
/// operation takes some fifty times that of a double.
using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

}  // namespace base
