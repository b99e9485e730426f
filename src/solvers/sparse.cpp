
#include "solvers/sparse.hpp"

#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "solvers/definite.hpp"
#include "solvers/gmres.hpp"

namespace solvers {

namespace {

/// The triangular factors of a sparse matrix, with row exchanges.
class Factors {
  public:
    struct Settings {
        /// METIS leaves fewer entries in the factors than AMD, which is faster itself.
        int ordering = UMFPACK_ORDERING_METIS;
        bool refined = true;  ///< solve() refines its result iteratively
    };
    Factors(const SparseRows& A, const Settings& settings) : columns_(A) {
        auto& control = factors_.umfpackControl();
        // Particles are neighbours of each other, or nearly always.
        control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
        control[UMFPACK_ORDERING] = settings.ordering;
        control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
        if (!settings.refined) control[UMFPACK_IRSTEP] = 0;
        factors_.compute(columns_);
        if (factors_.info() != Eigen::Success) {
            fault_ = factors_.out_of_memory() ? "does not fit into memory" : "is singular";
            return;
        }
        // Nearly every vector reveals a singular matrix; the right-hand side may be one of the few that do
        // not.
        const Eigen::VectorXd probe = Eigen::VectorXd::NullaryExpr(A.rows(), [](Eigen::Index k) {
            return std::cos(static_cast<double>(k) * static_cast<double>(k));
        });
        const double growth = solve(probe).cwiseAbs().maxCoeff();
        if (!(growth < 1 / (100 * std::numeric_limits<double>::epsilon()))) fault_ = "is singular";
    }

    /// Why the matrix cannot be solved with; empty if it can.
    [[nodiscard]] const std::string& fault() const { return fault_; }
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }

  private:
    /// Long indices: the factors of a million particles have more entries than an int can count.
    using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;
    struct Umfpack : Eigen::UmfPackLU<Columns> {
        [[nodiscard]] bool out_of_memory() const { return m_fact_errorCode < 0; }
    };

    Columns columns_;
    Umfpack factors_;
    std::string fault_;
};

/// A x.
Eigen::VectorXd product(const SparseRows& A, const Eigen::VectorXd& x) {
    Eigen::VectorXd y(A.rows());
    base::for_each_index(A.rows(), [&](Eigen::Index row) { y[row] = A.row(row).dot(x); });
    return y;
}

/// The solution of A x = b by GMRES.
/// \param inverse an approximate inverse of A
template <class Inverse>
std::optional<Eigen::VectorXd> iterated_by(const Inverse& inverse, const SparseRows& A,
                                           const Eigen::VectorXd& b) {
    const auto apply = [&](const Eigen::VectorXd& v) { return inverse(product(A, v)); };
    const Eigen::VectorXd first = inverse(b);
    // A solution far larger than this means that A is singular and what stands for it is not.
    const double most = 1e6 * first.cwiseAbs().maxCoeff();
    auto x = gmres(apply, first, 1e-14 * first.norm(), 150);
    // Where round-off has separated the two residuals, restart from the true one.
    for (int restarts = 0; x && x->cwiseAbs().maxCoeff() <= most; ++restarts) {
        if (relative_residual(A, *x, b) < largest_residual) return x;
        if (restarts == 2) break;
        const Eigen::VectorXd rest = inverse(b - product(A, *x));
        const auto more = gmres(apply, rest, 1e-4 * rest.norm(), 150);
        if (!more) break;
        *x += *more;
    }
    return {};
}

/// The rows at the edge and in some layers of neighbours around it.
std::vector<int> edge_and_neighbours(const Elements& elements, int layers) {
    std::vector<int> rows(elements.edge.begin(), elements.edge.end());
    std::vector<char> chosen(static_cast<std::size_t>(elements.K.rows()), 0);
    for (const int row : rows) chosen[static_cast<std::size_t>(row)] = 1;
    for (std::size_t begin = 0; layers > 0; --layers) {
        const std::size_t end = rows.size();
        for (; begin < end; ++begin)
            for (SparseRows::InnerIterator entry(elements.K, rows[begin]); entry; ++entry)
                if (char& known = chosen[static_cast<std::size_t>(entry.col())]; known == 0) {
                    known = 1;
                    rows.push_back(static_cast<int>(entry.col()));
                }
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

/// A(rows, rows).
SparseRows part(const SparseRows& A, const std::vector<int>& rows) {
    std::vector<int> place(static_cast<std::size_t>(A.cols()), -1);
    for (std::size_t k = 0; k < rows.size(); ++k)
        place[static_cast<std::size_t>(rows[k])] = static_cast<int>(k);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < rows.size(); ++k)
        for (SparseRows::InnerIterator entry(A, rows[k]); entry; ++entry)
            if (const int column = place[static_cast<std::size_t>(entry.col())]; column >= 0)
                entries.emplace_back(static_cast<int>(k), column, entry.value());
    const auto count = static_cast<Eigen::Index>(rows.size());
    SparseRows few(count, count);
    few.setFromTriplets(entries.begin(), entries.end());
    return few;
}

/// The approximate inverse of A by elements, and by A itself at the edge.
class ByElements {
  public:
    ByElements(const SparseRows& A, Elements&& elements)
        : A_(A),
          scale_(A.rows()),
          elements_(elements.K),
          rows_(edge_and_neighbours(elements, 2)),
          edge_(part(A, rows_), {.refined = false}) {
        // An equation of A is one of K but for a factor; not one at the edge whose own entry is small beside
        // 1.
        for (Eigen::Index row = 0; row < A.rows(); ++row) {
            const double diagonal = A.coeff(row, row);
            scale_[row] = std::abs(diagonal) > 0.1 ? elements.K.coeff(row, row) / diagonal : 0;
        }
        SparseRows().swap(elements.K);
    }

    [[nodiscard]] bool succeeded() const { return elements_.succeeded() && edge_.fault().empty(); }

    Eigen::VectorXd operator()(const Eigen::VectorXd& b) const {
        Eigen::VectorXd x = elements_.solve(scale_.cwiseProduct(b));
        Eigen::VectorXd rest = b(rows_);
        base::for_each_index(rest.size(), [&](Eigen::Index k) {
            rest[k] -= A_.row(rows_[static_cast<std::size_t>(k)]).dot(x);
        });
        x(rows_) += edge_.solve(rest);
        return x;
    }

  private:
    const SparseRows& A_;
    Eigen::VectorXd scale_;
    DefiniteFactors elements_;
    std::vector<int> rows_;
    Factors edge_;
};

}  // namespace

void scale_rows(SparseRows& A, Eigen::VectorXd& b, SparseRows& nearest) {
    const auto values = [](SparseRows& matrix, Eigen::Index row) {
        const int first = matrix.outerIndexPtr()[row];
        return Eigen::Map<Eigen::ArrayXd>(matrix.valuePtr() + first, matrix.outerIndexPtr()[row + 1] - first);
    };
    base::for_each_index(A.rows(), [&](Eigen::Index row) {
        double largest = 0;
        for (const double entry : values(A, row)) largest = std::max(largest, std::abs(entry));
        const double scale = 1 / largest;
        values(A, row) *= scale;
        b[row] *= scale;
        if (nearest.rows() > 0) values(nearest, row) *= scale;
    });
}

double relative_residual(const SparseRows& A, const Eigen::VectorXd& x, const Eigen::VectorXd& b) {
    Eigen::VectorXd residual(A.rows()), size(A.rows());
    base::for_each_index(A.rows(), [&](Eigen::Index row) {
        double sum = 0, terms = 0;
        for (SparseRows::InnerIterator entry(A, row); entry; ++entry) {
            sum += entry.value() * x[entry.col()];
            terms += std::abs(entry.value() * x[entry.col()]);
        }
        residual[row] = std::abs(b[row] - sum);
        size[row] = terms;
    });
    const double largest = size.maxCoeff() + b.cwiseAbs().maxCoeff();
    return largest == 0 ? 0 : residual.maxCoeff() / largest;
}

std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b,
                                        const SparseRows& nearest) {
    const int ordering = A.rows() > 100000 ? UMFPACK_ORDERING_METIS : UMFPACK_ORDERING_AMD;
    const Factors factors(nearest, {.ordering = ordering, .refined = false});
    if (!factors.fault().empty()) return {};
    return iterated_by([&](const Eigen::VectorXd& v) { return factors.solve(v); }, A, b);
}

std::optional<Eigen::VectorXd> iterated(const SparseRows& A, const Eigen::VectorXd& b, Elements&& elements) {
    const ByElements inverse(A, std::move(elements));
    if (!inverse.succeeded()) return {};
    return iterated_by(inverse, A, b);
}

namespace {

[[noreturn]] void refuse(Eigen::Index unknowns, const std::string& why) {
    throw base::FailedComputation(
        "the linear system of " + std::to_string(unknowns) + " unknowns " + why +
        "; take another scaling factor, another smoothing length or other particles");
}

Eigen::VectorXd scaled_and_solved(SparseRows& A, Eigen::VectorXd& b, SparseRows& nearest,
                                  Elements&& elements) {
    scale_rows(A, b, nearest);
    for (Eigen::Index row = 0; row < A.rows(); ++row)
        if (!std::isfinite(A.row(row).sum() + b[row]))
            refuse(A.rows(), "has a row " + std::to_string(row) + " that is zero or not finite");
    if (nearest.rows() > 0)
        if (const auto x = iterated(A, b, nearest)) return *x;
    if (elements.K.rows() > 0)
        if (const auto x = iterated(A, b, std::move(elements))) return *x;

    const Factors factors(A, {});
    if (!factors.fault().empty()) refuse(A.rows(), factors.fault());
    Eigen::VectorXd x = factors.solve(b);
    const double residual = relative_residual(A, x, b);
    if (!(residual < largest_residual))
        refuse(A.rows(), "was not solved (relative residual " + base::shown(residual, 2) + ")");
    return x;
}

}  // namespace

Eigen::VectorXd solve_sparse(SparseRows&& A, Eigen::VectorXd b, SparseRows&& nearest) {
    return scaled_and_solved(A, b, nearest, {});
}

Eigen::VectorXd solve_sparse(SparseRows&& A, Eigen::VectorXd b, Elements&& elements) {
    SparseRows none;
    return scaled_and_solved(A, b, none, std::move(elements));
}

struct SparseFactors::Factorised {
    Factorised(const SparseRows& A, Eigen::VectorXd row_scale)
        : scale(std::move(row_scale)), factors(A, {}) {}

    Eigen::VectorXd scale;
    Factors factors;
};

SparseFactors::SparseFactors(SparseRows A) {
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(A.rows());
    SparseRows none;
    scale_rows(A, scale, none);
    factorised_ = std::make_unique<Factorised>(A, std::move(scale));
    if (const std::string& fault = factorised_->factors.fault(); !fault.empty())
        throw base::FailedComputation("the linear system of " + std::to_string(A.rows()) + " unknowns " +
                                      fault + "; take another smoothing length or other particles");
}
SparseFactors::~SparseFactors() = default;

Eigen::VectorXd SparseFactors::solve(Eigen::VectorXd b) const {
    b.array() *= factorised_->scale.array();
    return factorised_->factors.solve(b);
}

}  // namespace solvers
