#include "solve/push_words.hpp"

#include <algorithm>

#include "lcpush/mechanics/model/round_distance.hpp"
#include "solve/sentence.hpp"
#include "solve/word_settings.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

std::string direction_words(const Vector3<double>& unit) {
  return vector_text(unit, word_settings.component);
}

/// A force's size and direction, and its moment.
std::string wrench_words(const Vector6<double>& wrench, const Noise& noise) {
  const Vector3<double> force = wrench.head<3>();
  const double size = force.norm();
  return number(size, noise.force) + " N" +
         (size > noise.force ? " along " + direction_words(force / size) : "") +
         "\nmoment about the centre of mass " + vector_text(wrench.tail<3>(), noise.moment) +
         " N m";
}

std::string motion_words(const SceneFile& file, const RunReport& report) {
  const Motion<double>& motion = report.motion;
  const std::string in_grip = report.hand_moves ? "" : " in the grip";
  std::string text;
  switch (motion.kind) {
  case MotionKind::rest: return "the object does not move" + in_grip + ".";
  case MotionKind::slide:
    return "slides: " + number(motion.translation) + " m/s^2 along " +
           direction_words(motion.direction);
  case MotionKind::pivot: text = "pivots" + in_grip + ": "; break;
  case MotionKind::roll:
    text = std::string(rolling_verb(file)) + " on the surface that carries it: ";
    break;
  case MotionKind::turn: text = "slides and turns: "; break;
  }
  text += number(motion.rotation) + " rad/s^2 about the axis " + direction_words(motion.axis) +
          " through " +
          vector_text(file.object.center_of_mass + motion.axis_point, report.noise.length) + " m";
  if (std::abs(motion.pitch) > report.brief_noise.length)
    text += "\nadvancing " + number(motion.pitch) + " m per rad along it (a screw)";
  return text;
}

/// `what` is "motion" or "push force"; `open` and `isolated`: what the final basis says of it.
std::string unique_words(const std::string& what, Uniqueness unique, const PushReport& report,
                         bool open, bool isolated) {
  const Index paths = report.paths_compared, tied = report.final_basis.tied_contacts;
  switch (unique) {
  case Uniqueness::yes:
    return "the " + what + " is unique (proved: every normal force with friction is known)";
  case Uniqueness::no:
    return "the " + what + " is NOT unique: " +
           (open ? "the final basis leaves it open"
                 : "another path of pivots leads to another answer");
  case Uniqueness::not_tested: return "no other " + what + " was looked for";
  case Uniqueness::none_other_found: break;
  }
  std::string text = "no other " + what + " was found";
  if (paths > 0) text += " on " + counted(paths, "other path") + " of pivots";
  if (isolated) return text + (paths > 0 ? ", and none lies next to it" : " next to it");
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
std::string because(const Statement& statement, const std::string& without) {
  const std::string said = statement.text.empty() ? without : statement.text;
  const bool fits = said.size() + statement.reasons.front().size() <= usual_width;
  return said + (fits ? ": " : ":\n") + joined(statement.reasons, ";\n");
}

/// Which theorem covers the scene.
std::string theory_words(const SceneFile& file, const PushReport& report) {
  std::string text =
      because(existence_statement(file, report.existence), "no theorem promises an answer");
  if (report.status != Status::solved) return text;
  Statement unique = uniqueness_statement(report);
  unique.reasons.resize(1); // more stands above
  text += ";\n" + because(unique, "no theorem says that it is the only one");
  if (file.pressure == Pressure::rigid)
    text += "\n(pressure = \"rigid\" leaves a patch's pressure open: one answer of a set)";
  if (file.pressure == Pressure::even && !file.planar)
    text += "\n(pressure = \"even\" cannot resist tilting: trust it where nothing tilts)";
  return text;
}

void add_caution(const Breaking<double>& b, double least_error, std::vector<Fact>& facts) {
  if (b.line_error > least_error)
    facts.push_back({"Caution", "a third, smaller push lies " + number(b.line_error) +
                                    " of the grip force off the line through two"});
}

/// Bodies that a push which just breaks the grasp opens or closes, if any.
void add_closings(const BreakReport& report, std::vector<Fact>& facts) {
  std::vector<std::string> moving;
  for (const NamedValue& closing : report.closings)
    if (std::abs(closing.value) > word_settings.digit)
      moving.push_back(closing.name + (closing.value > 0 ? " closes by " : " is forced open by ") +
                       printed("%.3g m/s^2", std::abs(closing.value)));
  if (!moving.empty())
    facts.push_back({"Fingers", listed(moving, "and") + " per m/s^2 of the push"});
}

/// N per m/s^2
double least_inertia(const SceneFile& file) { return word_settings.rounding * file.object.mass; }

/// What other paths of pivots have led to.
std::string break_unique_words(const BreakReport& report) {
  const bool same_force = report.unique_force != Uniqueness::no;
  const bool same_motion = report.unique_motion != Uniqueness::no;
  if (same_force && same_motion) return "no other was found on other paths of pivots";
  double least = report.breaking.break_force, largest = least;
  for (const OtherBreak& other : report.others) {
    least = std::min(least, other.break_force);
    largest = std::max(largest, other.break_force);
  }
  const std::string open = same_motion ? "force" : same_force ? "motion" : "force and motion";
  return "NOT unique: other paths of pivots lead to another " + open +
         (same_force ? ""
                     : ";\nfound between " + number(least) + " and " + number(largest) + " N") +
         "\nAll of them: lcpush spread --break";
}

/// How far friction is from a round cone's.
Fact friction_fact(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  const RoundDistance<double>::Worst worst =
      RoundDistance<double>(scene, report.scales, report.answer).worst();
  const double off = worst.distance * report.scales.force;
  const std::string facets = std::to_string(file.facets) + " facets";
  if (report.friction == FrictionLaw::round)
    return {"Friction", "round, to " + printed("%.1g", off) + " N"};
  if (report.friction == FrictionLaw::pyramids_instead)
    return {"Friction", "round friction did not settle: " + facets + " instead, off by up to " +
                            number(off) + " N"};
  if (off < report.noise.force)
    return {"Friction", "as a round cone's: every slip is along a generator"};
  return {"Friction", facets + " cost up to " + number(off) + " N, the friction of " +
                          point_name(file, worst.point) + "; facets = \"round\" costs none"};
}

} // namespace

std::string facts_text(const std::vector<Fact>& facts) {
  std::string all;
  for (const Fact& fact : facts) {
    std::string label = fact.label, text = fact.text;
    label.resize(std::max(label.size() + 1, word_settings.label_width), ' ');
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
      text.insert(at + 1, word_settings.label_width, ' ');
    all += label + text + "\n";
  }
  return all;
}

std::vector<Fact> push_facts(const SceneFile& file, const PushReport& report) {
  const Fact theory{"Theory", theory_words(file, report), true};
  if (report.status != Status::solved) return {theory};
  std::vector<Fact> facts;
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    if (file.bodies[b].role == Role::pusher)
      facts.push_back(
          {"Push by " + file.body_names[b],
           wrench_words(body_wrench(file.view(), report.answer, file.bodies[b]), report.noise)});
  facts.push_back({"Motion", motion_words(file, report)});
  facts.push_back({"Answer", unique_text(file, report), true});
  facts.push_back(friction_fact(file, report));
  facts.push_back(theory);
  return facts;
}

std::vector<Fact> break_facts(const SceneFile& file, const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  const std::string in_grip = report.hand_moves ? "" : " in the grip";
  const std::string force = number(b.break_force, report.noise.force) + " N, normal force of " +
                            file.body_name(report.pusher);
  std::vector<Fact> facts{
      {"Breaking force", b.breaks ? force + " when the object starts to move" + in_grip
                                  : "none: the object does not move; " + force},
      {"Whole force", wrench_words(b.force, report.noise)},
      {"Pushing faster", "adds " + number(b.inertia_normal, least_inertia(file)) +
                             " N to the normal force per m/s^2 of the push"},
      {"Motion", motion_words(file, report) + (b.breaks ? "\nper m/s^2 of the push" : "")}};
  add_closings(report, facts);
  if (report.unique_force != Uniqueness::not_tested)
    facts.push_back(
        {"Answer", break_unique_words(report),
         report.unique_force != Uniqueness::no && report.unique_motion != Uniqueness::no});
  if (b.valid_to > 0)
    facts.push_back({"Valid up to", "a push of " + number(b.valid_to) + " m/s^2"});
  add_caution(b, word_settings.component, facts);
  return facts;
}

std::vector<Fact> brief_break_facts(const SceneFile& file, const BreakReport& report) {
  const Breaking<double>& b = report.breaking;
  if (!b.breaks) return {};
  std::vector<Fact> facts;
  if (b.force.head<3>().norm() > report.brief_noise.force)
    facts.push_back({"Whole force", force_phrase(file, b.force.head<3>())});
  add_closings(report, facts);
  if (b.inertia_normal > least_inertia(file))
    facts.push_back(
        {"Pushing faster", "adds " + brief(b.inertia_normal) + " N per m/s^2 of the push"});
  add_caution(b, word_settings.digit, facts);
  return facts;
}

std::string run_words(const SceneFile& file, const RunReport& report) {
  const PressureRun& run = report.run;
  constexpr const char* names[] = {"Lemke: ", "Gauss-Seidel: ", "Hybrid: "};
  std::vector<std::string> steps;
  if (report.solver != Solver::lemke) steps.push_back(std::to_string(run.sweeps) + " sweeps");
  if (report.solver != Solver::gauss_seidel)
    steps.push_back(std::to_string(run.pivots) + " pivots");
  if (report.solver == Solver::lemke && run.sweeps > 0)
    steps.push_back(std::to_string(run.sweeps) + " sweeps");
  std::string text = names[static_cast<int>(report.solver)] + joined(steps, " and ");
  if (run.rounds > 0) text += " in " + counted(run.rounds, "round");
  if (run.cold_restarts > 0) text += ", " + std::to_string(run.cold_restarts) + " restarted cold";
  return text + "; pressure law " + pressure_text(file.pressure) + "; " +
         (report.friction == FrictionLaw::pyramids_instead ? std::to_string(file.facets) + " facets"
                                                           : friction_law_text(file));
}

} // namespace lcpush::desktop
