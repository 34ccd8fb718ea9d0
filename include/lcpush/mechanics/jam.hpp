// A jam: what a secondary ray means. Its forces squeeze the object and nothing gives way
// (docs/theory.md, "Rays and jams").
#pragma once

#include "lcpush/mechanics/assemble.hpp"

namespace lcpush {

/// One body's part in a ray. Forces have no unit of their own: a ray may be scaled.
template <class S> struct Squeeze {
  Vector6<S> wrench;      ///< on the object, force; moment over Scales::length
  S normal{0};            ///< sum of its normal forces' sizes; 0: takes no part
  S friction{0};          ///< sum of its friction forces' sizes
  S power{0};             ///< of its prescribed motion, in units of F / m: > 0 tightens
  bool runs_away = false; ///< an actuator closes it without end
};

/// Reads a ray v of assembly.problem() body by body. `bodies` has one entry for each body of the
/// scene. Cost: O(forces + drives).
template <class S> void read_ray(const Assembly<S>& assembly, const S* v, Span<Squeeze<S>> bodies) {
  const Scene<S>& scene = assembly.scene();
  const Layout<S>& layout = assembly.layout();
  for (Squeeze<S>& body : bodies) {
    body = {};
    body.wrench.setZero();
  }
  for (Index i = 0; i < layout.points; ++i) {
    const ConeGroup<S>& cone = layout.cones[i];
    Squeeze<S>& body = bodies[layout.body[i]];
    for (Index k = 0; k < cone.forces(); ++k) {
      const S force = v[cone.variable + k];
      body.wrench += force * assembly.factored().wrenches[cone.force + k];
      (k < cone.normals ? body.normal : body.friction) += force;
    }
  }
  for (Index b = 0; b < bodies.size; ++b)
    bodies[b].power = bodies[b].wrench.dot(laws::prescribed(scene.bodies[b], layout.scales));
  for (const Drive<S>& drive : scene.drives)
    if (v[layout.closing(drive.actuator)] > S(0)) bodies[drive.body].runs_away = true;
}

} // namespace lcpush
