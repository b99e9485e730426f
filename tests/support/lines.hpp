#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "asprone2010/section_5_numerical_tests.hpp"
#include "report/statistics.hpp"
#include "tests/support/relative.hpp"

/// Functions that several tests share.
namespace support {

using asprone2010::Column;
using particles::Index;

/// A function without symmetries, and its derivatives.
struct Wave {
    static double B(double x) { return std::exp(x) + std::cos(2 * x); }
    static double DB(double x) { return std::exp(x) - 2 * std::sin(2 * x); }
    static double D2B(double x) { return std::exp(x) - 4 * std::cos(2 * x); }
};

inline asprone2010::numerical_tests::Particles<double> particles_of(
    Index N, const asprone2010::numerical_tests::Discretisation& how = {}, unsigned long seed = 1) {
    return asprone2010::numerical_tests::discretise<double>(how, N, seed);
}

/// Σ_j w_j [B(x_j) − B(x_i)] for particle i of a line. \param near the particles that the weights belong to
template <class Function>
double sum_of_differences(const Column<double>& weights, const particles::Line<double>& line,
                          const particles::Range& near, Index i, const Function& B) {
    double sum = 0;
    for (Index k = 0; k < weights.size(); ++k)
        sum += weights[k] * (B(line.x()[near.first + k]) - B(line.x()[i]));
    return sum;
}

/// Σ_j w_j B(x_j). \param near the particles that the weights belong to
template <class Function>
double sum_of_values(const Column<double>& weights, const particles::Line<double>& line,
                     const particles::Range& near, const Function& B) {
    double sum = 0;
    for (Index k = 0; k < weights.size(); ++k) sum += weights[k] * B(line.x()[near.first + k]);
    return sum;
}

}  // namespace support
