#pragma once

#include <cstddef>
#include <ostream>

namespace command_line {

/// "3 of 12" on a terminal, wiped when it ends, however it ends. Steps may come from several threads.
class Progress {
  public:
    /// \param watched false where nobody looks, such as a file: then nothing is written
    Progress(std::size_t all, std::ostream& terminal, bool watched)
        : all_(all), terminal_(terminal), watched_(watched) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() {
        if (watched_) terminal_ << "\r\033[K" << std::flush;
    }
    void step() {
        if (!watched_) return;
#pragma omp critical(progress)
        {
            ++done_;
            terminal_ << "\r" << done_ << " of " << all_ << std::flush;
        }
    }

  private:
    std::size_t all_, done_ = 0;
    std::ostream& terminal_;
    bool watched_;
};

}  // namespace command_line
