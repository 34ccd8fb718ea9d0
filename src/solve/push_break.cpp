// Push: the grasp without a push, and the push that breaks it.
#include <limits>
#include <optional>

#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/noise.hpp"
#include "solve/push_rounds.hpp"
#include "solve/rest_by_friction.hpp"
#include "solve/scene_image.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

/// One basis gives the breaking force; nothing is extrapolated from finite pushes.
bool is_exact(const SceneFile& file, const PushOptions& options) {
  return !takes_rounds(file) && options.solver != Solver::gauss_seidel;
}

/// The core calls rest what is slow beside the grip; beside the load it may be a fall.
bool falls_slowly(const SceneFile& file, const BreakReport& report, const PushOptions& options) {
  const Breaking<double>& breaking = report.breaking;
  const double tolerance = rest_tolerance(options.solver);
  return !is_at_rest(file, breaking.rest, report.scales, tolerance) &&
         motion_size(breaking.rest, report.scales) > 64 * breaking.residuals.beside;
}

/// The least factor on the grip that holds the load, infinite if none does; none: not known.
std::optional<double> least_factor(const SceneFile& file) {
  Holding<double> holding;
  const Status status = find_holding(file, holding);
  if (status == Status::does_not_hold) return std::numeric_limits<double>::infinity();
  return status == Status::solved ? std::optional<double>(holding.factor) : std::nullopt;
}

/// Finite pushes may all be stronger than the fall: the object then moves as they do, to the last
/// digit, and nothing of the fall is left in what they are taken back to. Only statics tells.
bool falls_by_statics(const SceneFile& file) {
  if (carries_load(file)) return false;
  const double more = file.is_round ? 1 + 2e-3 : 1 + 1e-6; // its facets are short of a circle
  const std::optional<double> least = least_factor(file);
  return least && *least > more;
}

/// Pushes were extrapolated and say that the grasp holds, or that the pusher pulls: does it hold?
/// If not, report.breaking.rest becomes the fall.
Status verdict_of_pushes(const SceneFile& file, BreakReport& report, const PushOptions& options) {
  const bool falls = falls_by_statics(file);
  const bool pulled = pulls(report.breaking, report.scales);
  if (!falls && !pulled) return Status::solved;
  Vector6<double> motion;
  const bool is_known = Push(file).solve_at_rest(options, motion) == Status::solved;
  const bool moves =
      is_known && !is_at_rest(file, motion, report.scales, rest_tolerance(options.solver));
  if (moves) report.breaking.rest = motion;
  if (falls || moves) return Status::does_not_hold;
  report.run.reason = Reason::pull;
  return Status::numerical_breakdown;
}

/// The reverse: what is left when pushes far stronger than the load are taken back to none need not
/// be a fall, where statics holds the load with room to spare.
bool only_looks_falling(const SceneFile& file, const BreakReport& report,
                        const PushOptions& options) {
  constexpr double room = 1 - 1e-3;
  const double smallest_push = options.solver == Solver::gauss_seidel ? 1e-4 : 1e-5; // of F / m
  if (motion_size(report.breaking.rest, report.scales) > 2 * smallest_push) return false;
  const std::optional<double> least = least_factor(file);
  return least && *least < room;
}

bool is_over(Status status) { return status == Status::solved || status == Status::does_not_hold; }

bool is_same_motion(const Vector6<double>& one, const Vector6<double>& two, double length,
                    double slack) {
  Vector6<double> turn = one, off = one - two;
  turn.tail<3>() *= length;
  off.tail<3>() *= length;
  return off.norm() <= slack * std::max(1.0, turn.norm());
}

/// Notes that there was a second one, and `second` itself if it differs from all that is known. As
/// in a solve, what the line through small pushes leaves open is no other answer.
void add_other(const Breaking<double>& second, BreakReport& report) {
  constexpr double tolerance = 1e-5;
  const Breaking<double>& first = report.breaking;
  for (Uniqueness* unique : {&report.unique_motion, &report.unique_force})
    if (*unique == Uniqueness::not_tested) *unique = Uniqueness::none_other_found;
  const double slack = tolerance + 10 * std::max(first.line_error, second.line_error);
  const double near = slack * std::max(report.scales.force, first.break_force);
  const auto pushes_alike = [&](double force) {
    return std::abs(force - second.break_force) <= near;
  };
  const auto moves_alike = [&](const Vector6<double>& twist) {
    return is_same_motion(twist, second.twist, report.scales.length, slack);
  };
  if (!moves_alike(first.twist)) report.unique_motion = Uniqueness::no;
  if (!pushes_alike(first.break_force)) {
    report.unique_force = Uniqueness::no;
    const auto off = [&](double force) { return std::abs(force - first.break_force); };
    if (!report.other_force || off(second.break_force) > off(*report.other_force))
      report.other_force = second.break_force;
  }
  const bool is_known =
      (pushes_alike(first.break_force) && moves_alike(first.twist)) ||
      std::any_of(report.others.begin(), report.others.end(), [&](const OtherBreak& other) {
        return pushes_alike(other.break_force) && moves_alike(other.twist);
      });
  if (!is_known)
    report.others.push_back({second.break_force, second.force.head<3>(), second.twist});
}

} // namespace

Status holding_verdict(const SceneFile& file, BreakReport& report, const PushOptions& options) {
  if (is_exact(file, options))
    return report.status == Status::solved && falls_slowly(file, report, options)
               ? Status::does_not_hold
               : report.status;
  const bool pulled =
      report.status == Status::numerical_breakdown && pulls(report.breaking, report.scales);
  const bool holds =
      report.status == Status::solved || pulled ||
      (report.status == Status::does_not_hold && only_looks_falling(file, report, options));
  return holds ? verdict_of_pushes(file, report, options) : report.status;
}

/// In pads, far below what their last compliance usually leaves.
Status Push::solve_at_rest(const PushOptions& options, Vector6<double>& acceleration) {
  PressureRun ignored;
  const Status status = run(options, 0.0, ignored, file_.pressure == Pressure::pad ? 1e-4 : 1);
  if (status == Status::solved) acceleration = work_.answer.acceleration;
  return status;
}

/// Solves the assembled hand at rest: without pivots where friction plainly holds the load, which
/// the laws' own check confirms. Few points are pivoted all the same: that costs nothing.
Status Push::rest(const PushOptions& options) {
  if (options.solver == Solver::lemke && takes_structure(options)) {
    assembly_.push_by(0.0);
    pad_preload(assembly_, work_.pressure);
    const std::vector<double> z = rest_by_friction(assembly_, work_.pressure.preload.data);
    if (!z.empty()) {
      read_answer(assembly_, z.data(), work_.answer, 0.0);
      const Residuals<double> worst = check(assembly_.scene(), layout().scales, work_.answer, 0.0);
      if (worst.max() <= Tolerances<double>().residual) return Status::solved;
    }
  }
  PressureRun ignored;
  return run(options, 0.0, ignored);
}

HoldReport Push::holds_without_push(const PushOptions& options) {
  const SceneFile alone = hand_at_rest(file_);
  HoldReport report;
  report.length = layout().scales.length;
  const Scales<double> si{scene_.object.mass, 1.0, 1.0};
  report.acceleration = laws::newton(scene_, si) * laws::load(scene_, si);
  if (alone.bodies.empty()) {
    report.status = Status::solved;
    report.holds = !(report.acceleration.norm() > 0);
    return report;
  }
  const EvenScene even(alone.view());
  assembly_.assemble(even.scene);
  report.status = rest(options);
  if (report.status == Status::solved) {
    const double tolerance = rest_tolerance(options.solver);
    report.acceleration = work_.answer.acceleration;
    report.holds = is_at_rest(alone, report.acceleration, layout().scales, tolerance);
    // What the last round's compliance leaves looks like a slow fall, the more so the smaller the
    // patches are. A fall stays when more of that is taken away.
    constexpr double slow = 1e5, part = 1e-4;
    PressureRun ignored;
    if (!report.holds && alone.pressure == Pressure::pad &&
        is_at_rest(alone, report.acceleration, layout().scales, slow * tolerance) &&
        run(options, 0.0, ignored, part) == Status::solved) {
      report.acceleration = work_.answer.acceleration;
      report.holds = is_at_rest(alone, report.acceleration, layout().scales, tolerance);
    }
    if (report.holds && !shows_a_fall(alone, layout().scales, tolerance))
      report.status = Status::numerical_breakdown; // a fall would look the same
  }
  assembly_.assemble(scene_);
  return report;
}

Status Push::break_grasp(const PushOptions& options, Index pusher, Breaking<double>& breaking,
                         PressureRun& run) {
  settled_by_sweeps_ = 0;
  const PressureOptions<double> pressure = breaking_options(assembly_);
  const Status status = with_rounds(options, [&](const auto& rounds) {
    return lcpush::find_breaking(assembly_, rounds, work_, file_.body(pusher), pressure, breaking,
                                 run);
  });
  run.sweeps += settled_by_sweeps_;
  return status;
}

BreakReport Push::find_breaking(Index pusher, const PushOptions& options) {
  BreakReport report;
  begin(options, report);
  report.pusher = pusher;
  report.status = break_grasp(options, pusher, report.breaking, report.run);
  report.history = history_;
  report.status = holding_verdict(file_, report, options);
  if (report.status == Status::does_not_hold)
    report.reason = "the object moves before it is pushed: the grasp does not hold its load";
  else if (report.status == Status::bad_input && report.run.reason == Reason::none)
    report.reason = "no pusher moves: give one an acceleration";
  else if (report.status != Status::solved)
    report.reason = explain(report.status, report.run);
  if (report.status == Status::ray) read_ray(options, report);
  if (report.status != Status::solved) return report;
  name_file_bodies();
  find_noise(file_, work_.answer, report);
  Answer<double> moving = work_.answer;
  moving.acceleration = report.breaking.twist;
  report.motion =
      describe_motion(file_.view(), moving, report.scales.length, report.scales.acceleration, 1.0);
  report.closings = closings(report.breaking.small_push);
  report.hand_moves = any_moves(report.closings);
  compare_others(options, report);
  return report;
}

/// The same under other covers and in mirrors: is this the only force that breaks the grasp? What
/// comes of it has passed the same referee.
void Push::compare_others(const PushOptions& options, BreakReport& report) {
  if (options.other_covers <= 0 || layout().size > limits::unknowns_searched) return;
  pivots_left_ = limits::unknowns_pivoted_in_search / layout().size;
  Breaking<double> second;
  PressureRun ignored;
  for (Index k = 1; k <= options.other_covers; ++k)
    if (is_over(break_grasp(by_other_cover(options, k), report.pusher, second, ignored)))
      add_other(second, report);
  // Where a wide patch begins at a few of its points, so does its image: that starts from nothing
  // too.
  const Index starts = layout().size >= SettledPivots::smallest ? 2 : 1;
  for (const SceneImage& image : scene_images(file_)) {
    const SceneFile seen = image.of(file_);
    Push push(seen);
    push.pivots_left_ = pivots_left_;
    for (Index k = 0; k < starts; ++k) {
      if (!is_over(push.break_grasp(by_other_cover(options, k), report.pusher, second, ignored)))
        continue;
      second.force = image.of_twist(second.force);
      second.twist = image.of_twist(second.twist);
      add_other(second, report);
    }
    pivots_left_ = push.pivots_left_;
  }
  pivots_left_.reset();
}

} // namespace lcpush::desktop
