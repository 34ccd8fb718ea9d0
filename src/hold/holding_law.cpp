#include "hold/holding_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hold/settings.hpp"
#include "lcpush/desktop/smallest_grip.hpp"

namespace lcpush::desktop {

HoldingLaw::HoldingLaw(const SceneFile& hand, const PushOptions& options,
                       const GripStatics& statics, bool is_squeezed)
    : hand_(hand), statics_(statics), work_(options), touching_(hand.points.size(), true),
      holds_now_(holds(1, Vector6<double>::Zero())), pads_(hand, touching_),
      pads_least_(pads_.grip(true)), is_open_(is_squeezed || hand.hand != Hand::parallel) {
  for (Index b = 0; b < static_cast<Index>(hand.bodies.size()); ++b)
    is_open_ = is_open_ || !is_driven(hand.view(), b);
  knows_prestress_ = !is_open_ || hand.hand == Hand::locked;
  if (!holds_now_ && pads_least_ <= 1 && !is_squeezed) holds_now_ = true;
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
  const HoldReport rest = push.holds_without_push(options());
  if (rest.status != Status::solved) return std::nullopt;
  if (std::exchange(is_first_, false) && rest.holds) {
    std::size_t i = 0;
    for (const ContactAnswer<double>& contact : push.last_answer().contacts)
      touching_[i++] = contact.normal_force > 0;
  }
  return rest.holds;
}

/// By what the pads' points bear, or by statics, where the law agrees; else by the law's own word.
/// Between answers that rest it may find some that fall.
double HoldingLaw::least_grip(double bound) {
  const auto is_held = [&](double factor) { return holds(factor, Vector6<double>::Zero()); };
  const bool is_proved = !std::isnan(pads_least_) && knows_prestress_;
  const bool is_locked = hand_.hand == Hand::locked; // the law counts on a wedge, and nobody should
  const double start = is_proved ? std::max(bound, pads_least_) : bound;
  if (start <= statics_settings.closed && is_held(0).value_or(is_proved)) return 0;
  if (is_locked && holds_now_ == true && start > 1) return std::numeric_limits<double>::quiet_NaN();
  // Pads' points touch in more than one way, and these forces are the best of one.
  const bool may_be_less = is_proved && !is_locked && bound < (1 - hold_settings.of_points) * start;
  if (may_be_less && is_held((1 + hold_settings.same) * bound) == true) return bound;
  double least = least_from(start, is_proved, is_held);
  if (may_be_less && least == start) least = lowered(start, bound, is_held);
  if (holds_now_ == true && least > 1) least = lowered(1, bound, is_held);
  return least <= statics_settings.closed ? 0 : beyond_falls(least, is_held);
}

/// A least grip, or a larger one where the law falls a little above: who grips harder than the
/// least that is told shall hold. It may cost a part of the work: limits are to be found as well.
double HoldingLaw::beyond_falls(double least, const Question& is_held) {
  work_.allow(hold_settings.more_share);
  double told = least;
  for (bool falls_above = true; falls_above && !work_.is_used_up();) {
    double falls = 0;
    for (const double part : hold_settings.more)
      if (is_held(part * told) == false) falls = part * told;
    falls_above = falls > 0;
    if (!falls_above) break;
    const double found = searched(falls, 1, is_held);
    if (std::isnan(found) || (holds_now_ == true && found > 1)) break;
    told = found;
  }
  work_.allow(1);
  return told;
}

/// `start`, or the nearest above it that the law is found to hold; with nothing proved, nearest
/// below the present grip if that holds: what lies between may fall.
double HoldingLaw::least_from(double start, bool is_proved, const Question& is_held) const {
  const bool is_refuted = holds_now_ == false && start <= 1;
  if (is_refuted) return searched(1, 1, is_held);
  const std::optional<bool> is_start = is_held((1 + hold_settings.same) * start);
  if (is_start.value_or(is_proved)) return start;
  const double more = (1 + hold_settings.of_points) * start;
  if (is_proved && is_held(more) == true) {
    const double found = halved(start, more, is_held);
    return std::isnan(found) ? more : found;
  }
  return !is_proved && holds_now_ == true && start < 1 ? halved(start, 1, is_held)
                                                       : searched(start, 1, is_held);
}

/// More than the most is a grip that the law does not hold, or there is none that is known. Where
/// surfaces' forces may be a prestress, only what the law holds.
double HoldingLaw::most_grip(double bound) {
  const double pads = pads_.grip(false);
  const auto is_held = [&](double factor) { return holds(factor, Vector6<double>::Zero()); };
  if (holds_now_ != true) return pads;
  if (knows_prestress_)
    return std::isfinite(pads) && is_held((1 + hold_settings.beyond) * pads) == true
               ? std::numeric_limits<double>::infinity()
               : pads;
  const double most = std::isfinite(pads) ? std::min(pads, bound) : bound;
  const double far = std::min(most, statics_settings.most_force);
  if (is_held(far) == true) return most;
  return far > 1 ? halved(far, 1, is_held) : 1;
}

double HoldingLaw::limit(const Vector6<double>& wrench, double bound, bool asks) {
  const double pads = pads_.limit(wrench, !asks);
  if (std::isinf(pads) && std::isinf(bound) && !is_open_) return bound;
  const bool is_proved = std::isfinite(pads) && !is_open_; // surfaces know no prestress
  const double limit = is_proved ? std::min(pads, bound) : bound;
  if (!asks || !(limit > 0)) return limit;
  // Points bear a little less than surfaces; of statics' bound, which no surface proves, the law is
  // asked itself.
  const double slack = is_proved ? pads_.slack() : hold_settings.same, most = (1 - slack) * limit;
  const auto is_held = [&](double load) {
    return load <= 0 ? std::optional(true) : holds(1, load * wrench);
  };
  if (std::isfinite(limit) && holds(1, most * wrench).value_or(is_proved)) {
    // Which points touch was improved from corner to corner: the law may know better ones.
    const double more = (1 + hold_settings.of_points) * limit;
    if (!(more < bound && std::isfinite(bound))) return is_open_ ? not_less(limit, is_held) : limit;
    const std::optional<bool> holds_more = is_held(more);
    may_bear_more_ = may_bear_more_ || (!holds_more && work_.is_used_up());
    if (holds_more != true) return is_open_ ? not_less(limit, is_held) : limit;
    const double near = (1 - hold_settings.of_points) * bound; // mostly it is statics' then
    const double found = halved(bound, near > more && is_held(near) == true ? near : more, is_held);
    return is_open_ ? not_less(found, is_held) : found;
  }
  const double cap =
      statics_settings.most_force * statics_.scales().force / statics_.wrench_column(wrench).norm();
  const double far = std::isfinite(limit) ? limit : cap;
  // Of such forces a point may lie a hair off the line of what presses it.
  for (const double part : {1.0, 1 - hold_settings.of_points})
    if (far >= cap && is_held(part * far) == true) return std::numeric_limits<double>::infinity();
  const double found = far < cap ? searched(far, -1, is_held)
                                 : from_unit(cap / statics_settings.most_force, cap, is_held);
  const double least = not_less(found, is_held);
  return least == found && found >= most ? limit : least;
}

/// Up from `unit`, or down, in strides as long as it: where nothing but `most` bounds what is held.
double HoldingLaw::from_unit(double unit, double most, const Question& is_held) const {
  constexpr double stride = hold_settings.stride;
  double held = 0, refuted = most;
  if (is_held(unit) == true) {
    held = unit;
    for (double next = stride * unit; next < most; held = next, next *= stride)
      if (is_held(next) != true) {
        refuted = next;
        break;
      }
  } else {
    refuted = unit;
    for (double next = unit / stride; next > hold_settings.least_unit * unit; next /= stride) {
      if (is_held(next) == true) {
        held = next;
        break;
      }
      refuted = next;
    }
  }
  return halved(refuted, held, is_held);
}

/// A load that is held, or less where a part of it is not: beside a table or a locked finger the
/// law holds some loads by a prestress that less of them do not make.
double HoldingLaw::not_less(double held, const Question& is_held) const {
  for (const double part : hold_settings.less)
    if (is_held(part * held) == false) return halved(part * held, 0, is_held);
  return held;
}

/// From what holds downwards, with longer and longer strides, to the end of what is found to hold;
/// nan: there was no work left to look.
double HoldingLaw::lowered(double from, double bound, const Question& is_held) const {
  double held = from;
  for (double step = hold_settings.first_step * from; !work_.is_used_up(); step *= 2) {
    const double next = std::max(held - step, bound);
    if (!(next < held)) return held;
    if (is_held((1 + hold_settings.same) * next) == true) {
      held = next;
      continue;
    }
    const double found = halved(next, held, is_held);
    return std::isnan(found) && held < from ? held : found; // which holds, if not as the least
  }
  return held < from ? held : std::numeric_limits<double>::quiet_NaN();
}

/// From what does not hold upwards or downwards: the nearest that is found to hold. What lies
/// beyond is taken to be held: the law promises no convex set.
double HoldingLaw::searched(double refuted, double sign, const Question& is_held) const {
  const double unit = std::max(refuted, hold_settings.least_unit);
  double step = hold_settings.first_step * unit, held = std::max(0.0, refuted + sign * step);
  while (is_held(held) != true) {
    if (work_.is_used_up() || held > statics_settings.most_force * unit)
      return std::numeric_limits<double>::quiet_NaN();
    refuted = held;
    step *= 2;
    held = std::max(0.0, refuted + sign * step);
  }
  return halved(refuted, held, is_held);
}

/// The end of what holds, between what does not and what does. A search that ends before that is
/// known to what points leave open has found nothing, nor has one that ends at no answer.
double HoldingLaw::halved(double refuted, double held, const Question& is_held) const {
  const double least = hold_settings.least_unit * std::max(refuted, hold_settings.least_unit);
  bool is_refuted = true; // else its last question had no answer
  const auto is_open = [&](double precision) {
    return std::abs(held - refuted) > precision * std::max(held, least);
  };
  while (is_open(hold_settings.law) && !work_.is_used_up()) {
    const double middle = (held + refuted) / 2;
    const std::optional<bool> is_middle = is_held(middle);
    (is_middle == true ? held : refuted) = middle;
    if (is_middle != true) is_refuted = is_middle.has_value();
  }
  return is_open(hold_settings.of_points) || !is_refuted ? std::numeric_limits<double>::quiet_NaN()
                                                         : held;
}

} // namespace lcpush::desktop
