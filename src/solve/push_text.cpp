#include "lcpush/desktop/report.hpp"
#include "solve/failure_words.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

std::string run_line(const SceneFile& file, Solver solver, const PressureRun& run) {
  return run_words(file, solver, run) + ".\n";
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

const char* pressure_name(Pressure pressure) {
  return pressure == Pressure::pad ? "pad" : pressure == Pressure::even ? "even" : "rigid";
}

std::string failure_text(const SceneFile& file, Status status, const std::string& reason,
                         const std::vector<NamedValue>& ray, const Jam& jam) {
  std::string text = std::string("NOT SOLVED (") + status_text(status) + "): " + reason + ".\n";
  if (!ray.empty()) {
    text += "\n";
    for (const std::string& sentence : jam_sentences(file, jam)) text += sentence + "\n";
    text += "\nThe ray, largest entry 1:\n";
  }
  for (const NamedValue& entry : ray) text += "  " + number(entry.value) + "  " + entry.name + "\n";
  return text;
}

std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report) {
  std::string text =
      title_line(file) + facts_text({hold_fact(file, hold)}) + facts_text(push_facts(file, report));
  if (report.status != Status::solved)
    return text + failure_text(file, report.status, report.reason, report.ray, report.jam) + "\n" +
           run_line(file, report.solver, report.run);
  text += "\n" + table_text(contact_rows(file, report));
  text += list_text("Soft contacts:", torsion_sentences(file, report));
  text += list_text("Bodies whose actuators move them:", closing_sentences(file, report));
  return text + residual_line(report.residuals) + run_line(file, report.solver, report.run);
}

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report) {
  std::string text = title_line(file) + facts_text({grip_fact(file, hold, grip, report)});
  if (report.status == Status::does_not_hold)
    return text + does_not_hold_text(report) + "\n\n" + run_line(file, report.solver, report.run);
  if (report.status != Status::solved)
    return text + failure_text(file, report.status, report.reason, report.ray, report.jam) + "\n" +
           run_line(file, report.solver, report.run);
  return text + facts_text(break_facts(file, report)) + residual_line(report.breaking.residuals) +
         run_line(file, report.solver, report.run);
}

} // namespace lcpush::desktop
