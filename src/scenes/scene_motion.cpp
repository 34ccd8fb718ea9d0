// What a scene file says about a motion: velocities, strokes, who carries the points, faces.
#include "scenes/scene_tables.hpp"

#include "lcpush/mechanics/model/contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace lcpush::desktop {
namespace {

constexpr std::size_t most_corners = 1000;

} // namespace

MotionKeys motion_keys(const TableReader& table) {
  const MotionKeys velocities{"velocity", "angular_velocity", true};
  const MotionKeys accelerations{"acceleration", "angular_acceleration", false};
  const auto has = [&](const MotionKeys& keys) {
    return table.has(keys.linear) || table.has(keys.angular);
  };
  const MotionKeys keys = has(velocities) ? velocities : accelerations;
  if (has(velocities) && has(accelerations))
    table.fail(table.has("acceleration") ? "acceleration" : "angular_acceleration",
               "a pusher has a velocity or speeds up from rest by an acceleration; keep one");
  if (table.has("about") && !table.has(keys.angular))
    table.fail("about", "about goes with angular_acceleration or angular_velocity; add one or "
                        "remove about");
  if (!has(keys) && !table.has("normal_force"))
    table.fail("acceleration", "missing the motion; add velocity, acceleration, one of the two "
                               "with angular_ before it, or normal_force (for a wall at rest "
                               "velocity = [0, 0, 0])");
  return keys;
}

Stroke read_stroke(const TableReader& table) {
  Stroke stroke;
  if (table.has("points_on"))
    stroke.rides_on_object = table.choice("points_on", {"body", "object"}) == 1;
  stroke.is_velocity = table.has("velocity") || table.has("angular_velocity");
  if (table.has("from")) stroke.from = table.number<double>("from", Sign::not_negative);
  if (table.has("until")) stroke.until = table.number<double>("until", Sign::positive);
  if (!(stroke.until > stroke.from))
    table.fail("until", "until must be later than from; times are seconds from the start");
  for (const char* key : {"from", "until"})
    if (table.has(key) && table.has("normal_force"))
      table.fail(key, std::string("normal_force presses all the time; remove ") + key);
  return stroke;
}

ObjectFace read_face(const TableReader& table, const Vector3<double>& inside) {
  ObjectFace face;
  for (const std::vector<double>& row : table.rows<double>("corners", 3, most_corners))
    face.corners.push_back({row[0], row[1], row[2]});
  const std::size_t k = face.corners.size();
  if (k < 3) table.fail("corners", "a face needs three corners or more, got " + std::to_string(k));
  Vector3<double> area = Vector3<double>::Zero(); // twice it, along the normal
  double size = 0;
  for (std::size_t i = 0; i < k; ++i) {
    const Vector3<double> from = face.corners[i] - face.corners[0];
    area += cross<double>(from, face.corners[(i + 1) % k] - face.corners[0]);
    size = std::max(size, from.norm());
  }
  if (!(area.norm() > typing_slack * typing_slack * size * size))
    table.fail("corners", "the corners lie on one line; a face needs an area");
  face.normal = area.normalized();
  for (std::size_t i = 0; i < k; ++i) {
    const Vector3<double>&at = face.corners[i], &next = face.corners[(i + 1) % k];
    if (std::abs((at - face.corners[0]).dot(face.normal)) > typing_slack * size)
      table.fail("corners", "corner " + std::to_string(i + 1) +
                                " lies beside the plane of the others; a face is flat");
    const Vector3<double> turn = cross<double>(next - at, face.corners[(i + 2) % k] - next);
    if (turn.dot(face.normal) < -typing_slack * typing_slack * size * size)
      table.fail("corners", "the face is dented at corner " + std::to_string((i + 1) % k + 1) +
                                "; give the corners in their order around it, and split what is "
                                "not convex");
  }
  if ((face.corners[0] - inside).dot(face.normal) < 0) face.normal = -face.normal;
  return face;
}

} // namespace lcpush::desktop
