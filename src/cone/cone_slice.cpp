// A cut through a motion cone: where along one number of its motion a pusher sticks.
#include "cone/settings.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/push.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

/// What `break` finds at one value.
struct Sample {
  double value = 0;
  Status status = Status::bad_input;
  bool breaks = false, sticks = false;
  ConeSlice::End there;
  std::vector<Mode> modes;

  bool is_like(const Sample& other) const {
    return status == other.status && breaks == other.breaks && sticks == other.sticks;
  }
};

class Slicer {
public:
  Slicer(const VariedScene& scene, const Variation& variation, Index pusher, const StopCheck& stop)
      : scene_(scene), pusher_(pusher),
        stop_(stop), slice_{variation, pusher, true, Stop::none, {}, {}} {}

  ConeSlice cut() {
    ParameterSweepOptions options;
    options.pusher = pusher_;
    options.both_ways = false;
    options.steps = 2;
    options.stop = stop_;
    const Sweep sweep = sweep_parameter(scene_, {slice_.variation}, options);
    slice_.stop = sweep.stop;
    if (sweep.segments.empty())
      sample();
    else
      for (const SweepSegment& segment : sweep.segments) add(segment);
    return std::move(slice_);
  }

private:
  const VariedScene& scene_;
  const Index pusher_;
  const StopCheck& stop_;
  ConeSlice slice_;

  bool goes_on() {
    if (slice_.stop == Stop::none) slice_.stop = stop_now(stop_);
    return slice_.stop == Stop::none;
  }

  Sample sample_at(double value) const {
    const SceneFile file = scene_.at({slice_.variation.parameter}, {value});
    Push push(file);
    PushOptions options;
    options.other_paths = 0;
    options.explain_jams = false;
    options.study_existence = false;
    Sample found;
    found.value = value;
    if (!(push_size(file.view()) > 0)) return found;
    const BreakReport report = push.find_breaking(pusher_, options);
    found.status = report.status;
    if (found.status != Status::solved) return found;
    found.sticks = found.breaks = report.breaking.breaks;
    for (const ContactAnswer<double>& contact : push.last_answer().contacts)
      found.modes.push_back(contact.mode);
    const Body<double>& pusher = file.body(pusher_);
    for (const Index i : points_of(pusher)) {
      const ContactAnswer<double>& contact = push.last_answer().contacts[i];
      const Vector3<double> slip =
          contact.acceleration - contact.acceleration.dot(pusher.normal) * pusher.normal;
      Mode& mode = found.modes[static_cast<std::size_t>(i)];
      const bool creeps = slip.norm() <= cone_settings.creeps * report.breaking.small_push;
      if (mode == Mode::slide && creeps) mode = Mode::stick;
      found.sticks = found.sticks && mode == Mode::stick;
    }
    found.there = {report.breaking.twist, report.breaking.force};
    stay_in_plane(push.scene(), found.there.wrench); // what keeps it there is no balance's
    return found;
  }

  void add(const SweepSegment& segment) {
    const double by = cone_settings.inside * (segment.to - segment.from);
    ConeSlice::Range range;
    const Sample middle = sample_at((segment.from + segment.to) / 2);
    range.status = middle.status;
    range.breaks = middle.breaks;
    range.sticks = middle.sticks;
    range.from = segment.from;
    range.to = segment.to;
    range.at_from = sample_at(segment.from + by).there;
    range.at_to = sample_at(segment.to - by).there;
    for (const AnswerChange& one : segment.change.breaking)
      for (const ContactChange& contact : one.contacts)
        if (contact.from != contact.to) range.changing.push_back(contact.contact);
    join(std::move(range));
  }

  void join(ConeSlice::Range range) {
    std::sort(range.changing.begin(), range.changing.end());
    range.changing.erase(std::unique(range.changing.begin(), range.changing.end()),
                         range.changing.end());
    slice_.forces.emplace_back(range.from, range.at_from.wrench.head<3>().norm());
    slice_.forces.emplace_back(range.to, range.at_to.wrench.head<3>().norm());
    auto& ranges = slice_.ranges;
    if (ranges.empty() || ranges.back().status != range.status ||
        ranges.back().breaks != range.breaks || ranges.back().sticks != range.sticks) {
      ranges.push_back(std::move(range));
    } else {
      ranges.back().to = range.to;
      ranges.back().at_to = range.at_to;
      ranges.back().changing = std::move(range.changing);
    }
  }

  /// Where a sweep has no segments: what differs between two samples is bisected.
  void sample() {
    slice_.is_exact = false;
    const double from = slice_.variation.from, width = slice_.variation.to - from;
    Sample last = sample_at(from);
    const int samples = cone_settings.samples;
    for (int k = 1; k <= samples && goes_on(); ++k) {
      const Sample next =
          sample_at(k == samples ? slice_.variation.to : from + width * k / samples);
      Sample low = last, high = next;
      while (!low.is_like(high) && goes_on() &&
             std::abs(high.value - low.value) > cone_settings.sampled_to * std::abs(width)) {
        const Sample middle = sample_at((low.value + high.value) / 2);
        (middle.is_like(low) ? low : high) = middle;
      }
      if (low.is_like(high)) {
        join(between(last, next));
      } else {
        join(between(last, low));
        slice_.ranges.back().changing = differing(low, high);
        high.value = low.value;
        join(between(high, next));
      }
      last = next;
    }
  }

  static ConeSlice::Range between(const Sample& one, const Sample& two) {
    return {one.value, two.value, one.status, one.breaks, one.sticks, one.there, two.there, {}};
  }

  static std::vector<Index> differing(const Sample& one, const Sample& two) {
    std::vector<Index> contacts;
    for (std::size_t i = 0; i < std::min(one.modes.size(), two.modes.size()); ++i)
      if (one.modes[i] != two.modes[i]) contacts.push_back(static_cast<Index>(i));
    return contacts;
  }
};

} // namespace

ConeSlice find_slice(const VariedScene& scene, const Variation& variation, Index pusher,
                     const StopCheck& stop) {
  return Slicer(scene, variation, pusher, stop).cut();
}

} // namespace lcpush::desktop
