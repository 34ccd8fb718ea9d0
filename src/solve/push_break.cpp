// Push: the grasp without a push, and the push that breaks it.
#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/less_friction.hpp"
#include "solve/noise.hpp"
#include "solve/push_rounds.hpp"
#include "solve/rest_by_friction.hpp"
#include "solve/rest_verdict.hpp"

namespace lcpush::desktop {
namespace {

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
  const Breaking<double>& first = report.breaking;
  for (Uniqueness* unique : {&report.unique_motion, &report.unique_force})
    if (*unique == Uniqueness::not_tested) *unique = Uniqueness::none_other_found;
  const double slack = SolveSettings().same + 10 * std::max(first.line_error, second.line_error);
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

/// In pads, far below what their last compliance usually leaves.
Status Push::solve_at_rest(const PushOptions& options, Vector6<double>& acceleration) {
  PressureRun ignored;
  const Status status =
      run(options, 0.0, ignored, file_.pressure == Pressure::pad ? SolveSettings().finer_pads : 1);
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

/// Pivots begin without forces, and end in a fall that the laws allow where they allow rest as
/// well: friction that sticks may lift or drag what would rest without it, and nothing makes it.
HoldReport Push::holds_without_push(const PushOptions& options) {
  const SceneFile alone = hand_at_rest(file_);
  const HoldReport report = rest_alone(alone, options);
  if (report.status != Status::solved || report.holds) return report;
  const auto less = with_hardly_any_friction(alone, work_.answer, layout().scales);
  if (!less) return report;
  Push push(less->file);
  const HoldReport rest = push.rest_alone(less->file, options);
  if (rest.status != Status::solved || !rest.holds) return report;
  // Forces within smaller cones, and nothing moves: an answer of the given scene.
  const Answer<double>& held = push.work_.answer;
  work_.answer.acceleration = held.acceleration;
  std::copy(held.contacts.begin(), held.contacts.end(), work_.answer.contacts.begin());
  std::copy(held.friction.begin(), held.friction.end(), work_.answer.friction.begin());
  std::copy(held.closing.begin(), held.closing.end(), work_.answer.closing.begin());
  return rest;
}

/// Of `alone`, the hand of the file.
HoldReport Push::rest_alone(const SceneFile& alone, const PushOptions& options) {
  HoldReport report;
  report.length = layout().scales.length;
  const Scales<double> si{scene_.object.mass, 1.0, 1.0};
  report.acceleration = laws::newton(scene_, si) * laws::load(scene_, si);
  if (alone.bodies.empty()) {
    report.status = Status::solved;
    report.holds = !(report.acceleration.norm() > 0);
    return report;
  }
  EvenScene even(alone.view());
  if (has_round_friction(scene_))
    even.scene.round_cones = {work_.round_cones.data, even.scene.points.size};
  assembly_.assemble(even.scene);
  report.status = rest(options);
  const bool by_pyramids = report.status != Status::solved && has_round_friction(even.scene);
  if (by_pyramids) { // within the cones: what holds, holds
    even.scene.round_cones = {};
    assembly_.assemble(even.scene);
    report.status = rest(options);
  }
  if (report.status == Status::solved) {
    const double noise = rest_noise(alone, layout().scales, options.solver);
    const auto decide = [&](double left) {
      report.acceleration = work_.answer.acceleration;
      return decide_rest(alone, {report.acceleration, layout().scales, left});
    };
    Rest rest = decide(noise);
    // What the last round's compliance leaves looks like a slow fall, the more so the smaller the
    // patches are. A fall stays when more of that is taken away, but for what the check of an
    // answer calls rest: a hundred points end no nearer.
    const SolveSettings settings;
    PressureRun ignored;
    if (rest == Rest::falls && alone.pressure == Pressure::pad &&
        motion_size(report.acceleration, layout().scales) <= settings.slow_fall * noise &&
        run(options, 0.0, ignored, settings.finer_pads) == Status::solved)
      rest = decide(std::max(noise, Tolerances<double>().residual));
    report.holds = rest != Rest::falls;
    if (rest == Rest::not_known || (by_pyramids && !report.holds))
      report.status = Status::numerical_breakdown;
  }
  assembly_.assemble(scene_);
  return report;
}

Status Push::break_grasp(const PushOptions& options, Index pusher, Breaking<double>& breaking,
                         PressureRun& run) {
  PressureOptions<double> pressure;
  pressure.max_pivots = options.max_pivots;
  return with_rounds(options, [&](const AnyRounds& rounds) {
    return lcpush::find_breaking(assembly_, rounds, work_, file_.body(pusher), pressure, breaking,
                                 run);
  });
}

BreakReport Push::find_breaking(Index pusher, const PushOptions& options) {
  BreakReport report;
  begin(options, report);
  report.pusher = pusher;
  report.status = with_friction(
      report, [&] { return break_grasp(options, pusher, report.breaking, report.run); });
  report.history = history_;
  report.status = holding_verdict(file_, report, options);
  if (report.status == Status::does_not_hold)
    report.reason = "the object moves before it is pushed: the grasp does not hold its load";
  else if (report.status == Status::bad_input && report.run.reason == Reason::none)
    report.reason = "no pusher moves: give one an acceleration";
  else if (report.status != Status::solved)
    find_reason(report);
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

/// The same with less friction where it sticks, and on other paths: is this the only force that
/// breaks the grasp? What comes of it has passed the same referee.
void Push::compare_others(const PushOptions& options, BreakReport& report) {
  if (layout().size > limits::unknowns_searched) return;
  Breaking<double> second;
  PressureRun ignored;
  for (const double part : SolveSettings().less_friction) {
    if (options.other_paths == 0 || undetermined_body(scene_) < 0 || is_late(options)) break;
    const auto less = with_less_friction(file_, work_.answer, part, layout().scales);
    if (!less) break;
    Push push(less->file);
    push.assembled_.assemble(has_round_friction(scene_));
    const PushOptions search = search_options(options, layout().size);
    if (!is_over(push.break_grasp(search, report.pusher, second, ignored)) ||
        !less->sticks(push.work_.answer) ||
        falls_before_push(less->file, second, report.scales, options))
      continue;
    add_other(second, report);
    report.is_friction_open = report.unique_force == Uniqueness::no;
    break;
  }
  const Index paths = paths_to_search(options, has_round_friction(scene_));
  for (Index k = 1; k <= paths; ++k) {
    if ((k > options.other_paths && !report.others.empty()) || is_late(options)) break;
    const OtherPath path = other_path(file_, options, k, layout().size);
    std::optional<Push> turned;
    Push& push = on(path, turned);
    if (is_over(push.break_grasp(path.options, report.pusher, second, ignored)) &&
        !falls_before_push(push.file_, second, report.scales, path.options))
      add_other(second, report);
  }
}

} // namespace lcpush::desktop
