// A line on stderr while a solve takes longer than a second.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include <unistd.h>

#include "lcpush/desktop/watcher.hpp"

namespace lcpush::cli {

/// Watches Lemke's pivots, or sweeps. On a terminal the line is rewritten and wiped at the end.
class Progress : public desktop::Watcher {
public:
  ~Progress() override {
    if (shown_ && terminal_) std::fprintf(stderr, "\r\033[K");
  }

  void stepped(const Lemke<double>& lemke) override {
    progressed(lemke.dictionary().size(), lemke.covers_tried());
  }

  void progressed(Index unknowns, Index covers) override {
    ++pivots_;
    const long seconds = second();
    if (seconds < 0) return;
    std::fprintf(stderr, "%slcpush: %ld s, %ld pivots, %td unknowns, cover %td%s",
                 terminal_ ? "\r\033[K" : "", seconds, pivots_, unknowns, covers,
                 terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

  void swept(Index sweep, const double*, double residual) override {
    const long seconds = second();
    if (seconds < 0) return;
    std::fprintf(stderr, "%slcpush: %ld s, sweep %td, residual %.1e%s", terminal_ ? "\r\033[K" : "",
                 seconds, sweep, residual, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), next_ = begin_ + std::chrono::seconds(1);
  long pivots_ = 0;
  bool shown_ = false;
  bool terminal_ = isatty(STDERR_FILENO) != 0;

  /// The seconds since the start, once a second; -1 in between.
  long second() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return -1;
    next_ = now + std::chrono::seconds(1);
    shown_ = true;
    return static_cast<long>(
        std::chrono::duration_cast<std::chrono::seconds>(now - begin_).count());
  }
};

} // namespace lcpush::cli
