#include "play/instant.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "scenes/facing.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

bool touches(const PointState& contact) {
  return contact.touch == Touch::sticks || contact.touch == Touch::slips ||
         contact.touch == Touch::parted;
}

/// From the scene's axes to the object's, at its centre of mass there.
Vector6<double> turned_back(const Pose<double>& pose, const Vector6<double>& twist) {
  const Vector6<double> here = twist_at(twist, pose.position);
  const Matrix3<double> back = pose.rotation.transpose();
  Vector6<double> turned;
  turned << back * here.head<3>(), back * here.tail<3>();
  return turned;
}

/// Of body `b`, the points that touch something: appended to those of `now`.
Body<double> body_at(const SceneFile& file, const MotionFrame& frame, std::size_t b,
                     const Pose<double>& pose, SceneFile& now) {
  Body<double> body = file.bodies[b];
  body.first_point = static_cast<Index>(now.points.size());
  body.acceleration = turned_back(pose, body.acceleration);
  for (const Index i : points_of(file.bodies[b])) {
    const auto of_file = static_cast<std::size_t>(i);
    const PointState& contact = frame.contacts[of_file];
    if (!touches(contact)) continue;
    if (now.points.size() == static_cast<std::size_t>(body.first_point))
      body = facing(body, pose.rotation.transpose() * contact.normal);
    const Vector3<double> from_first = contact.position - file.object.center_of_mass;
    now.points.push_back(pose.back(from_first));
    now.positions.emplace_back(now.points.back() + file.object.center_of_mass);
    if (!file.weights.empty()) now.weights.push_back(file.weights[of_file]);
  }
  body.point_count = static_cast<Index>(now.points.size()) - body.first_point;
  return body;
}

} // namespace

SceneFile scene_at(const SceneFile& file, const MotionFrame& frame) {
  Pose<double> pose = frame.pose;
  pose.position -= frame.step * frame.twist.head<3>(); // points press where the step began
  SceneFile now = file;
  now.gravity = pose.rotation.transpose() * file.gravity;
  now.bodies.clear(), now.points.clear(), now.positions.clear(), now.weights.clear();
  now.strokes.clear(), now.body_names.clear(), now.drives.clear();
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    const Body<double> body = body_at(file, frame, b, pose, now);
    for (const Drive<double>& drive : file.drives) {
      if (drive.body != static_cast<Index>(b)) continue;
      if (body.point_count == 0)
        throw InputError("at this moment " + file.body_names[b] +
                         " touches nothing: watch the pivots of another");
      now.drives.push_back(
          {static_cast<Index>(now.bodies.size()), drive.actuator, turned_back(pose, drive.twist)});
    }
    if (body.point_count == 0) continue;
    now.bodies.push_back(body);
    now.strokes.push_back(file.strokes[b]);
    now.body_names.push_back(file.body_names[b]);
  }
  return now;
}

} // namespace lcpush::desktop
