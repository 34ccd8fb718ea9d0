#include "solve/push_words.hpp"
#include "lcpush/mechanics/model/round_distance.hpp"
#include "solve/told_force.hpp"

#include <algorithm>

#include "solve/sentence.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// "9.81 m/s^2 and 0 rad/s^2", without what rounding left of a zero.
std::string acceleration_text(const Vector6<double>& a, double length) {
  const double linear = a.head<3>().norm(), angular = a.tail<3>().norm();
  const double zero = 1e-9 * (linear + length * angular);
  return number(linear, zero) + " m/s^2 and " + number(angular, zero / length) + " rad/s^2";
}

/// "5.01 m/s^2 and 3 rad/s^2" in three digits, without what is a thousandth of the other.
std::string brief_acceleration(const Vector6<double>& a, double length) {
  const double linear = a.head<3>().norm(), angular = a.tail<3>().norm();
  std::string text;
  if (linear > 1e-3 * length * angular) text = brief(linear) + " m/s^2";
  if (length * angular > 1e-3 * linear)
    text += (text.empty() ? "" : " and ") + brief(angular) + " rad/s^2";
  return text;
}

/// The force's size and direction.
std::string force_words(const Vector3<double>& force, double zero) {
  const double size = force.norm();
  std::string text = number(size, zero) + " N";
  if (size > zero) text += " along " + vector_text(force / size, 1e-9);
  return text;
}

std::string moment_words(const Vector3<double>& moment, double zero) {
  return "\nmoment about the centre of mass " + vector_text(moment, zero) + " N m";
}

void add_wrenches(const SceneFile& file, const PushReport& report, std::vector<Fact>& facts) {
  const Scene<double> scene = file.view();
  const double zero = 1e-9 * told_force(file, report.scales);
  for (Index b = 0; b < scene.bodies.size; ++b) {
    if (scene.bodies[b].role != Role::pusher) continue;
    const Vector6<double> wrench = body_wrench(scene, report.answer, scene.bodies[b]);
    facts.push_back({"Push by " + file.body_name(b),
                     force_words(wrench.head<3>(), zero) +
                         moment_words(wrench.tail<3>(), zero * report.scales.length)});
  }
}

std::string motion_words(const SceneFile& file, const RunReport& report) {
  const Motion<double>& motion = report.motion;
  const double length = report.scales.length;
  const std::string in_grip = report.hand_moves ? "" : " in the grip";
  const Vector3<double> at = file.object.center_of_mass + motion.axis_point;
  const std::string axis = "about the axis " + vector_text(motion.axis, 1e-6) + " through " +
                           vector_text(at, 1e-9 * length) + " m";
  const std::string turning = number(motion.rotation) + " rad/s^2 " + axis;
  std::string text;
  switch (motion.kind) {
  case MotionKind::rest: return "the object does not move" + in_grip + ".";
  case MotionKind::slide:
    return "slides: " + number(motion.translation) + " m/s^2 along " +
           vector_text(motion.direction, 1e-6);
  case MotionKind::pivot: text = "pivots" + in_grip + ": "; break;
  case MotionKind::roll: text = "rolls on the surface that carries it: "; break;
  case MotionKind::turn: text = "slides and turns: "; break;
  }
  text += turning;
  if (std::abs(motion.pitch) > 1e-6 * length)
    text += "\nadvancing " + number(motion.pitch) + " m per rad along it (a screw)";
  return text;
}

/// `what` is "motion" or "push force"; `open` and `isolated`: what the final basis says of it.
std::string unique_words(const std::string& what, Uniqueness unique, const PushReport& report,
                         bool open, bool isolated) {
  const Index covers = report.covers_compared, tied = report.final_basis.tied_contacts;
  switch (unique) {
  case Uniqueness::yes:
    return "the " + what + " is unique (proved: every normal force with friction is known)";
  case Uniqueness::no:
    return "the " + what + " is NOT unique: " +
           (open ? "the final basis leaves it open"
                 : "another covering vector leads to another answer");
  case Uniqueness::not_tested: return "no other " + what + " was looked for";
  case Uniqueness::none_other_found: break;
  }
  std::string text = "no other " + what + " was found";
  if (covers > 0) text += " under " + counted(covers, "other covering vector");
  if (isolated) return text + (covers > 0 ? ", and none lies next to it" : " next to it");
  if (report.final_basis.studied && tied > 0) text += "; " + tied_words(tied);
  return text;
}

std::string unique_text(const SceneFile& file, const PushReport& report) {
  const FinalBasis& basis = report.final_basis;
  std::string text = unique_words("motion", report.unique_motion, report, basis.motion_open,
                                  basis.motion_isolated());
  if (has_pusher(file))
    text += ";\n" + unique_words("push force", report.unique_wrench, report, basis.wrench_open,
                                 basis.wrench_isolated());
  return text;
}

/// "said: why", on two lines if it is long, and a line for each further reason.
std::string because(const std::string& said, const std::vector<std::string>& reasons) {
  const bool fits = said.size() + reasons.front().size() <= 80;
  std::string text = said + (fits ? ": " : ":\n") + reasons.front();
  for (std::size_t k = 1; k < reasons.size(); ++k) text += ";\n" + reasons[k];
  return text;
}

/// Which theorem covers the scene.
std::string theory_words(const SceneFile& file, const PushReport& report) {
  const Statement exists = existence_statement(file, report.existence);
  std::string text =
      because(exists.covered ? exists.statement : "no theorem promises an answer", exists.reasons);
  if (report.status != Status::solved) return text;
  const Statement unique = uniqueness_statement(report);
  text +=
      ";\n" + because(unique.covered ? unique.statement : "no theorem says that it is the only one",
                      {unique.reasons.front()}); // more stands above
  if (file.pressure == Pressure::rigid)
    text += "\n(pressure = \"rigid\" leaves a patch's pressure open: one answer of a set)";
  if (file.pressure == Pressure::even && !file.planar)
    text += "\n(pressure = \"even\" cannot resist tilting: trust it where nothing tilts)";
  return text;
}

Fact caution_fact(const Breaking<double>& b) {
  return {"Caution", "a third, smaller push lies " + number(b.line_error) +
                         " of the grip force off the line through two"};
}

/// What other covers and the scene's images have led to.
std::string break_unique_words(const BreakReport& report) {
  const bool same_force = report.unique_force != Uniqueness::no;
  const bool same_motion = report.unique_motion != Uniqueness::no;
  if (same_force && same_motion)
    return "no other was found by other covering vectors and in mirrors";
  const std::string open = same_motion ? "force" : same_force ? "motion" : "force and motion";
  return "NOT unique: other covering vectors, or mirrors, lead to another " + open +
         (same_force ? ""
                     : ";\nfound between " + number(report.least_force()) + " and " +
                           number(report.largest_force()) + " N") +
         "\nAll of them: lcpush spread --break";
}

} // namespace

/// Fingers come first.
bool has_pusher(const SceneFile& file) { return file.bodies.back().role == Role::pusher; }

std::string facts_text(const std::vector<Fact>& facts) {
  std::string all;
  for (const Fact& fact : facts) {
    std::string label = fact.label, text = fact.text;
    label.resize(std::max<std::size_t>(label.size() + 1, 18), ' ');
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
      text.insert(at + 1, 18, ' ');
    all += label + text + "\n";
  }
  return all;
}

Fact hold_words(const SceneFile& file, const HoldReport& hold) {
  Fact fact{"Before the push", ""};
  if (file.bodies.front().role == Role::pusher)
    fact.text = "nothing grips the object";
  else if (!has_pusher(file))
    fact = {"Pusher", "none: this is the grasp alone"};
  else if (hold.status != Status::solved)
    fact.text = std::string("not known: without the pusher the solve ended with \"") +
                status_text(hold.status) + "\"";
  else if (hold.holds)
    fact.text = "the grasp holds the object";
  else
    fact.text = "the grasp does NOT hold the object: it accelerates at " +
                acceleration_text(hold.acceleration, hold.length);
  return fact;
}

Fact hold_fact(const SceneFile& file, const HoldReport& hold) {
  Fact fact = hold_words(file, hold);
  fact.text += ".";
  return fact;
}

/// How far friction is from a round cone's.
Fact friction_fact(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  const RoundDistance<double>::Worst worst =
      RoundDistance<double>(scene, report.scales, report.answer).worst();
  const double off = worst.distance * report.scales.force;
  if (file.is_round) return {"Friction", "round, to " + printed("%.1g", off) + " N"};
  if (off < 1e-9 * report.scales.force)
    return {"Friction", "as a round cone's: every slip is along a generator"};
  return {"Friction", std::to_string(file.facets) + " facets cost up to " + number(off) +
                          " N, the friction of " + point_name(file, worst.point) +
                          "; facets = \"round\" costs none"};
}

std::vector<Fact> push_facts(const SceneFile& file, const PushReport& report) {
  std::vector<Fact> facts;
  if (report.status == Status::solved) {
    add_wrenches(file, report, facts);
    facts.push_back({"Motion", motion_words(file, report)});
    facts.push_back({"Answer", unique_text(file, report)});
  }
  if (report.status == Status::solved) facts.push_back(friction_fact(file, report));
  facts.push_back({"Theory", theory_words(file, report)});
  return facts;
}

std::vector<Fact> break_facts(const SceneFile& file, const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  const std::string pusher = file.body_name(report.pusher);
  const double zero = 1e-9 * told_force(file, report.scales);
  std::vector<Fact> facts;
  const std::string force = number(b.break_force, zero) + " N, normal force of " + pusher;
  facts.push_back({"Breaking force", b.breaks ? force + " when the object starts to move" +
                                                    (report.hand_moves ? "" : " in the grip")
                                              : "none: the object does not move; " + force});
  facts.push_back(
      {"Whole force", force_words(b.force.head<3>(), zero) +
                          moment_words(b.force.tail<3>(), zero * report.scales.length)});
  facts.push_back({"Pushing faster", "adds " + number(b.inertia_normal, 1e-9 * file.object.mass) +
                                         " N to the normal force per m/s^2 of the push"});
  facts.push_back({"Motion", motion_words(file, report)});
  if (b.breaks) facts.back().text += "\nper m/s^2 of the push";
  for (const Fact& fact : closing_facts(report)) facts.push_back(fact);
  if (report.unique_force != Uniqueness::not_tested)
    facts.push_back({"Answer", break_unique_words(report)});
  if (b.valid_to > 0)
    facts.push_back({"Valid up to", "a push of " + number(b.valid_to) + " m/s^2"});
  if (b.line_error > 1e-6) facts.push_back(caution_fact(b));
  return facts;
}

std::string does_not_hold_text(const SceneFile& file, const BreakReport& report) {
  return "The grasp does not hold " + object_name(file) +
         ", so no force just breaks it: with the pusher in place, at rest, " + object_name(file) +
         " already accelerates at " +
         brief_acceleration(report.breaking.rest, report.scales.length) + ".";
}

std::string hold_sentence(const SceneFile& file, const HoldReport& hold) {
  const std::string found = file.pressure == Pressure::rigid // which leaves patches open
                                ? "Without the push one answer of the laws does not hold "
                                : "Without the push the grasp does not hold ";
  return found + object_name(file) + ": it accelerates at " +
         brief_acceleration(hold.acceleration, hold.length) + ".";
}

std::vector<Fact> brief_break_facts(const SceneFile& file, const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  std::vector<Fact> facts;
  if (!b.breaks) return facts;
  facts.push_back({"Whole force", force_phrase(file, b.force.head<3>())});
  for (const Fact& fact : closing_facts(report)) facts.push_back(fact);
  if (b.inertia_normal > 1e-9 * file.object.mass)
    facts.push_back(
        {"Pushing faster", "adds " + brief(b.inertia_normal) + " N per m/s^2 of the push"});
  if (b.line_error > 1e-3) facts.push_back(caution_fact(b));
  return facts;
}

std::string run_words(const SceneFile& file, const RunReport& report) {
  const PressureRun& run = report.run;
  const Solver solver = report.solver;
  std::string text = solver == Solver::lemke    ? "Lemke: "
                     : solver == Solver::hybrid ? "Hybrid: "
                                                : "Gauss-Seidel: ";
  if (solver != Solver::lemke) text += std::to_string(run.sweeps) + " sweeps";
  if (solver == Solver::hybrid) text += " and ";
  if (solver != Solver::gauss_seidel) text += std::to_string(run.pivots) + " pivots";
  if (solver == Solver::lemke && run.sweeps > 0)
    text += " and " + std::to_string(run.sweeps) + " sweeps";
  if (run.rounds > 0) text += " in " + counted(run.rounds, "round");
  if (run.cold_restarts > 0) text += ", " + std::to_string(run.cold_restarts) + " restarted cold";
  return text + "; pressure law " + pressure_text(file.pressure) + "; " +
         (file.is_round ? "round friction" : std::to_string(file.facets) + " facets");
}

} // namespace lcpush::desktop
