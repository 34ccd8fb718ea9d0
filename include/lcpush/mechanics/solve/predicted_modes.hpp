// The modes that one expects before anything is solved, as a first basis for Lemke's pivots: the
// object moves with its pusher and slides through the fingers.
#pragma once

#include "lcpush/mechanics/model/assemble.hpp"
#include "lcpush/mechanics/solve/expected_forces.hpp"
#include "lcpush/mechanics/solve/first_basis.hpp"

namespace lcpush {

namespace detail {

constexpr Index greatest_common_divisor(Index a, Index b) {
  return b == 0 ? a : greatest_common_divisor(b, a % b);
}

/// visit(body, point), a body's points such that neighbours in turn lie far apart: a golden section
/// of its list is between one and the next.
template <class S, class Visit> void for_each_point(const Scene<S>& scene, const Visit& visit) {
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    Index stride = 1 + 382 * body.point_count / 1000;
    while (stride > 1 && greatest_common_divisor(stride, body.point_count) > 1) --stride;
    for (Index k = 0; k < body.point_count; ++k)
      visit(b, body.first_point + k * stride % body.point_count);
  }
}

/// Only points whose normals are independent press; and where nothing slips, as many points stick.
template <class S>
void keep_independent(const Assembly<S>& assembly, bool sticks, Span<unsigned char> active) {
  const FactoredProblem<S>& factored = assembly.factored();
  const bool rigid = assembly.scene().pressure == Pressure::rigid;
  IndependentForces<S> forces(assembly);
  if (!forces.fits() || !(rigid || sticks)) return;
  const auto keep = [&](bool of_friction) {
    for_each_point(assembly.scene(), [&](Index b, Index i) {
      const ConeGroup<S>& cone = factored.cones[i];
      const Index first = of_friction ? cone.normals : 0, end = of_friction ? cone.forces() : 1;
      for (Index k = first; k < end; ++k) {
        unsigned char& is_active = active[cone.variable + k];
        if (is_active != 0 && !forces.take(b, cone.force + k) && (rigid || of_friction))
          is_active = 0;
      }
    });
  };
  keep(false);
  if (sticks) keep(true);
}

/// What the object is expected to do.
template <class S> struct ExpectedMotion {
  bool rests;
  Vector6<S> by_forces; ///< what the forces add to its fall
};

/// Who presses, and who slides which way; of every point by itself.
template <class S>
ExpectedMotion<S> predict_slides(const Assembly<S>& assembly, Span<unsigned char> active) {
  const Scene<S>& scene = assembly.scene();
  const Problem<S> problem = assembly.problem();
  const FactoredProblem<S>& factored = *problem.factored;
  for (Index i = 0; i < problem.size; ++i) active[i] = i >= problem.free_begin ? 1 : 0;
  const Body<S>* leader = nullptr; // the first pusher that moves
  for (const Body<S>& body : scene.bodies)
    if (leader == nullptr && body.role == Role::pusher && !body.acceleration.isZero(S(0)))
      leader = &body;
  const bool rests = leader == nullptr || !(assembly.sigma() > S(0));
  // q holds W(u)'(free fall - A_b) of every force.
  const Scales<S>& scales = assembly.layout().scales;
  Vector6<S> by_forces = Vector6<S>::Zero();
  if (!rests) {
    const Vector6<S> falls = factored.mobility.lazyProduct(laws::load(scene, scales));
    by_forces = laws::prescribed(*leader, scales) * assembly.sigma() - falls;
  }
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
      if (against < 0) continue;
      active[against] = 1;
      if (!rests) active[cone.slip()] = 1;
    }
  }
  return {rests, by_forces};
}

} // namespace detail

/// active[i] = 1 where z_i is expected to be positive (n flags), if the object accelerates as its
/// leading pusher does: the points of force-controlled bodies and of pushers press; where the
/// former slip, the generator most opposed to the slip carries friction. The pushers' own friction
/// is left to the pivots, closings are always basic. Where nothing pushes, the object is expected
/// to rest: friction is most opposed to its fall, and no point slips. A guess: pivots from there
/// end at an answer or say that they did not. Pre: `assembly` is of `scene`, pushed. Cost:
/// O(forces).
template <class S>
void predict_modes(const Assembly<S>& assembly, Span<unsigned char> active,
                   const S* preload = nullptr) {
  const detail::ExpectedMotion<S> expected = detail::predict_slides(assembly, active);
  // With fewer unknowns the pivots that this saves cost less than it does.
  constexpr Index worth_expecting = 40;
  if (!expected.rests && assembly.layout().size >= worth_expecting &&
      detail::ExpectedForces<S>(assembly, expected.by_forces, preload, active).find())
    return;
  detail::keep_independent(assembly, expected.rests, active);
}

/// The same without a look at which forces give that motion: some more pivots, and 2 KB of stack
/// where predict_modes takes 7 (float).
template <class S>
void predict_modes_in_little_stack(const Assembly<S>& assembly, Span<unsigned char> active) {
  const detail::ExpectedMotion<S> expected = detail::predict_slides(assembly, active);
  detail::keep_independent(assembly, expected.rests, active);
}

/// The predicted modes as a first basis. One that leads astray shall cost no more than a cold one.
template <class S> struct PredictedStart {
  static constexpr bool knows_limit = true;
  const Assembly<S>& assembly; ///< of the problems that the rounds solve
  bool is_cold;                ///< nothing is predicted

  PredictedStart(const Assembly<S>& of, bool begins_cold = false)
      : assembly(of), is_cold(begins_cold) {}

  bool propose(const Problem<S>&, const PressureMemory<S>& memory, PressureRun&,
               FirstBasis& first) {
    if (is_cold) return false;
    predict_modes(assembly, memory.active, memory.preload.data);
    first = {Guess::near, 2, assembly.layout().size / 2 + 16};
    return true;
  }
  void begins_cold() {}
};
template <class S, class Watcher = const Unwatched, class Pivots = Lemke<S>>
using PredictedRounds = StartedRounds<S, PredictedStart<S>, Watcher, Pivots>;

} // namespace lcpush
