#include "solvers/sparse_lu.hpp"

namespace solvers {

template class SparseLU<base::Quad>;

}  // namespace solvers
