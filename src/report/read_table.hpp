#pragma once

#include <string>

#include "particles/errors.hpp"
#include "report/file.hpp"
#include "report/table.hpp"

namespace report {

/// The table that a CSV file holds, as parsed(). \throws particles::FailedComputation naming the file
inline Table read_table(const std::string& path) {
    const std::string text = read_whole(path);
    try {
        return parsed(text);
    } catch (const particles::FailedComputation& error) {
        throw particles::FailedComputation(path + ": " + error.what());
    }
}

}  // namespace report
