#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/float128.hpp>

namespace base {

/// A real number of quadruple precision, 113 bits or about 34 digits: a scalar for all templates of this
/// package. An operation takes about fifty times as long as in double precision.
using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;

}  // namespace base
