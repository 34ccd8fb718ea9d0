// What stderr says while the work takes longer than a second.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include <unistd.h>

#include "lcpush/desktop/watcher.hpp"
#include "text/format.hpp"

namespace lcpush::cli {

/// At most one line a second. On a terminal it is rewritten, and wiped at the end.
class StatusLine {
public:
  ~StatusLine() {
    if (shown_ && terminal_) std::fprintf(stderr, "\r\033[K");
  }

  /// Is it time for another line?
  bool is_due() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::seconds(1);
    return true;
  }

  std::string seconds() const {
    const auto passed = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begin_);
    return std::to_string(passed.count()) + " s";
  }

  void show(const std::string& text) {
    shown_ = true;
    std::fprintf(stderr, "%slcpush: %s%s", terminal_ ? "\r\033[K" : "", text.c_str(),
                 terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

  /// How much of a parameter's sweep is done.
  void show_share(double done) {
    if (is_due()) show(std::to_string(std::lround(100 * done)) + " % of the sweep");
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), next_ = begin_ + std::chrono::seconds(1);
  bool shown_ = false, terminal_ = isatty(STDERR_FILENO) != 0;
};

/// Watches Lemke's pivots, or sweeps.
class Progress : public desktop::Watcher {
public:
  void stepped(const Lemke<double>& lemke) override {
    progressed(lemke.dictionary().size(), lemke.covers_tried());
  }

  void progressed(Index unknowns, Index covers) override {
    ++pivots_;
    if (line_.is_due())
      line_.show(line_.seconds() + ", " + std::to_string(pivots_) + " pivots, " +
                 std::to_string(unknowns) + " unknowns, cover " + std::to_string(covers));
  }

  void swept(Index sweep, const double*, double residual) override {
    if (line_.is_due())
      line_.show(line_.seconds() + ", sweep " + std::to_string(sweep) +
                 desktop::printed(", residual %.1e", residual));
  }

private:
  StatusLine line_;
  long pivots_ = 0;
};

} // namespace lcpush::cli
