#include "plan/plan_parts.hpp"

#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

constexpr double steps = 30;

/// The scene in the axes that the object has there: the fingers are elsewhere, the pushers where
/// they touch it, and the load pulls along another direction.
SceneFile seen_from_object(const SceneFile& file, const PlanarPose& pose) {
  SceneFile there = file;
  const Vector3<double> center(pose.x, pose.y, 0);
  for (const Body<double>& body : file.bodies) {
    if (body.role != Role::finger) continue;
    for (const Index i : points_of(body)) {
      const auto k = static_cast<std::size_t>(i);
      there.points[k] = turned(Vector3<double>(file.points[k] - center), -pose.angle);
      there.positions[k] = file.object.center_of_mass + there.points[k];
    }
  }
  there.gravity = turned(file.gravity, -pose.angle);
  there.object.wrench.head<3>() =
      turned(Vector3<double>(file.object.wrench.head<3>()), -pose.angle);
  return there;
}

} // namespace

std::optional<PlanarPose> slid(const SceneFile& file, Index body, const PlanarPose& from,
                               const Slip& slip) {
  SceneFile there = seen_from_object(file, from);
  for (std::size_t b = 0; b < there.bodies.size(); ++b) {
    if (there.bodies[b].role != Role::pusher) continue;
    Stroke& stroke = there.strokes[b];
    stroke.from = static_cast<Index>(b) == body ? 0 : 2 * slip.time;
    stroke.until = std::numeric_limits<double>::infinity();
    stroke.is_velocity = true;
    const Planar v = turned(slip.velocity, -from.angle);
    there.bodies[b].acceleration << v.x(), v.y(), 0, 0, 0, slip.turn;
  }
  MoveOptions options;
  options.time = slip.time;
  options.step = slip.time / steps;
  options.frames = 2;
  const MotionReport motion = move(there, options);
  if (motion.end != MoveEnd::time) return std::nullopt;
  const Pose<double>& end = motion.frames.back().pose;
  const Planar way = turned(Planar(end.position.x(), end.position.y()), from.angle);
  return PlanarPose{from.x + way.x(), from.y + way.y(),
                    from.angle + std::atan2(end.rotation(1, 0), end.rotation(0, 0))};
}

} // namespace lcpush::desktop
