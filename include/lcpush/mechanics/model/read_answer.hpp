// From the unknowns of the complementarity problem to an answer in SI units.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {

/// What is larger than these counts: a force in N, a motion in m/s^2.
template <class S> struct ContactMargins {
  S force, motion;

  bool presses(const ContactAnswer<S>& contact) const {
    return Eigen::numext::abs(contact.normal_force) > force;
  }
  bool opens(const ContactAnswer<S>& contact, const Body<S>& body) const {
    return contact.acceleration.dot(body.normal) > motion;
  }
  /// A soft point that spins slides.
  bool slides(const ContactAnswer<S>& contact, const Body<S>& body) const {
    const S opening = contact.acceleration.dot(body.normal);
    const Vector3<S> tangential = contact.acceleration - opening * body.normal;
    return tangential.norm() + body.torsion_radius * Eigen::numext::abs(contact.spin) > motion;
  }
  Mode mode(const ContactAnswer<S>& contact, const Body<S>& body, bool apart = false) const {
    if (!presses(contact) && (apart || opens(contact, body))) return Mode::separate;
    return slides(contact, body) ? Mode::slide : Mode::stick;
  }
};

/// Fills `answer` (spans of the lengths its fields say) from a solution z of assembly.problem().
/// `with_load` false reads z as a derivative by sigma instead: the load drops out.
template <class S>
void read_answer(const Assembly<S>& assembly, const S* z, Answer<S>& answer, S sigma,
                 bool with_load = true) {
  const Scene<S>& scene = assembly.scene();
  const Layout<S>& layout = assembly.layout();
  const Scales<S>& scales = layout.scales;
  const FactoredProblem<S>& factored = assembly.factored();

  Vector6<S> wrench = contact_wrench(factored, z);
  if (with_load) wrench += assembly.load();
  answer.acceleration = factored.mobility.lazyProduct(wrench);
  answer.acceleration *= scales.acceleration;
  answer.acceleration.template tail<3>() /= scales.length;
  for (Index a = 0; a < layout.actuators; ++a)
    answer.closing[a] = z[layout.closing_index(a)] * scales.acceleration / layout.reach[a];

  S fastest(0), own = size_of_twist(answer.acceleration, scales.length);
  Index entry = 0;
  for (Index i = 0; i < layout.points; ++i) {
    const Index b = layout.body[i], g = layout.cones[i].generators;
    const Body<S>& body = scene.bodies[b];
    const Vector6<S> twist = body_twist(scene, answer, b, sigma);
    const Vector6<S> relative = answer.acceleration - twist;
    own = Eigen::numext::maxi(own, size_of_twist(twist, scales.length));
    ContactAnswer<S>& contact = answer.contacts[i];
    contact.friction_force.setZero();
    contact.torsion = contact.slip = S(0);
    contact.body = b;
    contact.normal_force = layout.cones[i].normal_force(z) * scales.force;
    contact.acceleration = acceleration_at(scene.points[i], relative);
    contact.spin = relative.template tail<3>().dot(body.normal);
    contact.closing_acceleration =
        acceleration_at<S>(scene.points[i], twist - sigma * body.acceleration).dot(body.normal);
    for (Index j = 0; j < g; ++j) {
      const S beta = z[layout.friction_index(i, j)] * scales.force;
      answer.friction[entry++] = beta;
      if (beta == S(0)) continue; // most are, and directions cost time
      const Generator<S> d = generator(scene, body, i, j);
      for (Index k = 0; k < 3; ++k) contact.friction_force[k] += beta * d.force[k];
      contact.torsion += beta * d.torque;
    }
    if (has_round_friction(scene)) {
      const Generator<S> turning =
          generator_along(body, laws::resisting_force(body, scene.points[i], scene.round_cones[i],
                                                      answer.acceleration));
      contact.friction_force += turning.force;
      contact.torsion += turning.torque;
    }
    if (g > 0) contact.slip = z[layout.slip_index(i)] * scales.acceleration;
    fastest = Eigen::numext::maxi(fastest, S(contact.acceleration.norm()));
  }
  // Motion counts against the fastest point: a slow push moves everything slowly. Below what
  // rounding leaves of the loads, or of the twists whose difference it is, there is none at all.
  const S tolerance = ModelSettings<S>::counts();
  const bool is_step = scene.clearances.size > 0;
  const S noise = is_step ? ModelSettings<S>::step_noise() : ModelSettings<S>::motion_noise();
  const S rounding = noise * (scales.acceleration + own) / tolerance;
  const S unit = Eigen::numext::maxi(fastest, rounding);
  const ContactMargins<S> margins{S(tolerance * scales.force), S(tolerance * unit)};
  for (Index i = 0; i < layout.points; ++i) {
    ContactAnswer<S>& contact = answer.contacts[i];
    const Body<S>& body = scene.bodies[contact.body];
    const S opening = contact.acceleration.dot(body.normal) + clearance_of(scene, i);
    contact.mode = margins.mode(contact, body, opening > margins.motion);
  }
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template void read_answer<double>(const Assembly<double>&, const double*, Answer<double>&,
                                         double, bool);
#endif

} // namespace lcpush
