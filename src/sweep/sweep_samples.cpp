#include "sweep/sweep_samples.hpp"

#include <algorithm>
#include <utility>

#include "sweep/settings.hpp"
#include "sweep/sweep_pieces.hpp"

namespace lcpush::desktop {
namespace {

bool same_modes(const Sample& a, const Sample& b) {
  return same_modes(a.push, b.push) && same_modes(a.breaking, b.breaking);
}

SweepChange change_over(const Sample& low, const Sample& high) {
  SweepChange change;
  for (const Question question : questions) {
    const DetailedAnswer &before = low[question], &after = high[question];
    AnswerChange mine = change_between(before, after);
    // What is no jump may change over a wider gap by more.
    const double step =
        std::max(SweepSettings::sampled_jump, SweepSettings::steepest_change * (high.t - low.t));
    if (!after.is_known())
      mine.kind = AnswerChange::Kind::lost;
    else if (!before.is_known())
      mine.kind = AnswerChange::Kind::found;
    else
      mine.jumps = differ(before, after, question, step);
    if (mine.jumps || !same_modes(before, after)) change[question] = {mine};
    change.jumps = change.jumps || mine.jumps;
  }
  return change;
}

/// Between two neighbours of different modes: the two points closest to each change, one question
/// after the other. Pre: `from` is the last of the points.
void refine(SweepSolver& solver, const Sample& from, const Sample& to,
            std::vector<SweepPoint>& points) {
  const bool pushes = !same_modes(from.push, to.push);
  const Question asked = pushes ? Question::push : Question::breaking;
  const Question other = pushes ? Question::breaking : Question::push;
  const bool is_blurred = solver.is_from_nothing(asked) && from[asked].status == to[asked].status;
  const double width = is_blurred ? SweepSettings::breaking_blur : SweepSettings::bisection_width;
  Sample low = from, high = to;
  while (high.t - low.t > width) {
    Sample middle = sample_at(solver, (low.t + high.t) / 2, &low, {asked});
    (same_modes(middle[asked], low[asked]) ? low : high) = std::move(middle);
  }
  const auto complete = [&](Sample& sample, const Sample& neighbour) {
    const Sample rest = sample_at(solver, sample.t, &neighbour, {other});
    sample[other] = rest[other];
    sample.bases[other] = rest.bases[other];
  };
  const Variation& variation = solver.variations().front();
  if (low.t > from.t) {
    complete(low, from);
    if (!same_modes(from, low)) refine(solver, from, low, points);
    points.push_back(refined_point(low, variation));
  }
  if (high.t < to.t) complete(high, low);
  points.back().change = change_over(low, high);
  if (!(high.t < to.t)) return;
  points.push_back(refined_point(high, variation));
  // Several changes may lie between two steps.
  if (!same_modes(high, to)) refine(solver, high, to, points);
}

/// The points of one way through the range, and of its steps the bases in which they have ended.
struct SampledPath {
  struct Step {
    std::size_t point;
    OfBoth<RoundBases> bases;
  };
  std::vector<SweepPoint> points;
  std::vector<Step> steps;

  /// Where the step's answer is that of the way back, too, that goes on from the bases here: a push
  /// without a single answer may hold in many.
  void join(std::size_t step, const SweepPoint& back, OfBoth<RoundBases>& bases) const {
    const SweepPoint& point = points[steps[step].point];
    if (back.modes != point.modes) return;
    for (const Question question : questions)
      if (same_answer(point.at[question], back.at[question], question))
        bases[question] = steps[step].bases[question];
  }
};

/// Each step from its neighbour's answer, and more of them where modes change. Where the way back
/// is at the answer of the way `there`, both go on as one.
SampledPath sampled(SweepSolver& solver, Index steps, const Progress& progress,
                    const SampledPath* there = nullptr) {
  const Variation& variation = solver.variations().front();
  SampledPath way;
  Sample last;
  for (Index k = 0; k < steps; ++k) try {
      const double t = static_cast<double>(k) / static_cast<double>(std::max<Index>(steps - 1, 1));
      Sample sample = sample_at(solver, t, k > 0 ? &last : nullptr);
      if (k > 0 && !same_modes(last, sample)) refine(solver, last, sample, way.points);
      way.steps.push_back({way.points.size(), sample.bases});
      way.points.push_back(point_of(sample, variation));
      if (there != nullptr)
        there->join(static_cast<std::size_t>(steps - 1 - k), way.points.back(), sample.bases);
      last = std::move(sample);
      progress(t);
    } catch (const Stopped&) {
      break;
    }
  return way;
}

/// The two ways at the steps that both have taken. What is found from nothing is the same on both.
std::vector<TwoWays> compared(const SweepSolver& solver, const std::vector<SweepPoint>& there,
                              std::vector<SweepPoint>& back) {
  std::vector<TwoWays> list;
  auto returning = back.rbegin();
  for (const SweepPoint& point : there) {
    if (point.refined) continue;
    while (returning->refined) ++returning;
    if (solver.is_from_nothing(Question::breaking)) returning->at.breaking = point.at.breaking;
    list.push_back({point.value, point.value, point.at, returning++->at});
  }
  return list;
}

} // namespace

SweepPoint point_of(const Sample& sample, const Variation& variation) {
  SweepPoint point;
  point.value = value_at(variation, sample.t);
  for (const Question question : questions) point.at[question] = told(sample[question]);
  if (sample.push.is_solved())
    for (const ContactState& contact : sample.push.contacts) point.modes.push_back(contact.mode);
  return point;
}

SweepPoint refined_point(const Sample& sample, const Variation& variation) {
  SweepPoint point = point_of(sample, variation);
  point.refined = true;
  return point;
}

namespace {

/// At the solver's present value.
Sample sample_here(SweepSolver& solver, double t, const Sample* neighbour,
                   const std::vector<Question>& asked) {
  Sample sample;
  sample.t = t;
  if (solver.is_warm() && neighbour != nullptr) sample.bases = neighbour->bases;
  for (const Question question : asked)
    sample[question] = solver.solve(question, sample.bases[question]);
  return sample;
}

} // namespace

Sample sample_at(SweepSolver& solver, double t, const Sample* neighbour,
                 const std::vector<Question>& asked) {
  solver.go_to(value_at(solver.variations().front(), t));
  return sample_here(solver, t, neighbour, asked);
}

void sample_line(const VariedScene& scene, SweepSolver& solver,
                 const ParameterSweepOptions& options, Sweep& sweep) {
  const Index steps = options.steps > 0 ? options.steps : SweepSettings::usual_steps;
  // From nothing both ways are the same.
  const bool back = options.both_ways && options.warm && sweep.segments.empty();
  SampledPath there = sampled(solver, steps, part_of(options.progress, 0, back ? 0.5 : 1));
  for (const SweepPoint& point : there.points) {
    sweep.complete = sweep.complete && (point.refined || point.at.push.is_known());
    sweep.asks_breaking = sweep.asks_breaking || point.at.breaking.status != Status::bad_input;
  }
  if (back && solver.stop() == Stop::none) {
    SweepSolver backwards(scene, {reversed(sweep.variations.front())}, solver.pusher(), options);
    backwards.leave_out_what_is_from_nothing();
    SampledPath returning = sampled(backwards, steps, part_of(options.progress, 0.5, 0.5), &there);
    sweep.cold += backwards.cold();
    sweep.warm += backwards.warm();
    sweep.stop = backwards.stop();
    if (sweep.stop == Stop::none)
      sweep.bistable = disagreements(compared(solver, there.points, returning.points), 0);
    if (!sweep.bistable.empty()) sweep.points_back = std::move(returning.points);
  }
  sweep.points = std::move(there.points);
}

void sample_map(SweepSolver& solver, const ParameterSweepOptions& options, Sweep& sweep) {
  const Index steps = options.steps > 0 ? options.steps : SweepSettings::usual_map_steps;
  const Variation &first = sweep.variations[0], &second = sweep.variations[1];
  const auto share = [&](Index k) {
    return static_cast<double>(k) / static_cast<double>(std::max<Index>(steps - 1, 1));
  };
  const std::vector<Question> both(std::begin(questions), std::end(questions));
  const auto at = [&](Index k, Index row, const Sample* neighbour,
                      const std::vector<Question>& asked) {
    solver.go_to({value_at(first, share(k)), value_at(second, share(row))});
    return sample_here(solver, share(k), neighbour, asked);
  };
  Sample row_begin, last;
  for (Index row = 0; row < steps; ++row) {
    for (Index k = 0; k < steps; ++k) {
      const Sample* const neighbour = k > 0 ? &last : row > 0 ? &row_begin : nullptr;
      last = at(k, row, neighbour, both);
      if (k == 0) row_begin = last;
      sweep.points.push_back(point_of(last, first));
      sweep.points.back().second = value_at(second, share(row));
      sweep.complete = sweep.complete && last.push.is_known();
      sweep.asks_breaking = sweep.asks_breaking || last.breaking.status != Status::bad_input;
      if (options.progress)
        options.progress(static_cast<double>(row * steps + k) / static_cast<double>(steps * steps));
    }
    // Warm answers stay on their branch; from nothing another one may be found.
    for (Index k = 0; options.both_ways && options.warm && k < steps; ++k) {
      SweepPoint& point = sweep.points[static_cast<std::size_t>(row * steps + k)];
      point.bistable =
          moves_otherwise(point.at, point_of(at(k, row, nullptr, {Question::push}), first).at);
    }
  }
}

} // namespace lcpush::desktop
