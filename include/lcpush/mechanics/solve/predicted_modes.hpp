// The modes that one expects before anything is solved, as a first basis for Lemke's pivots: the
// object moves with its pusher and slides through the fingers.
#pragma once

#include "lcpush/mechanics/model/assemble.hpp"
#include "lcpush/mechanics/solve/rounds.hpp"

namespace lcpush {

namespace detail {

constexpr Index greatest_common_divisor(Index a, Index b) {
  return b == 0 ? a : greatest_common_divisor(b, a % b);
}

/// Of the points that are expected to press, those stay whose normals hold the object and the
/// actuators independently of each other: more could not be basic together. Points far apart come
/// first: a golden section of the body's list is between one and the next.
template <class S>
void keep_independent_normals(const Assembly<S>& assembly, Span<unsigned char> active) {
  constexpr Index most = 12; // 6 accelerations and the actuators of any hand that is usual
  const FactoredProblem<S>& factored = assembly.factored();
  const Scene<S>& scene = assembly.scene();
  if (6 + factored.sums.size > most) return;
  Eigen::Matrix<S, most, most> kept;
  Index rank = 0;
  for (const Body<S>& body : scene.bodies) {
    Index stride = 1 + 382 * body.point_count / 1000;
    while (stride > 1 && greatest_common_divisor(stride, body.point_count) > 1) --stride;
    for (Index k = 0; k < body.point_count; ++k) {
      const Index point = body.first_point + k * stride % body.point_count;
      const ConeGroup<S>& cone = factored.cones[point];
      if (active[cone.variable] == 0) continue;
      Eigen::Matrix<S, most, 1> row = Eigen::Matrix<S, most, 1>::Zero();
      row.template head<6>() = factored.wrenches[cone.force];
      for (const Drive<S>& drive : scene.drives)
        if (&scene.bodies[drive.body] == &body)
          row[6 + drive.actuator] -= laws::grip_coefficient(drive, factored.wrenches[cone.force],
                                                            assembly.layout().reach[drive.actuator],
                                                            assembly.layout().scales);
      const S size = row.norm();
      for (Index l = 0; l < rank; ++l) row -= kept.col(l).dot(row) * kept.col(l);
      const S rest = row.norm();
      if (rank < most && rest > size / S(1000))
        kept.col(rank++) = row / rest;
      else
        active[cone.variable] = 0;
    }
  }
}

} // namespace detail

/// active[i] = 1 where z_i is expected to be positive (n flags), if the object accelerates as its
/// leading pusher does: the points of force-controlled bodies and of pushers press; where the
/// former slip, the generator most opposed to the slip carries friction. The pushers' own friction
/// is left to the pivots, closings are always basic. A guess: pivots from there end at an answer or
/// say that they did not. Pre: `assembly` is of `scene`, pushed. Cost: O(forces).
template <class S> void predict_modes(const Assembly<S>& assembly, Span<unsigned char> active) {
  const Scene<S>& scene = assembly.scene();
  const Problem<S> problem = assembly.problem();
  const FactoredProblem<S>& factored = *problem.factored;
  for (Index i = 0; i < problem.size; ++i) active[i] = i >= problem.free_begin ? 1 : 0;
  const Body<S>* leader = nullptr; // the first pusher that moves
  for (const Body<S>& body : scene.bodies)
    if (leader == nullptr && body.role == Role::pusher && !body.acceleration.isZero(S(0)))
      leader = &body;
  if (leader == nullptr) return;
  // q holds W(u)'(free fall - A_b) of every force.
  const Scales<S>& scales = assembly.layout().scales;
  const Vector6<S> falls = factored.mobility.lazyProduct(laws::load(scene, scales));
  const Vector6<S> follows = laws::prescribed(*leader, scales) * assembly.sigma();
  const Vector6<S> by_forces = follows - falls;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    const bool driven = is_driven(scene, b);
    if (!driven && body.role != Role::pusher) continue;
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const ConeGroup<S>& cone = factored.cones[i];
      active[cone.variable] = 1;
      S slip(0);
      Index against = -1;
      for (Index k = cone.normals; driven && k < cone.forces(); ++k) {
        const S rate =
            factored.wrenches[cone.force + k].dot(by_forces) + problem.q[cone.variable + k];
        if (!(rate < slip)) continue;
        slip = rate;
        against = cone.variable + k;
      }
      if (against >= 0) active[against] = active[cone.slip()] = 1;
    }
  }
  if (scene.pressure == Pressure::rigid) detail::keep_independent_normals(assembly, active);
}

/// The predicted modes as a first basis. One that leads astray shall cost no more than a cold one.
template <class S> struct PredictedStart {
  const Assembly<S>& assembly; ///< of the problems that the rounds solve

  PredictedStart(const Assembly<S>& of) : assembly(of) {}

  bool propose(const Problem<S>& problem, const PressureMemory<S>& memory, PressureRun&,
               FirstBasis& first) {
    predict_modes(assembly, memory.active);
    first = {Guess::near, 2, problem.size / 2 + 16};
    return true;
  }
  void begins_cold() {}
};
template <class S, class Watcher = const Unwatched, class Pivots = Lemke<S>>
using PredictedRounds = StartedRounds<S, PredictedStart<S>, Watcher, Pivots>;

} // namespace lcpush
