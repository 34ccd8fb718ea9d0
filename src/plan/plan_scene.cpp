#include "plan/plan_parts.hpp"

#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {
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
