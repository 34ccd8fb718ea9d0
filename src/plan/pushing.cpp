#include "plan/pushing.hpp"

#include "cone/motion_cone.hpp"
#include "cone/pusher_cone.hpp"
#include "draw/view.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/naming.hpp"
#include "scenes/object_surface.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double room_kept = 0.01;    // of the wrench: a sticking push is no close shave
constexpr double way_between = 0.002; // m, at the object's size: where an arc is looked at
constexpr double most_parts = 1e5;
constexpr std::size_t most_pushers = 32;
constexpr double typed_place = 1e-2;
constexpr double on_the_rim = 1e-9; // m

/// Corners of what the fingers press on, about the centre of mass.
std::vector<Planar> face_under_fingers(const SceneFile& file) {
  std::vector<Planar> corners;
  for (const ObjectFace& face : file.faces)
    if (std::abs(face.normal.z()) > 0.5)
      for (const Vector3<double>& corner : face.corners)
        corners.push_back((corner - file.object.center_of_mass).head<2>());
  if (!corners.empty()) return hull(corners);
  const Vector3<double> half = file.shape.size / 2;
  if (file.shape.kind == ObjectShape::Kind::box)
    return {
        {-half.x(), -half.y()}, {half.x(), -half.y()}, {half.x(), half.y()}, {-half.x(), half.y()}};
  if (file.shape.kind == ObjectShape::Kind::cylinder && file.shape.axis == 2)
    for (int k = 0; k < 64; ++k)
      corners.push_back(turned(Planar(half.x(), 0), 6.283185307179586 * k / 64));
  return corners;
}

/// A plan has each pusher push where the scene has it touch.
void refuse_apart(const SceneFile& file, Index b, double length) {
  if (!file.faces.empty() || file.shape.kind == ObjectShape::Kind::unknown) return;
  for (const Index i : points_of(file.body(b))) {
    Vector3<double> at = file.positions[static_cast<std::size_t>(i)];
    at.z() = file.object.center_of_mass.z();
    const double off = nearest_on_surface(file, at, 0).distance;
    if (std::abs(off) > typed_place * length)
      throw InputError(file.lines.file, file.lines.bodies[static_cast<std::size_t>(b)].place,
                       "pusher " + quoted(file.body_name(b)) + ": " + point_name(file, i) +
                           " stands " + millimetres(std::abs(off)) + " " +
                           (off > 0 ? "off" : "inside") +
                           " the object; a plan has each pusher push where the scene has it "
                           "touch: move it there");
  }
}

} // namespace

Pushing::Pushing(const SceneFile& file, const std::vector<SceneFile>& corners)
    : file_(file), length_(planar_reach(file)), grip_(file), face_(face_under_fingers(file)),
      load_(planar_load(file, length_)) {
  if (!file.planar)
    throw InputError(file.lines.file, file.lines.object,
                     "a plan moves the object in the plane: say planar = true, if it moves in the "
                     "x-y plane, between fingers that press along z");
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const Body<double>& body = file.body(b);
    if (body.role != Role::pusher) continue;
    refuse_no_cone(file, b);
    refuse_apart(file, b, length_);
    Pusher pusher{b, pusher_cone(file, b, length_), 0, 0, 1};
    pusher.share = (pusher.cone.edges.front().force - body.normal).norm() / body.friction;
    double low = 1e300, high = -1e300;
    for (const Index i : points_of(body)) {
      const Vector3<double>& p = file.points[static_cast<std::size_t>(i)];
      low = std::min(low, p.dot(pusher.cone.along));
      high = std::max(high, p.dot(pusher.cone.along));
      pusher.standoff = p.dot(body.normal);
    }
    pusher.middle = (low + high) / 2;
    pushers_.push_back(std::move(pusher));
  }
  if (pushers_.size() > most_pushers)
    throw InputError(file.lines.file, file.lines.object, "more than 32 pushers are no plan's");
  if (pushers_.empty())
    throw InputError(file.lines.file, file.lines.object,
                     "a plan pushes against the scene's pushers, and there is none: add a "
                     "[[pusher]] for each feature of the environment");
  refuse_single_place(file, LimitSurface(grip_, length_));
  for (const SceneFile& corner : corners) {
    corners_.push_back({GripPoints(corner), planar_load(corner, length_), {}});
    for (const Pusher& pusher : pushers_)
      corners_.back().cones.push_back(pusher_cone(corner, pusher.body, length_));
  }
}

std::vector<bool> Pushing::touching(const PlanarPose& pose) const {
  std::vector<bool> touches(grip_.size(), true);
  for (std::size_t i = 0; i < grip_.size(); ++i) {
    const Vector3<double>& finger = grip_.place(i);
    const Planar p = turned(Planar(finger.x() - pose.x, finger.y() - pose.y), -pose.angle);
    for (std::size_t k = 0; k < face_.size(); ++k) {
      const Planar a = face_[k], along = face_[(k + 1) % face_.size()] - a;
      const double inside = along.x() * (p.y() - a.y()) - along.y() * (p.x() - a.x());
      if (inside < -on_the_rim * along.norm()) touches[i] = false;
    }
  }
  return touches;
}

bool Pushing::touches_whole(const PlanarPose& pose) const {
  const std::vector<bool> touches = touching(pose);
  return std::find(touches.begin(), touches.end(), false) == touches.end();
}

bool Pushing::holds(const PlanarPose& pose) const {
  const std::vector<bool> touches = touching(pose);
  const auto is_held = [&](const GripPoints& points, const Vector3<double>& load) {
    const LimitSurface grip(points, length_, {pose.x, pose.y, 0}, pose.angle, touches);
    return grip.touches_everywhere() && grip.is_solid() &&
           grip.share_of(turned(load, -pose.angle)) < 1;
  };
  return is_held(grip_, load_) &&
         std::all_of(corners_.begin(), corners_.end(),
                     [&](const Corner& corner) { return is_held(corner.grip, corner.load); });
}

std::optional<Vector3<double>> Pushing::wrench(const GripPoints& points,
                                               const Vector3<double>& load, const PlanarPose& pose,
                                               const Planar& velocity, double turn) const {
  const LimitSurface grip(points, length_, {pose.x, pose.y, 0}, pose.angle, touching(pose));
  if (!grip.touches_everywhere()) return std::nullopt;
  const Planar v = turned(velocity, -pose.angle);
  const Vector3<double> twist(v.x(), v.y(), turn * length_);
  return Vector3<double>(grip.resistance(beside(twist)) - turned(load, -pose.angle));
}

/// [T.20] Between the corners it then does as well.
bool Pushing::sticks_at_corners(std::size_t pusher, const PlanarPose& pose, const Planar& velocity,
                                double turn) const {
  return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& corner) {
    const auto w = wrench(corner.grip, corner.load, pose, velocity, turn);
    return w && corner.cones[pusher].room(*w) >= room_kept;
  });
}

bool Pushing::presses(const Pusher& pusher, const PlanarPose& pose, const Planar& velocity,
                      double turn) const {
  const Body<double>& body = file_.body(pusher.body);
  const Planar v = turned(velocity, -pose.angle);
  for (const Index i : points_of(body)) {
    const Vector3<double>& p = file_.points[static_cast<std::size_t>(i)];
    if ((v.x() - turn * p.y()) * body.normal.x() + (v.y() + turn * p.x()) * body.normal.y() > 0)
      return true;
  }
  return false;
}

unsigned Pushing::sticking(const Arc& arc) const {
  unsigned left = 0;
  for (std::size_t k = 0; k < pushers_.size(); ++k)
    if (!pushers_[k].cone.faces.empty())
      left |= 1U << k; // at one place it turns the object as it may
  const auto look = [&](double share) {
    const PlanarPose pose = arc.at(share);
    const Planar velocity = arc.velocity(share);
    const auto w = wrench(pose, velocity, arc.turn());
    for (std::size_t k = 0; k < pushers_.size(); ++k) {
      if ((left >> k & 1U) == 0) continue;
      if (!w || pushers_[k].cone.room(*w) < room_kept ||
          !presses(pushers_[k], pose, velocity, arc.turn()) ||
          !sticks_at_corners(k, pose, velocity, arc.turn()))
        left &= ~(1U << k);
    }
  };
  const int parts =
      static_cast<int>(std::clamp(std::ceil(way(arc) / way_between), 2.0, most_parts));
  look(0);
  if (left != 0) look(1);
  for (int i = 1; i < parts && left != 0; ++i) look(static_cast<double>(i) / parts);
  return left;
}

Arc Pushing::mixed(std::size_t k, const PlanarPose& pose, const std::vector<double>& shares,
                   double way) const {
  const LimitSurface grip(grip_, length_, {pose.x, pose.y, 0}, pose.angle, touching(pose));
  const Vector3<double> load = turned(load_, -pose.angle);
  Vector3<double> sum = Vector3<double>::Zero();
  for (std::size_t i = 0; i < shares.size(); ++i)
    sum += shares[i] * grip.crossing(load, pushers_[k].cone.edges[i].wrench).twist.normalized();
  sum *= way / (sum.head<2>().norm() + std::abs(sum.z()));
  return {pose, turned(Planar(sum.x(), sum.y()), pose.angle), sum.z() / length_};
}

PushNeeds Pushing::needs(std::size_t k, const Arc& arc) const {
  const Pusher& pusher = pushers_[k];
  const Vector3<double>&n = file_.body(pusher.body).normal, &t = pusher.cone.along;
  PushNeeds needs;
  constexpr int parts = 64;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    const PlanarPose pose = arc.at(share);
    const auto w = wrench(pose, arc.velocity(share), arc.turn());
    if (!w) continue;
    const double pressed = w->x() * n.x() + w->y() * n.y(),
                 dragged = w->x() * t.x() + w->y() * t.y();
    const double at = (pusher.standoff * dragged - w->z() * length_) / pressed;
    needs.friction = std::max(needs.friction, std::abs(dragged / pressed) / pusher.share);
    needs.reach = std::max(needs.reach, std::abs(at - pusher.middle));
    const Vector3<double> load = turned(load_, -pose.angle);
    const auto sticks = between_faces(pusher.cone, *w + load, load);
    if (sticks) needs.grip = std::max(needs.grip, sticks->least);
    const LimitSurface held(grip_, length_, {pose.x, pose.y, 0}, pose.angle, touching(pose));
    needs.grip = std::max(needs.grip, held.share_of(load)); // with less it falls
  }
  return needs;
}

} // namespace lcpush::desktop
