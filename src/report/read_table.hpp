#pragma once

#include <string>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "report/table.hpp"

namespace report {

/// The table that a CSV file holds, as parsed(). \throws base::FailedComputation naming the file
inline Table read_table(const std::string& path) {
    const std::string text = read_whole(path);
    try {
        return parsed(text);
    } catch (const base::FailedComputation& error) {
        throw base::FailedComputation(path + ": " + error.what());
    }
}

}  // namespace report
