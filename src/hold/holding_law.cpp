#include "hold/holding_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
  const bool is_proved = !std::isnan(pads_least_);
  const double least = is_proved ? std::max(bound, pads_least_) : bound;
  if (holds_now_ == true && least > 1) return 1;
  const auto is_held = [&](double factor, bool unknown) {
    return holds(factor, Vector6<double>::Zero()).value_or(unknown);
  };
  if (least <= statics_settings.closed && (is_proved || is_held(0, false))) return 0;
  const double refuted = holds_now_ == false ? std::max(least, 1.0) : least;
  if (refuted == least && is_held(least * (1 + pads_.slack()), is_proved)) return least;
  const double found = searched(refuted, 1, [&](double factor) { return is_held(factor, false); });
  return refuted == least && found <= least * (1 + pads_.slack()) ? least : found;
}

double HoldingLaw::limit(const Vector6<double>& wrench, double bound, bool asks) {
  const double pads = pads_.limit(wrench, !asks);
  if (std::isinf(pads)) return bound;
  const bool is_proved = !std::isnan(pads);
  const double limit = is_proved ? std::min(pads, bound) : bound;
  if (!asks || !(limit > 0)) return limit;
  // Points bear less than surfaces of all the load, as if the grip were less.
  const double slack = pads_.slack(), most = (1 - slack) * limit;
  const auto is_held = [&](double load) {
    return load <= 0 || holds(1, load * wrench).value_or(false);
  };
  if (std::isfinite(limit) && holds(1 + slack, most * wrench).value_or(is_proved)) {
    // Which points touch was improved from corner to corner: the law may know better ones.
    const double more = (1 + hold_settings.of_points) * limit;
    return more < bound && std::isfinite(bound) && is_held(more)
               ? std::fmax(more, searched(bound, -1, is_held))
               : limit;
  }
  const double found = searched(
      std::isfinite(limit) ? limit : statics_settings.most_force / wrench.norm(), -1, is_held);
  return found >= most ? limit : found;
}

/// From what does not hold upwards or downwards: the nearest that is found to hold. What lies
/// beyond is taken to be held: the law promises no convex set. A search that ends before that is
/// known to what points leave open has found nothing.
double HoldingLaw::searched(double refuted, double sign,
                            const std::function<bool(double)>& is_held) const {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const double unit = std::max(refuted, hold_settings.least_unit);
  double step = hold_settings.first_step * unit, held = std::max(0.0, refuted + sign * step);
  while (!is_held(held)) {
    if (work_.is_used_up() || held > statics_settings.most_force * unit) return nothing;
    refuted = held;
    step *= 2;
    held = std::max(0.0, refuted + sign * step);
  }
  const auto is_open = [&](double precision) {
    return std::abs(held - refuted) > precision * std::max(held, hold_settings.least_unit * unit);
  };
  while (is_open(hold_settings.law) && !work_.is_used_up()) {
    const double middle = (held + refuted) / 2;
    (is_held(middle) ? held : refuted) = middle;
  }
  return is_open(hold_settings.of_points) ? nothing : held;
}

} // namespace lcpush::desktop
