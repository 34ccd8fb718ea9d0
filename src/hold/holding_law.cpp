#include "hold/holding_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hold/settings.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/rest_verdict.hpp"

namespace lcpush::desktop {

HoldingLaw::HoldingLaw(const SceneFile& hand, const PushOptions& options)
    : hand_(hand), work_(options), touching_(hand.points.size(), true),
      holds_now_(holds(1, Vector6<double>::Zero())), pads_(hand, touching_),
      pads_least_(pads_.grip(true)) {
  if (!holds_now_ && pads_least_ <= 1) holds_now_ = true;
}

PushOptions HoldingLaw::options() const {
  PushOptions options = work_.options();
  if (!is_first_) options.max_pivots = hold_settings.most_pivots;
  return options;
}

std::optional<bool> HoldingLaw::holds(double factor, const Vector6<double>& more) {
  if (work_.is_used_up()) return std::nullopt;
  SceneFile there = with_grip(hand_, factor);
  there.object.wrench += more;
  Push push(there);
  Vector6<double> motion;
  if (push.solve_at_rest(options(), motion) != Status::solved) return std::nullopt;
  const Scales<double>& scales = push.layout().scales;
  const Rest rest =
      decide_rest(there, {motion, scales, rest_noise(there, scales, work_.options().solver)});
  if (rest == Rest::not_known) return std::nullopt;
  if (std::exchange(is_first_, false) && rest == Rest::holds) {
    std::size_t i = 0;
    for (const ContactAnswer<double>& contact : push.last_answer().contacts)
      touching_[i++] = contact.normal_force > 0;
  }
  return rest == Rest::holds;
}

double HoldingLaw::least_grip(double bound) {
  const auto is_held = [&](double factor) {
    return holds(factor, Vector6<double>::Zero()).value_or(false);
  };
  double low = std::isnan(pads_least_) ? bound : std::max(bound, pads_least_);
  if (low <= statics_settings.closed) return 0;
  if (is_held(low * (1 + hold_settings.same))) return low;
  double step = hold_settings.first_step * std::max(low, hold_settings.least_unit);
  double high = low + step;
  while (!is_held(high) && high < statics_settings.most_force && !work_.is_used_up()) {
    low = high;
    step *= 2;
    high = low + step;
  }
  while (high - low > hold_settings.law * high && !work_.is_used_up()) {
    const double middle = (low + high) / 2;
    (is_held(middle) ? high : low) = middle;
  }
  return high - low <= hold_settings.told * high ? high : std::numeric_limits<double>::quiet_NaN();
}

double HoldingLaw::limit(const Vector6<double>& wrench, double bound, bool asks) {
  const double pads = pads_.limit(wrench, !asks);
  if (std::isinf(pads)) return bound;
  const double limit = std::isnan(pads) ? bound : std::min(pads, bound);
  if (!asks || !(limit > 0)) return limit;
  if (std::isfinite(limit) && holds(1, (1 - hold_settings.same) * limit * wrench).value_or(false))
    return limit;
  return searched(wrench,
                  std::isfinite(limit) ? limit : statics_settings.most_force / wrench.norm());
}

/// The largest load that is found to hold, a little below most often. Loads in between are taken to
/// be held where more is: the law promises no convex set. A search that ends early, but not to a
/// per cent, has found nothing.
double HoldingLaw::searched(const Vector6<double>& wrench, double high) {
  const auto is_held = [&](double load) {
    return load <= 0 || holds(1, load * wrench).value_or(false);
  };
  double step = hold_settings.first_step * high, low = high - step;
  while (!is_held(low) && !work_.is_used_up()) {
    high = low;
    step *= 2;
    low = std::max(0.0, high - step);
  }
  while (high - low > hold_settings.law * high && !work_.is_used_up()) {
    const double middle = (low + high) / 2;
    (is_held(middle) ? low : high) = middle;
  }
  return high - low <= hold_settings.told * high ? low : std::numeric_limits<double>::quiet_NaN();
}

} // namespace lcpush::desktop
