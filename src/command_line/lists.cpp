#include "command_line/lists.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "base/text.hpp"

namespace command_line {

using base::InvalidInput;

namespace {

std::vector<std::string> parts(const std::string& text, char between) {
    std::vector<std::string> found{""};
    for (const char c : text)
        if (c == between)
            found.emplace_back();
        else
            found.back() += c;
    return found;
}

bool read(const std::string& text, double& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

/// The numbers from `from` to `to`. They are rounded, so that 2:0.1:4 holds 2.3 and not 2.3000000000000003.
std::vector<double> range(double from, double step, double to) {
    const auto steps = std::lround(std::floor((to - from) / step * (1 + 1e-12) + 1e-9));
    const double finest = from == 0 ? step : std::min(step, std::abs(from));
    const double digits = std::pow(10, 9 - std::floor(std::log10(finest)));
    std::vector<double> all;
    for (long k = 0; k <= steps; ++k) {
        const double number = from + static_cast<double>(k) * step;
        all.push_back(std::abs(number) * digits < 1e15 ? std::round(number * digits) / digits : number);
    }
    return all;
}

/// The numbers of a part of a list: one, or those of a range.
std::vector<double> numbers_of_part(const std::string& option, const std::string& part) {
    std::vector<double> given;
    for (const std::string& text : parts(part, ':')) {
        double number = 0;
        if (!read(text, number))
            throw InvalidInput(option + ": '" + part + "' is neither a number nor a range from:step:to");
        given.push_back(number);
    }
    if (given.size() == 1) return given;
    if (given.size() != 3 || !(given[1] > 0) || given[2] < given[0] || (given[2] - given[0]) / given[1] > 1e4)
        throw InvalidInput(option + ": '" + part + "' is no range from:step:to of at most 10000 steps");
    return range(given[0], given[1], given[2]);
}

}  // namespace

std::vector<std::string> names(const std::string& list) {
    return parts(list, ',');
}

std::vector<double> numbers(const std::string& option, const std::string& list) {
    std::vector<double> all;
    for (const std::string& part : parts(list, ','))
        for (const double number : numbers_of_part(option, part)) all.push_back(number);
    return all;
}

std::vector<long> whole_numbers(const std::string& option, const std::string& list) {
    for (const std::string& part : parts(list, ','))  // which other programs read as octal
        for (const std::string& text : parts(part, ':'))
            if (text.size() > 1 && text[0] == '0' && text[1] != '.')
                throw InvalidInput(option + ": " + text + " begins with 0; write it in decimal");
    std::vector<long> all;
    for (const double number : numbers(option, list)) {
        if (number != std::round(number) || std::abs(number) > 1e15)
            throw InvalidInput(option + ": " + base::shown(number) + " is no whole number up to 1e15");
        all.push_back(std::lround(number));
    }
    return all;
}

std::array<long, 2> pair_of(const std::string& option, const std::string& text) {
    const std::vector<std::string> both = parts(text, 'x');
    double first = 0, second = 0;
    if (both.size() != 2 || !read(both[0], first) || !read(both[1], second) || first != std::round(first) ||
        second != std::round(second) || std::max(std::abs(first), std::abs(second)) > 1e6)
        throw InvalidInput(option + ": '" + text + "' is no pair of whole numbers such as 16x4");
    return {std::lround(first), std::lround(second)};
}

std::vector<std::string> chosen(const std::string& what, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& known) {
    if (wanted == std::vector<std::string>{"all"}) return known;
    std::vector<std::pair<std::string, std::string>> choices{{"all", "all"}};
    for (const std::string& name : known) choices.emplace_back(name, name);
    for (const std::string& name : wanted)
        if (base::choose(what, name, choices) == "all")
            throw InvalidInput("--" + what + " all takes no other name beside it");
    return wanted;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace command_line
