// Whoever asked is told how far the work is, and may end it.
#pragma once

#include "lcpush/desktop/watcher.hpp"
#include "lcpush/lcpush_desktop.h"

#include <chrono>

namespace lcpush::desktop {

/// Leaves the work where it cannot be ended otherwise: all of it owns its memory.
struct Cancelled {};

class Listener {
public:
  explicit Listener(const lcpush_desktop_listener* other) : other_(other) {}

  /// Cheap: asks at most 50 times a second.
  bool is_cancelled();
  void pass_on(double done);

  void end_if_cancelled() {
    if (is_cancelled()) throw Cancelled();
  }
  bool was_cancelled() const { return cancelled_; }

private:
  using Clock = std::chrono::steady_clock;
  const lcpush_desktop_listener* other_;
  Clock::time_point next_ask_ = Clock::now(), next_tell_ = next_ask_;
  bool cancelled_ = false;
};

/// Ends pivots and sweeps.
class ListeningWatcher : public Watcher {
public:
  explicit ListeningWatcher(Listener& listener) : listener_(listener) {}
  void stepped(const Lemke<double>&) override { listener_.end_if_cancelled(); }
  void progressed(Index, Index) override { listener_.end_if_cancelled(); }
  void swept(Index, const double*, double) override { listener_.end_if_cancelled(); }

private:
  Listener& listener_;
};

} // namespace lcpush::desktop
