#include "python/messages.hpp"

#include <algorithm>
#include <regex>

namespace python {

std::string in_python(const std::string& message) {
    static const std::regex option(R"re(--(smoothing-from|method|equation|plane) ([a-z0-9-]+))re"
                                   R"re(|--([a-z][a-z0-9-]*)( "[^"]*"| -?[0-9][^\s,;)]*)?)re");
    const auto keyword = [](std::string name) {
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    };
    static const std::regex help("see ([a-z_]+) --help");
    const std::string with_help = std::regex_replace(message, help, "see help($1)");
    std::string text;
    auto rest = with_help.cbegin();
    for (std::sregex_iterator found(with_help.begin(), with_help.end(), option), end; found != end; ++found) {
        const std::smatch& match = *found;
        text.append(rest, match[0].first);
        if (match[1].matched)
            text += keyword(match[1]) + "=\"" + match[2].str() + '"';
        else
            text += keyword(match[3]) + (match[4].matched ? "=" + match[4].str().substr(1) : "");
        rest = match[0].second;
    }
    return text.append(rest, with_help.cend());
}

}  // namespace python
