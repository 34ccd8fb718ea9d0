// [T.10] The instant of breaking: the force that just moves the object in the grip, and how it then
// moves. It is the limit of an infinitesimal push, sigma -> 0+ (docs/theory.md, "Breaking").
#pragma once

#include "lcpush/mechanics/check.hpp"
#include "lcpush/mechanics/workspace.hpp"

namespace lcpush {

/// "Unit push" stands for the prescribed motion scaled so that the fastest point of contact with a
/// moving body accelerates at 1 m/s^2. Wrenches at the centre of mass, scene axes, on the object.
template <class S> struct Breaking {
  Vector6<S> rest = Vector6<S>::Zero(); ///< object's acceleration before the push, pusher in place,
                                        ///< [m/s^2; rad/s^2]
  Vector6<S> force =
      Vector6<S>::Zero(); ///< the pusher's wrench at the instant of breaking, [N; N m]
  Vector6<S> inertia = Vector6<S>::Zero(); ///< what a unit push adds to it, [N; N m] per m/s^2
  Vector6<S> twist =
      Vector6<S>::Zero(); ///< object's acceleration per unit push, [m/s^2; rad/s^2] per m/s^2
  S break_force{0};       ///< N, its normal forces summed over the pusher's points
  S inertia_normal{0};    ///< N per m/s^2, the same sum of what a unit push adds
  S valid_to{-1};         ///< m/s^2, the largest push for which this holds exactly; -1: not known
  S line_error{0};        ///< `pad`: how far a third push lies off the line through two, over F
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

/// The scene without its environment: the fingers, and the actuators that drive one.
/// Pre: fingers come before pushers, their actuators before the pushers' (as files are read).
template <class S> Scene<S> without_pushers(const Scene<S>& scene) {
  Scene<S> alone = scene;
  while (alone.bodies.size > 0 && alone.bodies[alone.bodies.size - 1].role == Role::pusher)
    --alone.bodies.size;
  alone.points.size = 0;
  for (const Body<S>& body : alone.bodies) alone.points.size += body.point_count;
  alone.drives.size = alone.actuators.size = 0;
  for (const Drive<S>& drive : scene.drives) {
    if (drive.body >= alone.bodies.size) break;
    ++alone.drives.size;
    alone.actuators.size = Eigen::numext::maxi(alone.actuators.size, drive.actuator + 1);
  }
  return alone;
}

/// |a| in units of F / m, rotations at the distance L.
template <class S> S motion_size(const Vector6<S>& acceleration, const Scales<S>& scales) {
  const S linear = acceleration.template head<3>().norm();
  const S angular = scales.length * acceleration.template tail<3>().norm();
  return Eigen::numext::maxi(linear, angular) / scales.acceleration;
}

/// Below this (in units of F / m) an acceleration counts as none.
template <class S> constexpr S at_rest() { return S(1024) * Tolerances<S>().residual; }

namespace detail {

template <class S> S normal_sum(const Answer<S>& answer, const Body<S>& body) {
  S sum(0);
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
    sum += answer.contacts[i].normal_force;
  return sum;
}

/// `rigid`: the push is one more right-hand side, so the limit is exact.
template <class S>
Status break_rigid(Assembly<S>& assembly, Lemke<S>& lemke, Workspace<S>& work, Index pusher,
                   const PressureOptions<S>& options, S unit, Breaking<S>& breaking,
                   PressureRun& run) {
  const Scene<S>& scene = assembly.scene();
  const Body<S>& body = scene.bodies[pusher];
  Status status = lemke.init(assembly.breaking_problem(), options.lemke);
  if (status == Status::running) status = lemke.solve();
  run.pivots += lemke.pivots();
  run.reason = lemke.reason();
  if (status != Status::solved) return status;
  read_answer(assembly, lemke.z_push(), work.answer, S(1), false);
  breaking.inertia = body_wrench(scene, work.answer, pusher) / unit;
  breaking.inertia_normal = normal_sum(work.answer, body) / unit;
  breaking.twist = work.answer.acceleration / unit;
  breaking.valid_to = lemke.valid_to() < S(0) ? S(-1) : S(lemke.valid_to() * unit);
  read_answer(assembly, lemke.z(), work.answer, S(0));
  breaking.rest = work.answer.acceleration;
  breaking.force = body_wrench(scene, work.answer, pusher);
  breaking.break_force = normal_sum(work.answer, body);
  breaking.residuals = check(scene, assembly.layout().scales, work.answer, S(0));

  // The same answer a little later, to be checked while it moves.
  S sigma = S(1e-4) * assembly.layout().scales.acceleration / unit;
  if (lemke.valid_to() >= S(0) && lemke.valid_to() < sigma) sigma = lemke.valid_to();
  for (Index i = 0; i < assembly.layout().size; ++i)
    work.pressure.z[i] = lemke.z()[i] + sigma * lemke.z_push()[i];
  read_answer(assembly, work.pressure.z.data, work.answer, sigma);
  const Residuals<S> moving = check(scene, assembly.layout().scales, work.answer, sigma);
  if (!(moving.max() <= breaking.residuals.max())) breaking.residuals = moving;
  return status;
}

/// `pad`: compliance has to vanish before the push does, so finite small pushes are extrapolated.
template <class S>
Status break_pad(Assembly<S>& assembly, Lemke<S>& lemke, Workspace<S>& work, Index pusher,
                 PressureOptions<S> options, S unit, Breaking<S>& breaking, PressureRun& run) {
  const Scene<S>& scene = assembly.scene();
  const Scales<S>& scales = assembly.layout().scales;
  constexpr int pushes = 3;
  S sigma[pushes], normal[pushes];
  Vector6<S> wrench[pushes], acceleration[pushes];
  for (int k = 0; k < pushes; ++k) {
    const S size = k == 0 ? S(1e-3) : k == 1 ? S(1e-4) : S(1e-5); // of F / m
    sigma[k] = size * scales.acceleration / unit;
    options.tolerance = Eigen::numext::maxi(S(size * Tolerances<S>().residual),
                                            S(512 * Eigen::NumTraits<S>::epsilon()));
    assembly.push_by(sigma[k]);
    PressureRun one;
    const Status status = solve_pressure(assembly, lemke, work.pressure, options, one);
    run.pivots += one.pivots;
    run.rounds += one.rounds;
    run.cold_restarts += one.cold_restarts;
    run.reason = one.reason;
    run.jammed = one.jammed;
    if (status != Status::solved) return status;
    read_answer(assembly, work.pressure.z.data, work.answer, sigma[k]);
    wrench[k] = body_wrench(scene, work.answer, pusher);
    normal[k] = normal_sum(work.answer, scene.bodies[pusher]);
    acceleration[k] = work.answer.acceleration;
    if (k == 1) breaking.residuals = check(scene, scales, work.answer, sigma[k]);
  }
  // What is left of the acceleration when the push is taken back along the line: zero if it holds.
  breaking.rest =
      acceleration[2] - (acceleration[1] - acceleration[2]) * (sigma[2] / (sigma[1] - sigma[2]));
  breaking.twist = acceleration[1] / (sigma[1] * unit);
  const S span = sigma[0] - sigma[1];
  breaking.inertia = (wrench[0] - wrench[1]) / (span * unit);
  breaking.inertia_normal = (normal[0] - normal[1]) / (span * unit);
  breaking.force = wrench[1] - sigma[1] * unit * breaking.inertia;
  breaking.break_force = normal[1] - sigma[1] * unit * breaking.inertia_normal;
  const S predicted = breaking.break_force + sigma[2] * unit * breaking.inertia_normal;
  using std::abs;
  breaking.line_error = abs(predicted - normal[2]) / scales.force;
  return Status::solved;
}

} // namespace detail

/// The push that `pusher` (a body of assembly.scene()) needs to move the object in the grip.
/// Pre: push_size(scene) > 0. Post: solved; does_not_hold (breaking.rest is the motion without a
/// push); or the solver's failure. work.answer is left at a small push: the modes at breaking.
template <class S>
[[nodiscard]] Status find_breaking(Assembly<S>& assembly, Lemke<S>& lemke, Workspace<S>& work,
                                   Index pusher, const PressureOptions<S>& options,
                                   Breaking<S>& breaking, PressureRun& run) {
  const S unit = push_size(assembly.scene());
  breaking = {};
  run = {};
  if (!(unit > S(0))) return Status::bad_input;
  const Status status =
      assembly.scene().pressure == Pressure::pad
          ? detail::break_pad(assembly, lemke, work, pusher, options, unit, breaking, run)
          : detail::break_rigid(assembly, lemke, work, pusher, options, unit, breaking, run);
  const bool moves = motion_size(breaking.rest, assembly.layout().scales) > at_rest<S>();
  return status == Status::solved && moves ? Status::does_not_hold : status;
}

} // namespace lcpush
