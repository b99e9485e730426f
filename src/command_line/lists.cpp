#include "command_line/lists.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/choose.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"

namespace command_line {

using base::InvalidInput;

std::vector<std::string> parts(const std::string& text, char between) {
    std::vector<std::string> found{""};
    for (const char c : text)
        if (c == between)
            found.emplace_back();
        else
            found.back() += c;
    return found;
}

namespace {

/// The entries of a list, without the blanks around them. A comma may stand at the end.
/// \throws InvalidInput where an entry is empty
std::vector<std::string> entries(const std::string& option, const std::string& list) {
    std::vector<std::string> found = parts(list, ',');
    if (found.size() > 1 && base::trimmed(found.back()).empty()) found.pop_back();
    for (std::string& entry : found) {
        entry = base::trimmed(entry);
        if (entry.empty())
            throw InvalidInput(option + ": " + base::quoted(list) +
                               " has an empty entry; leave the comma beside it out");
    }
    return found;
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

/// The numbers of an entry of a list: one, or those of a range.
std::vector<double> numbers_of_entry(const std::string& option, const std::string& entry) {
    std::vector<double> given;
    for (const std::string& text : parts(entry, ':')) given.push_back(number(option, text));
    if (given.size() == 1) return given;
    if (given.size() != 3 || !(given[1] > 0) || given[2] < given[0] || (given[2] - given[0]) / given[1] > 1e4)
        throw InvalidInput(option + ": " + base::quoted(entry) +
                           " is no range from:step:to of at most 10000 steps");
    return range(given[0], given[1], given[2]);
}

/// Refuses a list that is separated by semicolons, with the list to be written instead.
void check_commas(const std::string& option, const std::string& list) {
    if (list.find(';') == std::string::npos) return;
    std::string written = list;
    std::replace(written.begin(), written.end(), ',', '.');
    std::replace(written.begin(), written.end(), ';', ',');
    throw InvalidInput(option + ": " + base::quoted(list) +
                       " is separated by semicolons; write points and commas, " + written);
}

}  // namespace

double number(const std::string& option, const std::string& text) {
    return of_option(option, [&] { return base::number(text); });
}

long whole_number(const std::string& option, const std::string& text) {
    return of_option(option, [&] { return base::whole_number(text); });
}

std::vector<std::string> names(const std::string& option, const std::string& list) {
    return entries(option, list);
}

std::vector<double> numbers(const std::string& option, const std::string& list) {
    check_commas(option, list);
    std::vector<double> all;
    for (const std::string& entry : entries(option, list))
        for (const double number : numbers_of_entry(option, entry)) all.push_back(number);
    return all;
}

std::vector<long> whole_numbers(const std::string& option, const std::string& list) {
    check_commas(option, list);
    std::vector<long> all;
    for (const std::string& entry : entries(option, list)) {
        for (const std::string& text : parts(entry, ':')) static_cast<void>(whole_number(option, text));
        for (const double number : numbers_of_entry(option, entry)) all.push_back(std::lround(number));
    }
    return all;
}

std::array<long, 2> pair_of(const std::string& option, const std::string& text) {
    const std::vector<std::string> both = parts(text, 'x');
    try {
        if (const std::array<long, 2> pair{base::whole_number(both.front()), base::whole_number(both.back())};
            both.size() == 2 && std::abs(pair[0]) <= 1000000 && std::abs(pair[1]) <= 1000000)
            return pair;
    } catch (const InvalidInput&) {
    }
    throw InvalidInput(option + ": " + base::quoted(text) + " is no pair of whole numbers such as 16x4");
}

std::vector<std::string> chosen(const std::string& what, const std::vector<std::string>& wanted,
                                const std::vector<std::string>& known,
                                const std::vector<std::string>& beside) {
    if (wanted == std::vector<std::string>{"all"}) return known;
    std::vector<std::pair<std::string, std::string>> choices{{"all", "all"}};
    for (const auto* names : {&known, &beside})
        for (const std::string& name : *names) choices.emplace_back(name, name);
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
