#include "solvers/rows.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/parallel.hpp"

namespace solvers {

SparseRows rows_in_blocks(const std::vector<std::vector<int>>& near, int unknowns, Eigen::Index points) {
    using base::Index;
    const auto N = static_cast<Index>(near.size());
    std::size_t entries = 0;
    for (const auto& neighbours : near)
        entries += static_cast<std::size_t>(unknowns * unknowns) * neighbours.size();
    if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw base::InvalidInput("a system of " + std::to_string(entries) +
                                 " entries is too large; take fewer particles or a smaller scaling factor");
    SparseRows A(unknowns * N, unknowns * points);
    A.resizeNonZeros(static_cast<Index>(entries));
    A.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < A.rows(); ++i)
        A.outerIndexPtr()[i + 1] =
            A.outerIndexPtr()[i] +
            unknowns * static_cast<int>(near[static_cast<std::size_t>(i / unknowns)].size());
    base::for_each_index(A.rows(), [&](Index row) {
        int* column = A.innerIndexPtr() + A.outerIndexPtr()[row];
        for (const int j : near[static_cast<std::size_t>(row / unknowns)])
            for (int k = 0; k < unknowns; ++k) *column++ = unknowns * j + k;
    });
    std::fill(A.valuePtr(), A.valuePtr() + A.nonZeros(), 0.0);
    return A;
}

}  // namespace solvers
