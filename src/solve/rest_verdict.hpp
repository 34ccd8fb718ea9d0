// Does the object rest before it is pushed? The one place that decides it.
#pragma once

#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

enum class Rest {
  holds,
  falls,
  not_known, ///< the load is so small beside the grip that a fall would look like rest
};

/// What the scene's own law says of the object before it is pushed.
struct RestMotion {
  Vector6<double> acceleration; ///< m/s^2, rad/s^2
  Scales<double> scales;        ///< of the assembly that was solved
  double noise;                 ///< of its motion_size: what the solver may leave of rest
};

/// Of a law that was asked at rest: it has statics in it already.
Rest decide_rest(const SceneFile& file, const RestMotion& motion);

/// motion_size of what a solver leaves of an object at rest: beside what the load would do, or,
/// where that is little beside the grip, beside what the solver leaves of the grip.
double rest_noise(const SceneFile& file, const Scales<double>& scales, Solver solver);
/// The relative error behind it.
double rest_tolerance(Solver solver);

/// The largest acceleration that the loads could give the object, m/s^2, turning at `length`.
double load_acceleration(const SceneFile& file, double length);

/// Does it rest with less friction at what sticks while it moves? Then rest is an answer, too.
bool rests_by_less_friction(const SceneFile& file);

/// Of any breaking force: an exact limit says so itself; of finite pushes statics [T.12] proves a
/// fall, and where it allows rest, the scene's own law decides, asked at rest.
bool falls_before_push(const SceneFile& file, const Breaking<double>& breaking,
                       const Scales<double>& scales, const PushOptions& options);

/// The same of a breaking force that the core has found: report.status (solved or
/// does_not_hold, with report.breaking and report.scales), or the other of the two;
/// numerical_breakdown: the breaking force is below zero, yet no fall is seen. `scene` as solved.
/// Changes report.breaking.rest to a fall that the core did not see, and a force below zero to 0.
Status holding_verdict(const SceneFile& file, BreakReport& report, const PushOptions& options);

} // namespace lcpush::desktop
