#include "lcpush/desktop/verify.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// Two digits; without those that only say how rounding went.
std::string short_number(double x) {
  return std::abs(x) < 1e-9 ? "below 1e-9" : printed("%.2g", x);
}

std::string headline(const JudgedAnswer& report) {
  const std::string& because = report.because;
  std::string text = verdict_text(report.verdict);
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  if (report.verdict == Verdict::spurious_minimum)
    return text +
           ".\nEvery linear constraint holds, but not every product vanishes, and no small "
           "step\nlowers their sum: an optimiser stops here (" +
           because + ").\n";
  return because.empty() ? text + ".\n" : text + ", because " + because + ".\n";
}

std::string tolerance_line(const JudgedAnswer& report) {
  return "Tolerance         " + short_number(report.tolerance) + "; the worst row is off by " +
         residual_text(report.residual) + " in scaled units\n";
}

std::string metrics_lines(const ForeignMetrics& metrics) {
  return "Natural map       " + short_number(metrics.natural_map) +
         " (max |min(z, w)|); Fischer-Burmeister " + short_number(metrics.fischer_burmeister) +
         "; z'w " + short_number(metrics.products) + "\n";
}

std::string uniqueness_line(const VerifyReport& report) {
  const std::string label = "Around it         ";
  if (report.motion_proved)
    return label + "this scene has one motion only: every normal force is known\n";
  const FinalBasis& basis = report.basis;
  if (!basis.studied) return label + "not studied: too many contact points\n";
  std::string text = label + (basis.motion_open ? "the motion is open" : "no other motion");
  text += basis.wrench_open ? ", the pushers' wrench is open" : ", no other wrench of the pushers";
  if (basis.tied_contacts > 0)
    text += "; " + std::to_string(basis.tied_contacts) +
            " contacts are between two modes, where more may begin";
  return text + "\n";
}

std::string own_line(const VerifyReport& report) {
  const std::string label = "lcpush's own      ";
  if (report.own.status != Status::solved)
    return label + "ended with \"" + status_text(report.own.status) +
           "\": there is nothing to compare with\n";
  return label + "differs by " + short_number(report.own.force) +
         " N in a contact's force and by " + short_number(report.own.acceleration) +
         " m/s^2 in the motion\n";
}

} // namespace

std::string verify_text(const SceneFile& file, const VerifyReport& report) {
  std::string text = file.title.empty() ? "" : file.title + "\n\n";
  text += headline(report);
  if (report.verdict == Verdict::other_data) return text;
  text += "\n" + tolerance_line(report);
  for (const std::string& what : report.completed) text += "Completed         " + what + "\n";
  if (report.refined.found) {
    const bool solves = report.refined.residual <= 1e-8;
    text +=
        "Its basis         " +
        (solves ? "solved exactly, moves a force by " + short_number(report.refined.force) +
                      " N and the motion by " + short_number(report.refined.acceleration) + " m/s^2"
                : "is no solution's: solved exactly it is off by " +
                      short_number(report.refined.residual)) +
        "\n";
  }
  if (is_valid(report.verdict)) text += uniqueness_line(report) + own_line(report);
  text += metrics_lines(report.metrics);
  text += "Paper's objective " + short_number(report.objective) + " N m/s^2\n\n";
  std::vector<std::vector<std::string>> table = {{"law", "scaled", "SI", "", "worst row"}};
  for (const BrokenRow& row : report.rows) {
    const bool exact = row.scaled < 1e-9;
    table.push_back({law_text(row), short_number(row.scaled), exact ? "" : short_number(row.si),
                     exact ? "" : row.unit, row.scaled <= report.tolerance ? "holds" : row.name});
  }
  std::size_t widest = 0;
  for (auto& line : table) widest = std::max(widest, line.back().size());
  for (auto& line : table) line.back().resize(widest, ' ');
  return text + table_text(table);
}

std::string verify_text(const RawVerifyReport& report) {
  std::string text = headline(report);
  if (report.verdict == Verdict::other_data) return text;
  text += "\n" + tolerance_line(report);
  if (report.row >= 0)
    text += "Worst row         " + std::to_string(report.row + 1) + ": z = " + number(*report.z) +
            ", w = " + number(*report.w) + "\n";
  if (report.refined.found)
    text += "Its basis         solved exactly moves z by " + short_number(report.refined.moved) +
            " and is off by " + residual_text(report.refined.residual) + "\n";
  if (is_valid(report.verdict) && report.own.status == Status::solved)
    text += "lcpush's own      differs by " + short_number(report.own.force) + "\n";
  if (is_valid(report.verdict) && report.own.status != Status::solved)
    text +=
        "lcpush's own      ended with \"" + std::string(status_text(report.own.status)) + "\"\n";
  return text + metrics_lines(report.metrics);
}

} // namespace lcpush::desktop
