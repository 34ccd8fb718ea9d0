#include "sweep/sweep_samples.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sweep/sweep_pieces.hpp"

namespace lcpush::desktop {
namespace {

constexpr Index default_steps = 51, default_map_steps = 11;
constexpr double sampled_jump = 1e-3; // relative: a larger step over bisection_width is a jump

bool same_modes(const Sample& a, const Sample& b) {
  return same_modes(a.push, b.push) && same_modes(a.breaking, b.breaking);
}

/// Between two neighbours of different modes: the two points closest to the change.
void refine(SweepSolver& solver, const Sample& from, const Sample& to,
            std::vector<SweepPoint>& points) {
  Sample low = from, high = to;
  while (high.t - low.t > bisection_width) {
    Sample middle = sample_at(solver, (low.t + high.t) / 2, &low, &high);
    (same_modes(middle, low) ? low : high) = std::move(middle);
  }
  SweepChange change;
  if (!same_modes(low.push, high.push)) change.push = {change_between(low.push, high.push)};
  if (!same_modes(low.breaking, high.breaking))
    change.breaking = {change_between(low.breaking, high.breaking)};
  change.jumps = differ(low.push, high.push, Question::push, sampled_jump) ||
                 differ(low.breaking, high.breaking, Question::breaking, sampled_jump);
  const Variation& variation = solver.variations().front();
  if (low.t > from.t) {
    points.push_back(point_of(low, variation));
    points.back().refined = true;
  }
  points.back().change = change;
  if (high.t < to.t) {
    points.push_back(point_of(high, variation));
    points.back().refined = true;
    // Several changes may lie between two steps.
    if (!same_modes(high, to)) refine(solver, high, to, points);
  }
}

/// Each from its neighbour's answer, and more of them where modes change.
std::vector<SweepPoint> sampled(SweepSolver& solver, Index steps, const Progress& progress) {
  std::vector<SweepPoint> points;
  Sample last;
  for (Index k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(std::max<Index>(steps - 1, 1));
    Sample sample = sample_at(solver, t, k > 0 ? &last : nullptr);
    if (k > 0 && !same_modes(last, sample)) refine(solver, last, sample, points);
    points.push_back(point_of(sample, solver.variations().front()));
    last = std::move(sample);
    progress(t);
  }
  return points;
}

/// The two ways at the steps that both have taken.
std::vector<TwoWays> compared(const std::vector<SweepPoint>& there,
                              const std::vector<SweepPoint>& back) {
  const auto steps_of = [](const std::vector<SweepPoint>& points) {
    std::vector<SweepPoint> steps;
    std::copy_if(points.begin(), points.end(), std::back_inserter(steps),
                 [](const SweepPoint& point) { return !point.refined; });
    return steps;
  };
  const std::vector<SweepPoint> steps = steps_of(there), returning = steps_of(back);
  std::vector<TwoWays> list;
  for (std::size_t i = 0; i < steps.size(); ++i)
    list.push_back(
        {steps[i].value, steps[i].value, steps[i].at, returning[returning.size() - 1 - i].at});
  return list;
}

} // namespace

SweepPoint point_of(const Sample& sample, const Variation& variation) {
  SweepPoint point;
  point.value = value_at(variation, sample.t);
  point.at = told(sample.push, sample.breaking);
  if (sample.push.is_solved())
    for (const ContactState& contact : sample.push.contacts) point.modes.push_back(contact.mode);
  return point;
}

Sample sample_here(SweepSolver& solver, double t, const Sample* neighbour, const Sample* other) {
  Sample sample;
  sample.t = t;
  if (!solver.is_warm()) neighbour = nullptr;
  if (neighbour != nullptr) {
    sample.push_bases = neighbour->push_bases;
    sample.breaking_bases = neighbour->breaking_bases;
  }
  const bool both = neighbour != nullptr && other != nullptr;
  sample.push =
      solver.solve(Question::push, sample.push_bases, both ? &other->push_bases : nullptr);
  sample.breaking = solver.solve(Question::breaking, sample.breaking_bases,
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
  sweep.points = sampled(solver, steps, part_of(options.progress, 0, back ? 0.5 : 1));
  for (const SweepPoint& point : sweep.points)
    sweep.complete = sweep.complete && point.at.push.is_known();
  if (!back) return;
  SweepSolver backwards(scene, {reversed(sweep.variations.front())}, solver.pusher(), options.warm);
  std::vector<SweepPoint> returning =
      sampled(backwards, steps, part_of(options.progress, 0.5, 0.5));
  sweep.cold += backwards.cold();
  sweep.warm += backwards.warm();
  sweep.bistable = disagreements(compared(sweep.points, returning), false, 0);
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
    return sample_here(solver, share(k), neighbour);
  };
  Sample row_begin, last;
  for (Index row = 0; row < steps; ++row) {
    for (Index k = 0; k < steps; ++k) {
      const Sample* const neighbour = k > 0 ? &last : row > 0 ? &row_begin : nullptr;
      last = at(k, row, neighbour);
      if (k == 0) row_begin = last;
      sweep.points.push_back(point_of(last, first));
      sweep.points.back().second = value_at(second, share(row));
      sweep.complete = sweep.complete && last.push.is_known();
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
