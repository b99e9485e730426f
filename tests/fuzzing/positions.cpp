#include "command_line/positions.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/errors.hpp"

/// As positions of a line, any file is from 0 to 1 and increases, as points of the plane it is finite, or it
/// is refused as invalid input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const int file = memfd_create("positions", 0);
    if (ftruncate(file, 0) != 0 || pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
    const std::string path = "/proc/self/fd/" + std::to_string(file);
    try {
        const auto x = command_line::read_positions(path);
        if (x.size() < 2 || x[0] != 0 || x[x.size() - 1] != 1) std::abort();
        for (particles::Index j = 1; j < x.size(); ++j)
            if (!(x[j] > x[j - 1])) std::abort();
    } catch (const base::InvalidInput&) {
    }
    try {
        if (!command_line::read_points(path).allFinite()) std::abort();
    } catch (const base::InvalidInput&) {
    }
    return 0;
}
