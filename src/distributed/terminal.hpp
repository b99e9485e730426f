#pragma once

#include <unistd.h>

#include <iostream>
#include <streambuf>
#include <string>

#include "distributed/processes.hpp"

namespace distributed {

/// While it lives, what other processes than the first write goes nowhere.
class FirstSpeaks : std::streambuf {
  public:
    explicit FirstSpeaks(const Processes& processes) {
        if (processes.is_first()) return;
        output_ = std::cout.rdbuf(this);
        errors_ = std::cerr.rdbuf(this);
    }
    FirstSpeaks(const FirstSpeaks&) = delete;
    FirstSpeaks& operator=(const FirstSpeaks&) = delete;
    ~FirstSpeaks() override {
        if (output_ != nullptr) std::cout.rdbuf(output_);
        if (errors_ != nullptr) std::cerr.rdbuf(errors_);
    }

  private:
    int overflow(int letter) override { return letter == EOF ? 0 : letter; }

    std::streambuf *output_ = nullptr, *errors_ = nullptr;
};

/// The text on a terminal that says how far the work is; the first process writes it.
class Terminal {
  public:
    explicit Terminal(bool writes) : writes_(writes && isatty(STDERR_FILENO) != 0) {}
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() { show(""); }
    void show(const std::string& text) const {
        if (writes_) std::cerr << "\r\033[K" << text << std::flush;
    }

  private:
    bool writes_;
};

}  // namespace distributed
