#include "report/table.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/errors.hpp"

/// Any text is a table, equal to itself and to what is written of it, or is refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const report::Table table = report::parsed({reinterpret_cast<const char*>(data), size});
        if (!report::differences(table, table).empty()) std::abort();
    } catch (const base::FailedComputation&) {
    }
    return 0;
}
