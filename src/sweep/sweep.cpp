#include "lcpush/desktop/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lcpush/desktop/input_error.hpp"
#include "sweep/sweep_pieces.hpp"
#include "sweep/sweep_samples.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr double together = 1e-9; // of the range: cuts nearer than this are one
constexpr double jump = 1e-6;     // relative: a larger step of the answer is a jump
constexpr double blurred = 1e-5;  // of the range: what bisection leaves between two ways
constexpr double branches = 1e-5; // relative: farther apart, two answers are on different branches

/// Both quantities along the range, each in its own pieces.
struct Tracks {
  std::vector<Piece> push, breaking; ///< breaking: empty if no pusher moves
};

const Piece* piece_at(const std::vector<Piece>& pieces, double t) {
  for (const Piece& piece : pieces)
    if (t >= piece.from && t <= piece.to) return &piece;
  return nullptr;
}

Outputs piece_value(const Piece& piece, double t) {
  return on_line(piece.at_from, piece.from, piece.at_to, piece.to, t);
}

class Merger {
public:
  Merger(const SceneFile& file, const Variation& variation, const Tracks& tracks)
      : file_(file), variation_(variation), tracks_(tracks) {}

  std::vector<SweepSegment> segments() const;

private:
  const SceneFile& file_;
  const Variation& variation_;
  const Tracks& tracks_;

  std::vector<double> cuts() const;
  std::string change(Quantity quantity, double t, bool& jumps) const;
};

std::vector<double> Merger::cuts() const {
  std::vector<double> all = {1};
  for (const std::vector<Piece>* pieces : {&tracks_.push, &tracks_.breaking})
    for (const Piece& piece : *pieces)
      if (piece.to < 1) all.push_back(piece.to);
  std::sort(all.begin(), all.end());
  std::vector<double> cuts = {0};
  for (const double t : all)
    if (t - cuts.back() > together) cuts.push_back(t);
  cuts.back() = 1;
  return cuts;
}

/// What changes in one track at t, if anything.
std::string Merger::change(Quantity quantity, double t, bool& jumps) const {
  const std::vector<Piece>& pieces = quantity == Quantity::push ? tracks_.push : tracks_.breaking;
  std::string text;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Piece& before = pieces[i - 1];
    if (std::abs(before.to - t) > together) continue;
    const Piece& after = pieces[i];
    std::string words;
    if (after.kind == SegmentKind::unsolved)
      words = std::string("from here on no answer is found (") + status_text(after.at_from.status) +
              ")";
    else if (before.kind == SegmentKind::unsolved)
      words = "from here on there is an answer again";
    else
      words = change_text(file_, before.at_to, after.at_from);
    const bool steps = after.kind != SegmentKind::unsolved &&
                       before.kind != SegmentKind::unsolved &&
                       differ(before.at_to, after.at_from, quantity, jump);
    jumps = jumps || steps;
    if (steps)
      words += before.why.empty() ? "; the answer jumps" : "; the answer jumps: " + before.why;
    text += (text.empty() ? "" : "; ") + words;
  }
  return text;
}

std::vector<SweepSegment> Merger::segments() const {
  std::vector<SweepSegment> list;
  const std::vector<double> ends = cuts();
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const double from = ends[k - 1], to = ends[k], middle = (from + to) / 2;
    const Piece* const push = piece_at(tracks_.push, middle);
    const Piece* const breaking = piece_at(tracks_.breaking, middle);
    SweepSegment segment;
    segment.from = value_at(variation_, from);
    segment.to = value_at(variation_, to);
    segment.kind = SegmentKind::unsolved;
    for (const Piece* piece : {push, breaking})
      if (piece != nullptr && piece->kind != SegmentKind::unsolved) segment.kind = piece->kind;
    const auto at = [&](double t) {
      Outputs a, b;
      if (push != nullptr) a = piece_value(*push, t);
      if (breaking != nullptr) b = piece_value(*breaking, t);
      return merged(push != nullptr ? &a : nullptr, breaking != nullptr ? &b : nullptr);
    };
    segment.at_from = at(from);
    segment.at_to = at(to);
    if (to < 1) {
      const std::string pushed = change(Quantity::push, to, segment.jumps);
      const std::string broken = change(Quantity::breaking, to, segment.jumps);
      if (pushed == broken || broken.empty())
        segment.change = pushed;
      else
        segment.change = pushed.empty() ? "at breaking: " + broken
                                        : "as prescribed: " + pushed + "; at breaking: " + broken;
      if (broken.empty() && !tracks_.breaking.empty()) segment.change = "as prescribed: " + pushed;
    }
    list.push_back(std::move(segment));
  }
  return list;
}

Tracks find_tracks(SweepSolver& solver, bool exact, const ParameterSweepOptions& options,
                   double begin, double share) {
  const auto report = [&](double offset) {
    return [&options, begin, share, offset](double done) {
      if (options.progress) options.progress(begin + share * (offset + done / 2));
    };
  };
  const double tolerance = exact ? 1e-10 : 1e-6;
  const auto find = exact ? exact_pieces : bisected_pieces;
  Tracks tracks;
  tracks.push = joined(find(solver, Quantity::push, options.most_segments, report(0)),
                       Quantity::push, tolerance);
  bool pushes = false; // somewhere in the range
  for (const double t : {0.0, 0.3, 1.0}) {
    solver.go_to(value_at(solver.variations().front(), t));
    pushes = pushes || solver.has(Quantity::breaking);
  }
  if (pushes)
    tracks.breaking = joined(find(solver, Quantity::breaking, options.most_segments, report(0.5)),
                             Quantity::breaking, 10 * tolerance);
  return tracks;
}

Variation reversed(Variation variation) {
  std::swap(variation.from, variation.to);
  return variation;
}

/// Where the way there and the way back disagree, as shares of the range.
std::vector<BistableRange> disagreements(const Tracks& there, const Tracks& back,
                                         const Variation& variation, double shortest) {
  std::vector<double> cuts = {0, 1};
  for (const std::vector<Piece>* pieces : {&there.push, &there.breaking})
    for (const Piece& piece : *pieces) cuts.push_back(piece.to);
  for (const std::vector<Piece>* pieces : {&back.push, &back.breaking})
    for (const Piece& piece : *pieces) cuts.push_back(1 - piece.to);
  std::sort(cuts.begin(), cuts.end());
  std::vector<BistableRange> ranges;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i] - cuts[i - 1] <= shortest) continue;
    const double t = (cuts[i] + cuts[i - 1]) / 2;
    bool same = true, moves = false;
    for (const Quantity quantity : {Quantity::push, Quantity::breaking}) {
      const bool is_push = quantity == Quantity::push;
      const Piece* const first = piece_at(is_push ? there.push : there.breaking, t);
      const Piece* const second = piece_at(is_push ? back.push : back.breaking, 1 - t);
      if (first == nullptr || second == nullptr) continue;
      if (first->kind == SegmentKind::unsolved || second->kind == SegmentKind::unsolved) continue;
      const Outputs one = piece_value(*first, t), other = piece_value(*second, 1 - t);
      same = same && !differ(one, other, quantity, branches);
      moves = moves || (is_push && other_motion(one, other, branches));
    }
    if (same) continue;
    const double from = value_at(variation, cuts[i - 1]), to = value_at(variation, cuts[i]);
    const double near = 2 * shortest * std::abs(variation.to - variation.from);
    if (!ranges.empty() && ranges.back().motion == moves &&
        std::abs(ranges.back().to - from) <= near)
      ranges.back().to = to;
    else
      ranges.push_back({from, to, moves});
  }
  return ranges;
}

bool is_known(Status status) { return status == Status::solved || status == Status::does_not_hold; }

/// Where no pusher moves there is nothing to break.
bool is_complete(const SweepValue& value) {
  return is_known(value.push) && (is_known(value.breaking) || value.breaking == Status::bad_input);
}

void find_segments(const VariedScene& scene, SweepSolver& solver, bool exact,
                   const ParameterSweepOptions& options, Sweep& sweep) {
  const Variation& variation = sweep.variations.front();
  const double share = options.both_ways ? 0.5 : 1;
  const Tracks there = find_tracks(solver, exact, options, 0, share);
  const SceneFile file = scene.as_given();
  sweep.segments = Merger(file, variation, there).segments();
  if (options.both_ways) {
    SweepSolver backwards(scene, {reversed(variation)}, solver.pusher());
    const Tracks back = find_tracks(backwards, exact, options, share, share);
    sweep.bistable = disagreements(there, back, variation, exact ? 4 * together : blurred);
    if (!sweep.bistable.empty()) sweep.back = Merger(file, reversed(variation), back).segments();
    sweep.cold += backwards.cold();
    sweep.warm += backwards.warm();
  }
  for (const SweepSegment& segment : sweep.segments)
    sweep.complete = sweep.complete && is_complete(segment.at_from);
}

Index only_pusher(const SceneFile& file) {
  Index pusher = -1;
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::pusher) continue;
    if (pusher >= 0)
      throw InputError("the scene has several pushers: say which one the force is of");
    pusher = static_cast<Index>(b);
  }
  if (pusher < 0) throw InputError("the scene has no [[pusher]]: no push changes");
  return pusher;
}

} // namespace

SweepValue merged(const Outputs* push, const Outputs* breaking) {
  SweepValue value;
  if (push != nullptr) {
    value.push = push->status;
    if (push->is_solved()) {
      value.force = push->force;
      value.twist = push->twist;
      value.residual = push->residual;
      value.motion_noise = push->motion_noise;
      value.turning_noise = push->turning_noise;
    }
  }
  if (breaking != nullptr) {
    value.breaking = breaking->status;
    if (breaking->is_solved()) {
      value.break_force = breaking->normal;
      value.break_twist = breaking->twist;
      value.residual = std::max(value.residual, breaking->residual);
    }
  }
  return value;
}

Sweep sweep_parameter(const VariedScene& scene, const std::vector<Variation>& variations,
                      const ParameterSweepOptions& options) {
  const SceneFile file = scene.as_given();
  Sweep sweep;
  sweep.variations = variations;
  const Index pusher = options.pusher >= 0 ? options.pusher : only_pusher(file);
  sweep.pusher = file.body_names[static_cast<std::size_t>(pusher)];
  for (Index i = 0; i < static_cast<Index>(file.points.size()); ++i)
    sweep.contacts.push_back(point_name(file, i));
  SweepSolver solver(scene, variations, pusher);
  if (sweep.is_map()) {
    sample_map(solver, options, sweep);
  } else {
    const Variation& variation = variations.front();
    if (variation.parameter.whole)
      throw InputError(variation.parameter.path + " counts something: it takes a list of whole "
                                                  "numbers, not a range");
    for (const double value : {variation.from, variation.to}) solver.go_to(value);
    const bool linear = variation.parameter.linear;
    if (linear) find_segments(scene, solver, file.pressure != Pressure::pad, options, sweep);
    if (!linear || options.steps > 0) sample_line(scene, solver, options, sweep);
    find_zeros(solver, options, sweep);
  }
  sweep.cold += solver.cold();
  sweep.warm += solver.warm();
  return sweep;
}

} // namespace lcpush::desktop
