#pragma once

#include <boost/multiprecision/eigen.hpp>
#ifdef __SIZEOF_FLOAT128__
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace base {

/// A real number of quadruple precision, 113 bits or about 34 digits: a scalar for all templates of this
/// package. An operation takes about fifty times as long as in double precision. A compiler without such
/// numbers takes Boost's own, which are slower still.
#ifdef __SIZEOF_FLOAT128__
using Quad =
    boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;
#else
using Quad = boost::multiprecision::cpp_bin_float_quad;
#endif

}  // namespace base
