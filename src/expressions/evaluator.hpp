#pragma once

#include <array>

#include "expressions/parser.hpp"

/// How programs are evaluated: for parser.cpp and quad.cpp, which instantiate it.
namespace expressions {

/// A number in a scalar's precision. \param text as in Program::numbers
template <class Scalar>
Scalar number(const std::string& text);

/// The program of a function that is smooth on [0, 1], or on the unit square or cube.
/// \throws base::InvalidInput as smooth() does
Program smooth_program(const std::string& option, const std::string& text,
                       const std::vector<std::string>& variables = {"x"});

/// An operation on one or two jets. The name of a function is what one types; that of an operator is what
/// messages call its result.
template <class T>
struct Operation {
    std::string_view name;
    int arguments = 1;
    Jet<T> (*apply)(const Jet<T>& a, const Jet<T>& b);
};

/// All operations, in the same order for each scalar.
template <class T>
const auto& operations() {
    using A = const Jet<T>&;
    static constexpr std::array<Operation<T>, 23> all{
        {{"the negative", 1, [](A a, A /*unused*/) { return -a; }},
         {"the sum", 2, [](A a, A b) { return a + b; }},
         {"the difference", 2, [](A a, A b) { return a - b; }},
         {"the product", 2, [](A a, A b) { return a * b; }},
         {"the quotient", 2, [](A a, A b) { return a / b; }},
         {"the power", 2, [](A a, A b) { return pow(a, b); }},
         {"sin", 1, [](A a, A /*unused*/) { return sin(a); }},
         {"cos", 1, [](A a, A /*unused*/) { return cos(a); }},
         {"tan", 1, [](A a, A /*unused*/) { return tan(a); }},
         {"asin", 1, [](A a, A /*unused*/) { return asin(a); }},
         {"acos", 1, [](A a, A /*unused*/) { return acos(a); }},
         {"atan", 1, [](A a, A /*unused*/) { return atan(a); }},
         {"sinh", 1, [](A a, A /*unused*/) { return sinh(a); }},
         {"cosh", 1, [](A a, A /*unused*/) { return cosh(a); }},
         {"tanh", 1, [](A a, A /*unused*/) { return tanh(a); }},
         {"exp", 1, [](A a, A /*unused*/) { return exp(a); }},
         {"log", 1, [](A a, A /*unused*/) { return log(a); }},
         {"sqrt", 1, [](A a, A /*unused*/) { return sqrt(a); }},
         {"abs", 1, [](A a, A /*unused*/) { return max(a, -a); }},
         {"atan2", 2, [](A a, A b) { return atan2(a, b); }},
         {"hypot", 2, [](A a, A b) { return hypot(a, b); }},
         {"min", 2, [](A a, A b) { return min(a, b); }},
         {"max", 2, [](A a, A b) { return max(a, b); }}}};
    return all;
}

template <class Scalar>
Evaluator<Scalar>::Evaluator(const Program& program) : steps_(program.steps) {
    for (const std::string& text : program.numbers) numbers_.push_back(number<Scalar>(text));
}

template <class Scalar>
std::vector<Jet<Scalar>> Evaluator<Scalar>::results(std::span<const Scalar> at,
                                                    std::span<const double> direction) const {
    std::vector<Jet<Scalar>> results;
    results.reserve(steps_.size());
    for (const auto& [kind, which, a, b] : steps_) {
        if (kind == Step::Kind::number)
            results.push_back({numbers_[which]});
        else if (kind == Step::Kind::variable)
            results.push_back({at[which], Scalar(!direction.empty() ? direction[which]
                                                 : which == 0       ? 1.0
                                                                    : 0.0)});
        else
            results.push_back(operations<Scalar>()[which].apply(results[a], results[b]));
    }
    return results;
}

template <class Scalar>
base::Smooth<Scalar> smooth(const std::string& option, const std::string& text) {
    const Evaluator<Scalar> jet(smooth_program(option, text));
    return {[jet](const Scalar& x) {
                return jet({&x, 1}).value;
            },
            [jet](const Scalar& x) {
                return jet({&x, 1}).first;
            },
            [jet](const Scalar& x) {
                return jet({&x, 1}).second;
            }};
}

}  // namespace expressions
