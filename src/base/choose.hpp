#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/errors.hpp"

namespace base {

/// The value that a name stands for among those that are known.
/// \param what the names name, such as "kernel"
/// \throws InvalidInput "there is no kernel 'gauss'; choose one of gaussian, cubic_spline"
template <class Value>
Value choose(std::string_view what, std::string_view wanted,
             const std::vector<std::pair<std::string, Value>>& known) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const auto& choice) { return choice.first == wanted; });
    if (found != known.end()) return found->second;
    std::string names;
    for (const auto& [name, value] : known) names += (names.empty() ? "" : ", ") + name;
    throw InvalidInput("there is no " + std::string(what) + " '" + std::string(wanted) + "'; choose one of " +
                       names);
}

}  // namespace base
