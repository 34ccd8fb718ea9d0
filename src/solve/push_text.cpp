#include "lcpush/desktop/report.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"

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

} // namespace

std::string title_line(const SceneFile& file) {
  return file.title.empty() ? "" : file.title + "\n\n";
}

std::string failure_text(const SceneFile& file, const RunReport& report) {
  std::string text =
      std::string("NOT SOLVED (") + status_text(report.status) + "): " + report.reason + ".\n";
  if (!report.ray.empty()) {
    text += "\n";
    for (const std::string& sentence : jam_sentences(file, report.jam)) text += sentence + "\n";
    text += "\nThe ray, largest entry 1:\n";
  }
  for (const NamedValue& entry : report.ray)
    text += "  " + number(entry.value) + "  " + entry.name + "\n";
  return text;
}

std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  std::string text =
      title_line(file) + facts_text({hold_fact(file, hold)}) + facts_text(push_facts(file, report));
  if (report.status != Status::solved)
    return text + failure_text(file, report) + "\n" + run_line(file, report);
  text += "\n" + table_text(contact_rows(file, report));
  text += list_text("Soft contacts:", torsion_sentences(file, report));
  text += list_text("Bodies whose actuators move them:", closing_sentences(file, report));
  return text + residual_line(report.residuals) + run_line(file, report);
}

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report) {
  std::string text = title_line(file) + facts_text({grip_fact(file, hold, grip, report)});
  if (report.status == Status::does_not_hold)
    return text + does_not_hold_text(report) + "\n\n" + run_line(file, report);
  if (report.status != Status::solved)
    return text + failure_text(file, report) + "\n" + run_line(file, report);
  return text + facts_text(break_facts(file, report)) + residual_line(report.breaking.residuals) +
         run_line(file, report);
}

} // namespace lcpush::desktop
