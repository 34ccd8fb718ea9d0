#include "formats/json_writer.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/trajectory.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"
#include "verify/settings.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// "155 um/s": speeds of every size, in three digits.
std::string speed_text(double speed) {
  if (speed >= VerifySettings::in_metres) return brief(speed) + " m/s";
  if (speed >= VerifySettings::in_millimetres) return millimetres(speed) + "/s";
  return brief(millimetres_a_metre * millimetres_a_metre * speed) + " um/s";
}

/// Whose force it is; nothing of all together.
std::string whose(const SceneFile& file, const WorstForce& worst) {
  switch (worst.law) {
  case ForceLaw::newton: return "";
  case ForceLaw::sum: return file.body_name(worst.of);
  case ForceLaw::grip: return file.actuator_names[static_cast<std::size_t>(worst.of)];
  default:
    return worst.is_of_body ? file.body_name(file.body_of(worst.of)) : point_name(file, worst.of);
  }
}

const char* unit_of(const WorstForce& worst) { return worst.is_moment ? " N m" : " N"; }

/// "left.1 pulls with 1.2 N"
std::string fault_phrase(const SceneFile& file, const WorstForce& worst) {
  const auto [is, should] = told_apart(worst.found, worst.lawful);
  const std::string who = whose(file, worst), found = is + unit_of(worst),
                    lawful = should + unit_of(worst);
  switch (worst.law) {
  case ForceLaw::gap:
    return who + " presses with " + found +
           (worst.gap ? " across a gap of " + millimetres(*worst.gap)
                      : " where it touches nothing");
  case ForceLaw::normal:
    return who + " pulls with " + brief(-worst.found) + " N, and can only press";
  case ForceLaw::cone:
    return "the friction of " + who + " is " + found +
           (worst.is_out_of_plane ? " across the contact plane"
                                  : ", and its cone ends at " + lawful);
  case ForceLaw::dissipation:
    return "the friction of " + who +
           (worst.found < 0 ? " drives its slip with " + brief(-worst.found) + " N, and should"
                            : " opposes its slip with " + found + ", not with") +
           (worst.found < 0 ? " oppose it with " : " ") + lawful + " or more";
  case ForceLaw::sum:
    return std::string(worst.is_moment ? "the moment" : "the force") + " of " + who +
           " is not the sum of its contacts', by " + found;
  case ForceLaw::grip: return who + " closes with " + found + " instead of " + lawful;
  case ForceLaw::newton: break;
  }
  return worst.is_moment
             ? "the forces' moments do not make the change of spin: " + found + " are missing"
             : "the forces do not make the change of velocity: " + found + " are missing";
}

std::string fault_sentence(const SceneFile& file, const WorstForce& worst) {
  return "at " + brief(worst.time) + " s " + fault_phrase(file, worst);
}

/// How well the laws are kept; or which are, and what is wrong beside the first that is broken.
Fact force_fact(const SceneFile& file, const TrajectoryReport& report) {
  const ForceReport& forces = *report.forces;
  const WorstForce* const first = forces.broken(report.tolerance);
  std::vector<std::string> kept;
  std::string broken;
  double most = 0;
  for (const WorstForce& worst : forces.worst) {
    most = std::max(most, worst.off);
    if (worst.off <= report.tolerance)
      kept.emplace_back(force_law_text(worst.law));
    else if (&worst != first || report.verdict != TrajectoryVerdict::wrong_forces)
      broken += "\n" + fault_sentence(file, worst);
  }
  std::string text = "of " + counted(forces.frames, "frame") + " judged: ";
  const std::string unjudged =
      forces.balanced == forces.frames
          ? ""
          : "\nNewton's law, that forces make the motion, is " +
                (forces.balanced == 0 ? "not judged"
                                      : "judged of " + counted(forces.balanced, "frame")) +
                ": several steps lie between two frames, and only the last one's forces "
                "are known";
  if (first == nullptr)
    return {"Forces", text + "every law " + (forces.balanced > 0 ? "" : "but Newton's ") +
                          "is kept; the largest violation is " + residual_text(most) +
                          " of the largest force" + unjudged};
  return {"Forces", text + (kept.empty() ? "no law is kept" : "kept are " + listed(kept, "and")) +
                        broken + unjudged};
}

std::string verdict_sentence(const SceneFile& file, const TrajectoryReport& report) {
  const std::string worst = speed_text(report.worst) + " at " + brief(report.worst_time) + " s";
  switch (report.verdict) {
  case TrajectoryVerdict::follows:
    return "The motion obeys the laws: step by step it goes where they lead, within " +
           speed_text(report.worst) + ".";
  case TrajectoryVerdict::creeps: {
    std::string text = "The motion creeps: Coulomb's law holds " + object_name(file);
    if (report.held) text += ", with " + brief(*report.held) + " times the grip that it takes";
    return text + "; " +
           (report.creep < VerifySettings::negligible * report.fastest
                ? "what it does to and fro is"
                : speed_text(report.creep) + " is") +
           " the simulator's, not friction's.";
  }
  case TrajectoryVerdict::stopped:
    if (report.is_coarse && !report.hint.empty()) return "The motion is not judged.";
    if (report.is_coarse)
      return "The motion is not judged: before " + brief(report.worst_time) +
             " s the object goes so far from frame to frame that its speed is open; give "
             "velocities, "
             "or frames in between.";
    return "The laws have no step to " + brief(report.worst_time) +
           " s from where the motion is (" + std::string(status_text(report.status)) + ").";
  case TrajectoryVerdict::wrong_forces:
    return "The motion obeys the laws, its forces do not: " +
           fault_sentence(file, *report.forces->broken(report.tolerance)) + ".";
  case TrajectoryVerdict::differs: break;
  }
  const bool is_deep = report.overlap.depth > VerifySettings::pushed_out * object_size(file);
  const bool is_fast = report.overlap.speed > report.tolerance * report.fastest;
  if (is_deep || (is_fast && !(report.worst > report.overlap.speed))) // so deep nothing presses
    return "The motion breaks the laws: at " + brief(report.overlap.until) + " s " +
           point_name(file, report.overlap.point) + " is " + millimetres(report.overlap.depth) +
           " inside its face; bodies do not go into each other.";
  const MissedChange missed = report.missed.value_or(MissedChange());
  const auto change = [&](const Vector3<double>& of) {
    const double zero = VerifySettings::rounded * missed.speed;
    const auto digits = [&](double x) { return in_digits(x, VerifySettings::told_digits, zero); };
    return "(" + digits(of[0]) + ", " + digits(of[1]) + ", " + digits(of[2]) + ") m/s";
  };
  if (missed.speed > report.tolerance * report.fastest)
    return "The motion breaks the laws: from " + brief(missed.from) + " to " + brief(missed.until) +
           " s its velocity changes by " + change(missed.found) + ", and by the laws by " +
           change(missed.lawful) + ".";
  return "The motion breaks the laws: they lead elsewhere by " + worst + ".";
}

void write_forces(JsonWriter& json, const SceneFile& file, const TrajectoryReport& report) {
  const ForceReport& forces = *report.forces;
  const WorstForce* const broken = forces.broken(report.tolerance);
  json.begin_object()
      .member("frames", forces.frames)
      .member("balanced", forces.balanced)
      .member("broken", when(broken != nullptr,
                             force_law_text(broken != nullptr ? broken->law : ForceLaw::newton)));
  json.objects("laws", forces.worst, [&](const WorstForce& worst) {
    json.member("law", force_law_text(worst.law))
        .member("off", worst.off)
        .member("time", worst.time)
        .member("of", unless_empty(whose(file, worst)))
        .member("found", worst.found)
        .member("lawful", worst.lawful)
        .member("unit", worst.is_moment ? "N m" : "N")
        .member("gap", worst.gap);
  });
  json.end_object();
}

} // namespace

std::string trajectory_text(const SceneFile& file, const TrajectoryReport& report) {
  std::vector<Fact> facts{
      {"Compared", counted(report.steps, "step") +
                       ", each computed again from the motion's own state at its start, in as "
                       "many substeps as agree best"},
      {"Difference", speed_text(report.worst) + " at most" +
                         (report.worst > 0 ? " (at " + brief(report.worst_time) + " s)" : "") +
                         ", " + speed_text(report.mean) + " on average"},
      {"Allowed", brief(report.tolerance) + " of " + speed_text(report.fastest) +
                      ", the largest speed of a pusher or contact point"}};
  if (report.verdict == TrajectoryVerdict::differs && report.missed)
    facts.push_back({"Changes", "over many steps the laws lead to another velocity by " +
                                    speed_text(report.missed_speed()) + " at most"});
  if (report.offset)
    facts.push_back({"Begins", report.offset->isZero(0)
                                   ? "turned, unlike the scene: its turns are judged from there on"
                                   : "at " + vector_text(*report.offset) +
                                         " m instead of 0: its places are judged from there on"});
  if (!report.has_rotation)
    facts.push_back({"Rotation", "the file says none: the object is taken not to turn"});
  if (!report.unread.empty())
    facts.push_back({"Not read", listed(report.unread, "and") + ": docs/check/motions.md lists "
                                                                "what a motion says"});
  if (report.forces) facts.push_back(force_fact(file, report));
  return title_line(file) + verdict_sentence(file, report) + "\n" +
         (report.hint.empty() ? "" : report.hint + "\n") + "\n" + facts_text(facts);
}

std::string trajectory_json(const SceneFile& file, const TrajectoryReport& report) {
  JsonWriter json;
  json.begin_object()
      .member("verdict", verdict_text(report.verdict))
      .member("steps", report.steps)
      .member("tolerance", report.tolerance)
      .member("fastest", report.fastest)
      .member("worst", report.worst)
      .member("worst_time", report.worst_time)
      .member("mean", report.mean)
      .member("missed_change", when(report.missed.has_value(), report.missed_speed()))
      .member("overlap", report.overlap.depth)
      .member("offset", report.offset)
      .member("has_rotation", report.has_rotation)
      .member("unread", report.unread)
      .member("hint", unless_empty(report.hint))
      .member("coarse", report.is_coarse)
      .member("status", status_text(report.status))
      .member("creep", report.creep)
      .member("held", report.held)
      .key("forces");
  if (report.forces)
    write_forces(json, file, report);
  else
    json.value(nullptr);
  json.end_object();
  return json.text();
}

} // namespace lcpush::desktop
