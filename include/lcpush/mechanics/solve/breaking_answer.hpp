// [T.10] What is told of the instant of breaking, and the verdict on it.
#pragma once

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

/// A pusher that only presses cannot pull. Where finite pushes taken back to none say that it does,
/// by more than they leave open, the contacts change between none and the smallest of them: most
/// often to a fall.
template <class S> bool pulls(const Breaking<S>& breaking, const Scales<S>& scales) {
  const S open =
      Tolerances<S>().settled + S(10) * breaking.line_error + S(16) * breaking.residuals.max();
  return breaking.break_force < -open * scales.force;
}

/// The verdict on what was read from solved pushes by `pusher`; sets breaking.breaks.
template <class S>
Status judge(Breaking<S>& breaking, const Body<S>& pusher, const Scales<S>& scales,
             PressureRun& run) {
  if (!(breaking.residuals.max() <= Tolerances<S>().residual)) {
    run.reason = Reason::residual;
    return Status::numerical_breakdown;
  }
  breaking.breaks = moves_object(breaking, scales);
  if (motion_size(breaking.rest, scales) > at_rest<S>()) return Status::does_not_hold;
  if (pusher.bilateral || !pulls(breaking, scales)) return Status::solved;
  run.reason = Reason::pull;
  return Status::numerical_breakdown;
}

} // namespace lcpush
