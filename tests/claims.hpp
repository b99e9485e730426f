#pragma once

#include <string>

#include "base/errors.hpp"
#include "report/ledger.hpp"
#include "report/read_table.hpp"

namespace support {

/// What paper/claims.csv states of a claim. Tests run in the top folder.
inline report::Statement claim(const std::string& id) {
    static const report::Table claims = report::read_table("paper/claims.csv");
    for (std::size_t row = 0; row < claims.rows.size(); ++row)
        if (claims.word(row, "id") == id) return report::statement(claims, row);
    throw base::InvalidInput("there is no claim " + id);
}

/// The number that the paper gives.
inline double expected(const std::string& id) {
    return claim(id).expected;
}

}  // namespace support
