#include <algorithm>

#include "scenes/mirror.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "solve/word_settings.hpp"

namespace lcpush::desktop {
namespace {

std::string run_line(const SceneFile& file, const RunReport& report) {
  return run_words(file, report) + ".\n";
}

std::string residual_line(const Residuals<double>& residuals) {
  return "\nLargest scaled residual " + residual_text(residuals.max()) +
         ", checked apart from the solver.\n";
}

/// Paragraphs of their own, or nothing.
std::string list_text(const std::string& head, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string text = "\n" + head + "\n";
  for (const std::string& sentence : sentences) text += "  " + sentence + "\n";
  return text;
}

/// Two forces that the laws allow, in as many digits as tell them apart, and which law each obeys.
std::string both_answers(const SceneFile& file, double found, double other, bool is_friction_open) {
  std::string mine, its;
  for (int digits = 3; digits <= 6 && mine == its; ++digits) {
    mine = in_digits(found, digits);
    its = in_digits(other, digits);
  }
  const std::string both =
      "for instance " + (found < other ? mine + " or " + its : its + " or " + mine) + " N. ";
  if (is_friction_open)
    return both + "The laws leave open how much friction there is where contacts stick; " + its +
           " N has less of it.";
  if (file.pressure == Pressure::even) return both + "Both obey the laws.";
  return both + "Both obey the laws, which leave open how contacts share pressure and friction.";
}

/// Is the object's motion another than its image in a mirror that leaves the scene as it is?
std::string mirror_sentence(const SceneFile& file, const PushReport& report) {
  if (report.motion.kind == MotionKind::rest) return "";
  Vector6<double> motion = report.answer.acceleration;
  motion.tail<3>() *= report.scales.length;
  for (const Index axis : mirror_axes(file))
    if ((motion - mirrored_twist(motion, axis)).norm() > word_settings.digit * motion.norm())
      return std::string("The scene is its own mirror image across the plane ") + "xyz"[axis] +
             " = " + number(file.object.center_of_mass[axis]) +
             ", the motion is not: its mirror image is an answer too.\n";
  return "";
}

/// Where round friction did not settle: a paragraph, or nothing.
std::string friction_text(const SceneFile& file, const RunReport& report) {
  if (report.friction != FrictionLaw::pyramids_instead) return "";
  return "\nRound friction did not settle here: this is the answer of pyramids of " +
         std::to_string(file.facets) + " facets.\n";
}

/// How hard the pushers push together, N.
double total_push(const SceneFile& file, const PushReport& report) {
  double push = 0;
  for (const Body<double>& body : file.bodies)
    if (body.role == Role::pusher)
      push += body_wrench(file.view(), report.answer, body).head<3>().norm();
  return push;
}

/// The ray's entries, in the solver's units; nothing without one.
std::string ray_text(const RunReport& report) {
  std::string text = report.ray.empty() ? "" : "\nThe ray, largest entry 1:\n";
  for (const NamedValue& entry : report.ray)
    text += "  " + number(entry.value) + "  " + entry.name + "\n";
  return text;
}

/// Where inertia at the speed of a pusher, taken as an acceleration, is a part of the push.
std::string velocity_text(const SceneFile& file, const PushReport& report) {
  bool has_speed = false;
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    has_speed = has_speed || (file.bodies[b].role == Role::pusher && file.strokes[b].is_velocity);
  const double inertia = file.object.mass * report.answer.acceleration.head<3>().norm();
  if (!has_speed || !(inertia > word_settings.inertia * total_push(file, report))) return "";
  return "A pusher's velocity is taken as an acceleration here, from rest; for the push at that "
         "speed ask lcpush move.\n";
}

/// What else the laws allow, and where to look: a paragraph, or nothing.
std::string others_text(const SceneFile& file, const PushReport& report) {
  const std::string text = others_sentences(file, report);
  return text.empty() ? "" : "\n" + text + "See: lcpush spread " + file.lines.file + "\n";
}

} // namespace

std::string others_sentences(const SceneFile& file, const PushReport& report) {
  const bool motion = report.unique_motion == Uniqueness::no;
  std::string text = mirror_sentence(file, report);
  if (motion || report.unique_wrench == Uniqueness::no) {
    const double push = total_push(file, report);
    const double other = report.other ? report.other->wrench.head<3>().norm() : push;
    const bool may_rest = motion && report.other && report.other->acceleration.isZero(0);
    const bool is_told =
        !may_rest && std::abs(other - push) > word_settings.other_force * report.scales.force;
    text += std::string("The ") +
            (!motion   ? "push"
             : is_told ? "answer"
                       : "motion") +
            " is not unique: ";
    if (may_rest)
      text += report.is_friction_open
                  ? "without friction that lifts or drags it, it rests.\n"
                  : "bodies that stand still may also squeeze it, and hold it.\n";
    else if (is_told)
      text += both_answers(file, push, other, report.is_friction_open) + "\n";
    else
      text += motion ? "the paper's laws leave it open.\n"
                     : "any share of it that obeys the laws, and any place, holds; one is shown.\n";
  }
  return text;
}

std::string title_line(const SceneFile& file) {
  return file.title.empty() ? "" : file.title + "\n\n";
}

std::string failure_text(const SceneFile& file, const RunReport& report) {
  if (report.ray.empty())
    return "No answer (" + std::string(status_text(report.status)) + "): " + report.reason + ".\n";
  std::string text = "No answer. ";
  for (const std::string& sentence : jam_sentences(file, report.jam)) text += sentence + "\n";
  return text;
}

std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report,
                       Telling telling) {
  const bool is_full = telling == Telling::full, is_solved = report.status == Status::solved;
  std::string text = title_line(file) +
                     (is_solved ? push_sentence(file, report) + "\n" : failure_text(file, report));
  if (!is_full && !is_solved) return text;
  if (!is_full && hold.status == Status::solved && !hold.holds && has_pusher(file))
    text += hold_sentence(file, hold) + "\n";
  if (is_solved) text += velocity_text(file, report);
  text += "\n" + facts_text({hand_fact(file)});
  if (is_full) text += facts_text({hold_fact(file, hold)}) + facts_text(push_facts(file, report));
  if (!is_solved) return text + ray_text(report) + "\n" + run_line(file, report);
  text += "\n" + table_text(contact_rows(file, report, telling));
  text += list_text("Soft contacts:", torsion_sentences(file, report, telling));
  text += list_text("Bodies whose actuators move them:", closing_sentences(file, report, telling));
  text += friction_text(file, report) + others_text(file, report);
  return is_full ? text + residual_line(report.residuals) + run_line(file, report) : text;
}

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report, Telling telling) {
  const bool is_full = telling == Telling::full;
  const bool is_solved = report.status == Status::solved;
  std::string text = title_line(file);
  if (is_solved)
    text += break_sentence(file, report) + "\n";
  else if (report.status == Status::does_not_hold)
    text += does_not_hold_text(file, report) + "\n";
  else
    text += failure_text(file, report);
  text += "\n" + facts_text({hand_fact(file), grip_fact(file, hold, grip, report)});
  if (!is_solved) return is_full ? text + ray_text(report) + "\n" + run_line(file, report) : text;
  text += facts_text(is_full ? break_facts(file, report) : brief_break_facts(file, report));
  text += friction_text(file, report);
  if (report.other_force)
    text += "\nThe " + std::string(report.breaking.breaks ? "breaking" : "normal") +
            " force is not unique: " +
            both_answers(file, report.breaking.break_force, *report.other_force,
                         report.is_friction_open) +
            "\nSee: lcpush spread --break " + file.lines.file + "\n";
  return is_full ? text + residual_line(report.breaking.residuals) + run_line(file, report) : text;
}

} // namespace lcpush::desktop
