#pragma once

#include <string>

#include "base/smooth.hpp"

namespace expressions {

/// What an expression is made of, for --help.
inline constexpr const char* vocabulary =
    "numbers, x, pi, e, + - * / ^ ( ), sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, sqrt";

/// Reads an expression such as `sin(5*x)+x^2` and differentiates it exactly, by GiNaC.
///
/// It knows x, decimal numbers (taken as they are written: 0.1 is 1/10), pi and e, + - * / ^ and parentheses, and sin, cos, tan,
/// asin, acos, atan, sinh, cosh, tanh, exp, log and sqrt. Powers bind before signs, and from the right: -x^2 is -(x^2). GiNaC
/// simplifies as it reads: x/x is 1.
///
/// Guaranteed of what is returned: the value and both derivatives are real and bounded everywhere on [0, 1], not at samples alone.
/// They are bounded on subintervals, by interval arithmetic, halved until this succeeds. What is not bounded over a length of
/// 2⁻⁴⁰ is refused; so is a function with a pole so close to [0, 1], or one that only looks singular, such as sin(x)/x at 0. Equal
/// arguments give equal bytes in every run.
/// \param option what the text belongs to, for messages
/// \throws base::InvalidInput, in one line, naming the character that cannot be read, or the place where the function or
///         a derivative is not bounded
template <class Scalar = double>
base::Smooth<Scalar> expression(const std::string& option, const std::string& text);

}  // namespace expressions
