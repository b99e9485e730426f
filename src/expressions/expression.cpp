#include "expressions/expression.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/quad.hpp"
#include "base/text.hpp"
#include "expressions/interval.hpp"

namespace expressions {

using base::InvalidInput;
using base::Quad;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

// A reader's function is far smaller; a hostile one ends here.
constexpr std::size_t most_characters = 1000, most_terms = 50000;
constexpr const char* too_long = "the second derivative has too many terms; take a shorter one";
constexpr int deepest = 50, largest_exponent = 300;
constexpr double most_bits = 4096;
constexpr long most_work = 50'000'000;  // instructions with intervals, about a second

/// A function by its name, in both papers' and GiNaC's spelling: its symbol, its value in each precision, its bounds.
struct Function {
    std::string_view name;
    ex (*symbol)(const ex&);
    std::tuple<double (*)(double), long double (*)(long double), Quad (*)(Quad)> values;
    Bounds (*bounds)(const Interval&);

    template <class Scalar>
    [[nodiscard]] Scalar value(const Scalar& a) const {
        return std::get<Scalar (*)(Scalar)>(values)(a);
    }
};

/// One function in each precision.
template <class Of>
auto in_each(Of of) {
    return decltype(Function::values)(of, of, of);
}

const std::array<Function, 11>& functions() {
    static const std::array<Function, 11> all{{
        {"sin", [](const ex& a) -> ex { return sin(a); }, in_each([](auto a) -> decltype(a) {
             using std::sin;
             return sin(a);
         }),
         interval::sin},
        {"cos", [](const ex& a) -> ex { return cos(a); }, in_each([](auto a) -> decltype(a) {
             using std::cos;
             return cos(a);
         }),
         interval::cos},
        {"tan", [](const ex& a) -> ex { return tan(a); }, in_each([](auto a) -> decltype(a) {
             using std::tan;
             return tan(a);
         }),
         interval::tan},
        {"asin", [](const ex& a) -> ex { return asin(a); }, in_each([](auto a) -> decltype(a) {
             using std::asin;
             return asin(a);
         }),
         interval::asin},
        {"acos", [](const ex& a) -> ex { return acos(a); }, in_each([](auto a) -> decltype(a) {
             using std::acos;
             return acos(a);
         }),
         interval::acos},
        {"atan", [](const ex& a) -> ex { return atan(a); }, in_each([](auto a) -> decltype(a) {
             using std::atan;
             return atan(a);
         }),
         interval::atan},
        {"sinh", [](const ex& a) -> ex { return sinh(a); }, in_each([](auto a) -> decltype(a) {
             using std::sinh;
             return sinh(a);
         }),
         interval::sinh},
        {"cosh", [](const ex& a) -> ex { return cosh(a); }, in_each([](auto a) -> decltype(a) {
             using std::cosh;
             return cosh(a);
         }),
         interval::cosh},
        {"tanh", [](const ex& a) -> ex { return tanh(a); }, in_each([](auto a) -> decltype(a) {
             using std::tanh;
             return tanh(a);
         }),
         interval::tanh},
        {"exp", [](const ex& a) -> ex { return exp(a); }, in_each([](auto a) -> decltype(a) {
             using std::exp;
             return exp(a);
         }),
         interval::exp},
        {"log", [](const ex& a) -> ex { return log(a); }, in_each([](auto a) -> decltype(a) {
             using std::log;
             return log(a);
         }),
         interval::log},
    }};
    return all;
}

const Function* function_named(std::string_view name) {
    const auto* const found = std::find_if(functions().begin(), functions().end(),
                                           [&](const Function& function) { return function.name == name; });
    return found == functions().end() ? nullptr : found;
}

/// The text as one line of a message shows it.
std::string quoted(std::string text) {
    constexpr std::size_t longest = 80;
    if (text.size() > longest) {
        std::size_t end = longest;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
            --end;  // whole characters
        text.resize(end);
        text += "...";
    }
    for (char& letter : text)
        if (std::iscntrl(static_cast<unsigned char>(letter)) != 0) letter = '?';
    return "'" + text + "'";
}

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}
bool is_letter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}

/// The most bits that a number within an expression takes; a power has as many times its exponent.
double bits(const ex& of) {
    double most = 0;
    for (auto part = of.preorder_begin(); part != of.preorder_end(); ++part)
        if (GiNaC::is_a<numeric>(*part)) {
            const auto& number = GiNaC::ex_to<numeric>(*part);
            if (number.is_rational())
                most = std::max<double>(
                    {most, double(number.numer().int_length()), double(number.denom().int_length())});
        }
    return most;
}

/// Reads an expression from left to right, by recursive descent. GiNaC's own parser says less of what it cannot read, and takes
/// more than we want.
class Parser {
  public:
    Parser(std::string_view text, GiNaC::realsymbol x) : text_(text), x_(std::move(x)) {}

    ex parsed() {
        if (text_.size() > most_characters)
            throw InvalidInput(std::to_string(text_.size()) + " characters are too many; take at most " +
                               std::to_string(most_characters));
        ex all = sum();
        if (letter() == ')') fail("')' without a '('");
        if (at_ < text_.size()) fail("an operator or the end expected");
        return all;
    }

  private:
    [[noreturn]] static void fail(const std::string& why, std::size_t at, const std::string& remedy = "") {
        throw InvalidInput(why + " at character " + std::to_string(at + 1) + remedy);
    }
    [[noreturn]] void fail(const std::string& why) const { fail(why, at_); }

    /// The next character that is no blank; zero at the end.
    char letter() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char wanted) {
        if (letter() != wanted) return false;
        ++at_;
        return true;
    }
    [[nodiscard]] bool digit_at(std::size_t at) const { return at < text_.size() && is_digit(text_[at]); }

    /// What GiNaC makes of a step, which it refuses to take at a pole.
    template <class Step>
    static ex evaluated(std::size_t at, const char* what, const Step& step) {
        try {
            ex result = step();
            for (auto part = result.preorder_begin(); part != result.preorder_end(); ++part)
                if (GiNaC::is_a<numeric>(*part) && !GiNaC::ex_to<numeric>(*part).is_real())
                    fail(std::string(what) + " is not real", at);
            return result;
        } catch (const InvalidInput&) {
            throw;
        } catch (const std::exception&) {  // a pole: GiNaC's words name its own functions
            fail(std::string(what) + " has no finite value", at);
        }
    }

    ex sum() {
        ex all = product();
        for (char sign = letter(); sign == '+' || sign == '-'; sign = letter()) {
            ++at_;
            const ex next = product();
            all = sign == '+' ? ex(all + next) : ex(all - next);
        }
        return all;
    }

    ex product() {
        ex all = factor();
        for (char sign = letter(); sign == '*' || sign == '/'; sign = letter()) {
            const std::size_t at = at_++;
            const ex next = factor();
            all = sign == '*' ? ex(all * next) : evaluated(at, "the quotient", [&] { return all / next; });
        }
        return all;
    }

    ex factor() {
        if (++depth_ > deepest) fail("nested more than " + std::to_string(deepest) + " deep");
        ex all;
        if (take('+')) {
            all = factor();
        } else if (take('-')) {
            all = -factor();
        } else {
            all = operand();
            const char next = letter();
            const std::size_t at = at_;
            if (next == '^') {
                ++at_;
                all = power(all, factor(), at);
            }
        }
        --depth_;
        return all;
    }

    static ex power(const ex& base, const ex& exponent, std::size_t at) {
        if (base.is_equal(exp(ex(1)))) return exp(exponent);
        if (GiNaC::is_a<numeric>(exponent)) {
            const auto& number = GiNaC::ex_to<numeric>(exponent);
            const bool small = bits(exponent) < most_bits / 4;
            if (!small || std::abs(number.to_double()) * bits(base) > most_bits)
                fail("the power is too large", at);
        }
        return evaluated(at, "the power", [&] { return pow(base, exponent); });
    }

    ex operand() {
        const char first = letter();
        if (is_digit(first) || (first == '.' && digit_at(at_ + 1))) return number();
        if (is_letter(first)) return name();
        if (!take('(')) fail("a number, x, a function or '(' expected");
        return closed();
    }

    /// What is left of a pair of parentheses.
    ex closed() {
        ex inner = sum();
        if (!take(')')) {
            if (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '('))
                fail("an operator or ')' expected");
            fail("')' expected");
        }
        return inner;
    }

    ex number() {
        const std::size_t start = at_;
        std::string digits;
        int exponent = 0;
        while (digit_at(at_)) digits += text_[at_++];
        if (at_ < text_.size() && text_[at_] == '.')
            for (++at_; digit_at(at_); --exponent) digits += text_[at_++];
        if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
            const bool sign = at_ + 1 < text_.size() && (text_[at_ + 1] == '+' || text_[at_ + 1] == '-');
            const std::size_t from = at_ + (sign ? 2 : 1);
            if (digit_at(from)) {
                int read = 0;
                const bool negative = text_[at_ + 1] == '-';
                for (at_ = from; digit_at(at_); ++at_)
                    read = std::min(10 * read + (text_[at_] - '0'), 10 * largest_exponent);
                exponent += negative ? -read : read;
            }
        }
        if (std::abs(exponent) > largest_exponent || digits.size() > largest_exponent)
            fail("a number is too long", start);
        digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));  // else octal
        return numeric(digits.c_str()) * pow(numeric(10), exponent);
    }

    ex name() {
        const std::size_t start = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        const std::string word(text_.substr(start, at_ - start));
        if (word == "x") return x_;
        if (word == "pi") return GiNaC::Pi;
        if (word == "e") return exp(ex(1));
        if (word == "abs")
            fail("abs", start, ": it has no derivative where its argument is zero; take a smooth function");
        const Function* const function = function_named(word);
        if (function == nullptr && word != "sqrt") {
            std::string known = "x, pi, e";
            for (const Function& each : functions()) known += ", " + std::string(each.name);
            fail("there is no " + quoted(word), start, "; choose among " + known + ", sqrt");
        }
        if (!take('(')) fail("'(' expected after " + word);
        const ex argument = closed();
        return evaluated(start, word.c_str(),
                         [&] { return function != nullptr ? function->symbol(argument) : sqrt(argument); });
    }

    std::string_view text_;
    GiNaC::realsymbol x_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

/// A constant, rounded once for each precision.
struct Number {
    double rounded = 0;
    Quad precise = 0;

    template <class Scalar>
    [[nodiscard]] Scalar in() const {
        if constexpr (std::is_same_v<Scalar, double>)
            return rounded;
        else
            return static_cast<Scalar>(precise);
    }
};

/// One step of an evaluation: operands are results of earlier steps.
struct Instruction {
    enum class Kind { number, argument, minus, plus, less, times, power, raise, call };
    Kind kind = Kind::number;
    std::size_t a = 0, b = 0;
    Number number{};                     ///< of `number`, and the exponent of `power`
    const Function* function = nullptr;  ///< of `call`
};
using Kind = Instruction::Kind;

/// Steps in their order; the last one's result is the value.
using Program = std::vector<Instruction>;

/// Turns what GiNaC holds into steps. GiNaC orders the terms of sums and products by addresses, which differ from run to run, and
/// with them the sign that it draws out of a power of a sum. Here terms are ordered by what they are, and signs are kept apart
/// from sizes, so that round-off is the same in every run.
class Compiler {
  public:
    explicit Compiler(GiNaC::realsymbol x) : x_(std::move(x)) {}

    Program compiled(const ex& of) {
        const std::size_t last = signed_result(term(of));
        program_.resize(last + 1);  // behind it there may be a number that was a sign alone
        return std::move(program_);
    }

  private:
    /// ± the result of a step, and a key to what it computes.
    struct Term {
        std::size_t step;
        bool negative;
        std::uint64_t key;
    };

    static std::uint64_t mixed(std::uint64_t key, std::uint64_t with) {  // a round of SplitMix64
        key = (key ^ with) + 0x9E3779B97F4A7C15U;
        key = (key ^ (key >> 30U)) * 0xBF58476D1CE4E5B9U;
        key = (key ^ (key >> 27U)) * 0x94D049BB133111EBU;
        return key ^ (key >> 31U);
    }
    static std::uint64_t key_of(Kind kind, std::initializer_list<std::uint64_t> parts) {
        std::uint64_t key = static_cast<std::uint64_t>(kind) + 1;
        for (const std::uint64_t part : parts) key = mixed(key, part);
        return key;
    }

    std::size_t add(const Instruction& step) {
        if (program_.size() >= most_terms) throw InvalidInput(too_long);
        program_.push_back(step);
        return program_.size() - 1;
    }
    std::size_t signed_result(const Term& of) { return of.negative ? add({Kind::minus, of.step}) : of.step; }
    static std::uint64_t signed_key(const Term& of) { return mixed(of.key, of.negative ? 1 : 0); }

    Term term(const ex& of) {
        const auto known = known_.find(of);
        if (known != known_.end()) return known->second;
        const Term made = new_term(of);
        known_.emplace(of, made);
        return made;
    }

    Term new_term(const ex& of) {
        if (of.is_equal(x_)) return {add({Kind::argument}), false, key_of(Kind::argument, {})};
        if (GiNaC::is_a<numeric>(of)) return number(value_of(of));
        if (of.is_equal(GiNaC::Pi)) return number({std::numbers::pi, acos(Quad(-1))});
        if (GiNaC::is_a<GiNaC::add>(of)) return sum(sorted(of));
        if (GiNaC::is_a<GiNaC::mul>(of)) return product(sorted(of));
        if (GiNaC::is_a<GiNaC::power>(of)) return power(of.op(0), of.op(1));
        const Function* const function = GiNaC::is_a<GiNaC::function>(of) && of.nops() == 1
                                             ? function_named(GiNaC::ex_to<GiNaC::function>(of).get_name())
                                             : nullptr;
        if (function == nullptr) throw InvalidInput("has a derivative that is not known");
        const Term argument = term(of.op(0));
        const auto which = static_cast<std::uint64_t>(function - functions().data());
        return {add({Kind::call, signed_result(argument), 0, {}, function}), false,
                key_of(Kind::call, {which, signed_key(argument)})};
    }

    static Number value_of(const ex& of) {
        const auto& number = GiNaC::ex_to<numeric>(of);
        Number value{std::numeric_limits<double>::quiet_NaN()};
        try {
            if (number.is_rational())
                value = {number.to_double(), in_quad(number.numer()) / in_quad(number.denom())};
        } catch (const std::exception&) {  // beyond the range of a double
        }
        if (!std::isfinite(value.rounded)) throw InvalidInput("a number is too large or not real");
        return value;
    }
    static Quad in_quad(const numeric& whole) {
        std::ostringstream digits;
        digits << whole;
        return Quad(digits.str());
    }

    Term number(const Number& value) {
        const Number size{std::abs(value.rounded), abs(value.precise)};
        return {add({Kind::number, 0, 0, size}), std::signbit(value.rounded), number_key(size.rounded)};
    }
    static std::uint64_t number_key(double size) {
        return key_of(Kind::number, {std::bit_cast<std::uint64_t>(size)});
    }

    /// The terms of a sum or the factors of a product, ordered by what they are.
    std::vector<Term> sorted(const ex& of) {
        std::vector<Term> terms;
        for (std::size_t k = 0; k < of.nops(); ++k) terms.push_back(term(of.op(k)));
        std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.key < b.key; });
        return terms;
    }

    /// The sign of the first term is drawn out.
    Term sum(const std::vector<Term>& terms) {
        const bool negative = terms.front().negative;
        Term all{terms.front().step, negative, key_of(Kind::plus, {terms.front().key})};
        for (std::size_t k = 1; k < terms.size(); ++k) {
            const bool opposite = terms[k].negative != negative;
            all.step = add({opposite ? Kind::less : Kind::plus, all.step, terms[k].step});
            all.key = mixed(mixed(all.key, terms[k].key), opposite ? 1 : 0);
        }
        return all;
    }

    /// A sign is no factor: -x and x differ in it alone.
    Term product(std::vector<Term> factors) {
        const std::uint64_t one = number_key(1);
        const auto unit = std::find_if(factors.begin(), factors.end(),
                                       [&](const Term& factor) { return factor.key == one; });
        const bool opposite = unit != factors.end() && unit->negative;
        if (unit != factors.end()) factors.erase(unit);
        Term all = factors.front();
        all.negative = all.negative != opposite;
        for (std::size_t k = 1; k < factors.size(); ++k) {
            all.step = add({Kind::times, all.step, factors[k].step});
            all.negative = all.negative != factors[k].negative;
            all.key = key_of(Kind::times, {all.key, factors[k].key});
        }
        return all;
    }

    Term power(const ex& of, const ex& exponent) {
        const Term base = term(of);
        if (!GiNaC::is_a<numeric>(exponent)) {
            const Term by = term(exponent);
            return {add({Kind::raise, signed_result(base), signed_result(by)}), false,
                    key_of(Kind::raise, {signed_key(base), signed_key(by)})};
        }
        const Number by = value_of(exponent);
        const auto key = std::bit_cast<std::uint64_t>(by.rounded);
        if (GiNaC::ex_to<numeric>(exponent).is_integer())
            return {add({Kind::power, base.step, 0, by}),
                    base.negative && GiNaC::ex_to<numeric>(exponent).is_odd(),
                    key_of(Kind::power, {base.key, key})};
        return {add({Kind::power, signed_result(base), 0, by}), false,
                key_of(Kind::power, {signed_key(base), key})};
    }

    GiNaC::realsymbol x_;
    Program program_;
    std::map<ex, Term, GiNaC::ex_is_less> known_;
};

template <class Scalar>
Scalar value(const Program& program, const Scalar& x) {
    using std::pow;
    std::vector<Scalar> result(program.size());
    for (std::size_t k = 0; k < program.size(); ++k) {
        const auto& [kind, a, b, number, function] = program[k];
        switch (kind) {
            case Kind::number:
                result[k] = number.template in<Scalar>();
                break;
            case Kind::argument:
                result[k] = x;
                break;
            case Kind::minus:
                result[k] = -result[a];
                break;
            case Kind::plus:
                result[k] = result[a] + result[b];
                break;
            case Kind::less:
                result[k] = result[a] - result[b];
                break;
            case Kind::times:
                result[k] = result[a] * result[b];
                break;
            case Kind::power:
                result[k] = pow(result[a], number.template in<Scalar>());
                break;
            case Kind::raise:
                result[k] = pow(result[a], result[b]);
                break;
            case Kind::call:
                result[k] = function->value(result[a]);
                break;
        }
    }
    return result.back();
}

/// Whether all steps are bounded over an interval of x. \param results room for them
bool bounded(const Program& program, const Interval& x, std::vector<Interval>& results) {
    for (std::size_t k = 0; k < program.size(); ++k) {
        const auto& [kind, a, b, number, function] = program[k];
        Bounds step;
        switch (kind) {
            case Kind::number:
                step = Interval{number.rounded, number.rounded};
                break;
            case Kind::argument:
                step = x;
                break;
            case Kind::minus:
                step = interval::minus(results[a]);
                break;
            case Kind::plus:
                step = interval::plus(results[a], results[b]);
                break;
            case Kind::less:
                step = interval::plus(results[a], interval::minus(results[b]));
                break;
            case Kind::times:
                step = interval::times(results[a], results[b]);
                break;
            case Kind::power:
                step = interval::power(results[a], number.rounded);
                break;
            case Kind::raise:
                step = interval::power(results[a], results[b]);
                break;
            case Kind::call:
                step = function->bounds(results[a]);
                break;
        }
        if (!step) return false;
        results[k] = *step;
    }
    return true;
}

/// \throws InvalidInput naming a place of [0, 1] where the function is not bounded. \param what the function or a derivative
void check_bounded(const Program& program, const std::string& what) {
    const double narrowest = std::exp2(-40);
    std::vector<Interval> results(program.size()), pieces{{0, 1}};
    for (long work = 0; !pieces.empty();) {
        const Interval piece = pieces.back();
        pieces.pop_back();
        work += static_cast<long>(program.size());
        if (bounded(program, piece, results)) continue;
        const double middle = piece.lower + (piece.upper - piece.lower) / 2;
        if (piece.upper - piece.lower > narrowest && work < most_work) {
            pieces.push_back({middle, piece.upper});
            pieces.push_back({piece.lower, middle});
            continue;
        }
        const double place = piece.lower == 0 ? 0 : piece.upper == 1 ? 1 : middle;
        throw InvalidInput(what + " is not real and bounded near x = " + base::shown(place, 4) +
                           "; take one that is smooth on [0, 1]");
    }
}

/// Number of terms of an expression, counted up to the bound.
std::size_t terms(const ex& of) {
    std::size_t count = 0;
    for (auto part = of.preorder_begin(); part != of.preorder_end() && count <= most_terms; ++part) ++count;
    return count;
}

template <class Scalar>
std::function<Scalar(const Scalar&)> callable(Program program) {
    return [program = std::move(program)](const Scalar& x) { return value(program, x); };
}

}  // namespace

template <class Scalar>
base::Smooth<Scalar> expression(const std::string& option, const std::string& text) {
    try {
        const GiNaC::realsymbol x("x");
        const std::array<const char*, 3> what{"the function", "its first derivative",
                                              "its second derivative"};
        std::array<std::function<Scalar(const Scalar&)>, 3> derivative;
        ex of = Parser(text, x).parsed();
        for (std::size_t k = 0; k < derivative.size(); ++k) {
            if (k > 0) try {
                    of = of.diff(x);
                } catch (const std::exception&) {  // GiNaC's words name its own functions
                    throw InvalidInput(std::string(what[k]) + " does not exist on [0, 1]");
                }
            if (terms(of) > most_terms) throw InvalidInput(too_long);
            Program program = Compiler(x).compiled(of);
            check_bounded(program, what[k]);
            derivative[k] = callable<Scalar>(std::move(program));
        }
        return {derivative[0], derivative[1], derivative[2]};
    } catch (const InvalidInput& error) {
        throw InvalidInput(option + ": " + quoted(text) + " : " + error.what());
    }
}

template base::Smooth<double> expression(const std::string&, const std::string&);
template base::Smooth<long double> expression(const std::string&, const std::string&);
template base::Smooth<Quad> expression(const std::string&, const std::string&);

}  // namespace expressions
