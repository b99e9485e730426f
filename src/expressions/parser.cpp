#include "expressions/parser.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

#include "base/errors.hpp"
#include "expressions/evaluator.hpp"
#include "expressions/interval.hpp"

namespace expressions {

using base::InvalidInput;

template <>
double number(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}
template <>
long double number(const std::string& text) {
    return std::strtold(text.c_str(), nullptr);
}
/// The number itself where double precision holds it exactly, else the interval between its neighbours.
template <>
Interval number(const std::string& text) {
    const std::size_t digits = text.find('e');
    const int exponent = std::atoi(text.c_str() + digits + 1);
    const auto value = number<double>(text), whole = number<double>(text.substr(0, digits)),
               power = number<double>("1e" + std::to_string(std::abs(exponent)));
    const double error = exponent < 0 ? std::fma(value, power, -whole) : std::fma(whole, power, -value);
    const bool exact = digits <= 15 && std::abs(exponent) <= 22 && error == 0;
    return exact ? Interval(value) : Interval(below(value), above(value));
}

template class Evaluator<double>;
template class Evaluator<long double>;
template class Evaluator<Interval>;

namespace {

// A reader's function is far smaller. A hostile one ends here.
constexpr std::size_t most_characters = 1000;
constexpr int deepest = 50, largest_exponent = 300;
constexpr std::size_t most_work = 5'000'000;  // steps with intervals, about a second

constexpr const char* pi = "314159265358979323846264338327950288419716939937511e-50";
constexpr const char* e = "271828182845904523536028747135266249775724709369996e-50";

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}
bool is_letter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}

/// The text as one line of a message shows it.
std::string quoted(std::string text) {
    constexpr std::size_t longest = 80;
    if (text.size() > longest) {
        std::size_t end = longest;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
            --end;  // keep characters of several bytes whole
        text.resize(end);
        text += "...";
    }
    for (char& letter : text)
        if (std::iscntrl(static_cast<unsigned char>(letter)) != 0) letter = '?';
    return "'" + text + "'";
}

std::size_t operation_named(std::string_view name) {
    const auto& all = operations<Interval>();
    const auto* const found =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    return static_cast<std::size_t>(found - all.begin());
}

/// Names that can be typed. Those of operators hold a blank.
std::string function_names() {
    std::string names;
    for (const auto& each : operations<Interval>())
        if (each.name.find(' ') == std::string_view::npos) names += ", " + std::string(each.name);
    return names;
}

/// Reads an expression from left to right by recursive descent. Each rule returns the step that holds its
/// result.
class Parser {
  public:
    Parser(std::string_view text, const std::vector<std::string>& variables)
        : text_(text), variables_(variables) {
        for (const std::string& variable : variables) variable_names_ += variable + ", ";
    }

    Program program() {
        if (text_.size() > most_characters)
            throw InvalidInput(std::to_string(text_.size()) + " characters are too many; take at most " +
                               std::to_string(most_characters));
        sum();
        if (letter() == ')') fail("')' without a '('");
        if (at_ < text_.size()) fail("an operator or the end expected");
        return std::move(program_);
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

    /// \param constant bounds of the step's result, if it is a constant
    std::size_t add(const Step& step, const std::optional<Interval>& constant = {}) {
        program_.steps.push_back(step);
        constants_.push_back(constant);
        return program_.steps.size() - 1;
    }
    std::size_t add_number(const std::string& number_text, std::size_t at) {
        const auto bounds = number<Interval>(number_text);
        if (!is_bounded(bounds)) fail("a number is too large", at);
        program_.numbers.push_back(number_text);
        return add({Step::Kind::number, program_.numbers.size() - 1}, bounds);
    }

    /// Adds an operation on steps a and b. The result of an operation on constants must be a number.
    std::size_t add(std::string_view name, std::size_t at, std::size_t a, std::size_t b) {
        const std::size_t operation = operation_named(name);
        const Step step{Step::Kind::operation, operation, a, b};
        if (!constants_[a] || !constants_[b]) return add(step);
        const Interval p = *constants_[a], q = *constants_[b];
        const Interval result = operations<Interval>()[operation].apply({p}, {q}).value;
        if (is_bounded(result)) return add(step, result);
        const double value = operations<double>()[operation].apply({p.lower}, {q.lower}).value;
        const char* const why = contains(p, 0) || contains(q, 0) ? " has no finite value"
                                : std::isnan(value)              ? " is not real"
                                : std::isinf(value)              ? " is too large"
                                                                 : " has no finite value";
        fail(std::string(name) + why, at);
    }
    std::size_t add(std::string_view name, std::size_t at, std::size_t a) { return add(name, at, a, a); }

    std::size_t sum() {
        std::size_t all = product();
        for (char sign = letter(); sign == '+' || sign == '-'; sign = letter()) {
            const std::size_t at = at_++;
            all = add(sign == '+' ? "the sum" : "the difference", at, all, product());
        }
        return all;
    }

    std::size_t product() {
        std::size_t all = factor();
        for (char sign = letter(); sign == '*' || sign == '/'; sign = letter()) {
            const std::size_t at = at_++;
            all = add(sign == '*' ? "the product" : "the quotient", at, all, factor());
        }
        return all;
    }

    std::size_t factor() {
        if (++depth_ > deepest) fail("nested more than " + std::to_string(deepest) + " deep");
        const std::size_t all = take('+') ? factor() : take('-') ? negative() : power();
        --depth_;
        return all;
    }

    std::size_t negative() {
        const std::size_t at = at_ - 1;
        return add("the negative", at, factor());
    }

    std::size_t power() {
        const std::size_t base = operand();
        if (letter() != '^') return base;
        const std::size_t at = at_++;
        return add("the power", at, base, factor());
    }

    std::size_t operand() {
        const char first = letter();
        if (is_digit(first) || (first == '.' && digit_at(at_ + 1))) return decimal();
        if (is_letter(first)) return name();
        if (!take('(')) fail("a number, " + variable_names_ + "a function or '(' expected");
        return closed();
    }

    /// A sum and the parenthesis that closes it.
    std::size_t closed() {
        const std::size_t inner = sum();
        if (!take(')')) {
            if (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '('))
                fail("an operator or ')' expected");
            fail("')' expected");
        }
        return inner;
    }

    std::size_t decimal() {
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
        return add_number(digits + "e" + std::to_string(exponent), start);
    }

    std::size_t name() {
        const std::size_t start = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
        const std::string word(text_.substr(start, at_ - start));
        const auto variable = std::find(variables_.begin(), variables_.end(), word);
        if (variable != variables_.end())
            return add({Step::Kind::variable, static_cast<std::size_t>(variable - variables_.begin())});
        if (word == "pi") return add_number(pi, start);
        if (word == "e") return add_number(e, start);
        const std::size_t operation = operation_named(word);
        if (operation == operations<Interval>().size())
            fail("there is no " + quoted(word), start,
                 "; choose among " + variable_names_ + "pi, e" + function_names());
        if (!take('(')) fail("'(' expected after " + word);
        if (operations<Interval>()[operation].arguments == 1) return add(word, start, closed());
        const std::size_t first = sum();
        if (!take(',')) fail("',' expected after the first argument of " + word);
        return add(word, start, first, closed());
    }

    std::string_view text_;
    const std::vector<std::string>& variables_;
    std::string variable_names_;  // each with a comma behind
    std::size_t at_ = 0;
    int depth_ = 0;
    Program program_;
    std::vector<std::optional<Interval>> constants_;
};

/// How many of f, f′, f″, counted from the first, are bounded.
int bounded_orders(const Jet<Interval>& f) {
    return !is_bounded(f.value) ? 0 : !is_bounded(f.first) ? 1 : !is_bounded(f.second) ? 2 : 3;
}

/// The step at which a kink arises: min or max of two functions that may be equal, or abs of one that may be
/// zero.
const Operation<Interval>* kink(const Program& program, const std::vector<Jet<Interval>>& results) {
    for (std::size_t k = 0; k < results.size(); ++k) {
        const auto& [kind, which, a, b] = program.steps[k];
        if (kind != Step::Kind::operation || bounded_orders(results[k]) != 1) continue;
        const auto& operation = operations<Interval>()[which];
        const bool of_two = operation.name == "min" || operation.name == "max";
        if ((of_two || operation.name == "abs") && bounded_orders(results[a]) > 1 &&
            (!of_two || bounded_orders(results[b]) > 1))
            return &operation;
    }
    return nullptr;
}

/// An interval for each variable.
using Box = std::vector<Interval>;

/// The axes, and the directions between two of them: derivatives along these determine all up to the second.
std::vector<std::vector<double>> directions(std::size_t dim) {
    std::vector<std::vector<double>> all;
    for (std::size_t one = 0; one < dim; ++one)
        for (std::size_t other = one; other < dim; ++other) {
            std::vector<double> along(dim, 0);
            along[one] = along[other] = 1;
            all.push_back(along);
        }
    return all;
}

/// The two halves of a box, cut across its longest side.
std::array<Box, 2> halves(const Box& box, std::size_t longest) {
    const double middle = box[longest].lower + (box[longest].upper - box[longest].lower) / 2;
    std::array<Box, 2> both{box, box};
    both[0][longest].upper = both[1][longest].lower = middle;
    return both;
}

/// "x = 0.5" or "(x, y) = (0.5, 0)": a place of a small box, at the end of [0, 1] where it reaches to it.
std::string place(const Box& box, const std::vector<std::string>& variables) {
    std::ostringstream names, numbers;
    numbers.imbue(std::locale::classic());
    numbers.precision(4);
    for (std::size_t k = 0; k < box.size(); ++k) {
        const auto& [lower, upper] = static_cast<const base::Interval&>(box[k]);
        names << (k > 0 ? ", " : "") << variables[k];
        numbers << (k > 0 ? ", " : "") << (lower == 0 ? 0 : upper == 1 ? 1 : lower + (upper - lower) / 2);
    }
    return box.size() == 1 ? names.str() + " = " + numbers.str()
                           : "(" + names.str() + ") = (" + numbers.str() + ")";
}

/// \throws InvalidInput naming the first of f, f′, f″ that is not bounded, and a place of [0, 1]
void check_bounded(const Program& program, const std::vector<std::string>& variables) {
    const double narrowest = std::exp2(-40);
    const Evaluator<Interval> evaluator(program);
    const auto along = directions(variables.size());
    std::vector<Box> pieces{Box(variables.size(), {0, 1})};
    int known = 3;  // orders that are bounded on all pieces so far
    std::string message;
    for (std::size_t work = 0; !pieces.empty();) {
        const Box piece = pieces.back();
        pieces.pop_back();
        int orders = 3;
        std::vector<Jet<Interval>> results;
        for (std::size_t k = 0; k < along.size() && orders > 0; ++k) {
            work += program.steps.size();
            const auto found = evaluator.results(piece, along[k]);
            if (k > 0 && bounded_orders(found.back()) >= orders) continue;
            results = found;
            orders = bounded_orders(found.back());
        }
        if (orders >= known) continue;
        const auto longest = std::max_element(piece.begin(), piece.end(), [](const auto& a, const auto& b) {
            return a.upper - a.lower < b.upper - b.lower;
        });
        if (longest->upper - longest->lower > narrowest && work < most_work) {
            auto [lower, upper] = halves(piece, static_cast<std::size_t>(longest - piece.begin()));
            pieces.push_back(std::move(upper));
            pieces.push_back(std::move(lower));
            continue;
        }
        known = orders;
        constexpr std::array what{"the function", "its first derivative", "its second derivative"};
        const auto* const kinked = kink(program, results);
        message = kinked != nullptr
                      ? std::string(kinked->name) + " has a kink where its " +
                            (kinked->arguments == 1 ? "argument is zero," : "arguments meet,")
                      : std::string(what.at(static_cast<std::size_t>(orders))) + " is not real and bounded";
        message += " near " + place(piece, variables) + "; take one that is smooth on " +
                   (variables.size() == 1   ? "[0, 1]"
                    : variables.size() == 2 ? "the unit square"
                                            : "the unit cube");
    }
    if (known < 3) throw InvalidInput(message);
}

}  // namespace

std::string vocabulary(const std::string& variables) {
    return "numbers, " + variables + ", pi, e, + - * / ^ ( )" + function_names();
}

Program parsed(std::string_view text, const std::vector<std::string>& variables) {
    return Parser(text, variables).program();
}

std::vector<std::string> separated(std::string_view list) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char letter : list) {
        depth = letter == '(' ? depth + 1 : letter == ')' ? std::max(depth - 1, 0) : depth;
        if (letter == ',' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += letter;
    }
    return parts;
}

namespace {

/// What `work` returns of a text; its errors name the option and the text.
template <class Work>
auto of_option(const std::string& option, const std::string& text, const Work& work) {
    try {
        return work();
    } catch (const InvalidInput& error) {
        throw InvalidInput(option + ": " + quoted(text) + " : " + error.what());
    }
}

}  // namespace

Program smooth_program(const std::string& option, const std::string& text,
                       const std::vector<std::string>& variables) {
    return of_option(option, text, [&] {
        Program program = parsed(text, variables);
        check_bounded(program, variables);
        return program;
    });
}

Directional directional(const std::string& option, const std::string& text,
                        const std::vector<std::string>& variables) {
    const Evaluator<double> jet(of_option(option, text, [&] { return parsed(text, variables); }));
    return [jet](std::span<const double> at, std::span<const double> direction) {
        return jet.results(at, direction).back();
    };
}

void require_smooth(const std::string& option, const std::string& text,
                    const std::vector<std::string>& variables) {
    static_cast<void>(smooth_program(option, text, variables));
}

template base::Smooth<double> smooth(const std::string&, const std::string&);
template base::Smooth<long double> smooth(const std::string&, const std::string&);

}  // namespace expressions
