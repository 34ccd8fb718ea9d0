#include "sweep/sweep_samples.hpp"

#include <algorithm>
#include <memory>
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
  for (const Question question : questions) {
    const DetailedAnswer &before = low[question], &after = high[question];
    AnswerChange mine = change_between(before, after);
    if (!after.is_known())
      mine.kind = AnswerChange::Kind::lost;
    else if (!before.is_known())
      mine.kind = AnswerChange::Kind::found;
    else
      mine.jumps = differ(before, after, question, sampled_jump);
    if (mine.jumps || !same_modes(before, after)) change[question] = {mine};
    change.jumps = change.jumps || mine.jumps;
  }
  const Variation& variation = solver.variations().front();
  if (low.t > from.t) points.push_back(refined_point(low, variation));
  points.back().change = change;
  if (!(high.t < to.t)) return;
  points.push_back(refined_point(high, variation));
  // Several changes may lie between two steps.
  if (!same_modes(high, to)) refine(solver, high, to, points);
}

/// The points of one way through the range, and the bases in which its steps have ended.
class Way {
public:
  std::vector<SweepPoint> points;

  /// `began`: the bases of the step before.
  void add(const Sample& sample, const OfBoth<RoundBases>& began, const Variation& variation) {
    bool is_sure = true;
    for (const Question question : questions) {
      const bool from_nothing = began[question].empty() && sample.bases[question].empty();
      is_sure = is_sure && (from_nothing || sample[question].is_known());
    }
    if (!is_sure) {
      bases_.reset();
    } else if (!bases_ || !same_bases(*bases_, sample.bases)) {
      kept_ += size_of(sample.bases);
      bases_ = kept_ <= most_kept ? std::make_shared<OfBoth<RoundBases>>(sample.bases) : nullptr;
    }
    steps_.push_back({points.size(), bases_});
    points.push_back(point_of(sample, variation));
  }
  /// Whoever comes from the next step with the bases in which this one has ended finds its answer
  /// again. Null: these are not those, or the modes change in between.
  const SweepPoint* found_again(Index step, const OfBoth<RoundBases>& bases) const {
    const Step& here = at(step);
    const bool is_plain = here.bases && at(step + 1).point == here.point + 1;
    return is_plain && same_bases(*here.bases, bases) ? &points[here.point] : nullptr;
  }

  /// Where the step's answer is that of the way back, too, that goes on from the bases here: mostly
  /// they hold at the next step as well, whose answer is found again then. A push without a single
  /// answer may hold in many bases.
  void join(Index step, const SweepPoint& back, OfBoth<RoundBases>& bases) const {
    const Step& here = at(step);
    const SweepPoint& point = points[here.point];
    if (!here.bases || back.modes != point.modes) return;
    for (const Question question : questions)
      if (same_answer(point.at[question], back.at[question], question))
        bases[question] = (*here.bases)[question];
  }

private:
  static constexpr std::size_t most_kept = 64'000'000; // bytes: a flag an unknown and round
  struct Step {
    std::size_t point;
    std::shared_ptr<const OfBoth<RoundBases>> bases; // null: another start may end elsewhere
  };
  std::vector<Step> steps_;
  std::shared_ptr<const OfBoth<RoundBases>> bases_; // neighbours share them
  std::size_t kept_ = 0;

  const Step& at(Index step) const { return steps_[static_cast<std::size_t>(step)]; }
  static std::size_t size_of(const OfBoth<RoundBases>& bases) {
    std::size_t size = 0;
    for (const Question question : questions)
      for (const Basis& basis : bases[question]) size += basis.size();
    return size;
  }
  static bool same_bases(const OfBoth<RoundBases>& a, const OfBoth<RoundBases>& b) {
    return a.push == b.push && a.breaking == b.breaking;
  }
};

/// Each from its neighbour's answer, and more of them where modes change. On the way back what the
/// way `there` would find again is taken from it, and where both are at the same answer they go on
/// as one.
Way sampled(SweepSolver& solver, Index steps, const Progress& progress,
            const Way* there = nullptr) {
  Way way;
  Sample last;
  bool is_solved = false; // or only the bases of `last` are known
  for (Index k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(std::max<Index>(steps - 1, 1));
    const SweepPoint* const again =
        there != nullptr && k > 0 ? there->found_again(steps - 1 - k, last.bases) : nullptr;
    if (again != nullptr) {
      way.points.push_back(*again);
      way.points.back().change = {};
      last.t = t;
    } else {
      if (k > 0 && !is_solved) last = sample_at(solver, last.t, &last);
      Sample sample = sample_at(solver, t, k > 0 ? &last : nullptr);
      if (k > 0 && !same_modes(last, sample)) refine(solver, last, sample, way.points);
      way.add(sample, last.bases, solver.variations().front());
      if (there != nullptr) there->join(steps - 1 - k, way.points.back(), sample.bases);
      last = std::move(sample);
    }
    is_solved = again == nullptr;
    progress(t);
  }
  return way;
}

/// The two ways at the steps that both have taken.
std::vector<TwoWays> compared(const std::vector<SweepPoint>& there,
                              const std::vector<SweepPoint>& back) {
  std::vector<TwoWays> list;
  auto returning = back.rbegin();
  for (const SweepPoint& point : there) {
    if (point.refined) continue;
    while (returning->refined) ++returning;
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

Sample sample_here(SweepSolver& solver, double t, const Sample* neighbour, const Sample* other) {
  Sample sample;
  sample.t = t;
  if (!solver.is_warm()) neighbour = nullptr;
  if (neighbour != nullptr) sample.bases = neighbour->bases;
  const bool both = neighbour != nullptr && other != nullptr;
  for (const Question question : questions)
    sample[question] =
        solver.solve(question, sample.bases[question], both ? &other->bases[question] : nullptr);
  return sample;
}

Sample sample_at(SweepSolver& solver, double t, const Sample* neighbour, const Sample* other) {
  solver.go_to(value_at(solver.variations().front(), t));
  return sample_here(solver, t, neighbour, other);
}

void sample_line(const VariedScene& scene, SweepSolver& solver,
                 const ParameterSweepOptions& options, Sweep& sweep) {
  const Index steps = options.steps > 0 ? options.steps : default_steps;
  // From nothing both ways are the same.
  const bool back = options.both_ways && options.warm && sweep.segments.empty();
  Way there = sampled(solver, steps, part_of(options.progress, 0, back ? 0.5 : 1));
  for (const SweepPoint& point : there.points) {
    sweep.complete = sweep.complete && point.at.push.is_known();
    sweep.asks_breaking = sweep.asks_breaking || point.at.breaking.status != Status::bad_input;
  }
  if (back) {
    SweepSolver backwards(scene, {reversed(sweep.variations.front())}, solver.pusher(), options);
    Way returning = sampled(backwards, steps, part_of(options.progress, 0.5, 0.5), &there);
    sweep.cold += backwards.cold();
    sweep.warm += backwards.warm();
    sweep.bistable = disagreements(compared(there.points, returning.points), 0);
    if (!sweep.bistable.empty()) sweep.points_back = std::move(returning.points);
  }
  sweep.points = std::move(there.points);
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
      sweep.asks_breaking = sweep.asks_breaking || last.breaking.status != Status::bad_input;
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
