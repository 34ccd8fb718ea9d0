// From the unknowns of the complementarity problem to an answer in SI units.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/answer.hpp"
#include "lcpush/mechanics/assemble.hpp"

namespace lcpush {

/// Stick, slide or separate, by what is large: `tolerance` is relative to the scene's units.
template <class S>
Mode contact_mode(const ContactAnswer<S>& contact, const Vector3<S>& normal,
                  const Scales<S>& scales, S acceleration_unit, S tolerance) {
  const S opening = contact.acceleration.dot(normal);
  const Vector3<S> tangential = contact.acceleration - opening * normal;
  const bool pressed = contact.normal_force > tolerance * scales.force;
  if (!pressed && opening > tolerance * acceleration_unit) return Mode::separate;
  return tangential.norm() > tolerance * acceleration_unit ? Mode::slide : Mode::stick;
}

/// Fills `answer` (spans of the lengths its fields say) from a solution z of assembly.problem().
/// `with_weight` false reads z as a derivative by sigma instead: the weight drops out.
template <class S>
void read_answer(const Assembly<S>& assembly, const S* z, Answer<S>& answer, S sigma,
                 bool with_weight = true) {
  const Scene<S>& scene = assembly.scene();
  const Layout<S>& layout = assembly.layout();
  const Scales<S>& scales = layout.scales;
  const FactoredProblem<S>& factored = assembly.factored();

  Vector6<S> wrench = contact_wrench(factored, z);
  if (with_weight) wrench += laws::weight(scene, scales);
  answer.acceleration = factored.mobility.lazyProduct(wrench) * scales.acceleration;
  answer.acceleration.template tail<3>() /= scales.length;
  for (Index a = 0; a < layout.actuators; ++a)
    answer.closing[a] = z[layout.closing(a)] * scales.acceleration / layout.reach[a];

  S fastest(0);
  Index entry = 0;
  for (Index i = 0; i < layout.points; ++i) {
    const Index b = layout.body[i], g = layout.cones[i].generators;
    ContactAnswer<S>& contact = answer.contacts[i];
    contact = {b,
               z[layout.normal(i)] * scales.force,
               Vector3<S>::Zero(),
               S(0),
               S(0),
               acceleration_at<S>(scene.points[i],
                                  answer.acceleration - body_twist(scene, answer, b, sigma)),
               Mode::stick};
    for (Index j = 0; j < g; ++j) {
      const S beta = z[layout.friction(i, j)] * scales.force;
      answer.friction[entry++] = beta;
      contact.friction_force += beta * generator(scene.bodies[b], j, g);
    }
    if (g > 0) contact.slip = z[layout.slip(i)] * scales.acceleration;
    if (contact.acceleration.norm() > fastest) fastest = contact.acceleration.norm();
  }
  // Motion counts against the fastest point: a slow push moves everything slowly. Below what
  // rounding leaves of the loads there is no motion at all.
  const S tolerance = S(1000) * Tolerances<S>().tie;
  const S rounding = S(64) * Eigen::NumTraits<S>::epsilon() * scales.acceleration / tolerance;
  const S unit = fastest > rounding ? fastest : rounding;
  for (Index i = 0; i < layout.points; ++i) {
    ContactAnswer<S>& contact = answer.contacts[i];
    contact.mode =
        contact_mode<S>(contact, scene.bodies[contact.body].normal, scales, unit, tolerance);
  }
}

} // namespace lcpush
