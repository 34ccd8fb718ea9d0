// How far an answer's friction is from the round cone's law [T.16]: of round friction what the
// iterations leave, of pyramids what their facets cost.
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush {

/// Of the answer to a scene; looks at both. The answer may be longer: behind the contacts of the
/// scene's points a motion keeps those of earlier steps.
template <class S> class RoundDistance {
public:
  RoundDistance(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer)
      : scene_(scene), scales_(scales), answer_(answer),
        // Rounding is that of the twists whose difference a slip is.
        fastest_(ModelSettings<S>::slip_noise() *
                 fastest_body(scene, scales.length, scales.acceleration)) {
    for (Index i = 0; i < scene.points.size; ++i)
      fastest_ = Eigen::numext::maxi(fastest_, S(slip(i).norm()));
    slowest_ = Eigen::numext::maxi(S(ModelSettings<S>::sticking() * fastest_),
                                   S(ModelSettings<S>::slowest_slip() * scales.acceleration));
  }

  const Body<S>& body(Index i) const { return scene_.bodies[answer_.contacts[i].body]; }
  Vector3<S> friction(Index i) const { return friction_of(body(i), answer_.contacts[i]); }
  Vector3<S> slip(Index i) const {
    const ContactAnswer<S>& contact = answer_.contacts[i];
    return in_friction_space(body(i), contact.acceleration, contact.spin);
  }
  /// mu lambda
  S limit(Index i) const {
    return body(i).friction * Eigen::numext::abs(answer_.contacts[i].normal_force);
  }
  const S& fastest() const { return fastest_; } ///< slip, m/s^2
  /// Slower than this beside the fastest point, or beside F / m, rounding does not tell a slip from
  /// none; and a point that sticks is within its pyramid, and so within its cone.
  bool sticks(const S& speed) const { return !(speed > slowest_); }

  /// |f - projection of (f - v) onto the cone|, f over F, v over the fastest slip.
  S of(Index i) const {
    const Vector3<S> v = slip(i);
    if (sticks(v.norm())) return S(0);
    const S room = limit(i) / scales_.force;
    const Vector3<S> f = friction(i) / scales_.force;
    Vector3<S> projected = f - v / fastest_;
    if (projected.norm() > room) projected *= room / projected.norm();
    return (f - projected).norm();
  }

  struct Worst {
    S distance; ///< over F
    Index point;
  };
  Worst worst() const {
    Worst most{S(0), 0};
    for (Index i = 0; i < scene_.points.size; ++i)
      if (const S distance = of(i); !(distance <= most.distance)) most = {distance, i};
    return most;
  }

private:
  const Scene<S>& scene_;
  const Scales<S>& scales_;
  const Answer<S>& answer_;
  S fastest_, slowest_; // slips, m/s^2
};

} // namespace lcpush
