#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/smooth.hpp"
#include "expressions/jet.hpp"

/// Functions typed as text, such as `sin(5*x)+x^2`, with their first and second derivatives.
namespace expressions {

/// One step of an evaluation: a number, a variable, or an operation on results of earlier steps.
struct Step {
    enum class Kind { number, variable, operation };
    Kind kind{};
    std::size_t which = 0;     ///< number, variable or operation, by its place in its list
    std::size_t a = 0, b = 0;  ///< the steps that an operation takes
};

/// A parsed expression: its steps in order. The last step's result is the value.
struct Program {
    std::vector<Step> steps;
    std::vector<std::string> numbers;  ///< a whole number and a power of ten: 1.5 is 15e-1
};

/// What an expression is made of, for --help. \param variables their names, with commas between
std::string vocabulary(const std::string& variables = "x");

/// Reads an expression of variables, decimal numbers, pi and e, with + - * / ^, parentheses and functions.
/// Powers bind before signs, and from the right: -x^2 is -(x^2).
/// \param variables their names; the steps of a variable refer to its place in this list
/// \throws base::InvalidInput naming the character that cannot be read, or at which a constant part such as
///         1/0 has no value
Program parsed(std::string_view text, const std::vector<std::string>& variables = {"x"});

/// The expressions of a list. Commas separate them, except within parentheses.
std::vector<std::string> separated(std::string_view list);

/// Evaluates a program.
/// \tparam Scalar double, long double, base::Quad or Interval
template <class Scalar>
class Evaluator {
  public:
    explicit Evaluator(const Program& program);

    /// Value and derivatives. \param at the variables; derivatives are those in the first of them
    [[nodiscard]] Jet<Scalar> operator()(std::span<const Scalar> at) const { return results(at).back(); }

    /// The results of all steps.
    /// \param direction e of the derivatives \f$e\cdot\nabla f,\ e^T (\nabla\nabla f)\,e\f$, an entry for
    ///        each variable; empty for that of the first
    [[nodiscard]] std::vector<Jet<Scalar>> results(std::span<const Scalar> at,
                                                   std::span<const double> direction = {}) const;

  private:
    std::vector<Step> steps_;
    std::vector<Scalar> numbers_;
};

/// A function of x with its derivatives. All three are real and bounded everywhere on [0, 1], not at samples
/// alone: they are evaluated on subintervals, which are halved until the results are bounded (Interval).
///
/// A function that is not bounded on a subinterval of length 2⁻⁴⁰ is refused. So are functions that only
/// look singular, such as sin(x)/x at 0, and kinks: min and max where their arguments meet, abs at zero.
/// \tparam Scalar double, long double or base::Quad
/// \param option what the text belongs to, for messages
/// \throws base::InvalidInput, in one line, as parsed() does, or naming the place where the function or a
///         derivative is not bounded
template <class Scalar = double>
base::Smooth<Scalar> smooth(const std::string& option, const std::string& text);

/// A function of several variables with its derivatives along a direction: from those along the axes and
/// between them follow all derivatives up to the second.
/// \param at the variables \param direction an entry for each of them
using Directional = std::function<Jet<double>(std::span<const double> at, std::span<const double> direction)>;

/// \param variables their names, such as x and y
/// \throws base::InvalidInput as parsed() does
Directional directional(const std::string& option, const std::string& text,
                        const std::vector<std::string>& variables);

/// Refuses a function that is not smooth on the unit square or cube, as smooth() does on [0, 1].
void require_smooth(const std::string& option, const std::string& text,
                    const std::vector<std::string>& variables);

}  // namespace expressions
