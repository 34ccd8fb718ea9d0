#include "solve/sentence.hpp"
#include "solve/told_force.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

// What is said in three digits leaves out what a thousandth of the whole is.
constexpr double unsaid = 1e-3;

/// Which way gravity points: 0, 1 or 2 for an axis, or -1.
Index vertical_axis(const SceneFile& file) {
  Index axis = 0;
  const double largest = file.gravity.cwiseAbs().maxCoeff(&axis);
  return largest > 0 && file.gravity.norm() - largest <= unsaid * largest ? axis : -1;
}

/// "along x", "against x", "up".
std::string axis_phrase(const SceneFile& file, Index axis, bool is_positive) {
  if (axis == vertical_axis(file)) return (file.gravity[axis] < 0) == is_positive ? "up" : "down";
  return std::string(is_positive ? "along " : "against ") + "xyz"[axis];
}

/// "(0.924, -0.383, 0)", a unit vector.
std::string unit_text(const Vector3<double>& v) {
  const auto digits = [](double x) { return brief(std::abs(x) < unsaid ? 0 : x); };
  return "(" + digits(v[0]) + ", " + digits(v[1]) + ", " + digits(v[2]) + ")";
}

std::string direction_phrase(const SceneFile& file, const Vector3<double>& direction) {
  Index axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&axis);
  if (largest > 1 - unsaid) return axis_phrase(file, axis, direction[axis] > 0);
  return "along " + unit_text(direction);
}

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
  std::vector<std::string> deeds;
  for (const Mode mode : order) {
    if (count[mode] == 0) continue;
    std::string deed = mode_verb(mode);
    if (!count.all_are(mode)) deed += " at " + std::to_string(count[mode]);
    if (!count.all_are(mode) && deeds.empty())
      deed += " of its " + std::to_string(count.all()) + " points";
    deeds.push_back(deed);
  }
  return name + " " + joined(deeds, " and ");
}

} // namespace

std::string turn_phrase(const Vector3<double>& axis) {
  Index k = 0;
  const double largest = axis.cwiseAbs().maxCoeff(&k);
  if (largest > 1 - unsaid)
    return std::string(axis[k] > 0 ? "counter-clockwise" : "clockwise") + " about " + "xyz"[k];
  return "about " + unit_text(axis);
}

std::string object_name(const SceneFile& file) {
  switch (file.shape.kind) {
  case ObjectShape::Kind::box: return "the box";
  case ObjectShape::Kind::cylinder: return "the cylinder";
  case ObjectShape::Kind::unknown: break;
  }
  return "the object";
}

const char* mode_verb(Mode mode) {
  return mode == Mode::stick ? "sticks" : mode == Mode::slide ? "slips" : "opens";
}

std::string force_phrase(const SceneFile& file, const Vector3<double>& force) {
  const double size = force.norm();
  const std::string text = brief(size) + " N";
  std::vector<std::string> ways, parts;
  for (Index axis = 0; axis < 3; ++axis) {
    if (std::abs(force[axis]) <= unsaid * size) continue;
    ways.push_back(axis_phrase(file, axis, force[axis] > 0));
    parts.push_back(brief(std::abs(force[axis])) + " N " + ways.back());
  }
  if (ways.empty()) return text;
  return text + (ways.size() == 1 ? " " + ways.front() : " (" + listed(parts, "and") + ")");
}

std::string motion_phrase(const SceneFile& file, const RunReport& report) {
  const Motion<double>& motion = report.motion;
  const char* const in_grip = report.hand_moves ? "" : " in the grip";
  switch (motion.kind) {
  case MotionKind::rest: return std::string("does not move") + in_grip;
  case MotionKind::slide: return "slides " + direction_phrase(file, motion.direction);
  case MotionKind::pivot: return "pivots " + turn_phrase(motion.axis) + in_grip;
  case MotionKind::roll: return "rolls " + turn_phrase(motion.axis);
  case MotionKind::turn: break;
  }
  if (motion.pitch != 0) return "turns " + turn_phrase(motion.axis) + " and advances along it";
  const double lever = motion.axis_point.norm();
  if (lever < report.scales.length) return "turns " + turn_phrase(motion.axis);
  return "slides and turns " + turn_phrase(motion.axis);
}

std::string contacts_phrase(const SceneFile& file, const Answer<double>& answer) {
  ModeCount fingers;
  for (const Body<double>& body : file.bodies)
    if (body.role == Role::finger)
      for (std::size_t mode = 0; mode < 3; ++mode)
        fingers.of[mode] += count_modes(answer, body).of[mode];
  const bool as_one = fingers.all_are(Mode::slide) || fingers.all_are(Mode::stick);
  std::vector<std::string> phrases;
  if (fingers.all() > 0 && as_one)
    phrases.push_back(fingers[Mode::slide] > 0 ? "every finger point slips"
                                               : "no finger point slips");
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    if (file.bodies[b].role == Role::pusher || !as_one)
      phrases.push_back(body_phrase(file.body_names[b], count_modes(answer, file.bodies[b])));
  return listed(phrases, "and");
}

std::string push_sentence(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  std::vector<std::string> forces, names, idle;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].role != Role::pusher) continue;
    const Vector3<double> force = body_wrench(scene, report.answer, scene.bodies[b]).head<3>();
    const bool presses = force.norm() > 1e-9 * told_force(file, report.scales);
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

/// What a pusher does that moves nothing.
std::string idle_phrase(const SceneFile& file, const BreakReport& report) {
  const Body<double>& pusher = file.body(report.pusher);
  double speed = 0, closing = 0;
  for (const Index i : points_of(pusher)) {
    const Vector3<double> motion =
        acceleration_at(file.points[static_cast<std::size_t>(i)], pusher.acceleration);
    speed = std::max(speed, motion.norm());
    closing = std::min(closing, motion.dot(pusher.normal));
  }
  if (!(speed > 0)) return " rests at ";
  return closing < -unsaid * speed ? " moves away from " : " slides along ";
}

std::string idle_sentence(const SceneFile& file, const BreakReport& report) {
  const double force = report.breaking.break_force;
  return "The push does not break the grasp: " + file.body_name(report.pusher) +
         idle_phrase(file, report) + object_name(file) + ", which does not move" +
         (force > unsaid * report.scales.force ? ", and presses on it with " + brief(force) + " N"
                                               : "") +
         ".";
}

} // namespace

std::string break_sentence(const SceneFile& file, const BreakReport& report) {
  if (!report.breaking.breaks) return idle_sentence(file, report);
  const double force = report.breaking.break_force; // 0 where rounding is all there is
  return "The grasp breaks at " +
         brief(std::abs(force) > 1e-12 * report.scales.force ? force : 0.0) +
         " N, the normal force of " + file.body_name(report.pusher) + ": " + object_name(file) +
         " then " + motion_phrase(file, report) + ".";
}

} // namespace lcpush::desktop
