#pragma once

#include <string>

#include "report/ledger.hpp"
#include "report/read_table.hpp"

namespace support {

/// What paper/claims.csv states of a claim. Tests run in the top folder.
inline report::Statement claim(const std::string& id) {
    static const report::Table claims = report::read_table("paper/claims.csv");
    return report::statement(claims, id);
}

/// The number that the paper gives.
inline double expected(const std::string& id) {
    return claim(id).expected;
}

}  // namespace support
