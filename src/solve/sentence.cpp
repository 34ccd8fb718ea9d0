#include "solve/sentence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lcpush/desktop/naming.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// The axis (0, 1 or 2) that is nearly along `v`, in three digits, or -1.
Index axis_along(const Vector3<double>& v) {
  Index axis = 0;
  const double largest = v.cwiseAbs().maxCoeff(&axis);
  return largest > 0 && v.norm() - largest <= word_settings.digit * v.norm() ? axis : -1;
}

/// "along x", "against x"; "up" and "down" where gravity is along that axis.
std::string axis_phrase(const SceneFile& file, Index axis, bool is_positive) {
  if (axis == axis_along(file.gravity))
    return (file.gravity[axis] < 0) == is_positive ? "up" : "down";
  return std::string(is_positive ? "along " : "against ") + "xyz"[axis];
}

/// "slip" of "slips".
std::string plural_of(const std::string& verb) { return verb.substr(0, verb.size() - 1); }

struct ModeCount {
  std::array<Index, 3> of{}; ///< by Mode
  Index all() const { return of[0] + of[1] + of[2]; }
  Index operator[](Mode mode) const { return of[static_cast<std::size_t>(mode)]; }
  bool all_are(Mode mode) const { return (*this)[mode] == all(); }
};

ModeCount count_modes(const Answer<double>& answer, const Body<double>& body) {
  ModeCount count;
  for (const Index i : points_of(body))
    ++count.of[static_cast<std::size_t>(answer.contacts[i].mode)];
  return count;
}

/// "left slips", "wall opens at 1 of its 2 points and sticks at 1".
std::string body_phrase(const std::string& name, const ModeCount& count) {
  constexpr Mode order[] = {Mode::slide, Mode::separate, Mode::stick};
  std::vector<std::string> parts;
  for (const Mode mode : order) {
    if (count[mode] == 0) continue;
    parts.emplace_back(mode_verb(mode));
    if (count.all_are(mode)) continue;
    parts.back() += " at " + std::to_string(count[mode]);
    if (parts.size() == 1) parts.back() += " of its " + std::to_string(count.all()) + " points";
  }
  return name + " " + joined(parts, " and ");
}

/// Is this a finger that presses, and no table or stop?
bool is_gripping(const SceneFile& file, std::size_t b) {
  return file.bodies[b].role == Role::finger &&
         (file.bodies[b].preload > 0 || is_driven(file.view(), static_cast<Index>(b)));
}

/// "every finger point slips", "left slips, right sticks, wall opens at 1 of its 2 points". Tables
/// and stops have names.
std::string contacts_phrase(const SceneFile& file, const Answer<double>& answer) {
  ModeCount fingers;
  bool all_grip = true;
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    if (file.bodies[b].role != Role::finger) continue;
    all_grip = all_grip && is_gripping(file, b);
    for (std::size_t mode = 0; mode < 3; ++mode)
      fingers.of[mode] += count_modes(answer, file.bodies[b]).of[mode];
  }
  const bool as_one = all_grip && (fingers.all_are(Mode::slide) || fingers.all_are(Mode::stick));
  std::vector<std::string> phrases;
  if (fingers.all() > 0 && as_one)
    phrases.push_back(fingers[Mode::slide] > 0 ? "every finger point slips"
                                               : "no finger point slips");
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    if (file.bodies[b].role == Role::pusher || !as_one)
      phrases.push_back(body_phrase(file.body_names[b], count_modes(answer, file.bodies[b])));
  return listed(phrases, "and");
}

/// "sheet slides along", "wall rests at": what a pusher does that moves nothing.
std::string idle_phrase(const SceneFile& file, const BreakReport& report) {
  const Body<double>& pusher = file.body(report.pusher);
  double speed = 0, closing = 0;
  for (const Index i : points_of(pusher)) {
    const Vector3<double> motion =
        acceleration_at(file.points[static_cast<std::size_t>(i)], pusher.acceleration);
    speed = std::max(speed, motion.norm());
    closing = std::min(closing, motion.dot(pusher.normal));
  }
  const bool moves_away = closing < -word_settings.digit * speed;
  return file.body_name(report.pusher) + (!(speed > 0) ? " rests at "
                                          : moves_away ? " moves away from "
                                                       : " slides along ");
}

} // namespace

std::string direction_phrase(const SceneFile& file, const Vector3<double>& direction) {
  const Index axis = axis_along(direction);
  return axis < 0 ? "along " + components_text(direction)
                  : axis_phrase(file, axis, direction[axis] > 0);
}

std::string motion_phrase(const SceneFile& file, const RunReport& report) {
  const Motion<double>& motion = report.motion;
  bool has_grip = false;
  for (std::size_t b = 0; b < file.bodies.size(); ++b) has_grip = has_grip || is_gripping(file, b);
  const std::string in_grip = has_grip && !report.hand_moves ? " in the grip" : "";
  const std::string turn = turn_phrase(motion.axis);
  switch (motion.kind) {
  case MotionKind::rest: return "does not move" + in_grip;
  case MotionKind::slide: return "slides " + direction_phrase(file, motion.direction);
  case MotionKind::pivot: return "pivots " + turn + in_grip;
  case MotionKind::roll: return rolling_verb(file) + (" " + turn);
  case MotionKind::turn: break;
  }
  if (motion.pitch != 0) return "turns " + turn + " and advances along it";
  const bool is_near = motion.axis_point.norm() < report.scales.length;
  return (is_near ? "turns " : "slides and turns ") + turn;
}

const char* rolling_verb(const SceneFile& file) {
  return file.shape.kind == ObjectShape::Kind::box ? "tips" : "rolls";
}

std::string turn_phrase(const Vector3<double>& axis) {
  const Index k = axis_along(axis);
  if (k < 0) return "about " + components_text(axis);
  return std::string(axis[k] > 0 ? "counter-clockwise" : "clockwise") + " about " + "xyz"[k];
}

std::string object_name(const SceneFile& file) {
  switch (file.shape.kind) {
  case ObjectShape::Kind::box: return "the box";
  case ObjectShape::Kind::cylinder: return "the cylinder";
  case ObjectShape::Kind::ball: return "the ball";
  case ObjectShape::Kind::unknown: break;
  }
  return "the object";
}

const char* mode_verb(Mode mode) {
  return mode == Mode::stick ? "sticks" : mode == Mode::slide ? "slips" : "opens";
}

std::string modes_text(const Answer<double>& answer, const Body<double>& body) {
  const ModeCount count = count_modes(answer, body);
  std::vector<std::string> modes;
  for (const Mode mode : {Mode::stick, Mode::slide, Mode::separate}) {
    if (count.all_are(mode)) return mode_verb(mode);
    if (count[mode] == 1) modes.push_back(std::string("1 ") + mode_verb(mode));
    if (count[mode] > 1)
      modes.push_back(std::to_string(count[mode]) + " " + plural_of(mode_verb(mode)));
  }
  return listed(modes, "and");
}

std::string force_phrase(const SceneFile& file, const Vector3<double>& force) {
  const double size = force.norm();
  const std::string text = brief(size) + " N";
  std::vector<std::string> axes, parts;
  for (Index axis = 0; axis < 3; ++axis) {
    if (std::abs(force[axis]) <= word_settings.digit * size) continue;
    axes.push_back(axis_phrase(file, axis, force[axis] > 0));
    parts.push_back(brief(std::abs(force[axis])) + " N " + axes.back());
  }
  if (axes.empty()) return text;
  return text + (axes.size() == 1 ? " " + axes.front() : " (" + listed(parts, "and") + ")");
}

std::string push_sentence(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  std::vector<std::string> forces, names, idle;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].role != Role::pusher) continue;
    const Vector3<double> force = body_wrench(scene, report.answer, scene.bodies[b]).head<3>();
    const bool presses = force.norm() > report.noise.force;
    (presses ? names : idle).push_back(file.body_name(b));
    if (presses) forces.push_back(force_phrase(file, force));
  }
  std::vector<std::string> pushes = forces;
  if (forces.size() > 1 || !idle.empty())
    for (std::size_t k = 0; k < forces.size(); ++k) pushes[k] += " by " + names[k];
  std::string text = "Nothing pushes";
  if (!pushes.empty())
    text = "Push with " + listed(pushes, "and");
  else if (!idle.empty())
    text = listed(idle, "and") + (idle.size() > 1 ? " press" : " presses") + " on nothing";
  return text + ": " + object_name(file) + " " + motion_phrase(file, report) + ", " +
         contacts_phrase(file, report.answer) + ".";
}

namespace {

/// Of a pusher whose normal force is given, what it takes is its friction.
std::string drag_sentence(const SceneFile& file, const BreakReport& report) {
  const Vector3<double> n = file.body(report.pusher).normal,
                        whole = report.breaking.force.head<3>();
  return "The grasp breaks when " + file.body_name(report.pusher) + ", which presses with " +
         brief(report.breaking.break_force, report.noise.force) + " N as given, drags with " +
         brief((whole - whole.dot(n) * n).norm(), report.noise.force) + " N: " + object_name(file) +
         " then " + motion_phrase(file, report) + ".";
}

} // namespace

std::string break_sentence(const SceneFile& file, const BreakReport& report) {
  const double force = report.breaking.break_force;
  const bool is_given =
      std::any_of(file.drives.begin(), file.drives.end(),
                  [&](const Drive<double>& drive) { return drive.body == report.pusher; });
  if (report.breaking.breaks && is_given) return drag_sentence(file, report);
  if (report.breaking.breaks)
    return "The grasp breaks at " +
           (force < -report.noise.force
                ? "a pull of " + brief(-force) + " N by "
                : brief(force, report.noise.force) + " N, the normal force of ") +
           file.body_name(report.pusher) + ": " + object_name(file) + " then " +
           motion_phrase(file, report) + ".";
  const bool presses = force > word_settings.digit * report.scales.force;
  return "The push does not break the grasp: " + idle_phrase(file, report) + object_name(file) +
         ", which does not move" +
         (presses ? ", and presses on it with " + brief(force) + " N" : "") + ".";
}

} // namespace lcpush::desktop
