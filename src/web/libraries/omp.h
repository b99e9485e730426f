#pragma once

// OpenMP on one thread, which is what a browser's page has.
inline void omp_set_num_threads(int /*count*/) {}
inline int omp_get_max_threads() {
    return 1;
}
