// [T.10] The instant of breaking: the force that just moves the object in the grip, and how it then
// moves. It is the limit of an infinitesimal push, sigma -> 0+ (docs/theory/theory.md, "Breaking").
#pragma once

#include <limits>

#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/solve/settings.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush {

/// "Unit push" stands for the prescribed motion scaled so that the fastest point of contact with a
/// moving body accelerates at 1 m/s^2. Wrenches at the centre of mass, scene axes, on the object.
template <class S> struct Breaking {
  /// Object's acceleration before the push, pusher in place, [m/s^2; rad/s^2].
  Vector6<S> rest = Vector6<S>::Zero();
  Vector6<S> force = Vector6<S>::Zero();   ///< the pusher's wrench when it breaks, [N; N m]
  Vector6<S> inertia = Vector6<S>::Zero(); ///< what a unit push adds to it, [N; N m] per m/s^2
  Vector6<S> twist = Vector6<S>::Zero();   ///< object's acceleration per unit push, [1; rad/m]
  S break_force{0};                        ///< N, its normal forces summed over the pusher's points
  S inertia_normal{0};                     ///< N per m/s^2, the same sum of what a unit push adds
  S valid_to{-1};  ///< m/s^2, the largest push for which this holds exactly; -1: not known
  S line_error{0}; ///< `pad`: how far a third push lies off the line through two, over F
  S small_push{0}; ///< m/s^2: the push at which work.answer is left
  /// Does the object move when it is pushed? If not, break_force is only what the pusher meets
  /// while it slides along, rests or leaves.
  bool breaks = true;
  Residuals<S> residuals;
};

/// The fastest point of contact with a body that moves as prescribed, m/s^2; 0: nothing moves.
template <class S> S push_size(const Scene<S>& scene) {
  S fastest(0);
  for (const Body<S>& body : scene.bodies)
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      fastest = Eigen::numext::maxi(fastest,
                                    S(acceleration_at(scene.points[i], body.acceleration).norm()));
  return fastest;
}

/// |a| in units of F / m, rotations at the distance L.
template <class S> S motion_size(const Vector6<S>& acceleration, const Scales<S>& scales) {
  const S linear = acceleration.template head<3>().norm();
  const S angular = scales.length * acceleration.template tail<3>().norm();
  return Eigen::numext::maxi(linear, angular) / scales.acceleration;
}

/// The limit z + sigma z_push, for 0 <= sigma <= valid_to (< 0: no bound), as forces and motions.
/// Post: solved, or numerical_breakdown with run.reason; breaking.residuals is the check's word.
template <class S>
Status read_breaking(Assembly<S>& assembly, const S* z, const S* z_push, const S& valid_to,
                     Workspace<S>& work, const Body<S>& pusher, S unit, Breaking<S>& breaking,
                     PressureRun& run) {
  const Scene<S>& scene = assembly.scene();
  read_answer(assembly, z_push, work.answer, S(1), false);
  breaking.inertia = body_wrench(scene, work.answer, pusher) / unit;
  breaking.inertia_normal = normal_sum(work.answer, pusher) / unit;
  breaking.twist = work.answer.acceleration / unit;
  breaking.valid_to = valid_to < S(0) ? S(-1) : S(valid_to * unit);
  read_answer(assembly, z, work.answer, S(0));
  breaking.rest = work.answer.acceleration;
  breaking.force = body_wrench(scene, work.answer, pusher);
  breaking.break_force = normal_sum(work.answer, pusher);
  breaking.residuals = check(scene, assembly.layout().scales, work.answer, S(0));

  // The same answer a little later, to be checked while it moves.
  const S small = Eigen::numext::maxi(S(1e-4), smallest_push<S>());
  S sigma = small * assembly.layout().scales.acceleration / unit;
  if (valid_to >= S(0) && valid_to < sigma) sigma = valid_to;
  if (sigma * unit < Tolerances<S>().residual * assembly.layout().scales.acceleration) {
    run.reason = Reason::residual; // so short a range that rounding may have made it
    return Status::numerical_breakdown;
  }
  breaking.small_push = sigma * unit;
  for (Index i = 0; i < assembly.layout().size; ++i) work.pressure.z[i] = z[i] + sigma * z_push[i];
  read_answer(assembly, work.pressure.z.data, work.answer, sigma);
  const Residuals<S> moving = check(scene, assembly.layout().scales, work.answer, sigma);
  breaking.residuals.take(moving);
  return Status::solved;
}

/// Does the object move under the smallest push that was looked at? Beside it a millionth of the
/// push is no motion, nor is what rounding and the residual leave of one.
template <class S> bool moves_object(const Breaking<S>& breaking, const Scales<S>& scales) {
  const S rounding = S(512) * Eigen::NumTraits<S>::epsilon();
  const S noise = Eigen::numext::maxi(Tolerances<S>().residual,
                                      S(rounding * scales.acceleration / breaking.small_push));
  return motion_size(breaking.twist, scales) * scales.acceleration >
         BreakingSettings<S>().slowest_twist + S(16) * noise;
}

/// A pusher cannot pull. Where finite pushes taken back to none say that it does, by more than they
/// leave open, the contacts change between none and the smallest of them: most often to a fall.
template <class S> bool pulls(const Breaking<S>& breaking, const Scales<S>& scales) {
  const S open =
      Tolerances<S>().settled + S(10) * breaking.line_error + S(16) * breaking.residuals.max();
  return breaking.break_force < -open * scales.force;
}

/// The verdict on what was read from solved pushes; sets breaking.breaks.
template <class S> Status judge(Breaking<S>& breaking, const Scales<S>& scales, PressureRun& run) {
  if (!(breaking.residuals.max() <= Tolerances<S>().residual)) {
    run.reason = Reason::residual;
    return Status::numerical_breakdown;
  }
  breaking.breaks = moves_object(breaking, scales);
  if (motion_size(breaking.rest, scales) > at_rest<S>()) return Status::does_not_hold;
  if (!pulls(breaking, scales)) return Status::solved;
  run.reason = Reason::pull;
  return Status::numerical_breakdown;
}

namespace detail {

/// `rigid` and `even`: the push is one more right-hand side, so the limit is exact.
template <class S, class Rounds>
Status break_exactly(Assembly<S>& assembly, Rounds& rounds, Workspace<S>& work,
                     const Body<S>& pusher, S unit, Breaking<S>& breaking, PressureRun& run) {
  assembly.push_by(assembly.sigma());
  PushLimit<S> limit;
  const Status status = rounds.solve_limit(assembly, work.pressure, run, limit);
  assembly.push_by(assembly.sigma());
  if (status != Status::solved) return status;
  return read_breaking(assembly, limit.z, limit.z_push, limit.valid_to, work, pusher, unit,
                       breaking, run);
}

/// Round friction's linearization where everything moves so many times as slowly.
template <class S> void slow_down(LinearizedCone<S>& cone, const S& times) {
  cone.slip /= times;
  cone.body_motion /= times;
  cone.inertia *= times;
}

/// What one small push does.
template <class S> struct SmallPush {
  S sigma, normal, compliance;
  Vector6<S> wrench, acceleration;
  Residuals<S> residuals;
};

/// The line through two pushes, the second the smaller one.
template <class S> Breaking<S> line_through(const SmallPush<S>& a, const SmallPush<S>& b, S unit) {
  Breaking<S> line;
  const S span = (a.sigma - b.sigma) * unit, back = b.sigma * unit;
  line.inertia = (a.wrench - b.wrench) / span;
  line.inertia_normal = (a.normal - b.normal) / span;
  line.force = b.wrench - back * line.inertia;
  line.break_force = b.normal - back * line.inertia_normal;
  line.twist = b.acceleration / back;
  return line;
}

/// The line through two of three pushes, judged by the other: through the larger two, or, where the
/// force `curves` (round friction's is a smooth function of the push), through the smaller two.
template <class S>
Breaking<S> extrapolate(const SmallPush<S>* push, bool curves, S unit, const Scales<S>& scales) {
  Breaking<S> line = line_through(push[0], push[1], unit);
  S off = line.break_force + push[2].sigma * unit * line.inertia_normal - push[2].normal;
  if (curves) {
    off = line.break_force;
    line = line_through(push[1], push[2], unit);
    off -= line.break_force;
  }
  line.line_error = Eigen::numext::abs(off) / scales.force;
  // What is left of the acceleration when the push is taken back to 0: nothing if it holds.
  line.rest = push[2].acceleration - (push[1].acceleration - push[2].acceleration) *
                                         (push[2].sigma / (push[1].sigma - push[2].sigma));
  line.small_push = push[2].sigma * unit;
  line.residuals = push[1].residuals;
  for (const int k : {0, 2}) line.residuals.take(push[k].residuals);
  return line;
}

/// `pad`: compliance has to vanish before the push does, so the force of breaking is read off the
/// line through three finite pushes; so it is under round friction, whose slips have no direction
/// before they begin, and where the solver knows no infinitesimal push.
template <class S, class Rounds> class BreakByPushes {
public:
  BreakByPushes(Assembly<S>& assembly, const Rounds& rounds, Workspace<S>& work,
                const Body<S>& pusher, const PressureOptions<S>& options, S unit)
      : assembly_(assembly), rounds_(rounds), work_(work), pusher_(pusher), options_(options),
        unit_(unit) {}

  /// Slow pushes first. They ask for pads as stiff as they are slow, and of many points the
  /// stiffest have no answer in the digits: then faster ones.
  Status find(Breaking<S>& breaking, PressureRun& run) {
    const BreakingSettings<S> settings;
    S first = Eigen::numext::maxi(rounds_.carries_push() ? settings.first_push
                                                         : settings.first_swept_push,
                                  S(3) * smallest_push<S>());
    for (;; first *= settings.step) {
      const Status status = find_from(first, breaking, run);
      const bool is_lost = status == Status::numerical_breakdown || status == Status::pivot_limit ||
                           status == Status::sweep_limit || status == Status::stagnated;
      if (!is_lost || first * settings.step > settings.fastest_push) return status;
    }
  }

private:
  Assembly<S>& assembly_;
  Rounds rounds_;
  Workspace<S>& work_;
  const Body<S>& pusher_;
  PressureOptions<S> options_;
  S unit_;
  SmallPush<S> push_[3]; // the last three

  /// Where the third push is off the line of the first two, a change of mode lies between, and
  /// where they leave a motion of their own size, one may lie below: then the line is that of
  /// smaller pushes.
  Status find_from(S size, Breaking<S>& breaking, PressureRun& run) {
    const BreakingSettings<S> settings;
    const bool is_round = has_round_friction(assembly_.scene());
    bool is_of_push = false; // what is left without a push may be the smallest push's own doing
    for (int k = 0; k < BreakingSettings<S>::most_pushes; ++k, size /= settings.step) {
      const Status status = push_next(size, k, run);
      if (status != Status::solved) return k < 3 ? status : Status::solved;
      if (k < 2) continue;
      const Breaking<S> line = extrapolate(push_, is_round, unit_, assembly_.layout().scales);
      if (k == 2 || is_of_push || line.line_error < breaking.line_error) breaking = line;
      breaking.small_push = line.small_push;
      const S rest = motion_size(breaking.rest, assembly_.layout().scales);
      is_of_push = rest > at_rest<S>() && rest <= settings.own_motion * size;
      const S part = Eigen::numext::abs(breaking.break_force) / assembly_.layout().scales.force;
      const S straight = settings.straight * Eigen::numext::maxi(settings.small_force, part);
      if (breaking.line_error <= straight && !is_of_push) break;
    }
    return Status::solved;
  }

  /// The k-th push, kept as one of the last three.
  Status push_next(S size, int k, PressureRun& run) {
    if (k > 2) {
      push_[0] = push_[1];
      push_[1] = push_[2];
    }
    const int at = Eigen::numext::mini(k, 2);
    SmallPush<S>& push = push_[at];
    const bool is_round = has_round_friction(assembly_.scene());
    const bool goes_on = at > 0 && (is_round || rounds_.goes_on());
    if (goes_on && go_on(size, push_[at - 1].compliance, push, run)) return Status::solved;
    // Pads that yield more than a slow push moves would turn every slip away from what was
    // predicted; round friction's pyramids turn with the slips, but for the slowest.
    const BreakingSettings<S> settings;
    PressureOptions<S> options = options_;
    const bool is_slow = k > 2 || !is_round;
    if (rounds_.goes_on() && is_slow && size < settings.first_push)
      options.first_compliance *= size / settings.first_push;
    return push_slowly(size, options, push, run);
  }

  /// Solves a push whose fastest point moves at `size` of F / m.
  Status push_slowly(S size, PressureOptions<S> options, SmallPush<S>& push, PressureRun& run) {
    const Scene<S>& scene = assembly_.scene();
    const Scales<S>& scales = assembly_.layout().scales;
    const BreakingSettings<S> settings;
    push.sigma = size * scales.acceleration / unit_;
    options.tolerance =
        Eigen::numext::maxi(S(size * Tolerances<S>().residual), settings.finest_pads);
    assembly_.push_by(push.sigma);
    rounds_.require(options.tolerance);
    PressureSolve<S, Rounds> solve(assembly_, rounds_, work_.pressure, options,
                                   work_.friction_memory(scene));
    const Status status = solve.solve();
    const PressureRun& one = solve.run();
    run.pivots += one.pivots;
    run.sweeps += one.sweeps;
    run.rounds += one.rounds;
    run.cold_restarts += one.cold_restarts;
    run.reason = one.reason;
    run.jammed = one.jammed;
    if (status != Status::solved) return status;
    push.compliance = solve.compliance();
    read_answer(assembly_, work_.pressure.z.data, work_.answer, push.sigma);
    push.wrench = body_wrench(scene, work_.answer, pusher_);
    push.normal = normal_sum(work_.answer, pusher_);
    push.acceleration = work_.answer.acceleration;
    push.residuals = check(scene, scales, work_.answer, push.sigma);
    return status;
  }

  /// A tenth of the push moves everything a tenth as fast, but for what inertia takes: pads go on
  /// from the last answer, and round friction from its cones. False: the push has to be solved from
  /// nothing.
  bool go_on(S size, S compliance, SmallPush<S>& push, PressureRun& run) {
    if (assembly_.scene().pressure != Pressure::pad) return false;
    PressureOptions<S> options = options_;
    options.goes_on = options.keeps_cones = true;
    options.first_compliance = compliance;
    options.max_pivots = assembly_.layout().size; // from nothing takes no more
    for (LinearizedCone<S>& cone : work_.friction_memory(assembly_.scene()).round_cones)
      slow_down(cone, BreakingSettings<S>().step);
    (void)assembly_.assemble(assembly_.scene()); // it has fitted before
    return push_slowly(size, options, push, run) == Status::solved;
  }
};

/// Not inlined: a device that asks for the exact limit has no stack for pushes.
template <class S, class Rounds>
[[gnu::noinline]] Status break_by_pushes(Assembly<S>& assembly, const Rounds& rounds,
                                         Workspace<S>& work, const Body<S>& pusher,
                                         const PressureOptions<S>& options, S unit,
                                         Breaking<S>& breaking, PressureRun& run) {
  return BreakByPushes<S, Rounds>(assembly, rounds, work, pusher, options, unit)
      .find(breaking, run);
}

} // namespace detail

/// Will find_breaking ask for the limit of an infinitesimal push? Pads' compliance has to vanish
/// before the push does.
template <class Rounds, class S>
bool breaks_exactly(const Rounds& rounds, const Scene<S>& scene,
                    const PressureOptions<S>& options) {
  return rounds.carries_push() && options.exact_limit && scene.pressure != Pressure::pad &&
         !has_round_friction(scene);
}

/// The push that `pusher` (a body of the scene) needs to move the object in the grip, by one of the
/// solvers of rounds.hpp. Pre: push_size(scene) > 0. Post: solved; does_not_hold (breaking.rest is
/// the motion without a push); or the solver's failure. work.answer is left at a small push: the
/// modes at breaking.
template <class S, class Rounds>
[[nodiscard]] Status find_breaking(Assembly<S>& assembly, Rounds rounds, Workspace<S>& work,
                                   const Body<S>& pusher, const PressureOptions<S>& options,
                                   Breaking<S>& breaking, PressureRun& run) {
  const S unit = push_size(assembly.scene());
  breaking = {};
  run = {};
  if (unit > S(0)) run.reason = unsupported_reason(assembly);
  if (!(unit > S(0)) || run.reason != Reason::none) return Status::bad_input;
  Status status = Status::running;
  if (breaks_exactly(rounds, assembly.scene(), options))
    status = detail::break_exactly(assembly, rounds, work, pusher, unit, breaking, run);
  else
    status = detail::break_by_pushes(assembly, rounds, work, pusher, options, unit, breaking, run);
  if (status != Status::solved) return status;
  return judge(breaking, assembly.layout().scales, run);
}

} // namespace lcpush
