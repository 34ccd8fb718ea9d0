#include "solve/rest_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/settings.hpp"

namespace lcpush::desktop {
namespace {

/// Statics has no round cones: theirs are 0.1 % short of a circle.
Scene<double> in_facets(const SceneFile& file) {
  Scene<double> scene = file.view();
  if (file.is_round) scene.facets = SolveSettings().nearly_round;
  return scene;
}

/// ask(assembly, memory) of a file's scene.
template <class Ask> Status ask_statics(const SceneFile& file, const Ask& ask) {
  const AssembledScene assembled(in_facets(file));
  const AssemblySize size = size_of(assembled.scene);
  SolverMemory<double> memory(holding_scalars(size), holding_integers(size));
  return ask(assembled.assembly,
             StudyMemory<double>{span_of(memory.scalars), span_of(memory.integers)});
}

/// The least factor on the grip that holds the load, infinite if none does; none: not known.
std::optional<double> least_factor(const SceneFile& file) {
  Holding<double> holding;
  const Status status = find_holding(file, holding);
  if (status == Status::does_not_hold) return std::numeric_limits<double>::infinity();
  return status == Status::solved ? std::optional<double>(holding.factor) : std::nullopt;
}

bool carries_load(const SceneFile& file) {
  return ask_statics(file, [](const auto& assembly, const auto& memory) {
           return lcpush::carries_load(assembly, memory);
         }) == Status::solved;
}

bool statics_proves_fall(const SceneFile& file) {
  if (carries_load(file)) return false;
  const SolveSettings settings;
  const std::optional<double> least = least_factor(file);
  return least && *least > 1 + (file.is_round ? settings.short_of_round : settings.short_of_load);
}

/// What is left when pushes far stronger than the load are taken back to none need not be a fall,
/// where statics holds the load with room to spare.
bool statics_has_room(const SceneFile& file) {
  const std::optional<double> least = least_factor(file);
  return least && *least < 1 - SolveSettings().room;
}

} // namespace

Status find_holding(const SceneFile& file, Holding<double>& holding) {
  return ask_statics(file, [&](const auto& assembly, const auto& memory) {
    return lcpush::find_holding(assembly, memory, holding);
  });
}

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
  const double moves = motion_size(motion.acceleration, motion.scales);
  if (moves > motion.noise) {
    const double left = std::max(SolveSettings().left_by_pushes, 2 * motion.small_push);
    const bool may_be_of_push = motion.small_push > 0 && moves <= left;
    if (!may_be_of_push || !statics_has_room(file)) return Rest::falls;
  }
  if (motion.small_push > 0 && statics_proves_fall(file)) return Rest::falls;
  const double load = load_acceleration(file, motion.scales.length) / motion.scales.acceleration;
  return load == 0 || load >= 16 * motion.noise ? Rest::holds : Rest::not_known;
}

namespace {

bool is_extrapolated(const SceneFile& file, const PushOptions& options) {
  return takes_rounds(file) || options.solver == Solver::gauss_seidel;
}

/// What is left without a push, as the solver's laws let it be told.
RestMotion left_at_rest(const SceneFile& file, const Breaking<double>& breaking,
                        const Scales<double>& scales, const PushOptions& options) {
  if (is_extrapolated(file, options))
    return {breaking.rest, scales, at_rest<double>(), breaking.small_push / scales.acceleration};
  const double noise = rest_noise(file, scales, options.solver);
  return {breaking.rest, scales,
          std::min(at_rest<double>(), std::max(noise, 64 * breaking.residuals.beside)), 0};
}

} // namespace

bool falls_before_push(const SceneFile& file, const Breaking<double>& breaking,
                       const Scales<double>& scales, const PushOptions& options) {
  return decide_rest(file, left_at_rest(file, breaking, scales, options)) == Rest::falls;
}

Status holding_verdict(const SceneFile& file, BreakReport& report, const PushOptions& options) {
  Breaking<double>& breaking = report.breaking;
  const bool extrapolated = is_extrapolated(file, options);
  const bool presses_only = extrapolated && !file.body(report.pusher).bilateral;
  const double least = -SolveSettings().no_pull * report.scales.force;
  const bool pulled = presses_only && breaking.break_force < least &&
                      (report.status == Status::solved || pulls(breaking, report.scales));
  const bool is_below = presses_only && breaking.break_force < least * Tolerances<double>().settled;
  if (presses_only && !pulled) breaking.break_force = std::max(0.0, breaking.break_force);
  if (report.status != Status::solved && report.status != Status::does_not_hold && !pulled)
    return report.status;
  const RestMotion left = left_at_rest(file, breaking, report.scales, options);
  const double noise = rest_noise(file, report.scales, options.solver);
  bool falls = decide_rest(file, left) == Rest::falls;
  if (falls && (report.status == Status::does_not_hold || !extrapolated))
    return Status::does_not_hold;
  const double moves = motion_size(breaking.rest, report.scales);
  const bool is_excused = !falls && moves > left.noise; // as what the pushes leave
  if (!falls && !pulled && !is_excused) return Status::solved;
  // How does it fall, if the pushes did not see it?
  Vector6<double> motion;
  const bool is_known = Push(file).solve_at_rest(options, motion) == Status::solved;
  const bool moves_alone = is_known && motion_size(motion, report.scales) > noise;
  if (is_excused && !pulled) {
    const Vector6<double> off = motion - breaking.rest;
    const bool is_same =
        moves_alone && motion_size(off, report.scales) < SolveSettings().same_fall * moves;
    if (is_same || !is_below) return is_same ? Status::does_not_hold : Status::solved;
  }
  if (moves_alone) {
    breaking.rest = motion;
    falls = true;
  }
  if (falls) return Status::does_not_hold;
  report.run.reason = Reason::pull;
  return Status::numerical_breakdown;
}

} // namespace lcpush::desktop
