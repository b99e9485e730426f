#pragma once

// The functions of LAPACK that the programs call, with its names and arguments: lapack.cpp.
using lapack_int = int;
inline constexpr int LAPACK_COL_MAJOR = 102;

extern "C" {
lapack_int LAPACKE_dgbtrf_work(int layout, lapack_int m, lapack_int n, lapack_int kl, lapack_int ku,
                               double* ab, lapack_int ldab, lapack_int* ipiv);
lapack_int LAPACKE_dgbtrs_work(int layout, char trans, lapack_int n, lapack_int kl, lapack_int ku,
                               lapack_int nrhs, const double* ab, lapack_int ldab, const lapack_int* ipiv,
                               double* b, lapack_int ldb);
lapack_int LAPACKE_dgeev(int layout, char jobvl, char jobvr, lapack_int n, double* a, lapack_int lda,
                         double* wr, double* wi, double* vl, lapack_int ldvl, double* vr, lapack_int ldvr);
lapack_int LAPACKE_dsygv(int layout, lapack_int itype, char jobz, char uplo, lapack_int n, double* a,
                         lapack_int lda, double* b, lapack_int ldb, double* w);
lapack_int LAPACKE_dsyev(int layout, char jobz, char uplo, lapack_int n, double* a, lapack_int lda,
                         double* w);
}
