#include <algorithm>

#include "lcpush/desktop/report.hpp"
#include "scenes/mirror.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wrap.hpp"

namespace lcpush::desktop {
namespace {

std::string run_line(const SceneFile& file, const RunReport& report) {
  return run_words(file, report) + ".\n";
}

std::string residual_line(const Residuals<double>& residuals) {
  return "\nLargest scaled residual " + residual_text(residuals.max()) +
         ", checked apart from the solver.\n";
}

/// A paragraph of its own, or nothing.
std::string list_text(const std::string& head, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string text = "\n" + head + "\n";
  for (const std::string& sentence : sentences) text += "  " + sentence + "\n";
  return text;
}

/// Two forces that the laws allow, in as many digits as tell them apart, and which law each obeys.
std::string both_answers(const SceneFile& file, double found, double other) {
  std::string mine = brief(found), its = brief(other);
  for (const char* format : {"%.4g", "%.5g", "%.6g"}) {
    if (mine != its) break;
    mine = printed(format, found);
    its = printed(format, other);
  }
  const std::string both = (found < other ? mine + " or " + its : its + " or " + mine) + " N. ";
  switch (file.pressure) {
  case Pressure::pad:
    return both + mine + " N is the pad law's answer from an even preload; " + its +
           " N is another answer of the paper's laws, which leave open how a patch shares its "
           "force.";
  case Pressure::even:
    return both + "Both obey the paper's laws with an even share of the grip at every point; " +
           mine + " N was found first.";
  case Pressure::rigid: break;
  }
  return both + "Both obey the paper's laws; " + mine + " N was found first.";
}

/// Is the object's motion another than its image in a mirror that leaves the scene as it is?
std::string mirror_sentence(const SceneFile& file, const PushReport& report) {
  constexpr double same = 1e-3;
  if (report.motion.kind == MotionKind::rest) return "";
  Vector6<double> motion = report.answer.acceleration;
  motion.tail<3>() *= report.scales.length;
  for (const Index axis : mirror_axes(file))
    if ((motion - mirrored_twist(motion, axis)).norm() > same * motion.norm())
      return std::string("The scene is its own mirror image across the plane ") + "xyz"[axis] +
             " = " + number(file.object.center_of_mass[axis]) +
             ", the motion is not: its mirror image is an answer too.\n";
  return "";
}

/// What else the laws allow, and where to look.
std::string others_text(const SceneFile& file, const PushReport& report) {
  const bool motion = report.unique_motion == Uniqueness::no;
  std::string text = mirror_sentence(file, report);
  if (motion || report.unique_wrench == Uniqueness::no) {
    const std::string what = motion ? "motion" : "push";
    double push = 0;
    for (const Body<double>& body : file.bodies)
      if (body.role == Role::pusher)
        push += body_wrench(file.view(), report.answer, body).head<3>().norm();
    const double other = report.other ? report.other->wrench.head<3>().norm() : push;
    text += "The " + what + " is not unique: ";
    if (std::abs(other - push) > 1e-5 * report.scales.force)
      text += both_answers(file, push, other) + "\n";
    else
      text += "the paper's laws leave it open" +
              std::string(motion ? "" : " how it is shared and where it acts") + ".\n";
  }
  if (!text.empty()) text += "See: lcpush spread " + file.lines.file + "\n";
  return text;
}

std::string brief_solve(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  std::string text = title_line(file) + push_sentence(file, report) + "\n";
  if (hold.status == Status::solved && !hold.holds && has_pusher(file))
    text += hold_sentence(file, hold) + "\n";
  text += "\n" + facts_text({hand_fact(file)}) + "\n";
  text += table_text(brief_contact_rows(file, report));
  text += list_text("Soft contacts:", torsion_sentences(file, report));
  text += list_text("Bodies whose actuators move them:", closing_sentences(file, report));
  const std::string others = others_text(file, report);
  return text + (others.empty() ? "" : "\n" + others);
}

} // namespace

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

std::string ray_text(const RunReport& report) {
  std::string text = report.ray.empty() ? "" : "\nThe ray, largest entry 1:\n";
  for (const NamedValue& entry : report.ray)
    text += "  " + number(entry.value) + "  " + entry.name + "\n";
  return text;
}

std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report,
                       Telling telling) {
  const bool is_solved = report.status == Status::solved;
  if (telling == Telling::brief)
    return is_solved ? brief_solve(file, hold, report)
                     : title_line(file) + failure_text(file, report);
  std::string text = title_line(file);
  text += is_solved ? push_sentence(file, report) + "\n\n" : failure_text(file, report) + "\n";
  text += facts_text({hand_fact(file), hold_fact(file, hold)});
  text += facts_text(push_facts(file, report));
  if (!is_solved) return text + ray_text(report) + "\n" + run_line(file, report);
  text += "\n" + table_text(contact_rows(file, report));
  text += list_text("Soft contacts:", torsion_sentences(file, report));
  text += list_text("Bodies whose actuators move them:", closing_sentences(file, report));
  const std::string others = others_text(file, report);
  if (!others.empty()) text += "\n" + others;
  return text + residual_line(report.residuals) + run_line(file, report);
}

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report, Telling telling) {
  const bool is_full = telling == Telling::full;
  const std::string before = facts_text({hand_fact(file), grip_fact(file, hold, grip, report)});
  const std::string end = is_full ? ray_text(report) + "\n" + run_line(file, report) : "";
  if (report.status == Status::does_not_hold)
    return title_line(file) + does_not_hold_text(file, report) + "\n\n" + before + end;
  if (report.status != Status::solved)
    return title_line(file) + failure_text(file, report) + "\n" + before + end;
  std::string text =
      title_line(file) + break_sentence(file, report) + "\n\n" + before +
      facts_text(is_full ? break_facts(file, report) : brief_break_facts(file, report));
  if (report.other_force)
    text += "\nThe " + std::string(report.breaking.breaks ? "breaking" : "normal") +
            " force is not unique: " +
            both_answers(file, report.breaking.break_force, *report.other_force) +
            "\nSee: lcpush spread --break " + file.lines.file + "\n";
  return is_full ? text + residual_line(report.breaking.residuals) + run_line(file, report) : text;
}

} // namespace lcpush::desktop
