// With which grip force a grasp holds, in words.
#include "solve/push_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// "1.962 N per finger (of 20 N)", "a force of 1.962 (of 20) of actuator hand": that may turn its
/// bodies, so no unit is named.
std::string amount(const GripReport& report, double factor) {
  const double zero = 1e-9 * std::abs(report.force);
  const std::string now = number(factor * report.force, zero), whole = number(report.force);
  if (report.of_actuator) return "a force of " + now + " (of " + whole + ") " + report.of;
  return now + " N " + report.of + " (of " + whole + " N)";
}

/// From which force on it would hold, or down to which: "from 1.962 N per finger (of 1 N)".
std::string limit(const GripReport& report, const SmallestGrip& grip, bool holds) {
  if (grip.factor * std::abs(report.force) <= 1e-9 * std::abs(report.force))
    return "without any grip force";
  std::string word = holds ? "down to " : "with ";
  // A beginning only where it holds with more, and not where less is what it takes.
  if (!holds && grip.factor > 1 && grip.more == MoreGrip::holds) word = "from ";
  if (!holds && grip.more == MoreGrip::drops) word = "only at about ";
  if (holds && grip.gap > grip.factor) word = "with as little as ";
  return word + amount(report, grip.factor);
}

/// The end of the line that says whether it holds.
std::string ending(const GripReport& report, const SmallestGrip& grip, bool holds) {
  const std::string next = holds ? "; " : std::string(".\n"), it = holds ? "it" : "It";
  switch (grip.source) {
  case GripSource::no_grip: return next + (holds ? "no" : "No") + " grip force would hold it.";
  case GripSource::not_searched: return next + it + "s smallest grip was not searched for.";
  case GripSource::not_known:
    return next + it + "s smallest grip is not known" +
           (grip.bound > 0 ? ", but more than " + amount(report, grip.bound) : "") + ".";
  case GripSource::statics:
  case GripSource::search: break;
  }
  return next + it + (holds ? " holds " : " would hold ") + limit(report, grip, holds) + ".";
}

/// Where the pressure law, and not statics, sets the limit.
std::string law_line(const GripReport& report, const SmallestGrip& grip) {
  std::string line;
  if (grip.gap > grip.factor)
    line = "\nNot with every grip above that: with " + amount(report, grip.gap) + " it does not.";
  if (grip.source != GripSource::search || !(grip.bound > 0)) return line;
  return line + "\nThat is this pressure law's limit; statics alone would allow " +
         amount(report, grip.bound) + ".";
}

bool same_answer(const GripReport& report, bool holds_alone, bool holds_at_rest) {
  const SmallestGrip &a = report.alone, &b = report.at_rest;
  return holds_alone == holds_at_rest && a.source == b.source &&
         std::abs(a.factor - b.factor) <= 1e-6 * std::abs(a.factor);
}

} // namespace

Fact grip_fact(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
               const BreakReport& report) {
  if (grip.force == 0) return hold_fact(file, hold); // nothing grips
  Fact fact = hold_words(file, hold);
  std::string& text = fact.text;
  text += hold.status == Status::solved
              ? ending(grip, grip.alone, hold.holds) + law_line(grip, grip.alone)
              : ".";
  const bool holds = report.status == Status::solved;
  if (!holds && report.status != Status::does_not_hold) return fact;
  if (hold.status == Status::solved && same_answer(grip, hold.holds, holds)) return fact;
  text += std::string("\nWith the pusher in place, at rest, it ") +
          (holds ? "holds" : "does NOT hold") + ending(grip, grip.at_rest, holds);
  text += law_line(grip, grip.at_rest);
  return fact;
}

} // namespace lcpush::desktop
