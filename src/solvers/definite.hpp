#pragma once

#include <cstddef>
#include <vector>

#include "solvers/rows.hpp"

namespace solvers {

/// Cholesky factors of a sparse symmetric positive definite matrix, for a solution that is a first guess:
/// they are computed by CHOLMOD and kept in single precision, since a solution takes as long as to read them.
class DefiniteFactors {
  public:
    /// \param K symmetric; the upper triangle is read
    explicit DefiniteFactors(const SparseRows& K);

    /// Whether K is positive definite, by far more than round-off.
    [[nodiscard]] bool succeeded() const { return !order_.empty(); }

    /// \return x of \f$K x = b\f$, nearly
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  private:
    /// Columns of L with the same rows: those of the columns themselves, and some after them.
    struct Columns {
        int first, count;
        std::size_t row;    // where their rows begin in row_
        int rows;           // number of rows, from the first column's on
        std::size_t entry;  // where their entries begin in L_, column by column
    };
    [[nodiscard]] const float* column(const Columns& of, int j) const {
        return L_.data() + of.entry + static_cast<std::size_t>(j) * static_cast<std::size_t>(of.rows);
    }

    std::vector<int> order_;  // of the unknowns in L
    std::vector<Columns> columns_;
    std::vector<int> row_;
    std::vector<float> L_;
    int most_rows_ = 0;
};

}  // namespace solvers
