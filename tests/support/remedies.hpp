#pragma once

#include <doctest/doctest.h>

#include <string>

#include "base/errors.hpp"

/// What refusals say.
namespace support {

/// The message of a failed computation; empty where it succeeds.
template <class Work>
std::string refusal(const Work& work) {
    try {
        static_cast<void>(work());
    } catch (const base::FailedComputation& failed) {
        return failed.what();
    }
    return "";
}

/// The number of "try --smoothing 1.6", which a refusal must hold.
inline double smoothing_to_try(const std::string& refused) {
    const std::string before = "try --smoothing ";
    CAPTURE(refused);
    REQUIRE(refused.find(before) != std::string::npos);
    return std::stod(refused.substr(refused.find(before) + before.size()));
}

}  // namespace support
