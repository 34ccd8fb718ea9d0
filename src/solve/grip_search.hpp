// The search for the smallest grip, from statics' bound upwards: what it asks, and what it may
// cost.
#pragma once

#include "lcpush/desktop/smallest_grip.hpp"

#include <algorithm>
#include <functional>

namespace lcpush::desktop {

using GripQuestion = std::function<bool(double factor)>; // does the scene hold at this factor?

/// Counts the pivots of everything that is asked, so that a search costs seconds and no more. A
/// count before the clock: the same input gives the same bits, but where a command's time ends.
class CountingWatcher : public Watcher {
public:
  explicit CountingWatcher(const PushOptions& options) : given_(options), counting_(options) {
    counting_.watcher = this;
    counting_.other_paths = 0;
  }
  CountingWatcher(const CountingWatcher&) = delete;
  CountingWatcher& operator=(const CountingWatcher&) = delete;

  const PushOptions& options() const { return counting_; }
  bool is_used_up() const { return multiplications_ > until_ || is_late(given_); }
  /// What follows may use so much of all there is, until this is said again.
  void allow(double part) { until_ = std::min(most, multiplications_ + part * most); }

  void stepped(const Lemke<double>& lemke) override {
    const auto n = static_cast<double>(lemke.dictionary().size());
    multiplications_ += n * n + overhead;
    if (given_.watcher != nullptr) given_.watcher->stepped(lemke);
  }
  void progressed(Index unknowns, Index covers) override {
    multiplications_ += 64 * static_cast<double>(unknowns) + overhead;
    if (given_.watcher != nullptr) given_.watcher->progressed(unknowns, covers);
  }

private:
  PushOptions given_, counting_;
  // Discs of 96 points are asked in every direction of a hold, in 6 s; with half of it in few.
  static constexpr double most = 2e10, overhead = 2e5; // overhead: what a small pivot costs
  double multiplications_ = 0, until_ = most;
};

struct Precision {
  double width;  ///< of the last bracket, relative
  double growth; ///< largest excess over the bound that is tried, relative
};

/// From statics' bound to the law's own factor; `load`: the factor that makes the grip as large as
/// the load; `known` is a factor that holds, or 0.
SmallestGrip search_upwards(double bound, double load, double known, const Precision& precision,
                            const CountingWatcher& work, const GripQuestion& holds);

} // namespace lcpush::desktop
