#pragma once

namespace solvers {

/// Makes OpenBLAS use one thread. This package runs its threads on particles and on cases; threads of BLAS
/// below them would make the order of sums, and so the last digits, depend on their number.
void use_one_blas_thread();

/// The same in a process that is not ours: until the end of its life.
class OneBlasThread {
  public:
    OneBlasThread();
    ~OneBlasThread();
    OneBlasThread(const OneBlasThread&) = delete;
    OneBlasThread& operator=(const OneBlasThread&) = delete;

  private:
    int before_;
};

}  // namespace solvers
