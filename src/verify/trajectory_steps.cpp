#include "verify/trajectory_steps.hpp"

#include "lcpush/mechanics/model/answer.hpp"
#include "move/rotation.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

} // namespace

Vector6<double> mean_twist(const Pose<double>& from, const Pose<double>& to, double h) {
  Vector6<double> twist;
  twist << (to.position - from.position) / h,
      rotation_vector(to.rotation * from.rotation.transpose()) / h;
  return twist;
}

SeenMotion::SeenMotion(const SceneFile& file, const std::vector<TrajectoryFrame>& frames)
    : file_(file), frames_(frames), faces_(file), around_(faces_.view()), telling_(file) {}

bool SeenMotion::is_whole(std::size_t k) const {
  if (k == 0) return false;
  const double interval = frames_[k].time - frames_[k - 1].time;
  return std::abs(frames_[k].step.value_or(interval) - interval) <= Settings::interval * interval;
}

/// A velocity that is not given is the mean since the frame before, as of every implicit scheme.
std::optional<Vector6<double>> SeenMotion::twist_of(std::size_t k) const {
  if (frames_[k].twist || !is_whole(k)) return frames_[k].twist;
  return mean_twist(frames_[k - 1].pose, frames_[k].pose, frames_[k].time - frames_[k - 1].time);
}

/// A body's number is its first actuator's.
SeenMotion::Closings SeenMotion::of_actuators(std::size_t k,
                                              std::optional<double> FrameBody::*number) const {
  Closings list(file_.actuators.size());
  for (std::size_t b = 0; b < frames_[k].bodies.size(); ++b) {
    const auto first =
        std::find_if(file_.drives.begin(), file_.drives.end(), [&](const Drive<double>& drive) {
          return drive.body == static_cast<Index>(b);
        });
    if (first != file_.drives.end() && frames_[k].bodies[b].*number)
      list[static_cast<std::size_t>(first->actuator)] = frames_[k].bodies[b].*number;
  }
  return list;
}

/// As given, or as the closings since the frame before say.
SeenMotion::Closings SeenMotion::speeds_at(std::size_t k) const {
  Closings speeds = of_actuators(k, &FrameBody::closing_speed);
  if (!is_whole(k)) return speeds;
  const Closings from = closings_at(k - 1), to = closings_at(k);
  for (std::size_t a = 0; a < speeds.size(); ++a)
    if (!speeds[a] && from[a] && to[a])
      speeds[a] = (*to[a] - *from[a]) / (frames_[k].time - frames_[k - 1].time);
  return speeds;
}

SeenMotion::Closings SeenMotion::begin_closings(std::size_t k, const SeenStep& step) const {
  if (step.is_whole) return closings_at(k - 1);
  Closings closings = closings_at(k);
  for (std::size_t a = 0; a < closings.size(); ++a)
    if (closings[a] && step.speeds[a])
      *closings[a] -= step.h * *step.speeds[a];
    else
      closings[a].reset();
  return closings;
}

/// Under even pressure a driven body's points close each by itself.
bool SeenMotion::are_pads(Index body) const {
  return file_.pressure == Pressure::even && is_driven(file_.view(), body);
}

/// Does what is known of the closings say where it is?
bool SeenMotion::is_found(Index body, const Closings& closings) const {
  Index motions = file_.body(body).acceleration.squaredNorm() > 0 ? 1 : 0;
  bool is_known = true, turns = file_.body(body).acceleration.tail<3>().squaredNorm() > 0;
  for (const Drive<double>& drive : file_.drives) {
    if (drive.body != body) continue;
    ++motions;
    turns = turns || drive.twist.tail<3>().squaredNorm() > 0;
    is_known = is_known && closings[static_cast<std::size_t>(drive.actuator)];
  }
  // Where turns mix with other motions, the end depends on which went first.
  return !is_driven(file_.view(), body) || (is_known && (!turns || motions == 1));
}

Pose<double> SeenMotion::pose_of(Index body, double time, const Closings& closings) const {
  Vector6<double> path = faces_.path(body, time);
  for (const Drive<double>& drive : file_.drives)
    if (drive.body == body)
      path += closings[static_cast<std::size_t>(drive.actuator)].value_or(0) * drive.twist;
  return moved_about_origin(Pose<double>(), path, 1.0);
}

std::optional<Pose<double>> SeenMotion::driven_pose(Index body, std::size_t k) const {
  const Closings closings = closings_at(k);
  if (!is_driven(file_.view(), body) || are_pads(body) || !is_found(body, closings))
    return std::nullopt;
  return pose_of(body, frames_[k].time, closings);
}

/// Generous about ends of faces: a foreign motion's contacts may be a hair beside them. `part`: by
/// so much of the object's size less.
PlacedPoint<double> SeenMotion::placed(Index body, Index point, const Pose<double>& object,
                                       const Pose<double>& hand, double part) const {
  return place(around_, faces_.touching(body), faces_.bodies()[static_cast<std::size_t>(body)],
               file_.points[static_cast<std::size_t>(point)], object, hand, part * telling_.size);
}

/// At the hand's origin; none: what closes it is not known, and does not close along the normal.
std::optional<Vector6<double>> SeenMotion::body_twist(Index body, const SeenContact& contact,
                                                      const SeenStep& step) const {
  Vector6<double> twist =
      (faces_.path(body, step.time) - faces_.path(body, step.time - step.h)) / step.h;
  for (const Drive<double>& drive : file_.drives) {
    if (drive.body != body) continue;
    const std::optional<double>& speed = step.speeds[static_cast<std::size_t>(drive.actuator)];
    const bool is_known = speed && !are_pads(body);
    const Vector3<double> closes =
        acceleration_at(Vector3<double>(step.begin.position + contact.position), drive.twist);
    const Vector3<double> across = closes - contact.normal * contact.normal.dot(closes);
    const bool is_along = across.norm() <= Settings::along_normal * closes.norm() &&
                          !(drive.twist.tail<3>().squaredNorm() > 0);
    if (!is_known && !is_along) return std::nullopt;
    if (is_known) twist += *speed * drive.twist;
  }
  return twist;
}

/// Do its drives turn it? Then where it touches does not say how far they have closed.
bool SeenMotion::turns(Index body) const {
  return std::any_of(file_.drives.begin(), file_.drives.end(), [&](const Drive<double>& drive) {
    return drive.body == body && drive.twist.tail<3>().squaredNorm() > 0;
  });
}

/// As it is known; else where it touches: its first drive has closed until one of its points does.
Pose<double> SeenMotion::touching_pose(Index body, double time, Closings closings,
                                       const Pose<double>& object) const {
  Pose<double> hand = pose_of(body, time, closings);
  if (is_found(body, closings) || turns(body)) return hand;
  const auto drive = std::find_if(file_.drives.begin(), file_.drives.end(),
                                  [&](const Drive<double>& one) { return one.body == body; });
  std::optional<double>& closing = closings[static_cast<std::size_t>(drive->actuator)];
  double least = telling_.size;
  for (int k = 0; k < Settings::closings && std::abs(least) > Settings::closed * telling_.size;
       ++k) {
    double slope = 0;
    least = std::numeric_limits<double>::infinity();
    for (const Index i : points_of(file_.body(body))) {
      const PlacedPoint<double> point = placed(body, i, object, hand);
      if (point.gap >= least) continue;
      least = point.gap;
      slope = point.normal.dot(acceleration_at(point.position, drive->twist));
    }
    if (!(slope > Settings::closing_slope * drive->twist.norm())) break; // it does not close there
    closing = closing.value_or(0) + least / slope;
    hand = pose_of(body, time, closings);
  }
  return hand;
}

void SeenMotion::see_slip(Index b, SeenContact& contact, SeenStep& step) const {
  if (!step.twist) return;
  const Vector3<double> goes = acceleration_at(contact.position, *step.twist);
  step.fastest = std::max(step.fastest, goes.norm());
  const std::optional<Vector6<double>> body = body_twist(b, contact, step);
  if (!body) return;
  const Vector3<double> carries =
      acceleration_at(Vector3<double>(step.begin.position + contact.position), *body);
  const Vector3<double> beside = goes - carries;
  step.fastest = std::max(step.fastest, carries.norm());
  contact.slip = beside - contact.normal * contact.normal.dot(beside);
  contact.spin = contact.normal.dot(Vector3<double>(step.twist->tail<3>() - body->tail<3>()));
  const double turn =
      step.h * std::max(step.twist->tail<3>().norm(), Vector6<double>(*body).tail<3>().norm());
  contact.missed = 2 * turn * (turn * telling_.size + step.h * beside.norm());
  const Vector6<double> faster =
      faces_.prescribed(b, step.time) - faces_.prescribed(b, step.time - step.h);
  contact.unsure += acceleration_at(contact.position, faster).norm() / 2;
}

void SeenMotion::see_body(Index b, std::size_t k, const Closings& begin, const Closings& end,
                          SeenStep& step) {
  const bool is_known = !are_pads(b) && is_found(b, end);
  const Pose<double> hand = touching_pose(b, step.time - step.h, begin, step.begin),
                     hand_then = touching_pose(b, step.time, end, frames_[k].pose);
  const bool reach_their_face = are_pads(b) && faces_.touching(b).riding == Riding::on_body;
  for (const Index i : points_of(file_.body(b))) {
    SeenContact& contact = step.contacts[static_cast<std::size_t>(i)];
    const PlacedPoint<double> now = placed(b, i, step.begin, hand),
                              then = placed(b, i, frames_[k].pose, hand_then);
    const auto is_over = [](const PlacedPoint<double>& point) {
      return point.absence == Absence::none || point.absence == Absence::behind;
    };
    contact.is_placed = !turns(b) || is_found(b, begin);
    contact.touches = !is_absent(b) && (!contact.is_placed || is_over(now) || is_over(then));
    contact.position = now.position - step.begin.position;
    contact.normal = now.normal;
    if (reach_their_face) contact.position += now.gap * now.normal;
    const Vector3<double> arm = then.position - frames_[k].pose.position - contact.position;
    if (step.twist && is_over(then))
      contact.unsure = cross<double>(Vector3<double>(step.twist->tail<3>()), arm).norm();
    if (is_known && is_over(then)) contact.gap = then.gap;
    const auto is_within = [&](const Pose<double>& object, const Pose<double>& body) {
      return is_over(placed(b, i, object, body, Settings::pushed_out));
    };
    if (contact.gap && is_found(b, begin) && is_within(step.begin, hand) &&
        is_within(frames_[k].pose, hand_then))
      contact.gap_before = now.gap;
    see_slip(b, contact, step);
  }
}

SeenStep SeenMotion::step(std::size_t k) {
  const TrajectoryFrame &from = frames_[k - 1], &to = frames_[k];
  SeenStep step;
  step.time = to.time;
  step.is_whole = is_whole(k);
  step.h = to.step.value_or(to.time - from.time);
  step.twist = twist_of(k);
  step.contacts.resize(file_.points.size());
  step.speeds = speeds_at(k);
  step.speeds_before = step.is_whole ? speeds_at(k - 1) : Closings(step.speeds.size());
  if (step.is_whole) {
    step.before = twist_of(k - 1);
    step.begin = from.pose;
  } else {
    step.begin = step.twist ? moved(to.pose, *step.twist, -step.h) : to.pose;
  }
  step.begin_inertia = step.begin.rotation * file_.object.inertia * step.begin.rotation.transpose();
  step.end_inertia = to.pose.rotation * file_.object.inertia * to.pose.rotation.transpose();
  faces_.begin_strokes(step.time - step.h / 2, step.begin.rotation);
  faces_.place_strokes(step.time - step.h / 2);
  const Closings begin = begin_closings(k, step), end = closings_at(k);
  for (Index b = 0; b < static_cast<Index>(file_.bodies.size()); ++b)
    see_body(b, k, begin, end, step);
  return step;
}

Vector6<double> velocity_at(const std::vector<TrajectoryFrame>& given, std::size_t k) {
  if (given[k].twist) return *given[k].twist;
  const TrajectoryFrame& from = given[k == 0 ? 0 : k - 1];
  const TrajectoryFrame& to = given[k == 0 ? 1 : k];
  return mean_twist(from.pose, to.pose, to.time - from.time);
}

TellingPoints::TellingPoints(const SceneFile& file)
    : points(file.points.begin(), file.points.end()), size(object_size(file)) {
  Vector3<double> along = Vector3<double>::Zero();
  for (const Vector3<double>& p : points)
    if ((p - points[0]).norm() > along.norm()) along = p - points[0];
  const auto is_beside = [&](const Vector3<double>& p) {
    const Vector3<double> way = p - points[0], line = along.normalized();
    return (way - way.dot(line) * line).norm() > VerifySettings::digits * size;
  };
  if (!std::any_of(points.begin(), points.end(), is_beside))
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-size / 2, size / 2})
        points.emplace_back(side * Vector3<double>::Unit(axis));
}

Vector3<double> TellingPoints::fastest_point(const Pose<double>& object,
                                             const Vector6<double>& twist) const {
  const auto slower = [&](const Vector3<double>& a, const Vector3<double>& b) {
    const auto speed = [&](const Vector3<double>& p) {
      return acceleration_at<double>(object.rotation * p, twist).squaredNorm();
    };
    return speed(a) < speed(b);
  };
  return object.rotation * *std::max_element(points.begin(), points.end(), slower);
}

double TellingPoints::fastest(const Pose<double>& object, const Vector6<double>& twist) const {
  return acceleration_at(fastest_point(object, twist), twist).norm();
}

} // namespace lcpush::desktop
