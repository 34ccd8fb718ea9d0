#include "solve/rest_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/grip_statics.hpp"
#include "solve/less_friction.hpp"
#include "solve/settings.hpp"

namespace lcpush::desktop {
namespace {

/// `least`: least_factor of the scene.
bool statics_proves_fall(const std::optional<double>& least) {
  return least && *least > 1 + SolveSettings().short_of_load;
}

/// What is left when pushes far stronger than the load are taken back to none need not be a fall,
/// where statics holds the load with room to spare.
bool statics_has_room(const std::optional<double>& least) {
  return least && *least < 1 - SolveSettings().room;
}

} // namespace

double load_acceleration(const SceneFile& file, double length) {
  Vector3<double> load = file.gravity + file.object.wrench.head<3>() / file.object.mass;
  if (file.planar) load[2] = 0;
  const double turn = file.object.wrench.tail<3>().norm() / (file.object.mass * length);
  double largest = std::max(load.norm(), turn);
  const Scene<double> scene = file.view();
  for (Index a = 0; a < scene.actuators.size; ++a)
    if (!grips(scene, a))
      largest = std::max(largest, std::abs(scene.actuators[a].force) / file.object.mass);
  return largest;
}

double rest_tolerance(Solver solver) {
  // Pivots end at rounding, sweeps do not.
  const Tolerances<double> tolerances;
  return 64 * (solver == Solver::gauss_seidel ? tolerances.residual : tolerances.settled);
}

double rest_noise(const SceneFile& file, const Scales<double>& scales, Solver solver) {
  const double load = load_acceleration(file, scales.length) / scales.acceleration;
  return rest_tolerance(solver) * std::max(load, SolveSettings().least_load);
}

Rest decide_rest(const SceneFile& file, const RestMotion& motion) {
  if (motion_size(motion.acceleration, motion.scales) > motion.noise) return Rest::falls;
  const double load = load_acceleration(file, motion.scales.length) / motion.scales.acceleration;
  return load == 0 || load >= 16 * motion.noise ? Rest::holds : Rest::not_known;
}

namespace {

bool is_extrapolated(const SceneFile& file, const PushOptions& options) {
  return takes_rounds(file) || options.solver == Solver::gauss_seidel;
}

/// motion_size of what an exact limit leaves of rest.
double limit_noise(const SceneFile& file, const Breaking<double>& breaking,
                   const Scales<double>& scales, const PushOptions& options) {
  const double noise = rest_noise(file, scales, options.solver);
  return std::min(at_rest<double>(), std::max(noise, 64 * breaking.residuals.beside));
}

/// How the scene's own law moves the object while nothing pushes.
struct AtRest {
  Vector6<double> motion = Vector6<double>::Zero();
  bool is_known = false, moves = false;
};

AtRest solve_at_rest(const SceneFile& file, const Scales<double>& scales,
                     const PushOptions& options) {
  AtRest rest;
  rest.is_known = Push(file).solve_at_rest(options, rest.motion) == Status::solved;
  const double noise = rest_noise(file, scales, options.solver);
  rest.moves = rest.is_known && motion_size(rest.motion, scales) > noise;
  return rest;
}

/// Finite pushes may all be stronger than what lets the object fall or holds it: what they leave of
/// a motion, `left`, is asked only where the law has no answer at rest, or falls otherwise than
/// they do though statics holds the load with room to spare.
bool falls_at_rest(const std::optional<double>& least, const AtRest& rest,
                   const Vector6<double>& left, const Scales<double>& scales) {
  const double moved = motion_size(left, scales);
  if (!rest.is_known) return moved > at_rest<double>();
  if (!rest.moves || moved <= at_rest<double>()) return rest.moves;
  const Vector6<double> off = rest.motion - left;
  return !statics_has_room(least) || motion_size(off, scales) < SolveSettings().same_fall * moved;
}

} // namespace

bool rests_by_less_friction(const SceneFile& file) {
  Push push(file);
  Vector6<double> motion;
  if (push.solve_at_rest({}, motion) != Status::solved) return false;
  const auto less = with_hardly_any_friction(file, push.last_answer(), push.layout().scales);
  return less && Push(less->file).solve_at_rest({}, motion) == Status::solved &&
         motion_size(motion, push.layout().scales) <=
             rest_noise(file, push.layout().scales, Solver::lemke);
}

bool falls_before_push(const SceneFile& file, const Breaking<double>& breaking,
                       const Scales<double>& scales, const PushOptions& options) {
  const double moved = motion_size(breaking.rest, scales);
  if (!is_extrapolated(file, options)) return moved > limit_noise(file, breaking, scales, options);
  return moved > at_rest<double>() || statics_proves_fall(least_factor(GripStatics(file)));
}

Status holding_verdict(const SceneFile& file, BreakReport& report, const PushOptions& options) {
  Breaking<double>& breaking = report.breaking;
  const bool extrapolated = is_extrapolated(file, options);
  const bool presses_only = extrapolated && !file.body(report.pusher).bilateral;
  const double least = -SolveSettings().no_pull * report.scales.force;
  const bool pulled = presses_only && breaking.break_force < least &&
                      (report.status == Status::solved || pulls(breaking, report.scales));
  if (presses_only && !pulled) breaking.break_force = std::max(0.0, breaking.break_force);
  if (report.status != Status::solved && report.status != Status::does_not_hold && !pulled)
    return report.status;
  const double moved = motion_size(breaking.rest, report.scales);
  if (!extrapolated) {
    const double noise = limit_noise(file, breaking, report.scales, options);
    return moved > noise ? Status::does_not_hold : Status::solved;
  }
  const std::optional<double> least_grip = least_factor(GripStatics(file));
  const bool is_proved = statics_proves_fall(least_grip);
  if (!pulled && moved <= at_rest<double>() && !is_proved) return Status::solved;
  const AtRest rest = solve_at_rest(file, report.scales, options);
  if (is_proved || falls_at_rest(least_grip, rest, breaking.rest, report.scales)) {
    if (rest.moves) breaking.rest = rest.motion;
    return Status::does_not_hold;
  }
  // So near its limit that no finite push is on the line of the smallest?
  const bool is_open = rest.is_known && breaking.line_error > SolveSettings().no_pull &&
                       !statics_has_room(least_grip);
  if (!pulled && !is_open) return Status::solved;
  report.run.reason = Reason::pull;
  return Status::numerical_breakdown;
}

} // namespace lcpush::desktop
