// Of a step: which points touch, and where its push takes them. Included by step.hpp.
#pragma once

#include "lcpush/mechanics/solve/step.hpp"

namespace lcpush {

/// A drive's twist, along its face's normal where rounding alone has tilted that: what such a tilt
/// lets friction do to a jaw would be a pivot, and the basis behind it singular.
template <class S>
Vector6<S> along_face(const Vector3<S>& normal, Vector6<S> twist, const S& rounding) {
  const Vector3<S> way = twist.template head<3>(), along = normal * normal.dot(way);
  const bool turns = twist.template tail<3>().squaredNorm() > S(0);
  if (!turns && (way - along).norm() <= rounding * way.norm()) twist.template head<3>() = along;
  return twist;
}

/// How far a gap may be and close within the step, generously.
template <class S, class Pivots> S TimeStepper<S, Pivots>::reach(const S& h) const {
  S fastest(0), force = scene_->object.wrench.template head<3>().norm();
  for (const Vector6<S>& twist : m_.velocities)
    fastest = Eigen::numext::maxi(fastest, size_of_twist(twist, length_));
  for (const Actuator<S>& actuator : scene_->actuators) force += actuator.force;
  const S falls = scene_->gravity.norm() + force / scene_->object.mass;
  return S(4) * h * (fastest + size_of_twist(velocity_, length_) + h * falls) + length_ / S(1000);
}

template <class S, class Pivots>
PlacedPoint<S> TimeStepper<S, Pivots>::placed(Index b, Index i, const Pose<S>& object,
                                              const Pose<S>& hand) const {
  PlacedPoint<S> point = place(*around_, touching(b), scene_->bodies[b], scene_->points[i], object,
                               hand, S(length_ / S(1000)));
  if (!follows_face(b)) return point;
  if (point.absence == Absence::behind) point.absence = Absence::none;
  if (touching(b).riding == Riding::on_body) point.position += point.gap * point.normal;
  point.gap = S(0);
  return point;
}

/// Does a point come back over its face from beside, inside it? It has met the object's side, which
/// is no face of its own: to be out at the step's end it would be thrown, the faster the shorter.
template <class S, class Pivots> bool TimeStepper<S, Pivots>::comes_from_beside(Index i) const {
  const Absence last = m_.contacts[i].absence;
  return (last == Absence::outside || last == Absence::behind) &&
         m_.placed[i].absence == Absence::none && m_.placed[i].gap < -penetration_tolerance();
}

template <class S, class Pivots> void TimeStepper<S, Pivots>::place_points(const S& reach) {
  depth_ = S(0);
  for (Index b = 0; b < scene_->bodies.size; ++b) {
    const Body<S>& body = scene_->bodies[b];
    const bool closes = is_massless(b); // at any speed: nothing is too far for it
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      m_.placed[i] = placed(b, i, pose_, m_.poses[b]);
      if (is_absent(*around_, b)) m_.placed[i].absence = Absence::away;
      if (comes_from_beside(i)) m_.placed[i].absence = Absence::behind;
      const bool is_far = !closes && !body.bilateral && m_.placed[i].gap > reach;
      if (m_.placed[i].absence != Absence::none) continue;
      depth_ = Eigen::numext::maxi(depth_, S(-m_.placed[i].gap));
      if (is_far) m_.placed[i].absence = Absence::far;
    }
  }
}

template <class S, class Pivots>
void TimeStepper<S, Pivots>::gather_points(Index b, Index first, Index count, Index& points) {
  const Body<S>& body = scene_->bodies[b];
  const bool all = count == body.point_count;
  S sum(0);
  for (Index k = first; k < first + count; ++k) sum += weight_of(*scene_, body, m_.from[k]);
  for (Index k = first; k < first + count; ++k) {
    const PlacedPoint<S>& placed = m_.placed[m_.from[k]];
    const S weight = weight_of(*scene_, body, m_.from[k]);
    m_.weights[k] = all ? weight : S(weight / sum);
    m_.points[k] = without_rounding(Vector3<S>(placed.position - pose_.position), length_);
    m_.true_gaps[k] = placed.gap;
  }
  points += count;
}

/// The scene of the present contacts, in the hand's axes about the present centre of mass. False:
/// an actuator without inertia has lost what it drives.
template <class S, class Pivots> bool TimeStepper<S, Pivots>::gather() {
  Index bodies = 0, points = 0, drives = 0;
  for (Index b = 0; b < scene_->bodies.size; ++b) {
    const Body<S>& body = scene_->bodies[b];
    Index count = 0;
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      if (m_.placed[i].absence == Absence::none) m_.from[points + count++] = i;
    if (count == 0) continue;
    Body<S>& now = m_.bodies[bodies];
    now = body;
    now.normal = without_rounding(m_.placed[m_.from[points]].normal, S(1));
    now.tangent = without_rounding(m_.placed[m_.from[points]].tangent, S(1));
    now.first_point = points;
    now.point_count = count;
    m_.body_of[bodies] = b;
    m_.body_twists[bodies] = twist_at(m_.velocities[b], pose_.position);
    for (const Drive<S>& drive : scene_->drives)
      if (drive.body == b) {
        const Vector6<S> twist = twist_at(drive.twist, pose_.position);
        const bool is_turned = now.normal != body.normal; // else the bits are the scene's
        m_.drives[drives++] = {bodies, drive.actuator,
                               is_turned ? along_face(now.normal, twist, rounding()) : twist};
      }
    ++bodies;
    gather_points(b, points, count, points);
  }
  present_ = *scene_;
  const Matrix3<S> turned = pose_.rotation.lazyProduct(scene_->object.inertia);
  const Matrix3<S> inertia = turned.lazyProduct(pose_.rotation.transpose());
  present_.object.inertia = (inertia + inertia.transpose()) / S(2);
  present_.bodies = {m_.bodies.data, bodies};
  present_.points = {m_.points.data, points};
  present_.drives = {m_.drives.data, drives};
  straight_gaps();
  present_.weights = {m_.weights.data, scene_->weights.size > 0 ? points : 0};
  for (Index a = 0; a < scene_->actuators.size; ++a)
    if (drive_count(present_, a) == 0) return false;
  return true;
}

/// Flags of the last step's basis, from all points to the present ones or back; those that are no
/// contact keep nothing.
template <class S, class Pivots> void TimeStepper<S, Pivots>::carry_basis(bool to_present) {
  const Layout<S>& layout = assembly_.layout();
  if (!to_present)
    for (Index i = 0; i < m_.active.size; ++i) m_.active[i] = 0;
  Index all = 0, k = 0;
  for (const Body<S>& body : scene_->bodies) {
    const Index generators = generator_count(*scene_, body);
    const Index unknowns = (body.bilateral ? 2 : 1) + generators + (generators > 0 ? 1 : 0);
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const bool is_present = k < layout.points && m_.from[k] == i;
      for (Index j = 0; is_present && j < unknowns; ++j) {
        unsigned char& there = m_.kept[layout.normal_index(k) + j];
        (to_present ? there : m_.active[all + j]) = to_present ? m_.active[all + j] : there;
      }
      k += is_present ? 1 : 0;
      all += unknowns;
    }
  }
  for (Index i = layout.size - layout.actuators; to_present && i < layout.size; ++i) m_.kept[i] = 1;
}

/// The gaps as they are now, none below 0: squeezes stay what they were (theory, [T.13]). That of a
/// single point that pressed is where its face has turned away from it, however little that is:
/// dropped until it is no rounding any more, it would open in one step what presses in all.
template <class S, class Pivots> void TimeStepper<S, Pivots>::straight_gaps() {
  for (Index k = 0; k < present_.points.size; ++k) {
    const Index b = m_.body_of[body_at(k)];
    const Body<S>& body = scene_->bodies[b];
    const bool holds = body.bilateral;
    const bool turns = touching(b).riding != Riding::on_side && body.point_count == 1;
    const bool pressed = turns && m_.contacts[m_.from[k]].normal_force > S(0);
    const S gap = settled(m_.true_gaps[k], pressed);
    m_.gaps[k] = holds || gap > S(0) ? gap : S(0);
  }
  level_gaps();
}

/// Points of a body whose gaps differ by rounding close together: how they share its force is the
/// pressure law's to say.
template <class S, class Pivots> void TimeStepper<S, Pivots>::level_gaps() {
  for (const Body<S>& body : present_.bodies) {
    S least = Eigen::NumTraits<S>::highest();
    for (const Index i : points_of(body)) least = Eigen::numext::mini(least, m_.gaps[i]);
    for (const Index i : points_of(body))
      if (m_.gaps[i] - least <= penetration_tolerance()) m_.gaps[i] = least;
  }
}

/// The gaps less what a straight step misses by: those that its end will have, not its tangent.
/// Two answers that lead to each other's gaps would take turns for ever: from the fourth time on
/// only half the way there, and near the end only closer, so that nothing is left inside.
template <class S, class Pivots> void TimeStepper<S, Pivots>::bend_gaps(const S& h, Index times) {
  const S part(times < 3 ? 1 : 0.5);
  const bool only_closer = times >= most_corrections - 4;
  const Pose<S> object = moved(pose_, next_velocity_, h);
  for (Index k = 0; k < present_.points.size; ++k) {
    const Index i = m_.from[k], present = body_at(k), b = m_.body_of[present];
    const Pose<S> hand = moved_about_origin(m_.poses[b], end_twist(b), h);
    const Vector6<S> relative = next_velocity_ - twist_at(end_twist(b), pose_.position);
    const S opening = acceleration_at(m_.points[k], relative).dot(m_.bodies[present].normal);
    const PlacedPoint<S> then = placed(b, i, object, hand);
    if (then.absence == Absence::no_line || follows_face(b)) continue;
    // Of a point that ends in its face nothing is rounding, or the step would be taken for a leap.
    const S bent = then.gap - h * opening;
    const bool is_inside = then.gap < -penetration_tolerance();
    const S change = (is_inside ? bent : settled(bent)) - m_.gaps[k];
    m_.gaps[k] += only_closer ? Eigen::numext::mini(change, S(0)) : S(part * change);
  }
  level_gaps();
}

/// The closing speeds at the step's end; of an actuator whose points have one each, their mean.
template <class S, class Pivots> void TimeStepper<S, Pivots>::read_speeds(const S& h) {
  const Answer<S>& answer = m_.work.answer;
  for (Index a = 0; a < m_.next_speeds.size; ++a)
    m_.next_speeds[a] = presses_evenly(push_) ? S(0) : S(h * answer.closing[a]);
  if (!presses_evenly(push_)) return;
  Index share = 0;
  for (Index b = 0; b < push_.bodies.size; ++b)
    for (Index i = 0; i < push_.bodies[b].point_count; ++i)
      for (const Drive<S>& drive : push_.drives)
        if (drive.body == b)
          m_.next_speeds[drive.actuator] +=
              h * answer.closing[share++] / S(push_.bodies[b].point_count);
}

/// Are the end's velocities none but what rounding of the largest force makes in a step? Together
/// with the fingers, or gaps would open by it.
template <class S, class Pivots> bool TimeStepper<S, Pivots>::is_at_rest(const S& h) const {
  const S rest =
      S(64) * Eigen::NumTraits<S>::epsilon() * h * assembly_.layout().scales.acceleration;
  S fastest = Eigen::numext::maxi(S(next_velocity_.template head<3>().norm()),
                                  S(length_ * next_velocity_.template tail<3>().norm()));
  for (const S& speed : m_.next_speeds)
    fastest = Eigen::numext::maxi(fastest, Eigen::numext::abs(speed));
  return !(fastest > rest);
}

/// A body's twist at the step's end, at the hand's origin.
template <class S, class Pivots> Vector6<S> TimeStepper<S, Pivots>::end_twist(Index body) const {
  Vector6<S> twist = m_.velocities[body];
  for (const Drive<S>& drive : scene_->drives)
    if (drive.body == body) twist += m_.next_speeds[drive.actuator] * drive.twist;
  return twist;
}

/// Does the solved push take the object farther than a step can tell of? Beside its fingers it
/// turns and goes little in one, or a squeeze that gives way would throw it through a face; and no
/// point ends in its face deeper than it was.
template <class S, class Pivots> bool TimeStepper<S, Pivots>::leaps(const S& h) const {
  S slowest = next_velocity_.template head<3>().norm();
  for (Index b = 0; b < scene_->bodies.size; ++b) {
    const Vector6<S> beside = next_velocity_ - twist_at(end_twist(b), pose_.position);
    slowest = Eigen::numext::mini(slowest, S(beside.template head<3>().norm()));
  }
  return h * next_velocity_.template tail<3>().norm() > S(0.5) || h * slowest > length_ ||
         run_.penetration > Eigen::numext::maxi(penetration_tolerance(), depth_);
}

/// How deep the deepest point is in its face at the step's end; 0 if none is. `missed`: one is that
/// was left out as too far away.
template <class S, class Pivots> S TimeStepper<S, Pivots>::deepest(const S& h, bool& missed) const {
  const Pose<S> object = moved(pose_, next_velocity_, h);
  S depth(0);
  missed = false;
  for (Index b = 0; b < scene_->bodies.size; ++b) {
    const Body<S>& body = scene_->bodies[b];
    const Pose<S> hand = moved_about_origin(m_.poses[b], end_twist(b), h);
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const Absence absence = m_.placed[i].absence;
      if (absence != Absence::none && absence != Absence::far) continue;
      const PlacedPoint<S> then = placed(b, i, object, hand);
      if (then.absence == Absence::outside || then.absence == Absence::no_line) continue;
      missed = missed || (absence == Absence::far && then.gap < S(0));
      depth = Eigen::numext::maxi(depth, S(-then.gap));
    }
  }
  return depth;
}

/// The widest gap, m, at the step's end under a point that presses; 0 if there is none.
template <class S, class Pivots> S TimeStepper<S, Pivots>::loosest(const S& h) const {
  const Pose<S> object = moved(pose_, next_velocity_, h);
  S gap(0);
  for (Index k = 0; k < present_.points.size; ++k) {
    if (!(m_.work.answer.contacts[k].normal_force > S(0))) continue;
    const Index b = m_.body_of[body_at(k)];
    const Pose<S> hand = moved_about_origin(m_.poses[b], end_twist(b), h);
    const PlacedPoint<S> then = placed(b, m_.from[k], object, hand);
    if (then.absence == Absence::none) gap = Eigen::numext::maxi(gap, S(then.gap));
  }
  return gap;
}

/// What point i did; `present`: its place in the push, < 0 if it has none.
template <class S, class Pivots>
void TimeStepper<S, Pivots>::read_contact(Index i, Index present, const PlacedPoint<S>& then,
                                          const S& h) {
  StepContact<S>& contact = m_.contacts[i];
  contact = {};
  contact.absence = m_.placed[i].absence;
  contact.position = m_.placed[i].position;
  contact.normal = m_.placed[i].normal;
  contact.ends = then.absence;
  contact.gap = then.gap;
  if (present < 0) return;
  const ContactAnswer<S>& answer = m_.work.answer.contacts[present];
  contact.mode = answer.mode;
  contact.normal_force = answer.normal_force;
  contact.friction_force = answer.friction_force;
  contact.torsion = answer.torsion;
  contact.velocity = h * answer.acceleration;
}

/// The solved push happens.
template <class S, class Pivots> void TimeStepper<S, Pivots>::commit(const S& h) {
  pose_ = moved(pose_, next_velocity_, h);
  velocity_ = next_velocity_;
  Index present = 0;
  for (Index b = 0; b < scene_->bodies.size; ++b) {
    const Body<S>& body = scene_->bodies[b];
    m_.poses[b] = moved_about_origin(m_.poses[b], end_twist(b), h);
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const bool touches = m_.placed[i].absence == Absence::none;
      read_contact(i, touches ? present : -1, placed(b, i, pose_, m_.poses[b]), h);
      present += touches ? 1 : 0;
    }
  }
  for (Index a = 0; a < m_.speeds.size; ++a) {
    m_.speeds[a] = m_.next_speeds[a];
    m_.closings[a] += h * m_.speeds[a];
  }
  time_ += h;
}

} // namespace lcpush
