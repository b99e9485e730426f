#pragma once

#include <algorithm>

#include "particles/operators.hpp"

namespace support {

/// Whether two operators store the same entries, to the last bit.
inline bool same_bytes(const particles::Operator<double>& a, const particles::Operator<double>& b) {
    return a.nonZeros() == b.nonZeros() &&
           std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()) &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr());
}

}  // namespace support
