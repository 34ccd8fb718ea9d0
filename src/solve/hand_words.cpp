// The hand in words: what moves the fingers, and how they move.
#include <cmath>

#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// "20 N at left and 15 N at right", or "20 N" where a single finger presses.
std::string grip_forces(const SceneFile& file) {
  std::vector<std::string> list;
  for (const Drive<double>& drive : file.drives) {
    if (file.body(drive.body).role != Role::finger) continue;
    const double force = file.actuators[static_cast<std::size_t>(drive.actuator)].force;
    list.push_back(number(force) + " N at " + file.body_name(drive.body));
  }
  return listed(list, "and");
}

std::string actuators_of_fingers(const SceneFile& file) {
  std::vector<std::string> names;
  for (std::size_t a = 0; a < file.actuators.size(); ++a)
    if (grips(file.view(), static_cast<Index>(a))) names.push_back(file.actuator_names[a]);
  return listed(names, "and");
}

std::string hand_words(const SceneFile& file) {
  switch (file.hand) {
  case Hand::fixed: break;
  case Hand::independent: return "fingers that close independently: " + grip_forces(file);
  case Hand::parallel:
    return "a parallel jaw, " + number(file.actuators.front().force / 2) + " N a finger";
  case Hand::locked:
    return "locked jaws, closed with " + number(locked_force(file)) + " N a finger";
  case Hand::actuators: {
    const std::string names = actuators_of_fingers(file);
    return names.empty() ? "fingers that stand still" : "fingers moved by " + names;
  }
  }
  return file.bodies.front().role == Role::finger ? "fingers that stand still" : "none";
}

} // namespace

Fact hand_fact(const SceneFile& file) { return {"Hand", hand_words(file)}; }

std::vector<Fact> closing_facts(const BreakReport& report) {
  std::vector<std::string> moving;
  for (const NamedValue& closing : report.closings)
    if (std::abs(closing.value) > 1e-3)
      moving.push_back(closing.name + (closing.value > 0 ? " closes by " : " is forced open by ") +
                       printed("%.3g m/s^2", std::abs(closing.value)));
  if (moving.empty()) return {};
  return {{"Fingers", listed(moving, "and") + " per m/s^2 of the push"}};
}

} // namespace lcpush::desktop
