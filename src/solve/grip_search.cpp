#include "solve/grip_search.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double nudge = 1e-6;    // statics' bound is the answer if this much more holds
constexpr double stride = 16;     // of the excess over the bound, while nothing holds
constexpr double roughest = 1e-3; // a wider bracket is no answer
constexpr int most_drops = 6;     // times that less is looked for below what holds

/// From statics' bound to the law's own factor, in excesses over the bound: one that does not hold
/// and one that does.
struct Bracket {
  const SmallestGrip& grip;
  double unit, low, high;
  const CountingWatcher& work;
  const GripQuestion& holds;

  double factor(double excess) const { return grip.bound + excess * unit; }
  double width() const { return (high - low) * unit / factor(high); }
  void narrow(double precision) {
    while (width() > precision && !work.is_used_up()) {
      const double middle = high > stride * low ? std::sqrt(low * high) : (low + high) / 2;
      (holds(factor(middle)) ? high : low) = middle;
    }
  }
  /// What does not hold may lie between what does: where the law leaves more than one answer, or
  /// where a finger's squeeze drives the object out. Looks for that below, the farthest first.
  bool drop() {
    constexpr double parts[] = {0.7,  0.5,  0.3,  0.2,  0.1,  0.05, 0.02,
                                0.01, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 3e-6};
    double below = nudge;
    for (const double part : parts) {
      const double next = high - part * factor(high) / unit;
      if (next <= below) continue;
      if (work.is_used_up()) return false;
      if (holds(factor(next))) {
        low = below;
        high = next;
        return true;
      }
      below = next;
    }
    return false;
  }
};

} // namespace

SmallestGrip search_upwards(double bound, double load, double known, const Precision& precision,
                            const CountingWatcher& work, const GripQuestion& holds) {
  SmallestGrip grip;
  grip.bound = bound;
  if (work.is_used_up()) return grip;
  const double unit = std::max(bound, load / 1000);
  if (!(unit > 0) || holds(grip.bound + nudge * unit) || (grip.bound > 0 && holds(grip.bound))) {
    grip.factor = grip.certain = grip.bound;
    grip.source = GripSource::statics;
    return grip;
  }
  Bracket found{grip, unit, nudge, (known - grip.bound) / unit, work, holds};
  if (found.high <= found.low) found.high = -1;
  for (double next = stride * nudge; found.high < 0 && next <= precision.growth; next *= stride) {
    if (work.is_used_up()) return grip;
    (holds(found.factor(next)) ? found.high : found.low) = next;
  }
  if (found.high < 0) return grip;
  found.narrow(precision.width);
  if (found.width() > roughest) return grip;
  grip.factor = grip.certain = found.factor(found.high);
  grip.source = GripSource::search;
  for (int more = 0; more < most_drops; ++more) {
    if (!found.drop()) break;
    found.narrow(precision.width);
    if (found.width() > roughest) break;
    grip.factor = found.factor(found.high);
  }
  return grip;
}

} // namespace lcpush::desktop
