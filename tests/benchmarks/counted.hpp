#pragma once

#include <Eigen/Core>
#include <cmath>

/// A number that counts the operations made with its like, so that a formulation counts its own.
namespace benchmarks {

struct Counted {
    double value = 0;
    static inline thread_local long operations = 0;

    Counted() = default;
    Counted(double number) : value(number) {}  // NOLINT(google-explicit-constructor): as numbers convert
    explicit operator double() const { return value; }

    Counted& operator+=(const Counted& b) { return *this = *this + b; }
    Counted& operator-=(const Counted& b) { return *this = *this - b; }
    Counted& operator*=(const Counted& b) { return *this = *this * b; }
    Counted& operator/=(const Counted& b) { return *this = *this / b; }

    static Counted counted(double result) {
        ++operations;
        return result;
    }
    friend Counted operator+(const Counted& a, const Counted& b) {
        return Counted::counted(a.value + b.value);
    }
    friend Counted operator-(const Counted& a, const Counted& b) {
        return Counted::counted(a.value - b.value);
    }
    friend Counted operator*(const Counted& a, const Counted& b) {
        return Counted::counted(a.value * b.value);
    }
    friend Counted operator/(const Counted& a, const Counted& b) {
        return Counted::counted(a.value / b.value);
    }
    friend Counted operator-(const Counted& a) { return -a.value; }
    friend Counted sqrt(const Counted& a) { return Counted::counted(std::sqrt(a.value)); }
    friend Counted abs(const Counted& a) { return std::abs(a.value); }
    friend bool isfinite(const Counted& a) { return std::isfinite(a.value); }
    friend bool operator<(const Counted& a, const Counted& b) { return a.value < b.value; }
    friend bool operator<=(const Counted& a, const Counted& b) { return a.value <= b.value; }
    friend bool operator>(const Counted& a, const Counted& b) { return a.value > b.value; }
    friend bool operator>=(const Counted& a, const Counted& b) { return a.value >= b.value; }
    friend bool operator==(const Counted& a, const Counted& b) { return a.value == b.value; }
    friend bool operator!=(const Counted& a, const Counted& b) { return a.value != b.value; }
};

}  // namespace benchmarks

template <class BinaryOp>
struct Eigen::ScalarBinaryOpTraits<double, benchmarks::Counted, BinaryOp> {
    using ReturnType = benchmarks::Counted;
};

template <>
struct Eigen::NumTraits<benchmarks::Counted> : Eigen::NumTraits<double> {
    using Real = benchmarks::Counted;
    using NonInteger = benchmarks::Counted;
    using Nested = benchmarks::Counted;
};
