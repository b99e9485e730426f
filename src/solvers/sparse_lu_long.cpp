#include "solvers/sparse_lu.hpp"

namespace solvers {

template class SparseLU<long double>;

}  // namespace solvers
