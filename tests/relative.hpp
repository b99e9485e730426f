#pragma once

#include <doctest/doctest.h>

namespace support {

/// Equal up to a relative tolerance. (doctest's Approx alone adds an absolute one of the same size, in which a small number
/// drowns.)
inline doctest::Approx relative(double value, double tolerance) {
    return doctest::Approx(value).epsilon(tolerance).scale(0);
}

}  // namespace support
