// Scenes of a plan: one whose pushers keep to the faces, one in which a push slips, and the plan's
// own.
#include "plan/plan_parts.hpp"

#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lcpush::desktop {
namespace {

constexpr double typed_direction = 1e-3;
constexpr double kept_from_corners = 5e-3; // of the face's width

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Of the face with this outward normal along a direction, about the centre of mass.
std::optional<Range> face_range(const SceneFile& file, const Vector3<double>& outward,
                                const Vector3<double>& along) {
  Range range;
  for (const ObjectFace& face : file.faces)
    if ((face.normal - outward).norm() <= typed_direction)
      for (const Vector3<double>& corner : face.corners)
        range.take((corner - file.object.center_of_mass).dot(along));
  if (file.faces.empty() && file.shape.kind == ObjectShape::Kind::box)
    for (Index axis = 0; axis < 2; ++axis) {
      if (std::abs(outward[axis]) < 1 - typed_direction) continue;
      const double half = file.shape.size[1 - axis] / 2;
      range.take(-half);
      range.take(half);
    }
  if (!(range.low < range.high)) return std::nullopt;
  return range;
}

} // namespace

SceneFile along_faces(SceneFile file) {
  for (const Body<double>& body : file.bodies) {
    if (body.role != Role::pusher) continue;
    const Vector3<double> along = cross<double>(Vector3<double>::UnitZ(), body.normal);
    const std::optional<Range> face = face_range(file, -body.normal, along);
    if (!face) continue;
    const double kept = kept_from_corners * (face->high - face->low);
    const double low = face->low + kept, high = face->high - kept;
    Range pressed;
    for (const Index i : points_of(body))
      pressed.take(file.points[static_cast<std::size_t>(i)].dot(along));
    if (pressed.low >= high || pressed.high <= low) continue; // beside it altogether: refused
    // Its points stay apart: they are all drawn together.
    const double from = std::max(pressed.low, low), to = std::min(pressed.high, high);
    const double share =
        pressed.high > pressed.low ? (to - from) / (pressed.high - pressed.low) : 0;
    for (const Index i : points_of(body)) {
      const auto k = static_cast<std::size_t>(i);
      const double at = file.points[k].dot(along);
      const double by = from + share * (at - pressed.low) - at;
      file.points[k] += by * along;
      file.positions[k] += by * along;
    }
  }
  return file;
}

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

namespace {

std::string exact(double x) { return printed("%.17g", x); }
std::string listed(const Vector3<double>& v) {
  return "[" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + "]";
}

/// Without the tables of pushers.
std::string without_pushers(std::string_view text) {
  std::string kept;
  bool is_pusher = false;
  for (const std::string_view line : split_at(text, '\n')) {
    const std::string_view word = trimmed(line);
    if (!word.empty() && word.front() == '[' && line.front() == '[')
      is_pusher = word.substr(0, 10) == "[[pusher]]";
    if (!is_pusher) kept += std::string(line) + "\n";
  }
  while (kept.size() > 1 && kept[kept.size() - 2] == '\n') kept.pop_back();
  return kept;
}

/// How often the pusher has pushed before.
int turn_of(const std::vector<PlannedPush>& pushes, std::size_t k) {
  int turn = 1;
  for (std::size_t i = 0; i < k; ++i) turn += pushes[i].pusher == pushes[k].pusher ? 1 : 0;
  return turn;
}

/// The fastest point of the pusher along the way, m.
double longest_way(const SceneFile& file, const PlannedPush& push, const Arc& arc) {
  double most = 0;
  for (const Index i : points_of(file.body(push.pusher))) {
    const Vector3<double> r = turned(file.points[static_cast<std::size_t>(i)], push.from.angle);
    const Planar v = arc.velocity(0) + arc.turn() * Planar(-r.y(), r.x());
    most = std::max(most, v.norm());
  }
  return most;
}

} // namespace

std::string strokes_text(std::string_view text, const SceneFile& file,
                         std::vector<PlannedPush>& pushes, double speed, double gap) {
  std::string scene = without_pushers(text);
  double now = 0;
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    PlannedPush& push = pushes[k];
    const Body<double>& body = file.body(push.pusher);
    const Vector3<double> normal = turned(body.normal, push.from.angle);
    // What a pusher stands back it makes up for on its way.
    const double back = k > 0 ? gap : 0;
    const PlanarPose from =
        pose_at(place_of(push.from) - back * Planar(normal.x(), normal.y()), push.from.angle);
    const double planned = push.end - push.begin; // of a slipping push
    push.begin = now;
    if (push.kind == PushKind::slip) {
      push.end = now += planned;
    } else {
      const Arc arc(from, push.to);
      const double time = longest_way(file, push, arc) / speed;
      push.end = now += time;
      const Planar v = arc.velocity(0) / time;
      push.twist << v.x(), v.y(), 0, 0, 0, arc.turn() / time;
    }
    Vector3<double> velocity = push.twist.head<3>();
    if (push.kind == PushKind::slip) velocity += back / planned * normal;
    const Vector3<double> center = file.object.center_of_mass + Vector3<double>(from.x, from.y, 0);
    const int turn = turn_of(pushes, k);
    scene += "\n[[pusher]]\nname = \"" + file.body_name(push.pusher) +
             (turn > 1 ? " " + std::to_string(turn) : "") + "\"\nshape = \"points\"\npoints = [";
    const char* comma = "";
    for (const Index i : points_of(body)) {
      scene += comma +
               listed(center + turned(file.points[static_cast<std::size_t>(i)], push.from.angle));
      comma = ",\n          ";
    }
    scene += "]\nnormal = " + listed(normal) +
             "\ntangent = " + listed(turned(body.tangent, push.from.angle)) +
             "\nfriction = " + exact(body.friction) + "\nvelocity = [" + exact(velocity.x()) +
             ", " + exact(velocity.y()) + ", 0]\nangular_velocity = [0, 0, " +
             exact(push.twist[5]) + "]\nabout = " + listed(center) +
             "\nfrom = " + exact(push.begin) + "\nuntil = " + exact(push.end) + "\n";
  }
  return scene;
}

} // namespace lcpush::desktop
