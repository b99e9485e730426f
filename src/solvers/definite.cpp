#include "solvers/definite.hpp"

#include <cholmod.h>
#include <omp.h>

#include <algorithm>

namespace solvers {

namespace {

/// Until the end of its life no loop is shared by threads. CHOLMOD's are short, and it would start four
/// threads for each of them.
class OneThread {
  public:
    OneThread() { omp_set_max_active_levels(0); }
    ~OneThread() { omp_set_max_active_levels(before_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

  private:
    int before_ = omp_get_max_active_levels();
};

/// CHOLMOD's factors, until the end of their life.
class Cholmod {
  public:
    explicit Cholmod(const SparseRows& K) {
        const OneThread one_thread;
        cholmod_start(&common_);
        common_.print = 0;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_AMD;
        common_.supernodal = CHOLMOD_SUPERNODAL;
        // The rows of a symmetric matrix are its columns. CHOLMOD does not write into them.
        cholmod_sparse columns{};
        columns.nrow = columns.ncol = static_cast<std::size_t>(K.rows());
        columns.nzmax = static_cast<std::size_t>(K.nonZeros());
        columns.p = const_cast<int*>(K.outerIndexPtr());
        columns.i = const_cast<int*>(K.innerIndexPtr());
        columns.x = const_cast<double*>(K.valuePtr());
        columns.stype = 1;
        columns.itype = CHOLMOD_INT;
        columns.xtype = CHOLMOD_REAL;
        columns.dtype = CHOLMOD_DOUBLE;
        columns.sorted = columns.packed = 1;
        factors_ = cholmod_analyze(&columns, &common_);
        if (factors_ != nullptr) cholmod_factorize(&columns, factors_, &common_);
    }
    ~Cholmod() {
        cholmod_free_factor(&factors_, &common_);
        cholmod_finish(&common_);
    }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;

    [[nodiscard]] bool succeeded() {
        return common_.status == CHOLMOD_OK && cholmod_rcond(factors_, &common_) > 1e-10;
    }
    [[nodiscard]] const cholmod_factor& factors() const { return *factors_; }

  private:
    cholmod_common common_{};
    cholmod_factor* factors_ = nullptr;
};

}  // namespace

DefiniteFactors::DefiniteFactors(const SparseRows& K) {
    Cholmod cholmod(K);
    if (!cholmod.succeeded()) return;
    const cholmod_factor& L = cholmod.factors();
    const auto* order = static_cast<const int*>(L.Perm);
    const auto* first = static_cast<const int*>(L.super);
    const auto* row = static_cast<const int*>(L.pi);
    const auto* entry = static_cast<const int*>(L.px);
    const auto* rows = static_cast<const int*>(L.s);
    const auto* entries = static_cast<const double*>(L.x);
    order_.assign(order, order + L.n);
    row_.assign(rows, rows + L.ssize);
    L_.assign(entries, entries + L.xsize);
    for (std::size_t s = 0; s < L.nsuper; ++s) {
        columns_.push_back({first[s], first[s + 1] - first[s], static_cast<std::size_t>(row[s]),
                            row[s + 1] - row[s], static_cast<std::size_t>(entry[s])});
        most_rows_ = std::max(most_rows_, columns_.back().rows);
    }
}

Eigen::VectorXd DefiniteFactors::solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = b(order_);
    std::vector<double> below(static_cast<std::size_t>(most_rows_));
    for (const Columns& of : columns_) {
        double* const own = x.data() + of.first;
        const int rest = of.rows - of.count;
        const int* const row = row_.data() + of.row + of.count;
        std::fill_n(below.begin(), rest, 0.0);
        for (int j = 0; j < of.count; ++j) {
            const float* const L = column(of, j);
            const double x_j = own[j] /= L[j];
            for (int i = j + 1; i < of.count; ++i) own[i] -= L[i] * x_j;
            const float* const L_below = L + of.count;
#pragma omp simd
            for (int i = 0; i < rest; ++i) below[static_cast<std::size_t>(i)] += L_below[i] * x_j;
        }
        for (int i = 0; i < rest; ++i) x[row[i]] -= below[static_cast<std::size_t>(i)];
    }
    for (std::size_t k = columns_.size(); k-- > 0;) {
        const Columns& of = columns_[k];
        double* const own = x.data() + of.first;
        const int rest = of.rows - of.count;
        const int* const row = row_.data() + of.row + of.count;
        for (int i = 0; i < rest; ++i) below[static_cast<std::size_t>(i)] = x[row[i]];
        for (int j = of.count - 1; j >= 0; --j) {
            const float* const L = column(of, j);
            double sum = own[j];
            for (int i = j + 1; i < of.count; ++i) sum -= L[i] * own[i];
            const float* const L_below = L + of.count;
#pragma omp simd reduction(- : sum)
            for (int i = 0; i < rest; ++i) sum -= L_below[i] * below[static_cast<std::size_t>(i)];
            own[j] = sum / L[j];
        }
    }
    Eigen::VectorXd result(x.size());
    result(order_) = x;
    return result;
}

}  // namespace solvers
