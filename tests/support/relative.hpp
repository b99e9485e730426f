#pragma once

#include <doctest/doctest.h>

namespace support {

/// Equal up to a relative tolerance. doctest's Approx alone adds an absolute tolerance of the same size, too
/// large for small numbers.
inline doctest::Approx relative(double value, double tolerance) {
    return doctest::Approx(value).epsilon(tolerance).scale(0);
}

}  // namespace support
