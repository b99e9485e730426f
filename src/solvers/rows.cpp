#include "solvers/rows.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "base/errors.hpp"
#include "base/parallel.hpp"

namespace solvers {

SparseRows rows_in_pairs(const std::vector<std::vector<int>>& near) {
    using base::Index;
    const auto N = static_cast<Index>(near.size());
    std::size_t entries = 0;
    for (const auto& neighbours : near) entries += 4 * neighbours.size();
    if (entries > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw base::InvalidInput("a system of " + std::to_string(entries) +
                                 " entries is too large; take fewer particles or a smaller scaling factor");
    SparseRows A(2 * N, 2 * N);
    A.resizeNonZeros(static_cast<Index>(entries));
    A.outerIndexPtr()[0] = 0;
    for (Index i = 0; i < 2 * N; ++i)
        A.outerIndexPtr()[i + 1] =
            A.outerIndexPtr()[i] + 2 * static_cast<int>(near[static_cast<std::size_t>(i / 2)].size());
    base::for_each_index(N, [&](Index i) {
        for (int row = 0; row < 2; ++row) {
            int* column = A.innerIndexPtr() + A.outerIndexPtr()[2 * i + row];
            for (const int j : near[static_cast<std::size_t>(i)]) {
                *column++ = 2 * j;
                *column++ = 2 * j + 1;
            }
        }
    });
    std::fill(A.valuePtr(), A.valuePtr() + A.nonZeros(), 0.0);
    return A;
}

void set_row(SparseRows& A, Eigen::Index row, const std::vector<int>& points, const Eigen::ArrayXd& first,
             const Eigen::ArrayXd& second) {
    Eigen::Index place = A.outerIndexPtr()[row];
    for (std::size_t j = 0; j < points.size(); ++j) {
        while (A.innerIndexPtr()[place] != 2 * points[j]) place += 2;
        A.valuePtr()[place] = first[static_cast<Eigen::Index>(j)];
        A.valuePtr()[place + 1] = second[static_cast<Eigen::Index>(j)];
    }
}

}  // namespace solvers
