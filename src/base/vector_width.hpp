#pragma once

#include <Eigen/Core>

#if __cplusplus < 202002L
#error "particle-methods is written in C++20: compile with -std=c++20"
#endif

// A program and the library that it links may be compiled for different vector registers. Eigen's memory must
// be aligned alike in both, and Packs must be as wide; `make install` writes the library's width above.
static_assert(
    EIGEN_MAX_ALIGN_BYTES == 64 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16,
    "compile with -DEIGEN_MAX_ALIGN_BYTES=64 -DEIGEN_MAX_STATIC_ALIGN_BYTES=16, as pkg-config --cflags particle-methods says");
#ifndef PARTICLE_METHODS_REGISTER
#if defined(__AVX512F__)
#define PARTICLE_METHODS_REGISTER 64
#elif defined(__AVX__)
#define PARTICLE_METHODS_REGISTER 32
#else
#define PARTICLE_METHODS_REGISTER 16
#endif
#endif

namespace base {

/// Numbers in a vector register, whose bytes are PARTICLE_METHODS_REGISTER.
inline constexpr int numbers_in_register = PARTICLE_METHODS_REGISTER / static_cast<int>(sizeof(double));

}  // namespace base
