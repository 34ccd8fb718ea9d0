// A line on stderr while a solve takes longer than a second.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include <unistd.h>

#include "lcpush/lcp/lemke.hpp"

namespace lcpush::cli {

/// Watches Lemke's pivots. On a terminal the line is rewritten and wiped at the end.
class Progress {
public:
  ~Progress() {
    if (shown_ && terminal_) std::fprintf(stderr, "\r\033[K");
  }

  LemkeOptions<double> watch(LemkeOptions<double> options) {
    options.on_pivot = [](void* self, const Lemke<double>& lemke) {
      static_cast<Progress*>(self)->tick(lemke);
    };
    options.context = this;
    return options;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), next_ = begin_ + std::chrono::seconds(1);
  long pivots_ = 0;
  bool shown_ = false;
  bool terminal_ = isatty(STDERR_FILENO) != 0;

  void tick(const Lemke<double>& lemke) {
    ++pivots_;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::seconds(1);
    shown_ = true;
    const long seconds =
        static_cast<long>(std::chrono::duration_cast<std::chrono::seconds>(now - begin_).count());
    std::fprintf(stderr, "%slcpush: %ld s, %ld pivots, %td unknowns, cover %td%s",
                 terminal_ ? "\r\033[K" : "", seconds, pivots_, lemke.dictionary().size(),
                 lemke.covers_tried(), terminal_ ? "" : "\n");
    std::fflush(stderr);
  }
};

} // namespace lcpush::cli
