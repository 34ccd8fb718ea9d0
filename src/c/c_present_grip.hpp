// What an older answer's forces become when the grip changes: a controller has them at once,
// whatever the solve of its new command still takes.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush::c {

/// Friction is brought within its cones to the last bit. Then a body's forces are scaled as a
/// whole: they stay there, and no normal force turns round. The motion stays.
template <class S> class PresentGrip {
public:
  /// Looks at the scene, and changes the answer.
  PresentGrip(const Scene<S>& scene, const S& length, Answer<S>& answer)
      : scene_(scene), length_(length), answer_(answer) {}

  /// Each actuator's bodies balance its force [T.5], one actuator after the other. Then the bodies
  /// that none drives give what Newton's law [T.1] asks of them, as nearly as scaling can.
  /// Cost: O(forces + bodies points + actuators drives points).
  void fit() {
    for (Index b = 0; b < scene_.bodies.size; ++b) clamp(b);
    for (Index a = 0; a < scene_.actuators.size; ++a) press(a);
    for (Index b = 0; b < scene_.bodies.size; ++b)
      if (!is_driven(scene_, b)) push_back(b);
  }

private:
  const Scene<S>& scene_;
  const S& length_; // m: the largest distance of a contact point from the centre of mass
  Answer<S>& answer_;

  /// What its own inertia leaves of the actuator's force, on bodies that press already in
  /// proportion, on others evenly. One that has let go, or has less force than its inertia takes,
  /// moves on its own.
  void press(Index a) {
    const S little = Tolerances<S>().residual;
    const Actuator<S>& actuator = scene_.actuators[a];
    const S taken = actuator.inertia * answer_.closing[a];
    S left = actuator.force - taken, pressed = pressed_by(a);
    const bool presses = pressed > little * left;
    if (left < S(0) || (!presses && taken > little * actuator.force)) {
      answer_.closing[a] = actuator.force / actuator.inertia;
      left = S(0);
    } else if (!presses) {
      for_driven(a, [&](Index b) { press_evenly(b); });
      pressed = pressed_by(a);
    }
    const S times = pressed > S(0) ? S(left / pressed) : S(0);
    for_driven(a, [&](Index b) { scale(b, times); });
  }

  void push_back(Index b) {
    Vector6<S> left = scene_.object.wrench;
    left.template head<3>() += scene_.object.mass * scene_.gravity;
    left.template head<3>() -= scene_.object.mass * answer_.acceleration.template head<3>();
    left.template tail<3>() -=
        scene_.object.inertia.lazyProduct(answer_.acceleration.template tail<3>());
    for (const Body<S>& body : scene_.bodies) left += body_wrench(scene_, answer_, body);
    Vector6<S> own = body_wrench(scene_, answer_, scene_.bodies[b]);
    for (Vector6<S>* wrench : {&left, &own}) {
      wrench->template tail<3>() /= length_;
      stay_in_plane(scene_, *wrench);
    }
    const S size = own.squaredNorm(), rest = size - left.dot(own);
    if (size > S(0)) scale(b, rest > S(0) ? S(rest / size) : S(0));
  }

  /// The power of the forces of its bodies, per unit of the actuator.
  S pressed_by(Index a) const {
    S sum(0);
    for (const Drive<S>& drive : scene_.drives)
      if (drive.actuator == a)
        sum += drive.twist.dot(body_wrench(scene_, answer_, scene_.bodies[drive.body]));
    return sum;
  }

  template <class Visit> void for_driven(Index a, const Visit& visit) const {
    for (Index b = 0; b < scene_.bodies.size; ++b)
      for (const Drive<S>& drive : scene_.drives)
        if (drive.body == b && drive.actuator == a) {
          visit(b);
          break;
        }
  }

  /// The first point's part of answer_.friction.
  S* parts_of(Index b) const {
    S* beta = answer_.friction.data;
    for (Index k = 0; k < b; ++k)
      beta += scene_.bodies[k].point_count * generator_count(scene_, scene_.bodies[k]);
    return beta;
  }
  void scale(Index b, const S& times) {
    const Body<S>& body = scene_.bodies[b];
    const Index g = generator_count(scene_, body);
    S* beta = parts_of(b);
    for (const Index i : points_of(body)) {
      answer_.contacts[i].normal_force *= times;
      scale_friction(answer_.contacts[i], {beta, g}, times);
      beta += g;
    }
  }
  static void scale_friction(ContactAnswer<S>& contact, const Span<S>& beta, const S& times) {
    contact.friction_force *= times;
    contact.torsion *= times;
    for (S& part : beta) part *= times;
  }
  /// What a solved answer violates by less than the check sees, scaling might make large.
  void clamp(Index b) {
    const Body<S>& body = scene_.bodies[b];
    const Index g = generator_count(scene_, body);
    S* first = parts_of(b);
    for (const Index i : points_of(body)) {
      ContactAnswer<S>& contact = answer_.contacts[i];
      const Span<S> beta{first, g};
      first += g;
      if (!body.bilateral && contact.normal_force < S(0)) contact.normal_force = S(0);
      S taken(0);
      for (const S& part : beta) taken += part;
      if (has_round_friction(scene_, body)) taken = lcpush::friction_of(body, contact).norm();
      const S room = body.friction * Eigen::numext::abs(contact.normal_force);
      if (taken > room) scale_friction(contact, beta, S(room / taken));
    }
  }
  void press_evenly(Index b) {
    scale(b, S(0));
    for (const Index i : points_of(scene_.bodies[b]))
      answer_.contacts[i].normal_force = weight_of(scene_, scene_.bodies[b], i);
  }
};

} // namespace lcpush::c
