#include "base/memory.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace base {

namespace {

std::string gigabytes(double bytes) {
    return shown(bytes / 1e9, 3) + " GB";
}

}  // namespace

void prefer_large_pages(void* first, std::size_t bytes) {
    if (bytes < large_page) return;
    // The pages at both ends belong to it only in part. What of them is no memory at all is passed over.
    const std::uintptr_t before = reinterpret_cast<std::uintptr_t>(first) % large_page;
    const std::uintptr_t pages = (before + bytes + large_page - 1) / large_page;
    char* const begin = static_cast<char*>(first) - before;
    madvise(begin, pages * large_page, MADV_HUGEPAGE);
    // malloc has written the size before the array, and so a small page where the first large page shall be.
    constexpr int collapse = 25;  // MADV_COLLAPSE, of Linux 6.1, which older headers lack
    madvise(begin, large_page, collapse);
}

void keep_freed_memory() {
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc takes
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

double available_memory() {
    const double machine =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return machine;
    return std::min(machine, static_cast<double>(limit.rlim_cur));
}

void require_memory(const std::string& what, double bytes, const std::string& remedy) {
    if (bytes > available_memory())
        throw InvalidInput(what + " take at least " + gigabytes(bytes) + " of memory, there are " +
                           gigabytes(available_memory()) + "; " + remedy);
}

void require_memory_of_entries(const std::string& what, double entries, double bytes,
                               const std::string& remedy) {
    constexpr int most = std::numeric_limits<int>::max();
    if (entries > most)
        throw InvalidInput(what + " make a matrix of " + shown(entries, 3) +
                           " entries, which holds at most " + std::to_string(most) + "; " + remedy);
    require_memory(what, bytes, remedy);
}

}  // namespace base
