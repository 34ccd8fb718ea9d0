// Push: the grasp without a push, and the push that breaks it.
#include "lcpush/desktop/smallest_grip.hpp"
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

/// The core calls rest what is slow beside the grip; beside the load it may be a fall. Where finite
/// pushes were extrapolated, all of them far stronger than the load, only statics' word counts.
bool falls_slowly(const SceneFile& file, const Scene<double>& scene, const BreakReport& report,
                  const PushOptions& options) {
  constexpr double more = 1 + 1e-6;
  const Breaking<double>& breaking = report.breaking;
  const double tolerance = rest_tolerance(options.solver);
  if (is_at_rest(file, breaking.rest, report.scales, tolerance)) return false;
  if (is_exact(file, options))
    return motion_size(breaking.rest, report.scales) > 64 * breaking.residuals.beside;
  if (size_of(scene).unknowns() > limits::unknowns_holding) return false;
  Holding<double> holding;
  const Status status = find_holding(file, options, holding);
  return status == Status::does_not_hold || (status == Status::solved && holding.factor > more);
}

/// The reverse: what is left when pushes far stronger than the load are taken back to none need not
/// be a fall, where statics holds the load with room to spare.
bool only_looks_falling(const SceneFile& file, const Scene<double>& scene,
                        const BreakReport& report, const PushOptions& options) {
  constexpr double room = 1 - 1e-3;
  const double smallest_push = options.solver == Solver::gauss_seidel ? 1e-4 : 1e-5; // of F / m
  if (is_exact(file, options) || size_of(scene).unknowns() > limits::unknowns_holding) return false;
  if (motion_size(report.breaking.rest, report.scales) > 2 * smallest_push) return false;
  Holding<double> holding;
  return find_holding(file, options, holding) == Status::solved && holding.factor < room;
}

bool is_over(Status status) { return status == Status::solved || status == Status::does_not_hold; }

bool is_same_motion(const Vector6<double>& one, const Vector6<double>& two, double length,
                    double slack) {
  Vector6<double> turn = one, off = one - two;
  turn.tail<3>() *= length;
  off.tail<3>() *= length;
  return off.norm() <= slack * std::max(1.0, turn.norm());
}

/// Notes `second` if it differs from all that is known. As in a solve, what the line through small
/// pushes leaves open is no other answer.
void add_other(const Breaking<double>& second, BreakReport& report) {
  constexpr double tolerance = 1e-5;
  const Breaking<double>& first = report.breaking;
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

Status holding_verdict(const SceneFile& file, const Scene<double>& scene, const BreakReport& report,
                       const PushOptions& options) {
  if (report.status == Status::solved && falls_slowly(file, scene, report, options))
    return Status::does_not_hold;
  if (report.status == Status::does_not_hold && only_looks_falling(file, scene, report, options))
    return Status::solved;
  return report.status;
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
  return with_rounds(options, [&](const auto& rounds) {
    return lcpush::find_breaking(assembly_, rounds, work_, file_.body(pusher), {}, breaking, run);
  });
}

BreakReport Push::find_breaking(Index pusher, const PushOptions& options) {
  BreakReport report;
  begin(options, report);
  report.pusher = pusher;
  report.status = break_grasp(options, pusher, report.breaking, report.run);
  report.history = history_;
  report.status = holding_verdict(file_, scene_, report, options);
  if (report.status == Status::does_not_hold)
    report.reason = "the object moves before it is pushed: the grasp does not hold its load";
  else if (report.status == Status::bad_input && report.run.reason == Reason::none)
    report.reason = "no pusher moves: give one an acceleration";
  else if (report.status != Status::solved)
    report.reason = explain(report.status, report.run);
  if (report.status == Status::ray) read_ray(options, report);
  if (report.status != Status::solved) return report;
  name_file_bodies();
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
  report.unique_motion = report.unique_force = Uniqueness::none_other_found;
  Breaking<double> second;
  PressureRun ignored;
  for (Index k = 1; k <= options.other_covers; ++k)
    if (is_over(break_grasp(by_other_cover(options, k), report.pusher, second, ignored)))
      add_other(second, report);
  for (const SceneImage& image : scene_images(file_)) {
    const SceneFile seen = image.of(file_);
    Push push(seen);
    if (!is_over(push.break_grasp(by_other_cover(options, 0), report.pusher, second, ignored)))
      continue;
    second.force = image.of_twist(second.force);
    second.twist = image.of_twist(second.twist);
    add_other(second, report);
  }
}

} // namespace lcpush::desktop
