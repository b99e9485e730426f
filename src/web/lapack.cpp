#include <lapacke.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

// The functions of LAPACK and OpenBLAS that the programs call, by Eigen: column by column, without right-hand
// sides beyond the first, and without eigenvectors.

namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Eigenvalues = Eigen::Map<Eigen::VectorXd>;

Matrix matrix(double* a, lapack_int n, lapack_int lda) {
    return {a, n, n, Eigen::OuterStride<>(lda)};
}

}  // namespace

/// Gaussian elimination with row exchanges, one column after another.
lapack_int LAPACKE_dgbtrf_work(int /*layout*/, lapack_int /*m*/, lapack_int n, lapack_int kl, lapack_int ku,
                               double* ab, lapack_int ldab, lapack_int* ipiv) {
    const lapack_int diagonal = kl + ku;
    const auto entry = [=](lapack_int i, lapack_int j) { return ab + (diagonal + i - j) + j * ldab; };
    lapack_int zero_pivot = 0;
    for (lapack_int j = 0; j < n; ++j) {
        const lapack_int below = std::min(kl, n - 1 - j), last = std::min(j + diagonal, n - 1);
        Eigen::Map<Eigen::VectorXd> column(entry(j, j), below + 1);
        Eigen::Index pivot = 0;
        column.cwiseAbs().maxCoeff(&pivot);
        ipiv[j] = j + static_cast<lapack_int>(pivot);
        if (column[pivot] == 0) {
            if (zero_pivot == 0) zero_pivot = j + 1;
            continue;
        }
        for (lapack_int k = j; k <= last; ++k) std::swap(*entry(j, k), *entry(ipiv[j], k));
        column.tail(below) /= column[0];
        for (lapack_int k = j + 1; k <= last; ++k)
            Eigen::Map<Eigen::VectorXd>(entry(j, k), below + 1).tail(below) -=
                *entry(j, k) * column.tail(below);
    }
    return zero_pivot;
}

lapack_int LAPACKE_dgbtrs_work(int /*layout*/, char trans, lapack_int n, lapack_int kl, lapack_int ku,
                               lapack_int /*nrhs*/, const double* ab, lapack_int ldab, const lapack_int* ipiv,
                               double* b, lapack_int /*ldb*/) {
    const lapack_int diagonal = kl + ku;
    const auto column = [=](lapack_int first, lapack_int j, lapack_int count) {
        return Eigen::Map<const Eigen::VectorXd>(ab + (diagonal + first - j) + j * ldab, count);
    };
    const auto below = [=](lapack_int j) { return std::min(kl, n - 1 - j); };
    const auto above = [=](lapack_int j) { return std::min(diagonal, j); };
    Eigen::Map<Eigen::VectorXd> x(b, n);
    if (trans == 'N') {
        for (lapack_int j = 0; j < n; ++j) {
            std::swap(x[j], x[ipiv[j]]);
            x.segment(j + 1, below(j)) -= x[j] * column(j + 1, j, below(j));
        }
        for (lapack_int j = n - 1; j >= 0; --j) {
            x[j] /= column(j, j, 1)[0];
            x.segment(j - above(j), above(j)) -= x[j] * column(j - above(j), j, above(j));
        }
    } else {
        for (lapack_int j = 0; j < n; ++j)
            x[j] = (x[j] - column(j - above(j), j, above(j)).dot(x.segment(j - above(j), above(j)))) /
                   column(j, j, 1)[0];
        for (lapack_int j = n - 1; j >= 0; --j) {
            x[j] -= column(j + 1, j, below(j)).dot(x.segment(j + 1, below(j)));
            std::swap(x[j], x[ipiv[j]]);
        }
    }
    return 0;
}

lapack_int LAPACKE_dgeev(int /*layout*/, char /*jobvl*/, char /*jobvr*/, lapack_int n, double* a,
                         lapack_int lda, double* wr, double* wi, double* /*vl*/, lapack_int /*ldvl*/,
                         double* /*vr*/, lapack_int /*ldvr*/) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix(a, n, lda), false);
    if (solver.info() != Eigen::Success) return 1;
    Eigenvalues(wr, n) = solver.eigenvalues().real();
    Eigenvalues(wi, n) = solver.eigenvalues().imag();
    return 0;
}

lapack_int LAPACKE_dsygv(int /*layout*/, lapack_int /*itype*/, char /*jobz*/, char /*uplo*/, lapack_int n,
                         double* a, lapack_int lda, double* b, lapack_int ldb, double* w) {
    if (Eigen::LLT<Eigen::MatrixXd>(matrix(b, n, ldb)).info() != Eigen::Success) return n + 1;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        matrix(a, n, lda), matrix(b, n, ldb), Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success) return 1;
    Eigenvalues(w, n) = solver.eigenvalues();
    return 0;
}

lapack_int LAPACKE_dsyev(int /*layout*/, char /*jobz*/, char /*uplo*/, lapack_int n, double* a,
                         lapack_int lda, double* w) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix(a, n, lda), Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success) return 1;
    Eigenvalues(w, n) = solver.eigenvalues();
    return 0;
}

extern "C" void openblas_set_num_threads(int /*threads*/) {}
extern "C" int openblas_get_num_threads() {
    return 1;
}
