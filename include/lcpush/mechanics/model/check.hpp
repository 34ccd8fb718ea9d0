// The referee of mechanics/: does an answer obey the paper's laws? Works on the scene and the
// answer in SI units alone: no matrix, no scaled unknowns, nothing of the solvers or the assembly
// (laws.hpp lends it [T.6], contact.hpp the geometry of a point).
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/laws.hpp"

namespace lcpush {

namespace detail {
// A NaN is the worst of all: it stays, and it wins over every number.
template <class S> void keep_worst(S& worst, S violation) {
  violation = Eigen::numext::abs(violation);
  if (!(violation <= worst) && worst == worst) worst = violation;
}
} // namespace detail

enum class Law { newton, normal, dissipation, cone, grip, rigidity, pusher };
constexpr Law all_laws[] = {Law::newton, Law::normal,   Law::dissipation, Law::cone,
                            Law::grip,   Law::rigidity, Law::pusher};
constexpr Index law_count = 7;

/// As reports and histories name its residual.
constexpr const char* law_text(Law law) {
  constexpr const char* names[] = {"newton", "normal",   "dissipation", "cone",
                                   "grip",   "rigidity", "pusher"};
  return names[static_cast<int>(law)];
}

/// One row of a law, and by how much an answer violates it.
template <class S> struct Violation {
  Law law = Law::newton;
  Index of = 0; ///< newton: axis 0..5; grip: actuator; otherwise: contact point
  Index part =
      -1;      ///< dissipation: generator; cone: component of the friction that its generators
               ///< do not make up, 3 for torsion, or -1; rigidity: component, or 3 + other point
  S scaled{0}; ///< signed
  S unit{1};   ///< SI value = scaled times this: N, N m, m/s^2 or the actuator's
};

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

  S& operator[](Law law) {
    S* const all[] = {&newton, &normal, &dissipation, &cone, &grip, &rigidity, &pusher};
    return *all[static_cast<int>(law)];
  }
  S max() const {
    S worst = newton;
    for (const S& r : {normal, dissipation, cone, grip, rigidity, pusher})
      detail::keep_worst(worst, r);
    return worst;
  }
};

namespace detail {

/// The smaller of a force and an acceleration that exclude each other, both scaled: negative, or
/// positive where both are.
template <class S>
Violation<S> complementarity(Law law, Index of, Index part, const S& force, const S& acceleration,
                             const Scales<S>& scales) {
  const bool is_force = !(acceleration < force) && acceleration == acceleration;
  return {law, of, part, is_force ? force : acceleration,
          is_force ? scales.force : scales.acceleration};
}

/// [T.1]
template <class S, class Visit>
void check_newton(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer,
                  Visit& visit) {
  Vector3<S> force = scene.object.mass * scene.gravity;
  Vector3<S> moment = Vector3<S>::Zero();
  for (const Body<S>& body : scene.bodies) {
    const Vector6<S> wrench = body_wrench(scene, answer, body);
    force += wrench.template head<3>();
    moment += wrench.template tail<3>();
  }
  force -= scene.object.mass * answer.acceleration.template head<3>();
  moment -= scene.object.inertia.lazyProduct(answer.acceleration.template tail<3>());
  const S turn = scales.acceleration / scales.length;
  for (Index k = 0; k < 6; ++k) {
    if (scene.planar && k >= 2 && k <= 4) {
      const S unit = k < 3 ? scales.acceleration : turn; // nothing moves out of the plane
      visit(Violation<S>{Law::newton, k, -1, answer.acceleration[k] / unit, unit});
      continue;
    }
    const S unit = k < 3 ? scales.force : S(scales.force * scales.length);
    visit(Violation<S>{Law::newton, k, -1, (k < 3 ? force[k] : moment[k - 3]) / unit, unit});
  }
}

/// [T.3] and [T.4] of point i, and that its friction is made of its generators; `beta`: theirs.
template <class S, class Visit>
void check_friction(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer,
                    const Body<S>& body, Index i, const S* beta, const Vector6<S>& relative,
                    Visit& visit) {
  const ContactAnswer<S>& contact = answer.contacts[i];
  const Vector3<S> acceleration = acceleration_at<S>(scene.points[i], relative);
  const S spin = relative.template tail<3>().dot(body.normal);
  const S lambda = body.bilateral ? Eigen::numext::abs(contact.normal_force) : contact.normal_force;
  S room = body.friction * lambda;
  Vector3<S> friction = contact.friction_force;
  S torsion = contact.torsion;
  const Index g = generator_count(scene, body);
  for (Index j = 0; j < g; ++j) {
    const Generator<S> d = generator(body, j, scene.facets);
    const S slides = acceleration.dot(d.force) + spin * d.torque + contact.slip;
    visit(complementarity<S>(Law::dissipation, i, j, beta[j] / scales.force,
                             slides / scales.acceleration, scales));
    room -= beta[j];
    friction -= beta[j] * d.force;
    torsion -= beta[j] * d.torque;
  }
  for (Index k = 0; k < 3; ++k)
    visit(Violation<S>{Law::cone, i, k, friction[k] / scales.force, scales.force});
  const S moment_unit = scales.force * scales.length;
  visit(Violation<S>{Law::cone, i, 3, torsion / moment_unit, moment_unit});
  if (g > 0)
    visit(complementarity<S>(Law::cone, i, -1, room / scales.force,
                             contact.slip / scales.acceleration, scales));
}

/// [T.2], [T.6] and the pusher's motion at point i.
template <class S, class Visit>
void check_motion(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer,
                  const Body<S>& body, Index i, const Vector6<S>& relative, Visit& visit) {
  const ContactAnswer<S>& contact = answer.contacts[i];
  const S unit = scales.acceleration, lambda = contact.normal_force / scales.force;
  const Vector3<S> acceleration = acceleration_at<S>(scene.points[i], relative);
  const S opening = acceleration.dot(body.normal) / unit;
  Violation<S> normal = complementarity<S>(Law::normal, i, -1, lambda, opening, scales);
  if (body.bilateral) normal = {Law::normal, i, -1, opening, unit};
  visit(normal);
  if (body.role == Role::pusher && (body.bilateral || lambda > S(0))) {
    normal.law = Law::pusher;
    visit(normal);
  }
  // Distances between coplanar points do not see a warp out of the plane; the motion does.
  for (Index k = 0; k < 3; ++k)
    visit(Violation<S>{Law::rigidity, i, k, (contact.acceleration[k] - acceleration[k]) / unit,
                       unit});
  for (Index k = body.first_point; k < i; ++k)
    visit(Violation<S>{Law::rigidity, i, 3 + k,
                       laws::patch_rigidity<S>(scene.points[i], contact.acceleration,
                                               scene.points[k], answer.contacts[k].acceleration) /
                           unit,
                       unit});
}

/// [T.5]
template <class S, class Visit>
void check_grip(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer, Index a,
                Visit& visit) {
  const Actuator<S>& actuator = scene.actuators[a];
  S balance = actuator.inertia * answer.closing[a] - actuator.force;
  S reach(0);
  for (const Drive<S>& drive : scene.drives) {
    if (drive.actuator != a) continue;
    const Body<S>& body = scene.bodies[drive.body];
    balance += drive.twist.dot(body_wrench(scene, answer, body));
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const S speed = acceleration_at(scene.points[i], drive.twist).norm();
      if (speed > reach) reach = speed;
    }
  }
  const S unit = scales.force * (reach > S(0) ? reach : S(1));
  visit(Violation<S>{Law::grip, a, -1, balance / unit, unit});
}

} // namespace detail

/// Calls visit(Violation<S>) for every row of every law. `sigma` scales the prescribed motions, as
/// it did for the solve. Cost: O(forces + drives points), and O(points^2) of a patch.
template <class S, class Visit>
void check_rows(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer, S sigma,
                Visit visit) {
  detail::check_newton(scene, scales, answer, visit);
  const S* beta = answer.friction.data;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    const Vector6<S> relative = answer.acceleration - body_twist(scene, answer, b, sigma);
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      detail::check_motion(scene, scales, answer, body, i, relative, visit);
      detail::check_friction(scene, scales, answer, body, i, beta, relative, visit);
      beta += generator_count(scene, body);
    }
  }
  for (Index a = 0; a < scene.actuators.size; ++a)
    detail::check_grip(scene, scales, answer, a, visit);
}

/// The worst row of each law.
template <class S>
Residuals<S> check(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer,
                   S sigma) {
  Residuals<S> worst;
  check_rows(scene, scales, answer, sigma,
             [&](const Violation<S>& row) { detail::keep_worst(worst[row.law], row.scaled); });
  return worst;
}

} // namespace lcpush

#ifdef LCPUSH_EXTERN_TEMPLATES
namespace lcpush {
extern template Residuals<double> check<double>(const Scene<double>&, const Scales<double>&,
                                                const Answer<double>&, double);
} // namespace lcpush
#endif
