#include "expressions/expression.hpp"

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "base/errors.hpp"
#include "base/quad.hpp"
#include "report/table.hpp"
#include "tests/programs/run.hpp"
#include "tests/relative.hpp"

using namespace expressions;
using programs::check_refused;
using programs::run;

namespace {

base::Smooth<> read(const std::string& text) {
    return expression<double>("--function", text);
}

std::string refusal(const std::string& text) {
    try {
        static_cast<void>(read(text));
    } catch (const base::InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int k = 0; k < times; ++k) all += text;
    return all;
}

}  // namespace

TEST_CASE("expression: value and derivatives are those of the closed form") {
    using Function = double (*)(double);
    struct Case {
        const char* text;
        Function value, first, second;
    };
    const std::vector<Case> all{
        {"sin(5*x)+x^2", [](double x) { return std::sin(5 * x) + x * x; },
         [](double x) { return 5 * std::cos(5 * x) + 2 * x; },
         [](double x) { return -25 * std::sin(5 * x) + 2; }},
        {"x*exp(-x)+sin(3*x)", [](double x) { return x * std::exp(-x) + std::sin(3 * x); },
         [](double x) { return (1 - x) * std::exp(-x) + 3 * std::cos(3 * x); },
         [](double x) { return (x - 2) * std::exp(-x) - 9 * std::sin(3 * x); }},
        {"-exp(x)+e*x+1", [](double x) { return -std::exp(x) + std::numbers::e * x + 1; },
         [](double x) { return -std::exp(x) + std::numbers::e; }, [](double x) { return -std::exp(x); }},
        {"2/(1+x)", [](double x) { return 2 / (1 + x); }, [](double x) { return -2 / std::pow(1 + x, 2); },
         [](double x) { return 4 / std::pow(1 + x, 3); }},
        {"x^2.5", [](double x) { return std::pow(x, 2.5); }, [](double x) { return 2.5 * std::pow(x, 1.5); },
         [](double x) { return 3.75 * std::sqrt(x); }},
        {"pi", [](double) { return std::numbers::pi; }, [](double) { return 0.0; },
         [](double) { return 0.0; }},
    };
    for (const auto& [text, value, first, second] : all) {
        const std::string tried = text;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        const base::Smooth<> f = read(text);
        for (const double x : {0.0, 0.125, 0.3, 0.77, 1.0}) {
            CAPTURE(x);
            CHECK(std::abs(f.f(x) - value(x)) < 1e-14);
            CHECK(std::abs(f.Df(x) - first(x)) < 2e-14);
            CHECK(std::abs(f.D2f(x) - second(x)) < 2e-13);
        }
    }
}

TEST_CASE("expression: derivatives are those of finite differences, for every function and operator") {
    const double h = 1e-4;
    for (const char* text : {"sin(2*x)",
                             "cos(3*x)",
                             "tan(x)",
                             "asin(x/2)",
                             "acos(x/3)",
                             "atan(4*x)",
                             "sinh(x)",
                             "cosh(2*x)",
                             "tanh(3*x)",
                             "exp(-x)",
                             "log(1+x)",
                             "sqrt(1+x)",
                             "(1+x)^x",
                             "2^x",
                             "x^3/(1+x^2)-1/(2+sin(x))",
                             "-x^2*pi^x",
                             "exp(sin(3*x)*cos(x))^2",
                             "(sin(x)-x^2+exp(x)-log(x+1))^-3",
                             "(2+x)^-2.5",
                             "e^(-x^2)",
                             "(1+x)^(1+x)^2"}) {
        CAPTURE(text);
        const base::Smooth<> f = read(text);
        for (const double x : {0.1, 0.45, 0.9}) {
            CAPTURE(x);
            const double size = 1 + std::abs(f.f(x)) + std::abs(f.Df(x)) + std::abs(f.D2f(x));
            CHECK(std::abs((f.f(x + h) - f.f(x - h)) / (2 * h) - f.Df(x)) < 1e-6 * size);
            CHECK(std::abs((f.Df(x + h) - f.Df(x - h)) / (2 * h) - f.D2f(x)) < 2e-6 * size);
        }
    }
}

TEST_CASE("expression: powers bind before signs and from the right, decimals are read as written") {
    CHECK(read("-x^2").f(0.5) == -0.25);
    CHECK(read("2^-1*x").f(1) == 0.5);
    CHECK(read("2^3^2").f(0) == 512);
    CHECK(read("1-2-3").f(0) == -4);
    CHECK(read("8/4/2").f(0) == 1);
    CHECK(read("--+-3").f(0) == -3);
    CHECK(read(" 010 + .5 + 5. + 1.5e2 + 1E-1 ").f(0) == 165.6);
    CHECK(read("0.1+0.2").f(0) == 0.3);
}

TEST_CASE("expression: what cannot be read is refused at its character") {
    const std::vector<std::pair<std::string, std::string>> all{
        {"sin(5*x", "--function: 'sin(5*x' : ')' expected at character 8"},
        {"", "--function: '' : a number, x, a function or '(' expected at character 1"},
        {"y", "there is no 'y' at character 1; choose among x, pi, e, sin"},
        {"1+foo(x)", "there is no 'foo' at character 3"},
        {"I", "there is no 'I' at character 1"},
        {"SIN(x)", "there is no 'SIN' at character 1"},
        {"2x", "an operator or the end expected at character 2"},
        {"3 4", "an operator or the end expected at character 3"},
        {"(2 x)", "an operator or ')' expected at character 4"},
        {"x)", "')' without a '(' at character 2"},
        {"x**2", "a number, x, a function or '(' expected at character 3"},
        {"x+", "a number, x, a function or '(' expected at character 3"},
        {"()", "a number, x, a function or '(' expected at character 2"},
        {"sin x", "'(' expected after sin at character 5"},
        {"exp", "'(' expected after exp at character 4"},
        {"sin(x,2)", "')' expected at character 6"},
        {"x=1", "an operator or the end expected at character 2"},
        {"5·x", "an operator or the end expected at character 2"},
        {"x\n+1", "'x?+1' : an operator or the end expected at character 2"},
        {"abs(x)", "abs at character 1: it has no derivative where its argument is zero"},
        {"x+1/0", "the quotient has no finite value at character 4"},
        {"1/(x-x)", "the quotient has no finite value at character 2"},
        {"0^0", "the power has no finite value at character 2"},
        {"log(0)", "log has no finite value at character 1"},
        {"tan(pi/2)", "tan has no finite value at character 1"},
        {"x*sqrt(-1)", "sqrt is not real at character 3"},
        {"log(-2)", "log is not real at character 1"},
    };
    for (const auto& [text, reason] : all) {
        const std::string tried = text;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        const std::string found = refusal(text);
        CAPTURE(found);
        CHECK(found.starts_with("--function: '"));
        CHECK(found.find(reason) != std::string::npos);
        CHECK(found.find('\n') == std::string::npos);
    }
}

TEST_CASE("expression: what is singular on [0, 1] is refused with its place, between samples as well") {
    const std::vector<std::pair<std::string, std::string>> all{
        {"1/(x-0.5)", "the function is not real and bounded near x = 0.5;"},
        {"1/(x-0.3)^2", "the function is not real and bounded near x = 0.3;"},
        {"1/(x-1/pi)^2", "the function is not real and bounded near x = 0.3183;"},
        {"tan(2*x)", "the function is not real and bounded near x = 0.7854;"},
        {"log(x)", "the function is not real and bounded near x = 0;"},
        {"log(0.25-x)", "the function is not real and bounded near x = 0.25;"},
        {"sqrt(x)", "its first derivative is not real and bounded near x = 0;"},
        {"x^1.5", "its second derivative is not real and bounded near x = 0;"},
        {"asin(x)", "its first derivative is not real and bounded near x = 1;"},
        {"sqrt((x-0.7)^2)", "its first derivative is not real and bounded near x = 0.7;"},
        {"sin(1/x)", "the function is not real and bounded near x = 0;"},
        {"atan(1/(x-0.2))", "the function is not real and bounded near x = 0.2;"},
        {"x^x", "the function is not real and bounded near x = 0;"},
        {"sin(x)/x", "the function is not real and bounded near x = 0;"},
        {"asin(1+x^2)", "the function is not real and bounded near x = 0;"},
        {"exp(1000*x)", "the function is not real and bounded near x = 0.7098;"},
        {"(-8)^(1/3)", "the function is not real and bounded near x = 0;"},
    };
    for (const auto& [text, reason] : all) {
        const std::string tried = text;  // clang++ 14 captures no bindings
        CAPTURE(tried);
        const std::string found = refusal(text);
        CAPTURE(found);
        CHECK(found.find(reason) != std::string::npos);
    }
}

TEST_CASE("expression: what comes close to a pole, or ends at a zero, is taken") {
    for (const char* text : {"1/(x^2-x+0.2501)", "1/(x+1e-6)", "1/(1.000001-x)", "(1-x)^2.5", "sqrt(x+1e-9)",
                             "tan(1.57*x)", "1/(1.0001+sin(1000*x))", "sin(1e9*x)", "x^1000"}) {
        CAPTURE(text);
        CHECK(refusal(text) == "accepted");
    }
}

TEST_CASE("expression: hostile input is refused in time") {
    const std::vector<std::pair<std::string, std::string>> all{
        {repeated("x+", 50000) + "x", "100001 characters are too many; take at most 1000"},
        {repeated("(", 400) + "x" + repeated(")", 400), "nested more than 50 deep at character 51"},
        {repeated("-", 900) + "x", "nested more than 50 deep at character 51"},
        {repeated("x^", 400) + "x", "nested more than 50 deep at character 101"},
        {repeated("sin(", 49) + "x" + repeated(")", 49), "too many terms"},
        {repeated("9", 500), "a number is too long at character 1"},
        {"1e999999999999", "a number is too long at character 1"},
        {"x*1e-400", "a number is too long at character 3"},
        {"2^(10^9)", "the power is too large at character 2"},
        {"10^10^10*x", "the power is too large at character 3"},
        {"((2*x)^4000)^4000", "the power is too large at character 7"},
        {"((x+1)^1000)^1000", "the power is too large at character 13"},
        {"1e300^2*x", "a number is too large or not real"},
        {"x^1e200", "a number is too large or not real"},
        {"0^x", "not real and bounded near x = 0"},
        {std::string("x\0y", 3), "an operator or the end expected at character 2"},
    };
    for (const auto& [text, reason] : all) {
        const std::string tried = text.substr(0, 100);
        CAPTURE(tried);
        const std::string found = refusal(text);
        CAPTURE(found);
        CHECK(found.find(reason) != std::string::npos);
        CHECK(found.size() < 300);
    }
}

TEST_CASE("expression: the programs refuse in one line, with code 2") {
    for (const std::string option : {"derivative_test --function", "static_test --displacement"}) {
        check_refused(option + " 'sin(5*x'", 2, ": 'sin(5*x' : ')' expected at character 8");
        check_refused(option + " 1/x", 2, "not real and bounded near x = 0");
        check_refused(option + " ' '", 2, "a number, x, a function or '(' expected at character 2");
        check_refused(option + " 0^0", 2, "the power has no finite value");
    }
}

// GiNaC orders terms by addresses, which the system chooses anew for each process. The difference below is zero but for
// round-off, and large enough that the last bit of any term shows.
TEST_CASE("expression: the same bytes in every run") {
    const std::string cube = "(sin(x)-x^2+exp(x)-log(x+1)+cos(3*x)+2)";
    const std::string command =
        "derivative_test --formulation second_order_fpm --particles 50 --function '1e15*(" + cube +
        "^3-exp(3*log" + cube + "))'";
    std::set<std::string> outputs;
    for (int k = 0; k < 12; ++k) outputs.insert(run(command).output);
    CHECK(outputs.size() == 1);
    CHECK(report::parsed(*outputs.begin()).rows.size() == 1);
}

TEST_CASE("expression: in quad precision, numbers, constants and functions have its digits") {
    const auto f = expression<base::Quad>("--function", "sin(0.1*pi*x)/3 + x^(1/3)*0 + sqrt(2)*x");
    const base::Quad x = base::Quad(3) / 7, pi = acos(base::Quad(-1));
    const base::Quad exact = sin(pi * x / 10) / 3 + sqrt(base::Quad(2)) * x;
    CHECK(abs(f.f(x) - exact) < 1e-33);
    CHECK(abs(f.Df(x) - (pi / 30 * cos(pi * x / 10) + sqrt(base::Quad(2)))) < 1e-33);
}
