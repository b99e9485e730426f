#include "python/messages.hpp"

#include <algorithm>
#include <regex>

namespace python {

std::string in_python(const std::string& message) {
    static const std::regex help("see ([a-z_]+) --help");
    const std::string said = std::regex_replace(message, help, "see help($1)");

    // An option, and behind it a name, a number, a text in quotes, or letters that stand for a value.
    static const std::regex option(
        R"re(--([A-Za-z][A-Za-z0-9-]*)(?: (?:(local|largest|[0-9]+-nearest|hats|fpm|poisson|elasticity|stress|strain)\b|("[^"]*"|-?[0-9][^\s,;)]*|[A-Z][A-Z0-9]*\b)))?)re");
    std::string text;
    auto rest = said.cbegin();
    bool after_value = false;
    for (std::sregex_iterator found(said.begin(), said.end(), option), end; found != end; ++found) {
        const std::smatch& match = *found;
        const std::string between(rest, match[0].first);
        text += after_value && between == " " ? ", " : between;
        std::string name = match[1];
        std::replace(name.begin(), name.end(), '-', '_');
        text += name;
        if (match[2].matched) text += "=\"" + match[2].str() + '"';
        if (match[3].matched) text += "=" + match[3].str();
        after_value = match[2].matched || match[3].matched;
        rest = match[0].second;
    }
    text.append(rest, said.cend());

    // What is given on a side is an entry of a dict.
    static const std::regex on_side(R"re(="(?:NAME|A\+B): ([^"]*)")re");
    static const std::regex several(R"re(=\{"NAME": ([^}]*,[^}]*)\})re");
    return std::regex_replace(std::regex_replace(text, on_side, R"(={"NAME": $1})"), several,
                              R"re(={"NAME": ($1)})re");
}

}  // namespace python
