#include "sweep/sweep_samples.hpp"

#include <algorithm>
#include <utility>

#include "sweep/sweep_pieces.hpp"

namespace lcpush::desktop {
namespace {

constexpr Index default_steps = 51, default_map_steps = 11;
constexpr double sharpest = 1e-6; // of the range
constexpr double same = 1e-5;     // relative: answers of one branch agree that well

bool same_modes(const Outputs& a, const Outputs& b) {
  if (a.status != b.status || a.contacts.size() != b.contacts.size()) return false;
  for (std::size_t i = 0; i < a.contacts.size(); ++i)
    if (a.contacts[i].mode != b.contacts[i].mode) return false;
  return true;
}

class Sampler {
public:
  Sampler(SweepSolver& solver, bool warm) : solver_(solver), warm_(warm) {}

  Sample at(double t, const Sample* neighbour, const Sample* other = nullptr) {
    return sample_at(solver_, t, warm_ ? neighbour : nullptr, other);
  }

  std::vector<SweepPoint> line(Index steps, const Progress& progress);

private:
  SweepSolver& solver_;
  bool warm_;

  void refine(const Sample& from, const Sample& to, std::vector<SweepPoint>& points);
};

/// Between two neighbours of different modes: the two points closest to the change.
void Sampler::refine(const Sample& from, const Sample& to, std::vector<SweepPoint>& points) {
  Sample low = from, high = to;
  const auto alike = [](const Sample& a, const Sample& b) {
    return same_modes(a.push, b.push) && same_modes(a.breaking, b.breaking);
  };
  while (high.t - low.t > sharpest) {
    Sample middle = at((low.t + high.t) / 2, &low, &high);
    (alike(middle, low) ? low : high) = std::move(middle);
  }
  const SceneFile& file = solver_.point().file;
  std::string change =
      same_modes(low.push, high.push) ? "" : change_text(file, low.push, high.push);
  if (!same_modes(low.breaking, high.breaking)) {
    const std::string broken = change_text(file, low.breaking, high.breaking);
    if (broken != change) change += (change.empty() ? "at breaking: " : "; at breaking: ") + broken;
  }
  const bool jumps = differ(low.push, high.push, Quantity::push, 1e-3) ||
                     differ(low.breaking, high.breaking, Quantity::breaking, 1e-3);
  if (jumps) change += "; the answer jumps";
  const Variation& variation = solver_.variations().front();
  if (low.t > from.t) {
    points.push_back(point_of(low, variation));
    points.back().refined = true;
  }
  points.back().change = change;
  if (high.t < to.t) {
    points.push_back(point_of(high, variation));
    points.back().refined = true;
    // Several changes may lie between two steps.
    if (!alike(high, to)) refine(high, to, points);
  }
}

std::vector<SweepPoint> Sampler::line(Index steps, const Progress& progress) {
  std::vector<SweepPoint> points;
  Sample last;
  for (Index k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(std::max<Index>(steps - 1, 1));
    Sample sample = at(t, k > 0 ? &last : nullptr);
    if (k > 0 &&
        !(same_modes(last.push, sample.push) && same_modes(last.breaking, sample.breaking)))
      refine(last, sample, points);
    points.push_back(point_of(sample, solver_.variations().front()));
    last = std::move(sample);
    if (progress) progress(t);
  }
  return points;
}

bool agree(const SweepValue& a, const SweepValue& b) {
  Outputs first, second;
  first.status = a.push;
  second.status = b.push;
  first.force = a.force;
  second.force = b.force;
  first.twist = a.twist;
  second.twist = b.twist;
  if (differ(first, second, Quantity::push, same)) return false;
  first.status = a.breaking;
  second.status = b.breaking;
  first.normal = a.break_force;
  second.normal = b.break_force;
  return !differ(first, second, Quantity::breaking, same);
}

bool moves_otherwise(const SweepValue& a, const SweepValue& b) {
  Outputs first, second;
  first.twist = a.twist;
  second.twist = b.twist;
  first.motion_noise = a.motion_noise;
  second.motion_noise = b.motion_noise;
  return a.push == Status::solved && b.push == Status::solved && other_motion(first, second, same);
}

/// Steps at which the two ways disagree, as ranges.
std::vector<BistableRange> disagreements(const std::vector<SweepPoint>& there,
                                         const std::vector<SweepPoint>& back) {
  std::vector<const SweepPoint*> steps, returning;
  for (const SweepPoint& point : there)
    if (!point.refined) steps.push_back(&point);
  for (const SweepPoint& point : back)
    if (!point.refined) returning.push_back(&point);
  std::vector<BistableRange> ranges;
  bool open = false;
  for (std::size_t i = 0; i < steps.size() && i < returning.size(); ++i) {
    const SweepPoint& other = *returning[returning.size() - 1 - i];
    if (agree(steps[i]->at, other.at)) {
      open = false;
      continue;
    }
    const bool motion = moves_otherwise(steps[i]->at, other.at);
    if (!open || ranges.back().motion != motion)
      ranges.push_back({steps[i]->value, steps[i]->value, motion});
    ranges.back().to = steps[i]->value;
    open = true;
  }
  return ranges;
}

bool is_known(Status status) { return status == Status::solved || status == Status::does_not_hold; }

} // namespace

SweepPoint point_of(const Sample& sample, const Variation& variation) {
  SweepPoint point;
  point.value = value_at(variation, sample.t);
  point.at = merged(&sample.push, &sample.breaking);
  if (sample.push.is_solved())
    for (const ContactState& contact : sample.push.contacts) point.modes.push_back(contact.mode);
  return point;
}

Sample sample_here(SweepSolver& solver, double t, const Sample* neighbour, const Sample* other) {
  Sample sample;
  sample.t = t;
  if (neighbour != nullptr) {
    sample.push_bases = neighbour->push_bases;
    sample.breaking_bases = neighbour->breaking_bases;
  }
  const bool both = neighbour != nullptr && other != nullptr;
  sample.push =
      solver.solve(Quantity::push, sample.push_bases, both ? &other->push_bases : nullptr);
  sample.breaking = solver.solve(Quantity::breaking, sample.breaking_bases,
                                 both ? &other->breaking_bases : nullptr);
  return sample;
}

Sample sample_at(SweepSolver& solver, double t, const Sample* neighbour, const Sample* other) {
  solver.go_to(value_at(solver.variations().front(), t));
  return sample_here(solver, t, neighbour, other);
}

void sample_line(const VariedScene& scene, SweepSolver& solver,
                 const ParameterSweepOptions& options, Sweep& sweep) {
  const Index steps = options.steps > 0 ? options.steps : default_steps;
  const bool back = options.both_ways && sweep.segments.empty();
  const auto report = [&](double offset) {
    return [&options, back, offset](double done) {
      if (options.progress) options.progress(back ? offset + done / 2 : done);
    };
  };
  sweep.points = Sampler(solver, options.warm).line(steps, report(0));
  for (const SweepPoint& point : sweep.points)
    sweep.complete = sweep.complete && is_known(point.at.push);
  if (!back) return;
  Variation reversed = sweep.variations.front();
  std::swap(reversed.from, reversed.to);
  SweepSolver backwards(scene, {reversed}, solver.pusher());
  std::vector<SweepPoint> returning = Sampler(backwards, options.warm).line(steps, report(0.5));
  sweep.cold += backwards.cold();
  sweep.warm += backwards.warm();
  sweep.bistable = disagreements(sweep.points, returning);
  if (!sweep.bistable.empty()) sweep.points_back = std::move(returning);
}

void sample_map(SweepSolver& solver, const ParameterSweepOptions& options, Sweep& sweep) {
  const Index steps = options.steps > 0 ? options.steps : default_map_steps;
  const Variation &first = sweep.variations[0], &second = sweep.variations[1];
  const auto share = [&](Index k) {
    return static_cast<double>(k) / static_cast<double>(std::max<Index>(steps - 1, 1));
  };
  const auto at = [&](Index k, Index row, const Sample* neighbour) {
    solver.go_to({value_at(first, share(k)), value_at(second, share(row))});
    return sample_here(solver, share(k), options.warm ? neighbour : nullptr);
  };
  Sample row_begin, last;
  for (Index row = 0; row < steps; ++row) {
    for (Index k = 0; k < steps; ++k) {
      const Sample* const neighbour = k > 0 ? &last : row > 0 ? &row_begin : nullptr;
      last = at(k, row, neighbour);
      if (k == 0) row_begin = last;
      sweep.points.push_back(point_of(last, first));
      sweep.points.back().second = value_at(second, share(row));
      sweep.complete = sweep.complete && is_known(last.push.status);
      if (options.progress)
        options.progress(static_cast<double>(row * steps + k) / static_cast<double>(steps * steps));
    }
    // Warm answers stay on their branch; from nothing another one may be found.
    for (Index k = 0; options.both_ways && options.warm && k < steps; ++k) {
      SweepPoint& point = sweep.points[static_cast<std::size_t>(row * steps + k)];
      point.bistable = moves_otherwise(point.at, point_of(at(k, row, nullptr), first).at);
    }
  }
}

} // namespace lcpush::desktop
