#include "hold/holding_law.hpp"

#include <algorithm>
#include <cmath>

#include "hold/settings.hpp"
#include "solve/grip_search.hpp"
#include "solve/rest_verdict.hpp"

namespace lcpush::desktop {

HoldingLaw::HoldingLaw(const SceneFile& hand, const PushOptions& options)
    : hand_(hand), options_(options), counter_(options.watcher),
      touching_(hand.points.size(), true), holds_now_(holds(1, Vector6<double>::Zero())),
      pads_(hand, touching_), pads_least_(pads_.grip(true)) {
  options_.watcher = &counter_;
  options_.max_pivots = hold_settings.most_pivots;
  if (!holds_now_ && pads_least_ <= 1) holds_now_ = true;
}

bool HoldingLaw::may_ask() const { return counter_.pivots() < hold_settings.all_pivots; }

std::optional<bool> HoldingLaw::holds(double factor, const Vector6<double>& more) {
  SceneFile there = hand_;
  for (Actuator<double>& actuator : there.actuators) actuator.force *= factor;
  for (Body<double>& body : there.bodies) body.preload *= factor;
  there.object.wrench += more;
  Push push(there);
  Vector6<double> motion;
  if (push.solve_at_rest(options_, motion) != Status::solved) return std::nullopt;
  const Scales<double>& scales = push.layout().scales;
  const Rest rest =
      decide_rest(there, {motion, scales, rest_noise(there, scales, options_.solver)});
  if (rest == Rest::not_known) return std::nullopt;
  if (is_first_ && rest == Rest::holds) {
    is_first_ = false;
    std::size_t i = 0;
    for (const ContactAnswer<double>& contact : push.last_answer().contacts)
      touching_[i++] = contact.normal_force > 0;
  }
  return rest == Rest::holds;
}

SmallestGrip HoldingLaw::least_grip(double bound) {
  SmallestGrip grip;
  grip.bound = bound;
  const auto none = Vector6<double>::Zero();
  if (pads_least_ >= 0 && holds(pads_least_ * (1 + hold_settings.same), none).value_or(true)) {
    grip.factor = pads_least_;
    grip.source = pads_least_ - bound <= hold_settings.same * bound ? GripSource::statics
                                                                    : GripSource::search;
    return grip;
  }
  Holding<double> holding;
  holding.factor = std::isnan(pads_least_) ? bound : std::max(bound, pads_least_);
  holding.unit = std::max(holding.factor, hold_settings.least_unit);
  const CountingWatcher work(options_);
  grip = search_upwards(holding, holds_now_.value_or(false) ? 1 : 0,
                        {hold_settings.law, hold_settings.most_force}, work,
                        [&](double factor) { return holds(factor, none).value_or(false); });
  grip.bound = bound;
  return grip;
}

double HoldingLaw::limit(const Vector6<double>& wrench, double bound, bool asks) {
  const double pads = pads_.limit(wrench);
  if (std::isinf(pads)) return bound;
  const double limit = std::isnan(pads) ? bound : std::min(pads, bound);
  if (!(limit > 0)) return limit;
  if (!asks || !may_ask()) return pads;
  if (std::isfinite(limit) &&
      holds(1, (1 - hold_settings.same) * limit * wrench).value_or(!std::isnan(pads)))
    return limit;
  return bisected(wrench, std::isfinite(limit) ? limit : hold_settings.most_force / wrench.norm());
}

/// Loads in between are taken to be held where more is: the law promises no convex set. A search
/// that ends early, but not to a per cent, has found nothing.
double HoldingLaw::bisected(const Vector6<double>& wrench, double high) {
  double low = 0;
  const double least = hold_settings.law * high;
  while (high - low > least && may_ask()) {
    const double middle = (low + high) / 2;
    (holds(1, middle * wrench).value_or(false) ? low : high) = middle;
  }
  return high - low <= hold_settings.told * high ? (low + high) / 2
                                                 : std::numeric_limits<double>::quiet_NaN();
}

} // namespace lcpush::desktop
