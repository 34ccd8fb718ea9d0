#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/grip_search.hpp"
#include "solve/grip_statics.hpp"
#include "solve/rest_verdict.hpp"
#include "solve/self_stress.hpp"
#include "text/limits.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

bool grips(const SceneFile& file, std::size_t actuator) {
  return grips(file.view(), static_cast<Index>(actuator));
}

/// What a locked finger would press with, in the preload's unit, if it had to equal the load.
double load_over_preload(const SceneFile& file) {
  const AssembledScene assembled(file.view());
  const double length = assembled.assembly.layout().scales.length;
  return file.object.mass * load_acceleration(file, length) / locked_force(file);
}

SmallestGrip smallest(const SceneFile& file, Index most_unknowns, const CountingWatcher& work,
                      double known, const Precision& precision, const GripQuestion& holds) {
  SmallestGrip grip;
  grip.source = GripSource::not_searched;
  if (size_of(EvenScene(file.view()).scene).unknowns() > most_unknowns) return grip;
  std::optional<double> bound = 0;
  double unit = 0;
  bool is_statics = false; // laws that leave forces open hold what statics can
  if (file.hand == Hand::locked) {
    unit = load_over_preload(file); // statics lets locked fingers squeeze with any force
  } else {
    const GripStatics statics(file);
    unit = statics.unit();
    bound = least_factor(statics);
    is_statics = !statics.has_pads() && !is_squeezed(file, statics);
  }
  if (bound && std::isfinite(*bound)) {
    if (is_statics) {
      grip.bound = grip.factor = grip.certain = *bound;
      grip.source = GripSource::statics;
    } else {
      grip = search_upwards(*bound, unit, known, precision, work, holds);
    }
    const bool holds_now = known > 0;
    if (!holds_now && grip.factor > 0 && !work.is_used_up())
      grip.more = !holds(1.01 * grip.factor) ? MoreGrip::drops
                  : holds(2 * grip.factor)   ? MoreGrip::holds
                                             : MoreGrip::not_known;
    return grip;
  }
  grip.source = bound ? GripSource::no_grip : GripSource::not_known;
  return grip;
}

/// The first body that an actuator with a force grips with.
const Drive<double>* first_grip(const SceneFile& file) {
  const Drive<double>* first = nullptr;
  for (const Drive<double>& drive : file.drives) {
    const auto actuator = static_cast<std::size_t>(drive.actuator);
    const bool counts = grips(file, actuator) && file.actuators[actuator].force != 0;
    if (counts && (first == nullptr || drive.body < first->body)) first = &drive;
  }
  return first;
}

} // namespace

SceneFile with_grip(SceneFile file, double factor) {
  for (std::size_t a = 0; a < file.actuators.size(); ++a)
    if (grips(file, a)) file.actuators[a].force *= factor;
  for (Body<double>& body : file.bodies) body.preload *= factor;
  return file;
}

double locked_force(const SceneFile& file) {
  double force = 0;
  for (const Body<double>& body : file.bodies) force = std::max(force, body.preload);
  return force;
}

SceneFile hand_at_rest(const SceneFile& file) {
  SceneFile alone = file;
  std::size_t bodies = 0, points = 0; // fingers come first
  for (; bodies < file.bodies.size() && file.bodies[bodies].role == Role::finger; ++bodies) {
    points += static_cast<std::size_t>(file.bodies[bodies].point_count);
    alone.bodies[bodies].acceleration.setZero();
  }
  alone.bodies.resize(bodies);
  alone.body_names.resize(bodies);
  alone.patches.resize(std::min(bodies, alone.patches.size()));
  alone.points.resize(points);
  alone.positions.resize(points);
  alone.weights.resize(std::min(points, alone.weights.size()));
  alone.actuators.clear();
  alone.actuator_names.clear();
  alone.drives.clear();
  for (std::size_t a = 0; a < file.actuators.size(); ++a) {
    if (!grips(file, a)) continue;
    for (Drive<double> drive : file.drives) {
      const bool of_hand = static_cast<std::size_t>(drive.body) < bodies;
      if (static_cast<std::size_t>(drive.actuator) != a || !of_hand) continue;
      drive.actuator = static_cast<Index>(alone.actuators.size());
      alone.drives.push_back(drive);
    }
    alone.actuators.push_back(file.actuators[a]);
    alone.actuator_names.push_back(file.actuator_names[a]);
  }
  return alone;
}

GripReport named_grip(const SceneFile& file) {
  GripReport report;
  if (file.hand == Hand::locked) {
    report.force = locked_force(file);
    report.of = "per finger";
    return report;
  }
  const Drive<double>* const first = first_grip(file);
  if (first == nullptr) return report;
  const auto actuator = static_cast<std::size_t>(first->actuator);
  const std::string& name = file.actuator_names[actuator];
  report.force = file.actuators[actuator].force;
  report.of = "per finger";
  if (file.hand == Hand::parallel) {
    report.force /= 2;
    return report;
  }
  // Names are unique, so only a grip_force's actuator shares its body's.
  report.of_actuator = name != file.body_name(first->body);
  bool same = true;
  std::size_t forces = 0;
  for (std::size_t a = 0; a < file.actuators.size(); ++a) {
    if (!grips(file, a) || file.actuators[a].force == 0) continue;
    ++forces;
    same = same && file.actuators[a].force == report.force;
  }
  if (forces > 1 && same && !report.of_actuator) return report;
  report.of = (report.of_actuator ? "of actuator " : "at ") + name;
  if (forces > 1) report.of += ", the others in proportion";
  return report;
}

GripReport find_smallest_grip(const SceneFile& file, const HoldReport& hold,
                              const BreakReport& broken, const PushOptions& options) {
  GripReport report = named_grip(file);
  if (report.force == 0) return report;
  const SceneFile alone = hand_at_rest(file);
  const bool holds_now = hold.status == Status::solved && hold.holds;
  CountingWatcher work(options);
  report.alone = smallest(alone, limits::unknowns_holding, work, holds_now ? 1 : 0, {1e-9, 1e6},
                          [&](double factor) {
                            const SceneFile there = with_grip(alone, factor);
                            Push push(there);
                            const HoldReport at = push.holds_without_push(work.options());
                            return at.status == Status::solved && at.holds;
                          });
  if (broken.status != Status::solved && broken.status != Status::does_not_hold) return report;
  CountingWatcher pushed(options);
  report.at_rest =
      smallest(file, limits::unknowns_grip, pushed, broken.status == Status::solved ? 1 : 0,
               {1e-6, 1e4}, [&](double factor) {
                 const SceneFile there = with_grip(file, factor);
                 Push push(there);
                 const BreakReport at = push.find_breaking(broken.pusher, pushed.options());
                 return at.status == Status::solved;
               });
  return report;
}

} // namespace lcpush::desktop
