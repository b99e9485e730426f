#include "programs/room.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

#include "particles/errors.hpp"

namespace programs {

namespace {

std::string gigabytes(double bytes) {
    return particles::shown(bytes / 1e9, 3) + " GB";
}

}  // namespace

double room() {
    const double machine =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return machine;
    return std::min(machine, static_cast<double>(limit.rlim_cur));
}

void check_room(const std::string& what, double bytes, const std::string& remedy) {
    if (bytes > room())
        throw particles::InvalidInput(what + " take at least " + gigabytes(bytes) + " of memory, there are " +
                                      gigabytes(room()) + "; " + remedy);
}

void check_room_of_entries(const std::string& what, double entries, double bytes, const std::string& remedy) {
    constexpr int most = std::numeric_limits<int>::max();
    if (entries > most)
        throw particles::InvalidInput(what + " make a matrix of " + particles::shown(entries, 3) +
                                      " entries, which holds at most " + std::to_string(most) + "; " +
                                      remedy);
    check_room(what, bytes, remedy);
}

}  // namespace programs
