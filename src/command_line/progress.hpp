#pragma once

#include <unistd.h>

#include <cstddef>
#include <iostream>
#include <type_traits>
#include <vector>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace command_line {

/// "3 of 12" on a terminal, from "0 of 12" on; erased at the end, also after a failure. Steps may come from
/// several threads.
class Progress {
  public:
    /// \param watched whether the stream is a terminal; to anything else nothing is written
    explicit Progress(std::size_t all, std::ostream& terminal = std::cerr,
                      bool watched = isatty(STDERR_FILENO) != 0)
        : all_(all), terminal_(terminal), watched_(watched) {
        show();
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() {
        if (watched_) terminal_ << "\r\033[K" << std::flush;
    }
    void step() {
#pragma omp critical(progress)
        {
            ++done_;
            show();
        }
    }

  private:
    void show() {
        if (watched_) terminal_ << "\r" << done_ << " of " << all_ << std::flush;
    }

    std::size_t all_, done_ = 0;
    std::ostream& terminal_;
    bool watched_;
};

/// What `compute` returns for each case, in the order of the cases. They are computed in parallel, with
/// progress on the terminal.
template <class Case, class Compute>
auto computed_in_parallel(const std::vector<Case>& cases, const Compute& compute) {
    std::vector<std::invoke_result_t<Compute, const Case&>> results(cases.size());
    Progress progress(cases.size());
    base::for_each_index(static_cast<base::Index>(cases.size()), [&](base::Index k) {
        const auto at = static_cast<std::size_t>(k);
        results[at] = compute(cases[at]);
        progress.step();
    });
    return results;
}

}  // namespace command_line
