#pragma once

#include <Eigen/Core>

#if __cplusplus < 202002L
#error "particle-methods is written in C++20: compile with -std=c++20"
#endif

// Bytes of a vector register, which Packs fill and to which Eigen aligns memory. Both must be alike in a program and in
// the library that it links, whatever flags they were compiled with: `make install` writes the library's number above.
#ifndef PARTICLE_METHODS_REGISTER
#if defined(__AVX512F__)
#define PARTICLE_METHODS_REGISTER 64
#elif defined(__AVX__)
#define PARTICLE_METHODS_REGISTER 32
#else
#define PARTICLE_METHODS_REGISTER 16
#endif
#endif
#define PARTICLE_METHODS_TEXT(number) #number
#define PARTICLE_METHODS_FLAG(number) "compile with -DEIGEN_MAX_ALIGN_BYTES=" PARTICLE_METHODS_TEXT(number)
static_assert(EIGEN_MAX_ALIGN_BYTES == PARTICLE_METHODS_REGISTER,
              "particle-methods was compiled for other vector registers; " PARTICLE_METHODS_FLAG(
                  PARTICLE_METHODS_REGISTER) ", as pkg-config --cflags particle-methods says");

namespace base {

/// Numbers in a vector register.
inline constexpr int numbers_in_register = PARTICLE_METHODS_REGISTER / static_cast<int>(sizeof(double));

}  // namespace base

#undef PARTICLE_METHODS_TEXT
#undef PARTICLE_METHODS_FLAG
