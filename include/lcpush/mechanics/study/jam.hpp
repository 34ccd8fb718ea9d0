// A jam: what a secondary ray means. Its forces squeeze the object and nothing relieves them
// (docs/theory/theory.md, "Rays and jams").
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {

/// One body's part in a ray. Forces have no unit of their own: a ray may be scaled.
template <class S> struct Squeeze {
  Vector6<S> wrench = Vector6<S>::Zero(); ///< on the object, force; moment over Scales::length
  S normal{0};                            ///< sum of its normal forces' sizes; 0: takes no part
  S friction{0};                          ///< sum of its friction forces' sizes
  S power{0};             ///< of its prescribed motion, in units of F / m: > 0 tightens
  bool runs_away = false; ///< an actuator closes it without end
};

/// A ray as a whole: what decides whether it proves that there is no answer.
template <class S> struct RaySum {
  S noise{0};     ///< what rounding may leave of a force: a fraction of the ray's largest entry
  S friction{0};  ///< sum of the friction forces' sizes
  S imbalance{0}; ///< the largest part of the forces' wrench that the object could follow
  S load{0};      ///< the largest size of an actuator's load Q_a
  S power{0};     ///< P, of all prescribed motions
  S motion{0};    ///< the largest prescribed motion, in units of F / m

  /// A balanced squeeze by normal forces alone, that no actuator feels and that motions tighten.
  bool proves_no_answer() const {
    return friction <= noise && imbalance <= noise && load <= noise && power > noise * motion;
  }
};

/// The largest |Q_a| of the forces in v. Cost: O(couplings).
template <class S> S actuator_load(const FactoredProblem<S>& problem, const S* v) {
  using std::abs;
  S largest(0);
  for (const SumGroup<S>& sum : problem.sums) {
    S load(0);
    for (Index k = sum.first; k < sum.first + sum.count; ++k)
      load += problem.coupling[k] * v[problem.coupled_variable[k]];
    largest = Eigen::numext::maxi(largest, S(abs(load)));
  }
  return largest;
}

/// Reads a ray v of assembly.problem() body by body; entries that rounding may have left count as
/// 0. `bodies` has one entry for each body of the scene. Cost: O(forces + couplings).
template <class S>
RaySum<S> read_ray(const Assembly<S>& assembly, const S* v, Span<Squeeze<S>> bodies) {
  using std::abs;
  const Scene<S>& scene = assembly.scene();
  const Layout<S>& layout = assembly.layout();
  RaySum<S> sum;
  // Forces, slips and actuators all count: a ray of an actuator alone leaves traces at contacts
  // that are large beside each other only.
  for (Index i = 0; i < layout.size; ++i) sum.noise = Eigen::numext::maxi(sum.noise, v[i]);
  sum.noise *= Tolerances<S>().residual;
  for (Squeeze<S>& body : bodies) body = {};
  for (Index i = 0; i < layout.points; ++i) {
    const ConeGroup<S>& cone = layout.cones[i];
    Squeeze<S>& body = bodies[layout.body[i]];
    for (Index k = 0; k < cone.forces(); ++k) {
      const S force = v[cone.variable + k];
      if (!(force > sum.noise)) continue;
      body.wrench += force * assembly.factored().wrenches[cone.force + k];
      (k < cone.normals ? body.normal : body.friction) += force;
    }
  }
  Vector6<S> wrench = Vector6<S>::Zero();
  for (Index b = 0; b < bodies.size; ++b) {
    const Vector6<S> motion = laws::prescribed(scene.bodies[b], layout.scales);
    bodies[b].power = bodies[b].wrench.dot(motion);
    wrench += bodies[b].wrench;
    sum.friction += bodies[b].friction;
    sum.power += bodies[b].power;
    sum.motion = Eigen::numext::maxi(sum.motion, S(motion.norm()));
  }
  for (Index k = 0; k < 6; ++k) // in a planar scene the plane takes the rest
    if (assembly.factored().mobility(k, k) > S(0))
      sum.imbalance = Eigen::numext::maxi(sum.imbalance, S(abs(wrench[k])));
  sum.load = actuator_load(assembly.factored(), v);
  for (const Drive<S>& drive : scene.drives)
    if (v[layout.closing_index(drive.actuator)] > sum.noise) bodies[drive.body].runs_away = true;
  return sum;
}

} // namespace lcpush
