#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace programs {

/// The exit code of a program, and what it wrote to standard output and standard error.
struct Outcome {
    int code;
    std::string output, errors;
};

/// Whether a cell of a CSV table is NaN or infinite.
inline bool has_non_finite_cell(const std::string& table) {
    std::string cells = "\n" + table;
    std::transform(cells.begin(), cells.end(), cells.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    for (const char* start : {"\nnan", ",nan", "\n-nan", ",-nan", "\ninf", ",inf", "\n-inf", ",-inf"})
        if (cells.find(start) != std::string::npos) return true;
    return false;
}

}  // namespace programs
