// Round friction [T.16] by rounds: each is the same complementarity problem over pyramids that are
// turned to the last round's slips. Near the answer it is Newton's method.
#pragma once

#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "lcpush/mechanics/model/round_distance.hpp"
#include "lcpush/mechanics/solve/rounds.hpp"
#include "lcpush/mechanics/solve/settings.hpp"

namespace lcpush {

/// What rounds of round friction need beside a pressure law's memory: the scene's own linearized
/// cones, to be turned, and an answer to read. None: friction is a pyramid, and every answer is
/// settled.
template <class S> struct FrictionMemory {
  Span<LinearizedCone<S>> round_cones; ///< points, those that Scene::round_cones looks at
  Answer<S>* answer = nullptr;
};

/// The linearized cones of an assembled scene.
template <class S> class RoundFriction {
public:
  RoundFriction(Assembly<S>& assembly, const FrictionMemory<S>& memory)
      : assembly_(assembly), cones_(memory.round_cones), answer_(memory.answer) {}

  bool is_round() const { return cones_.size > 0; }

  /// Every point's pyramid along its tangent.
  void begin() {
    if (!is_round()) return;
    for (LinearizedCone<S>& cone : cones_) cone = {};
    stalls_ = false;
    fastest_ = S(0);
    reassemble();
  }

  /// Do the forces of z oppose their slips? Notes worst_point().
  bool is_settled(const S* z) {
    if (!is_round()) return true;
    read_answer(assembly_, z, *answer_, assembly_.sigma());
    const typename RoundDistance<S>::Worst worst = distances().worst();
    worst_ = worst.point;
    distance_ = worst.distance;
    return distance_ <= Tolerances<S>().residual;
  }

  /// Does the answer that is_settled looked at obey all laws? Their rows are judged by their own
  /// terms, which may be smaller than F.
  bool passes() const {
    if (!is_round()) return true;
    const Residuals<S> residuals =
        check(assembly_.scene(), assembly_.layout().scales, *answer_, assembly_.sigma());
    return residuals.max() <= Tolerances<S>().residual / S(2);
  }

  /// Turns every pyramid to the answer that is_settled looked at, and with it what later rounds
  /// start from: the basis and the unknowns. Where slips die away, or a step leads nowhere, points
  /// are about to stick: the corner then goes to their force, which it holds.
  /// Not damped: Newton's method as it is, whose other paths settle where those come back.
  void turn(const PressureMemory<S>& memory, bool damps) {
    if (!is_round()) return;
    const RoundDistance<S> cones = distances();
    const S step = damps && fastest_ > S(0) ? step_length(cones) : S(1);
    const bool is_short = step < RoundSettings::least_step<S>();
    const bool halts =
        cones.fastest() < RoundSettings::halts<S>() * fastest_ || (is_short && stalls_);
    stalls_ = is_short && !halts;
    fastest_ = cones.fastest();
    for (Index i = 0; i < assembly_.layout().points; ++i)
      if (assembly_.layout().cones[i].generators > 2) // two are all of it, in a plane
        turn_point(cones, i, step, halts, memory);
    reassemble();
  }

  Index worst_point() const { return worst_; }
  /// From [T.16], of the answer that is_settled looked at; of pyramids 0.
  const S& distance() const { return distance_; }

private:
  Assembly<S>& assembly_;
  Span<LinearizedCone<S>> cones_;
  Answer<S>* answer_;
  Index worst_ = 0;
  S distance_{0};
  S fastest_{0}; // slip, when the pyramids last turned; 0: they have not
  bool stalls_ = false;

  RoundDistance<S> distances() const {
    return {assembly_.scene(), assembly_.layout().scales, *answer_};
  }

  /// How far to go from the slips of the last linearization to the answer's, up to 1: to where
  /// friction takes the least power beyond what the answer's own forces give. Newton's method
  /// overshoots where the friction's curvature mu lambda / |v| is much more than the object's mass.
  S step_length(const RoundDistance<S>& cones) const {
    const auto rises = [&](const S& step) {
      S slope(0);
      for (Index i = 0; i < assembly_.layout().points; ++i) {
        const Vector3<S> change = cones.slip(i) - cones_[i].slip;
        const Vector3<S> v = cones_[i].slip + step * change;
        slope += cones.friction(i).dot(change);
        if (const S speed = v.norm(); speed > S(0)) slope += cones.limit(i) * v.dot(change) / speed;
      }
      return slope > S(0);
    };
    S low(0), high(1), step(1); // the whole step first
    while (high - low > RoundSettings::step_error<S>()) {
      (rises(step) ? high : low) = step;
      step = (low + high) / S(2);
    }
    return high;
  }

  void turn_point(const RoundDistance<S>& cones, Index i, const S& step, bool halts,
                  const PressureMemory<S>& memory) {
    const Body<S>& body = cones.body(i);
    LinearizedCone<S>& cone = cones_[i];
    const Vector3<S> v = cone.slip + step * (cones.slip(i) - cone.slip), f = cones.friction(i);
    cone.slip = v;
    const S room = cones.limit(i), speed = v.norm(), force = f.norm();
    const Vector3<S> in_pyramid =
        f - laws::resisting_force(body, assembly_.scene().points[i], cone, answer_->acceleration);
    cone.inertia = S(0);
    const bool slides = answer_->contacts[i].slip > S(0) && !cones.sticks(speed);
    const S least = slides ? RoundSettings::slides<S>() : RoundSettings::sticks<S>();
    if (!(force > least * room)) return;
    // Along an edge a polygon gives way before the circle does: first fill it out there.
    const bool on_edge = halts || in_pyramid.norm() < RoundSettings::corner<S>() * room;
    cone.along = slides && !on_edge ? Vector3<S>(v / -speed) : Vector3<S>(f / force);
    if (!slides || on_edge) return;
    cone.inertia = room / speed;
    const Vector6<S> twist =
        body_twist(assembly_.scene(), *answer_, assembly_.layout().body[i], assembly_.sigma());
    cone.body_motion = slip_of(body, assembly_.scene().points[i], twist);
    const ConeGroup<S>& group = assembly_.layout().cones[i];
    const Index first = group.variable + group.normals;
    for (Index k = 0; k < group.generators; ++k) {
      memory.active[first + k] = k == 0 ? 1 : 0;
      memory.z[first + k] = k == 0 ? group.friction_limit(memory.z.data) : S(0);
    }
  }

  /// The same push over the pyramids as they are now.
  void reassemble() {
    const S sigma = assembly_.sigma();
    (void)assembly_.assemble(assembly_.scene()); // it has fitted before
    assembly_.push_by(sigma);
  }
};

} // namespace lcpush
