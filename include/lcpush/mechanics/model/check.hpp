// The referee of mechanics/: does an answer obey the paper's laws? Works on the scene and the
// answer in SI units alone: no matrix, no scaled unknowns, nothing of the solvers or the assembly
// (laws.hpp lends it [T.6], contact.hpp the geometry of a point).
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/laws.hpp"
#include "lcpush/mechanics/model/term_sizes.hpp"

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
  S common{1}; ///< what the scene's largest force makes of the same unit: unit <= common
  bool moves = false; ///< of a force and an acceleration that exclude each other, the latter
};

/// The largest scaled violation of each law. A row is measured by the sum of its own |terms|, plus
/// what rounding leaves of F, F / m or F L (Scales), at most by these (term_sizes.hpp).
template <class S> struct Residuals {
  S newton{0};      ///< [T.1]
  S normal{0};      ///< [T.2]
  S dissipation{0}; ///< [T.3]
  S cone{0};        ///< [T.4]
  S grip{0};        ///< [T.5]
  S rigidity{0};    ///< [T.6]
  S pusher{0};      ///< pushers in contact move as prescribed: |normal acceleration| where pressed

  /// The largest violation of all, measured by F, F / m or F L alone: what rounding does to the
  /// scene as a whole.
  S beside{0};

  S& operator[](Law law) {
    constexpr S Residuals::*all[] = {
        &Residuals::newton, &Residuals::normal,   &Residuals::dissipation, &Residuals::cone,
        &Residuals::grip,   &Residuals::rigidity, &Residuals::pusher};
    return this->*all[static_cast<int>(law)];
  }
  /// Of two answers' residuals those with the worse row.
  void take(const Residuals& other) {
    const S most = beside;
    if (!(other.max() <= max())) *this = other;
    detail::keep_worst(beside, most);
    detail::keep_worst(beside, other.beside);
  }
  S max() const {
    S worst = newton;
    for (const S& r : {normal, dissipation, cone, grip, rigidity, pusher})
      detail::keep_worst(worst, r);
    return worst;
  }
};

namespace detail {

/// The rows of the laws, shown to `visit` one by one.
template <class S, class Visit> struct LawRows {
  const Scene<S>& scene;
  const Answer<S>& answer;
  Visit& visit;
  Scales<S> scales;
  TermSizes<S> sizes{scene, scales, answer};
  S motion_scale = fastest_of(scene, scales); // m/s^2, whose rounding no motion is told from
  // Of the present body: its forces' sum, the object's twist beside it, and the size of its terms.
  S pressing{0};
  Vector6<S> relative = Vector6<S>::Zero(), moving = Vector6<S>::Zero();
  // Of the present point: how the object moves over it, and the size of the terms.
  Vector3<S> acceleration = Vector3<S>::Zero(), speed = Vector3<S>::Zero();

  /// The row fails by `amount` in SI units; `own` is the sum of its |terms|, `common` what F makes
  /// of such a unit, `given` a load that must not be lost in it.
  void show(Law law, Index of, Index part, S amount, S own, S common, S given = S(0)) {
    const S unit = row_unit_of(own, common, given);
    visit(Violation<S>{law, of, part, unit > S(0) ? S(amount / unit) : amount, unit, common});
  }

  /// The smaller of a force and an acceleration that exclude each other, both scaled: negative, or
  /// positive where both are. `size` is that of the acceleration's terms.
  Violation<S> complementarity(Law law, Index of, Index part, S force, S motion, S size) const {
    const S force_unit = row_unit_of(pressing, scales.force);
    const S motion_unit = row_unit_of(size, motion_scale);
    force /= force_unit;
    motion /= motion_unit;
    const bool is_force = !(motion < force) && motion == motion;
    if (is_force) return {law, of, part, force, force_unit, scales.force};
    return {law, of, part, motion, motion_unit, motion_scale, true};
  }

  /// The body whose points come next.
  void enter(Index b, const S& sigma) {
    const Body<S>& body = scene.bodies[b];
    pressing = S(0);
    for (const Index i : points_of(body))
      pressing += Eigen::numext::abs(answer.contacts[i].normal_force) +
                  answer.contacts[i].friction_force.norm();
    relative = answer.acceleration - body_twist(scene, answer, b, sigma);
    moving = sizes.acceleration + twist_size(scene, answer, b, sigma);
  }
  /// The point that comes next.
  void enter_point(Index i) {
    acceleration = acceleration_at<S>(scene.points[i], relative);
    speed = size_at<S>(scene.points[i], moving);
  }

  /// [T.1]
  void newton() {
    Vector6<S> left = scene.object.wrench;
    left.template head<3>() += scene.object.mass * scene.gravity;
    left.template tail<3>() += scene.object.turning;
    for (const Body<S>& body : scene.bodies) left += body_wrench(scene, answer, body);
    left.template head<3>() -= scene.object.mass * answer.acceleration.template head<3>();
    left.template tail<3>() -=
        scene.object.inertia.lazyProduct(answer.acceleration.template tail<3>());
    for (Index k = 0; k < 6; ++k) {
      const S lever = k < 3 ? S(1) : scales.length;
      if (scene.planar && k >= 2 && k <= 4) // nothing moves out of the plane
        show(Law::newton, k, -1, answer.acceleration[k], S(0), scales.acceleration / lever);
      else
        show(Law::newton, k, -1, left[k], sizes.wrench[k], scales.force * lever,
             sizes.load * lever);
    }
  }

  /// [T.3] and [T.4] of point i, and that its friction is made of its generators; `beta`: theirs.
  void friction(const Body<S>& body, Index i, const S* beta) {
    const ContactAnswer<S>& contact = answer.contacts[i];
    const S spin = relative.template tail<3>().dot(body.normal);
    const S turning = moving.template tail<3>().dot(body.normal.cwiseAbs());
    const S lambda =
        body.bilateral ? Eigen::numext::abs(contact.normal_force) : contact.normal_force;
    S room = body.friction * lambda;
    if (has_round_friction(scene, body)) return round_friction(body, i, room, spin);
    Vector3<S> left = contact.friction_force;
    S torsion = contact.torsion;
    const Index g = generator_count(scene, body);
    for (Index j = 0; j < g; ++j) {
      const Generator<S> d = generator(body, j, scene.facets);
      const S slides = acceleration.dot(d.force) + spin * d.torque + contact.slip;
      const S size = speed.dot(d.force.cwiseAbs()) + turning * Eigen::numext::abs(d.torque) +
                     Eigen::numext::abs(contact.slip);
      visit(complementarity(Law::dissipation, i, j, beta[j], slides, size));
      room -= beta[j];
      left -= beta[j] * d.force;
      torsion -= beta[j] * d.torque;
    }
    for (Index k = 0; k < 3; ++k) show(Law::cone, i, k, left[k], pressing, scales.force);
    show(Law::cone, i, 3, torsion, pressing * scales.length, scales.force * scales.length);
    if (g > 0) visit(complementarity(Law::cone, i, -1, room, contact.slip, speed.norm()));
  }

  /// [T.16] of point i: friction within the round cone, and none across the slip or along it.
  void round_friction(const Body<S>& body, Index i, S limit, S spin) {
    if (!(body.friction > S(0))) return;
    const Vector3<S> f = friction_of(body, answer.contacts[i]);
    const Vector3<S> v = in_friction_space(body, acceleration, spin);
    const S slip = v.norm(), force = f.norm(), size = speed.norm();
    visit(complementarity(Law::cone, i, -1, limit - force, slip, size));
    if (slip == S(0)) return;
    const S along = f.dot(v) / slip;
    const S misdirected = along > S(0) ? force : S((f - along / slip * v).norm());
    visit(complementarity(Law::dissipation, i, -1, misdirected, slip, size));
  }

  /// [T.2], [T.6] and the pusher's motion at point i.
  void motion(const Body<S>& body, Index i) {
    const ContactAnswer<S>& contact = answer.contacts[i];
    const S unit = motion_scale;
    const S gap = clearance_of(scene, i);
    const S opening = acceleration.dot(body.normal) + gap;
    const S size = speed.dot(body.normal.cwiseAbs()) + gap;
    Violation<S> normal = complementarity(Law::normal, i, -1, contact.normal_force, opening, size);
    if (body.bilateral) {
      const S own = row_unit_of(size, unit);
      normal = {Law::normal, i, -1, opening / own, own, unit, true};
    }
    visit(normal);
    if (body.role == Role::pusher &&
        (body.bilateral || contact.normal_force / scales.force > S(0))) {
      normal.law = Law::pusher;
      visit(normal);
    }
    // Distances between coplanar points do not see a warp out of the plane; the motion does.
    constexpr Index most = ModelSettings<S>::rigidity_neighbours;
    for (Index k = 0; k < 3; ++k)
      show(Law::rigidity, i, k, contact.acceleration[k] - acceleration[k], speed[k], unit);
    for (Index k = i - body.first_point > most ? i - most : body.first_point; k < i; ++k)
      show(Law::rigidity, i, 3 + k,
           laws::patch_rigidity<S>(scene.points[i], contact.acceleration, scene.points[k],
                                   answer.contacts[k].acceleration),
           speed.norm(), unit);
  }

  /// [T.5]
  void grip(Index a) {
    const Actuator<S>& actuator = scene.actuators[a];
    S balance = actuator.inertia * answer.closing[a] - actuator.force;
    using Eigen::numext::abs;
    const S given = abs(actuator.force);
    S reach(0), own = abs(actuator.inertia * answer.closing[a]) + given;
    for (const Drive<S>& drive : scene.drives) {
      if (drive.actuator != a) continue;
      const Body<S>& body = scene.bodies[drive.body];
      balance += drive.twist.dot(body_wrench(scene, answer, body));
      own += drive.twist.cwiseAbs().dot(wrench_size(scene, answer, body));
      reach = Eigen::numext::maxi(reach, drive_reach(scene, drive));
    }
    show(Law::grip, a, -1, balance, own, scales.force * (reach > S(0) ? reach : S(1)), given);
  }
};

} // namespace detail

/// Calls visit(Violation<S>) for every row of every law. `sigma` scales the prescribed motions, as
/// it did for the solve. Cost: O(forces + drives points).
template <class S, class Visit>
void check_rows(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer, S sigma,
                Visit visit) {
  detail::LawRows<S, Visit> rows{scene, answer, visit,
                                 detail::scales_of_reactions(scene, scales, answer)};
  rows.newton();
  const S* beta = answer.friction.data;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    rows.enter(b, sigma);
    for (const Index i : points_of(body)) {
      rows.enter_point(i);
      rows.motion(body, i);
      rows.friction(body, i, beta);
      beta += generator_count(scene, body);
    }
  }
  for (Index a = 0; a < scene.actuators.size; ++a) rows.grip(a);
}

/// The worst row of each law.
template <class S>
Residuals<S> check(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer,
                   S sigma) {
  Residuals<S> worst;
  check_rows(scene, scales, answer, sigma, [&](const Violation<S>& row) {
    detail::keep_worst(worst[row.law], row.scaled);
    detail::keep_worst(worst.beside, S(row.scaled * (row.unit / row.common)));
  });
  return worst;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template Residuals<double> check<double>(const Scene<double>&, const Scales<double>&,
                                                const Answer<double>&, double);
#endif

} // namespace lcpush
