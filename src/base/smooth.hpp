#pragma once

#include <functional>

namespace base {

/// A function of one variable with its first two derivatives.
/// \tparam Scalar double, long double or base::Quad
template <class Scalar = double>
struct Smooth {
    std::function<Scalar(const Scalar&)> f, Df, D2f;  ///< may be called from several threads at once
};

}  // namespace base
