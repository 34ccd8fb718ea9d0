// Where a component of the object's acceleration is zero.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sweep/settings.hpp"
#include "sweep/sweep_samples.hpp"

namespace lcpush::desktop {
namespace {

/// Below this a component counts as zero: rounding, or nothing compared with its largest value.
Vector6<double> thresholds(const Sweep& sweep) {
  Vector6<double> noise = Vector6<double>::Zero(), largest = noise;
  for_each_value(sweep, [&](const SweepValue& value) {
    for (Index k = 0; k < 6; ++k) noise[k] = std::max(noise[k], value.push.twist_noise(k));
    largest = largest.cwiseMax(value.push.twist.cwiseAbs());
  });
  const Vector6<double> zero = noise.cwiseMax(SweepSettings::negligible * largest);
  // -1: zero everywhere, which is not worth a word
  return (largest.array() > zero.array()).select(zero, -1.0);
}

int sign_of(double value, double zero) { return value > zero ? 1 : value < -zero ? -1 : 0; }

/// The zeros of one component after those of others, with the signs on either side.
class ZeroList {
public:
  explicit ZeroList(std::vector<SweepZero>& zeros)
      : zeros_(zeros), first_(zeros.size()), open_(first_) {}

  /// Joined with the last one where they touch.
  void add(SweepZero zero) {
    zero.before = sign_;
    SweepZero* const last = zeros_.size() > first_ ? &zeros_.back() : nullptr;
    if (last != nullptr && last->to == zero.from && !last->jumps && !zero.jumps)
      last->to = zero.to;
    else
      zeros_.push_back(zero);
  }
  /// The next value's sign; a zero's has been added.
  void see(int sign) {
    if (sign == 0) return;
    for (; open_ < zeros_.size(); ++open_) zeros_[open_].after = sign;
    sign_ = sign;
  }
  /// There is no value.
  void lose() {
    open_ = zeros_.size();
    sign_ = 0;
  }

private:
  std::vector<SweepZero>& zeros_;
  std::size_t first_, open_; ///< of this component; of those whose sign after them is to come
  int sign_ = 0;
};

void add_of_segments(const std::vector<SweepSegment>& segments, Index k, double threshold,
                     ZeroList& zeros) {
  int before = 0; // the sign where the last segment ended
  for (const SweepSegment& segment : segments) {
    if (!segment.at_from.push.is_solved()) {
      before = 0;
      zeros.lose();
      continue;
    }
    const double a = segment.at_from.push.twist[k], b = segment.at_to.push.twist[k];
    const int first = sign_of(a, threshold), last = sign_of(b, threshold);
    if (before * first < 0) zeros.add({k, segment.from, segment.from, true});
    if (first == 0) zeros.add({k, segment.from, last == 0 ? segment.to : segment.from, false});
    zeros.see(first);
    if (first * last < 0) {
      const double at = segment.from + a / (a - b) * (segment.to - segment.from);
      zeros.add({k, at, at, false});
    }
    if (first != 0 && last == 0) zeros.add({k, segment.to, segment.to, false});
    zeros.see(last);
    before = last;
  }
}

/// A change of sign between two points, in bisection: what is found, and points that show it.
struct Crossing {
  SweepZero zero;
  std::vector<SweepPoint> points; ///< between the two, in order
};

Crossing crossing_between(SweepSolver& solver, Index k, double threshold, const SweepPoint& first,
                          const SweepPoint& second) {
  const Variation& variation = solver.variations().front();
  const auto share_of = [&](double value) {
    return (value - variation.from) / (variation.to - variation.from);
  };
  const double whole = std::abs(second.at.push.twist[k] - first.at.push.twist[k]);
  const std::vector<Question> asked = {Question::push};
  Sample low = sample_at(solver, share_of(first.value), nullptr, asked);
  Sample high = sample_at(solver, share_of(second.value), nullptr, asked);
  Sample shoulder_low = low, shoulder_high = high; // the last ones that are not yet on the slope
  const auto value = [k](const Sample& sample) { return sample.push.twist[k]; };
  if (sign_of(value(low), 0) * sign_of(value(high), 0) != -1) // afresh, another branch is found
    return {{k, first.value, second.value, true}, {}};
  const auto near = [&](const Sample& sample, const SweepPoint& end) {
    return std::abs(value(sample) - end.at.push.twist[k]) <= SweepSettings::shoulder * whole;
  };
  while (high.t - low.t > SweepSettings::zero_width) {
    Sample middle = sample_at(solver, (low.t + high.t) / 2, &low, asked);
    if (!middle.push.is_solved()) break;
    const bool below = sign_of(value(middle), 0) * sign_of(value(low), 0) > 0;
    if (below && near(middle, first)) shoulder_low = middle;
    if (!below && near(middle, second)) shoulder_high = middle;
    (below ? low : high) = std::move(middle);
  }
  Crossing crossing;
  const double rise = value(high) - value(low);
  crossing.zero.component = k;
  crossing.zero.jumps =
      std::abs(rise) > std::max(SweepSettings::steepest_zero * whole, 2 * threshold);
  const double t = crossing.zero.jumps ? high.t : low.t - value(low) / rise * (high.t - low.t);
  crossing.zero.from = crossing.zero.to = value_at(variation, t);
  const auto show = [&](const Sample& at) { // with both answers
    crossing.points.push_back(refined_point(sample_at(solver, at.t, &at), variation));
  };
  if (shoulder_low.t > share_of(first.value)) show(shoulder_low);
  if (!crossing.zero.jumps) show(sample_at(solver, t, &low, asked));
  if (shoulder_high.t < share_of(second.value)) show(shoulder_high);
  return crossing;
}

void add_of_points(SweepSolver& solver, Index k, double threshold, std::vector<SweepPoint>& points,
                   ZeroList& zeros) {
  const auto sign = [&](const SweepPoint& point) {
    return point.at.push.is_solved() ? sign_of(point.at.push.twist[k], threshold) : 2;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int here = sign(points[i]);
    const int next = i + 1 < points.size() ? sign(points[i + 1]) : 2;
    if (here == 0) {
      zeros.add({k, points[i].value, next == 0 ? points[i + 1].value : points[i].value, false});
      continue;
    }
    if (here == 2)
      zeros.lose();
    else
      zeros.see(here);
    if (here * next != -1) continue;
    if (points[i].change.jumps) {
      zeros.add({k, points[i].value, points[i + 1].value, true});
      continue;
    }
    const Crossing crossing = crossing_between(solver, k, threshold, points[i], points[i + 1]);
    zeros.add(crossing.zero);
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(i) + 1, crossing.points.begin(),
                  crossing.points.end());
    i += crossing.points.size();
  }
}

} // namespace

void find_zeros(SweepSolver& solver, Sweep& sweep) {
  const Vector6<double> threshold = thresholds(sweep);
  for (Index k = 0; k < 6; ++k) {
    const double zero = threshold[k];
    if (zero < 0) continue;
    ZeroList zeros(sweep.zeros);
    if (!sweep.segments.empty())
      add_of_segments(sweep.segments, k, zero, zeros);
    else
      add_of_points(solver, k, zero, sweep.points, zeros);
  }
}

} // namespace lcpush::desktop
