#include "lcpush/desktop/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/push.hpp"
#include "sweep/settings.hpp"
#include "sweep/sweep_pieces.hpp"
#include "sweep/sweep_samples.hpp"
#include "sweep/sweep_words.hpp"

namespace lcpush::desktop {
namespace {

/// Both questions along the range, each in its own pieces.
using Tracks = OfBoth<std::vector<Piece>>; // breaking: empty if no pusher moves

/// The piece around t, if there is an answer to the question at all.
const Piece* piece_at(const std::vector<Piece>& pieces, double t) {
  for (const Piece& piece : pieces)
    if (t >= piece.from && t <= piece.to) return &piece;
  return nullptr;
}

/// Where the pieces of both end.
std::vector<double> ends_of(const Tracks& tracks) {
  std::vector<double> ends;
  for (const Question question : questions)
    for (const Piece& piece : tracks[question]) ends.push_back(piece.to);
  return ends;
}

/// The ends of the segments.
std::vector<double> merged_cuts(const Tracks& tracks, double end) {
  std::vector<double> ends = ends_of(tracks);
  std::sort(ends.begin(), ends.end());
  std::vector<double> cuts = {0};
  for (const double t : ends)
    if (t < end && t - cuts.back() > SweepSettings::merge_distance) cuts.push_back(t);
  if (end - cuts.back() > SweepSettings::merge_distance) cuts.push_back(end);
  cuts.back() = end;
  return cuts;
}

/// What changes from a piece to the next.
AnswerChange change_between(const Piece& before, const Piece& after, Question question) {
  AnswerChange change = change_between(before.at_to, after.at_from);
  if (after.is_unsolved())
    change.kind = AnswerChange::Kind::lost;
  else if (before.is_unsolved())
    change.kind = AnswerChange::Kind::found;
  else
    change.jumps = differ(before.at_to, after.at_from, question, SweepSettings::jump);
  change.path = before.path;
  return change;
}

SweepChange change_at(const Tracks& tracks, double t) {
  SweepChange change;
  for (const Question question : questions) {
    const std::vector<Piece>& pieces = tracks[question];
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (!(std::abs(pieces[i - 1].to - t) <= SweepSettings::merge_distance)) continue;
      change[question].push_back(change_between(pieces[i - 1], pieces[i], question));
      change.jumps = change.jumps || change[question].back().jumps;
    }
  }
  return change;
}

/// How far both have come: to 1, unless they were stopped.
double end_of(const Tracks& tracks) {
  double end = 1;
  for (const Question question : questions)
    if (!tracks[question].empty()) end = std::min(end, tracks[question].back().to);
  return end;
}

/// Both tracks together.
std::vector<SweepSegment> segments_of(const Variation& variation, const Tracks& tracks) {
  std::vector<SweepSegment> list;
  const double end = end_of(tracks);
  const std::vector<double> ends = merged_cuts(tracks, end);
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double from = ends[k - 1], to = ends[k], middle = (from + to) / 2;
    SweepSegment segment;
    segment.from = value_at(variation, from);
    segment.to = value_at(variation, to);
    segment.kind = SegmentKind::unsolved;
    for (const Question question : questions) {
      const Piece* const piece = piece_at(tracks[question], middle);
      if (piece == nullptr) continue;
      if (!piece->is_unsolved()) segment.kind = piece->kind;
      segment.at_from[question] = told(piece->at(from));
      segment.at_to[question] = told(piece->at(to));
    }
    if (to < end) segment.change = change_at(tracks, to);
    list.push_back(std::move(segment));
  }
  return list;
}

Tracks find_tracks(SweepSolver& solver, const ParameterSweepOptions& options, double begin,
                   double share) {
  Tracks tracks;
  for (const Question question : questions) {
    if (solver.stop() != Stop::none) break;
    bool has = false; // somewhere in the range
    for (const double t : SweepSettings::looked_at) {
      solver.go_to(value_at(solver.variations().front(), t));
      has = has || solver.has(question);
    }
    if (!has) continue;
    const bool second = question == Question::breaking;
    const double tolerance = SweepSettings::one_line * (second ? SweepSettings::breaking_lines : 1);
    const Progress progress =
        part_of(options.progress, second ? begin + share / 2 : begin, share / 2);
    tracks[question] = joined(exact_pieces(solver, question, progress), question, tolerance);
  }
  return tracks;
}

/// The two ways between all of their cuts; a question that one of them leaves open is left out.
std::vector<TwoWays> compared(const Tracks& there, const Tracks& back, const Variation& variation,
                              double shortest) {
  std::vector<double> cuts = ends_of(there);
  for (const double t : ends_of(back)) cuts.push_back(1 - t);
  cuts.insert(cuts.end(), {0, 1});
  std::sort(cuts.begin(), cuts.end());
  std::vector<TwoWays> list;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i] - cuts[i - 1] <= shortest) continue;
    const double t = (cuts[i] + cuts[i - 1]) / 2;
    TwoWays ways{value_at(variation, cuts[i - 1]), value_at(variation, cuts[i]), {}, {}};
    for (const Question question : questions) {
      const Piece* const a = piece_at(there[question], t);
      const Piece* const b = piece_at(back[question], 1 - t);
      if (a == nullptr || b == nullptr || a->is_unsolved() || b->is_unsolved()) continue;
      ways.there[question] = a->at(t);
      ways.back[question] = b->at(1 - t);
    }
    list.push_back(ways);
  }
  return list;
}

/// Where no pusher moves there is nothing to break.
bool is_complete(const SweepValue& value) {
  return value.push.is_known() &&
         (value.breaking.is_known() || value.breaking.status == Status::bad_input);
}

void find_segments(const VariedScene& scene, SweepSolver& solver,
                   const ParameterSweepOptions& options, Sweep& sweep) {
  const Variation &variation = sweep.variations.front(), back_again = reversed(variation);
  const double share = options.both_ways ? 0.5 : 1;
  const Tracks there = find_tracks(solver, options, 0, share);
  sweep.asks_breaking = !there.breaking.empty();
  const bool has_any = !there.push.empty() || !there.breaking.empty();
  if (has_any) sweep.segments = segments_of(variation, there);
  if (options.both_ways && solver.stop() == Stop::none) {
    SweepSolver backwards(scene, {back_again}, solver.pusher(), options);
    const Tracks back = find_tracks(backwards, options, share, share);
    const double shortest = SweepSettings::shortest_told * SweepSettings::merge_distance;
    sweep.stop = backwards.stop();
    if (sweep.stop == Stop::none)
      sweep.bistable = disagreements(compared(there, back, variation, shortest),
                                     2 * shortest * std::abs(variation.to - variation.from));
    if (!sweep.bistable.empty()) sweep.back = segments_of(back_again, back);
    sweep.cold += backwards.cold();
    sweep.warm += backwards.warm();
  }
  for (const SweepSegment& segment : sweep.segments)
    sweep.complete = sweep.complete && is_complete(segment.at_from);
}

/// Where a sweep was stopped, its range ends; of a map whole rows remain.
void end_where_stopped(const Variation& asked, Sweep& sweep) {
  sweep.complete = false;
  std::vector<SweepPoint>& points = sweep.points;
  double end = asked.from;
  if (sweep.is_map()) {
    const auto next = std::find_if(points.begin(), points.end(), [&](const SweepPoint& point) {
      return point.second != points.front().second;
    });
    const auto columns = static_cast<std::size_t>(next - points.begin());
    if (next != points.end()) {
      points.resize(points.size() / columns * columns);
      sweep.variations[1].to = *points.back().second;
      return;
    }
  }
  if (!points.empty()) end = points.back().value;
  if (!sweep.segments.empty()) end = sweep.segments.back().to;
  if (end != asked.from) sweep.variations[0].to = end;
}

void sweep_line(const VariedScene& scene, SweepSolver& solver, const ParameterSweepOptions& options,
                Sweep& sweep) {
  const Variation& variation = sweep.variations.front();
  for (const double value : {variation.from, variation.to}) solver.go_to(value);
  const bool is_one_problem = !sweep.scene.is_round && sweep.scene.pressure != Pressure::pad;
  const bool has_segments = variation.parameter.linear && is_one_problem;
  if (has_segments) find_segments(scene, solver, options, sweep);
  if (!has_segments || options.steps > 0) sample_line(scene, solver, options, sweep);
  find_zeros(solver, sweep);
}

/// At an end of the range, if at one.
std::optional<OpenForce> find_open_force(const VariedScene& scene, const Variation& variation,
                                         Index pusher, const StopCheck& stop) {
  StopWatcher watcher(stop);
  for (const double value : {variation.to, variation.from}) {
    const SceneFile file = scene.at({variation.parameter}, {value});
    PushOptions options;
    options.explain_jams = options.study_existence = false;
    options.other_paths = 1;
    options.watcher = &watcher;
    const BreakReport report = Push(file).find_breaking(pusher, options);
    if (report.status == Status::solved && report.is_friction_open && report.other_force)
      return OpenForce{value, report.breaking.break_force, *report.other_force};
  }
  return std::nullopt;
}

Index only_pusher(const SceneFile& file) {
  Index pusher = -1;
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::pusher) continue;
    if (pusher >= 0)
      throw InputError("the scene has several pushers: say which one the force is of");
    pusher = static_cast<Index>(b);
  }
  if (pusher < 0)
    throw InputError(
        "the scene has no [[pusher]]: no push changes; how well it holds says `lcpush hold`");
  return pusher;
}

} // namespace

Sweep sweep_parameter(const VariedScene& scene, const std::vector<Variation>& variations,
                      const ParameterSweepOptions& options) {
  Sweep sweep;
  sweep.scene = scene.as_given();
  const SceneFile& file = sweep.scene;
  sweep.variations = variations;
  const Index pusher = options.pusher >= 0 ? options.pusher : only_pusher(file);
  sweep.pusher = file.body_name(pusher);
  SweepSolver solver(scene, variations, pusher, options);
  if (!sweep.is_map()) {
    const Variation& variation = variations.front();
    if (variation.parameter.whole)
      throw InputError(file.lines.file + ": " + variation.parameter.path +
                       " counts something: it takes a list of whole numbers "
                       "(--each facets=4,8,16), not a range");
  }
  try {
    if (sweep.is_map())
      sample_map(solver, options, sweep);
    else
      sweep_line(scene, solver, options, sweep);
    if (!sweep.is_map() && solver.stop() == Stop::none && asked(sweep) == Question::breaking)
      sweep.open = find_open_force(scene, variations.front(), pusher, options.stop);
  } catch (const Stopped& stopped) {
    sweep.stop = stopped.why;
  }
  if (solver.stop() != Stop::none) sweep.stop = solver.stop();
  if (sweep.stop != Stop::none) end_where_stopped(variations.front(), sweep);
  sweep.cold += solver.cold();
  sweep.warm += solver.warm();
  return sweep;
}

} // namespace lcpush::desktop
