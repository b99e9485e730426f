#pragma once

#include "distributed/petsc.hpp"
#include "distributed/processes.hpp"

namespace support {

/// All processes of the test runner.
inline distributed::Processes world() {
    return distributed::Processes(PETSC_COMM_WORLD);
}

}  // namespace support
