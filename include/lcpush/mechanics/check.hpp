// The referee of mechanics/: does an answer obey the paper's laws? Works on the scene and the
// answer in SI units alone: no matrix, no scaled unknowns, nothing of the solvers or the assembly
// (laws.hpp lends it [T.6], contact.hpp the geometry of a point).
#pragma once

#include "lcpush/mechanics/answer.hpp"
#include "lcpush/mechanics/laws.hpp"

namespace lcpush {

namespace detail {
// A NaN is the worst of all: it stays, and it wins over every number.
template <class S> void keep_worst(S& worst, S violation) {
  if (violation < S(0)) violation = -violation;
  if (!(violation <= worst) && worst == worst) worst = violation;
}
template <class S> S smaller(const S& x, const S& y) { return x < y || !(x == x) ? x : y; }
template <class S> S magnitude(const S& x) { return x < S(0) ? S(-x) : x; }
} // namespace detail

/// The largest scaled violation of each law. Forces are measured by F, accelerations by F / m,
/// moments by F L (Scales).
template <class S> struct Residuals {
  S newton{0};      ///< [T.1]
  S normal{0};      ///< [T.2]
  S dissipation{0}; ///< [T.3]
  S cone{0};        ///< [T.4]
  S grip{0};        ///< [T.5]
  S rigidity{0};    ///< [T.6]
  S pusher{0};      ///< pushers in contact move as prescribed: |normal acceleration| where pressed

  S max() const {
    S worst = newton;
    for (const S& r : {normal, dissipation, cone, grip, rigidity, pusher})
      detail::keep_worst(worst, r);
    return worst;
  }
};

/// `sigma` scales the prescribed motions, as it did for the solve. Cost: O(forces + drives points).
template <class S>
Residuals<S> check(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer,
                   S sigma) {
  using detail::keep_worst;
  using detail::smaller;
  Residuals<S> worst;

  Vector3<S> force = scene.object.mass * scene.gravity;
  Vector3<S> moment = Vector3<S>::Zero();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Vector6<S> wrench = body_wrench(scene, answer, scene.bodies[b]);
    force += wrench.template head<3>();
    moment += wrench.template tail<3>();
  }
  force -= scene.object.mass * answer.acceleration.template head<3>();
  moment -= scene.object.inertia.lazyProduct(answer.acceleration.template tail<3>());
  for (Index k = 0; k < 3; ++k) {
    const bool counts_force = !scene.planar || k < 2, counts_moment = !scene.planar || k == 2;
    if (counts_force) keep_worst(worst.newton, S(force[k] / scales.force));
    if (counts_moment) keep_worst(worst.newton, S(moment[k] / (scales.force * scales.length)));
  }

  Index entry = 0;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    const Vector6<S> relative = answer.acceleration - body_twist(scene, answer, b, sigma);
    const Index g = generator_count(scene, body);
    const Index end = body.first_point + body.point_count;
    for (Index i = body.first_point; i < end; ++i) {
      const ContactAnswer<S>& contact = answer.contacts[i];
      const Vector3<S> acceleration =
          acceleration_at<S>(scene.points[i], relative) / scales.acceleration;
      const S lambda = contact.normal_force / scales.force, xi = contact.slip / scales.acceleration;
      const S opening = acceleration.dot(body.normal);
      const S spin = relative.template tail<3>().dot(body.normal) / scales.acceleration;
      const S normal_violation = body.bilateral ? opening : smaller(lambda, opening);
      keep_worst(worst.normal, normal_violation);
      if (body.role == Role::pusher && (body.bilateral || lambda > S(0)))
        keep_worst(worst.pusher, normal_violation);
      S room = body.friction * (body.bilateral ? detail::magnitude(lambda) : lambda);
      Vector3<S> friction = contact.friction_force / scales.force;
      S torsion = contact.torsion / scales.force;
      for (Index j = 0; j < g; ++j) {
        const Generator<S> d = generator(body, j, scene.facets);
        const S beta = answer.friction[entry++] / scales.force;
        keep_worst(worst.dissipation,
                   smaller(beta, S(acceleration.dot(d.force) + spin * d.torque + xi)));
        room -= beta;
        friction -= beta * d.force;
        torsion -= beta * d.torque;
      }
      for (Index k = 0; k < 3; ++k) keep_worst(worst.cone, S(friction[k]));
      keep_worst(worst.cone, S(torsion / scales.length));
      if (g > 0) keep_worst(worst.cone, smaller(xi, room));
      // Distances between coplanar points do not see a warp out of the plane; the motion does.
      const Vector3<S> off = contact.acceleration / scales.acceleration - acceleration;
      for (Index k = 0; k < 3; ++k) keep_worst(worst.rigidity, S(off[k]));
      for (Index k = body.first_point; k < i; ++k)
        keep_worst(worst.rigidity,
                   S(laws::patch_rigidity<S>(scene.points[i], contact.acceleration, scene.points[k],
                                             answer.contacts[k].acceleration) /
                     scales.acceleration));
    }
  }

  for (Index a = 0; a < scene.actuators.size; ++a) {
    const Actuator<S>& actuator = scene.actuators[a];
    S balance = actuator.inertia * answer.closing[a] - actuator.force;
    S reach(0);
    for (const Drive<S>& drive : scene.drives) {
      if (drive.actuator != a) continue;
      balance += drive.twist.dot(body_wrench(scene, answer, scene.bodies[drive.body]));
      const Body<S>& body = scene.bodies[drive.body];
      for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
        const S speed = acceleration_at(scene.points[i], drive.twist).norm();
        if (speed > reach) reach = speed;
      }
    }
    keep_worst(worst.grip, S(balance / (scales.force * (reach > S(0) ? reach : S(1)))));
  }
  return worst;
}

} // namespace lcpush
