#include "lcpush/desktop/verify.hpp"
#include "solve/push_words.hpp"
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

Fact tolerance_fact(const JudgedAnswer& report) {
  return {"Tolerance", short_number(report.tolerance) + "; the worst row is off by " +
                           residual_text(report.residual) + " in scaled units"};
}

Fact metrics_fact(const ForeignMetrics& metrics) {
  return {"Natural map",
          short_number(metrics.natural_map) + " (max |min(z, w)|); Fischer-Burmeister " +
              short_number(metrics.fischer_burmeister) + "; z'w " + short_number(metrics.products)};
}

Fact basis_fact(const RefinedAnswer& refined) {
  if (!(refined.residual <= 1e-8))
    return {"Its basis",
            "is no solution's: solved exactly it is off by " + short_number(refined.residual)};
  return {"Its basis", "solved exactly, moves a force by " + short_number(refined.force) +
                           " N and the motion by " + short_number(refined.acceleration) + " m/s^2"};
}

std::string around_words(const VerifyReport& report) {
  if (report.motion_proved) return "this scene has one motion only: every normal force is known";
  const FinalBasis& basis = report.basis;
  if (!basis.studied) return "not studied: too many contact points";
  std::string text = basis.motion_open ? "the motion is open" : "no other motion";
  text += basis.wrench_open ? ", the pushers' wrench is open" : ", no other wrench of the pushers";
  if (basis.tied_contacts > 0)
    text += "; " + std::to_string(basis.tied_contacts) +
            " contacts are between two modes, where more may begin";
  return text;
}

std::string own_words(const OwnAnswer& own) {
  if (own.status != Status::solved)
    return std::string("ended with \"") + status_text(own.status) +
           "\": there is nothing to compare with";
  return "differs by " + short_number(own.force) + " N in a contact's force and by " +
         short_number(own.acceleration) + " m/s^2 in the motion";
}

} // namespace

std::string verify_text(const SceneFile& file, const VerifyReport& report) {
  const std::string text = title_line(file) + headline(report);
  if (report.verdict == Verdict::other_data) return text;
  std::vector<Fact> facts{tolerance_fact(report)};
  for (const std::string& what : report.completed) facts.push_back({"Completed", what});
  if (report.refined.found) facts.push_back(basis_fact(report.refined));
  if (is_valid(report.verdict)) {
    facts.push_back({"Around it", around_words(report)});
    facts.push_back({"lcpush's own", own_words(report.own)});
  }
  facts.push_back(metrics_fact(report.metrics));
  facts.push_back({"Paper's objective", short_number(report.objective) + " N m/s^2"});
  std::vector<std::vector<std::string>> table = {{"law", "scaled", "SI", "", "worst row"}};
  for (const BrokenRow& row : report.rows) {
    const bool exact = row.scaled < 1e-9;
    table.push_back({law_text(row), short_number(row.scaled), exact ? "" : short_number(row.si),
                     exact ? "" : row.unit, row.scaled <= report.tolerance ? "holds" : row.name});
  }
  std::size_t widest = 0;
  for (auto& line : table) widest = std::max(widest, line.back().size());
  for (auto& line : table) line.back().resize(widest, ' ');
  return text + "\n" + facts_text(facts) + "\n" + table_text(table);
}

std::string verify_text(const RawVerifyReport& report) {
  const std::string text = headline(report);
  if (report.verdict == Verdict::other_data) return text;
  std::vector<Fact> facts{tolerance_fact(report)};
  if (report.row >= 0)
    facts.push_back({"Worst row", std::to_string(report.row + 1) + ": z = " + number(*report.z) +
                                      ", w = " + number(*report.w)});
  if (report.refined.found)
    facts.push_back({"Its basis", "solved exactly moves z by " +
                                      short_number(report.refined.moved) + " and is off by " +
                                      residual_text(report.refined.residual)});
  if (is_valid(report.verdict))
    facts.push_back({"lcpush's own",
                     report.own.status == Status::solved
                         ? "differs by " + short_number(report.own.force)
                         : std::string("ended with \"") + status_text(report.own.status) + "\""});
  facts.push_back(metrics_fact(report.metrics));
  return text + "\n" + facts_text(facts);
}

} // namespace lcpush::desktop
