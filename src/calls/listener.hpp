// Whoever asked through C is told how far the work is, and may end it.
#pragma once

#include "commands/listener.hpp"
#include "lcpush/lcpush_desktop.h"

#include <chrono>
#include <limits>

namespace lcpush::calls {

/// Leaves the work where it cannot be ended otherwise: all of it owns its memory.
struct Cancelled {};

/// Calls the other one at most 50 times a second.
class ForeignListener : public commands::Listener {
public:
  explicit ForeignListener(const lcpush_desktop_listener* other) : other_(other) {}

  /// The work is to end with what there is after so much processor time of this thread.
  void end_after(double seconds) { seconds_ = seconds; }
  bool was_cancelled() const { return was_cancelled_; }

  void progress(double done, const std::string& of) override;
  desktop::Stop stop(double part) override;
  void end_if_cancelled() override {
    if (is_cancelled()) throw Cancelled();
  }
  Index choose_row(const desktop::PivotTrace&) override { return 0; } // nobody is asked
  void stepped(const Lemke<double>&) override { end_if_cancelled(); }
  void progressed(Index, Index) override { end_if_cancelled(); }
  void swept(Index, const double*, double) override { end_if_cancelled(); }

private:
  using Clock = std::chrono::steady_clock;
  const lcpush_desktop_listener* other_;
  Clock::time_point next_look_ = Clock::now(), next_note_ = next_look_;
  double seconds_ = std::numeric_limits<double>::infinity(), begin_ = processor_time();
  bool was_cancelled_ = false;

  static double processor_time(); // s, of this thread
  bool is_cancelled();
};

} // namespace lcpush::calls
