// What holds the object before it is pushed: the hand, and with which grip force.
#include <algorithm>
#include <cmath>
#include <optional>

#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/grip_statics.hpp"
#include "solve/push_words.hpp"
#include "solve/rest_verdict.hpp"
#include "solve/sentence.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// "20 N at left and 15 N at right", or "20 N" where a single finger presses.
std::string grip_forces(const SceneFile& file) {
  std::vector<std::string> list;
  for (const Drive<double>& drive : file.drives)
    if (file.body(drive.body).role == Role::finger)
      list.push_back(number(file.actuators[static_cast<std::size_t>(drive.actuator)].force) +
                     " N at " + file.body_name(drive.body));
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
  case Hand::independent: return "fingers that close independently: " + grip_forces(file);
  case Hand::parallel:
    return "a parallel jaw, " + number(file.actuators.front().force / 2) + " N a finger";
  case Hand::locked:
    return "locked jaws, closed with " + number(locked_force(file)) + " N a finger";
  case Hand::actuators:
    if (const std::string names = actuators_of_fingers(file); !names.empty())
      return "fingers moved by " + names;
    return "fingers that stand still";
  case Hand::fixed: break;
  }
  return file.bodies.front().role == Role::finger ? "fingers that stand still" : "none";
}

/// "; table presses with 0 N, ..": of fingers across the plane that nothing closes.
std::string idle_words(const SceneFile& file) {
  std::vector<std::string> idle;
  for (std::size_t b = 0; b < file.bodies.size() && file.planar; ++b)
    if (const Body<double>& body = file.bodies[b];
        body.role == Role::finger && body.normal.head<2>().isZero(word_settings.component) &&
        !is_driven(file.view(), static_cast<Index>(b)))
      idle.push_back(file.body_names[b]);
  if (idle.empty()) return "";
  return "; " + listed(idle, "and") + (idle.size() > 1 ? " press" : " presses") +
         " with 0 N: a force across the plane is a finger's grip_force";
}

/// Do forces exist that hold it? Laws but that of pads leave open which there are.
bool may_be_held(const SceneFile& file) {
  if (file.pressure == Pressure::pad) return false;
  const std::optional<double> least = least_factor(GripStatics(file));
  return least && *least <= 1;
}

std::string subject(bool is_open) { return is_open ? "one answer of the laws" : "the grasp"; }

/// Without a full stop.
Fact hold_words(const SceneFile& file, const HoldReport& hold) {
  const std::string label = "Before the push";
  if (file.bodies.front().role == Role::pusher) return {label, "nothing grips the object"};
  if (!has_pusher(file)) return {"Pusher", "none: this is the grasp alone"};
  if (hold.status != Status::solved)
    return {label, std::string("not known: without the pusher the solve ended with \"") +
                       status_text(hold.status) + "\""};
  if (hold.holds) return {label, "the grasp holds the object"};
  return {label, subject(may_be_held(hand_at_rest(file))) +
                     " does NOT hold the object: it accelerates at " +
                     acceleration_text(hold.acceleration, hold.length, Telling::full)};
}

/// "1.962 N per finger (of 20 N)", "a force of 1.962 (of 20) of actuator hand": that may turn its
/// bodies, so no unit is named.
std::string amount(const GripReport& report, double factor) {
  const double zero = word_settings.rounding * std::abs(report.force);
  const std::string now = number(factor * report.force, zero), whole = number(report.force);
  if (report.of_actuator) return "a force of " + now + " (of " + whole + ") " + report.of;
  return now + " N " + report.of + " (of " + whole + " N)";
}

/// From which force on it would hold, or down to which: "from 1.962 N per finger (of 1 N)".
std::string limit(const GripReport& report, const SmallestGrip& grip, bool holds) {
  if (grip.certain <= word_settings.rounding) return "without any grip force";
  const char* word = holds ? "down to " : "with ";
  // A beginning only where it holds with more, and not where less is what it takes.
  if (!holds && grip.factor > 1 && grip.more == MoreGrip::holds) word = "from ";
  if (!holds && grip.more == MoreGrip::drops) word = "only at about ";
  return word + amount(report, grip.certain);
}

/// The end of the line that says whether it holds, and where the pressure law, and not statics,
/// sets the limit.
std::string ending(const SceneFile& file, const GripReport& report, const SmallestGrip& grip,
                   bool holds, bool is_open) {
  std::string text = holds ? "; it" : ".\nIt";
  switch (grip.source) {
  case GripSource::no_grip:
    return std::string(holds ? "; no" : ".\nNo") + " grip force would hold it.";
  case GripSource::not_searched: return text + "s smallest grip was not searched for.";
  case GripSource::not_known:
    return text + "s smallest grip is not known" +
           (grip.bound > 0 ? ", but more than " + amount(report, grip.bound) : "") + ".";
  case GripSource::statics:
  case GripSource::search: break;
  }
  if (!holds && is_open)
    return ".\nOther forces that the laws allow hold it, from " + amount(report, grip.bound) + ".";
  text += (holds ? " holds " : " would hold ") + limit(report, grip, holds) + ".";
  if (grip.factor < (1 - word_settings.digit) * grip.certain)
    text += "\nBelow that some grips hold it and some do not: it holds with " +
            amount(report, grip.factor) + ".";
  const bool is_of_law = grip.bound < (1 - word_settings.digit) * grip.factor;
  if (grip.source == GripSource::search && grip.bound > 0 && is_of_law)
    text += (has_patches(file) ? "\nThat is this pressure law's limit; statics" : "\nStatics") +
            std::string(" alone would allow ") + amount(report, grip.bound) + ".";
  return text;
}

/// To three digits.
bool same_answer(const SmallestGrip& a, const SmallestGrip& b) {
  if (!a.is_known() || !b.is_known()) return a.source == b.source;
  return std::abs(a.certain - b.certain) <= word_settings.digit * std::abs(a.certain);
}

} // namespace

std::string acceleration_text(const Vector6<double>& a, double length, Telling telling) {
  const double linear = a.head<3>().norm(), angular = a.tail<3>().norm();
  const bool full = telling == Telling::full;
  const double least = full ? word_settings.rounding : word_settings.digit;
  std::vector<std::string> parts;
  if (linear > least * length * angular)
    parts.push_back((full ? number(linear) : brief(linear)) + " m/s^2");
  if (length * angular > least * linear)
    parts.push_back((full ? number(angular) : brief(angular)) + " rad/s^2");
  return listed(parts, "and");
}

bool has_patches(const SceneFile& file) {
  return std::any_of(file.bodies.begin(), file.bodies.end(), [](const Body<double>& body) {
    return body.role == Role::finger && body.point_count > 1;
  });
}

bool has_pusher(const SceneFile& file) { return file.bodies.back().role == Role::pusher; }

Fact hand_fact(const SceneFile& file) { return {"Hand", hand_words(file) + idle_words(file)}; }

Fact hold_fact(const SceneFile& file, const HoldReport& hold) {
  const Fact fact = hold_words(file, hold);
  return {fact.label, fact.text + "."};
}

Fact grip_fact(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
               const BreakReport& report) {
  if (grip.force == 0) return hold_fact(file, hold); // nothing grips
  Fact fact = hold_words(file, hold);
  const bool is_known = hold.status == Status::solved, holds = report.status == Status::solved;
  fact.text +=
      is_known ? ending(file, grip, grip.alone, hold.holds, may_be_held(hand_at_rest(file))) : ".";
  if (!holds && report.status != Status::does_not_hold) return fact;
  if (is_known && hold.holds == holds && same_answer(grip.alone, grip.at_rest)) return fact;
  fact.text += std::string("\nWith the pusher in place, at rest, it ") +
               (holds ? "holds" : "does NOT hold") +
               ending(file, grip, grip.at_rest, holds, may_be_held(file));
  return fact;
}

std::string does_not_hold_text(const SceneFile& file, const BreakReport& report) {
  const bool is_open =
      may_be_held(file) || (file.pressure == Pressure::pad && rests_by_less_friction(file));
  return (is_open ? "One answer of the laws" : "The grasp") + std::string(" does not hold ") +
         object_name(file) + ", so no force just breaks it: with the pusher in place, at rest, " +
         object_name(file) + " already accelerates at " +
         acceleration_text(report.breaking.rest, report.scales.length, Telling::brief) +
         (is_open ? ". Other forces that the laws allow hold it." : ".");
}

std::string hold_sentence(const SceneFile& file, const HoldReport& hold) {
  return "Without the push " + subject(may_be_held(hand_at_rest(file))) + " does not hold " +
         object_name(file) + ": it accelerates at " +
         acceleration_text(hold.acceleration, hold.length, Telling::brief) + ".";
}

} // namespace lcpush::desktop
