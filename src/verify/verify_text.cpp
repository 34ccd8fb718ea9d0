#include <algorithm>
#include <cmath>

#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/verify.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "verify/settings.hpp"
#include "verify/verify_rows.hpp"

namespace lcpush::desktop {
namespace {

bool is_rounding(double x) { return std::abs(x) < VerifySettings::negligible; }

/// Two digits; without those that only say how rounding went.
std::string short_number(double x) { return is_rounding(x) ? "below 1e-9" : printed("%.2g", x); }

/// "by 11 N", "by less than 1e-9 N".
std::string by(double x, const std::string& unit) {
  return "by " + (is_rounding(x) ? "less than 1e-9" : short_number(x)) +
         (unit.empty() ? "" : " " + unit);
}

/// `because`: the report's, in words of its own.
std::string headline(const JudgedAnswer& report, const std::string& because) {
  std::string text = verdict_text(report.verdict);
  text[0] = static_cast<char>(text[0] - 'a' + 'A');
  if (report.verdict == Verdict::spurious_minimum)
    return text +
           ".\nEvery linear constraint holds, but not every product vanishes, and no small step "
           "lowers their sum: an optimiser stops here (" +
           because + ").\n";
  return text + (because.empty() ? "" : ", because " + because) + ".\n";
}

std::string headline(const RawVerifyReport& report) {
  return headline(report, report.verdict == Verdict::not_a_solution ? "of " + report.because
                                                                    : report.because);
}

/// ": 0.059 N (1.3 %) too much"
std::string excess(const BrokenRow& row) {
  if (!row.found || !row.lawful) return "";
  const double share = VerifySettings::percent * std::abs((*row.found - *row.lawful) / *row.lawful);
  const bool is_share = *row.found * *row.lawful > 0 && // and not of a rounded zero
                        std::abs(*row.lawful) > VerifySettings::negligible * std::abs(*row.found);
  return ": " + short_number(row.si) + " " + row.unit +
         (is_share ? " (" + brief(share) + " %)" : "") +
         (!is_share                                      ? " off"
          : std::abs(*row.found) > std::abs(*row.lawful) ? " too much"
                                                         : " too little");
}

std::string headline(const VerifyReport& report) {
  if (report.verdict != Verdict::not_a_solution) return headline(report, report.because);
  const BrokenRow& told = report.rows[report.told];
  return headline(report, told.law ? "of " + report.because : told.name + excess(told));
}

/// "For an object that moves at 0.01 m/s^2 along +x, its forces and its load leave 0.059 N along
/// +x."
std::string imbalance_sentence(const VerifyReport& report) {
  if (!report.imbalance || !report.hint.empty() ||
      report.imbalance->norm() <= VerifySettings::turned * report.rows[report.told].si)
    return "";
  const auto told = [](const Vector3<double>& v, const std::string& unit) {
    return short_number(v.norm()) + " " + unit + " along " + direction_text(v.normalized());
  };
  const bool moves = !is_rounding(report.acceleration.norm());
  return "For an object that " +
         (moves ? "moves at " + told(report.acceleration, "m/s^2") : "does not accelerate") +
         ", the bodies' forces and its load leave " + told(*report.imbalance, "N") + ".\n";
}

/// "Along z the forces leave 5.6 N: ..", of a planar scene.
std::string plane_sentence(const VerifyReport& report) {
  if (report.out_of_plane == 0) return "";
  return "Along z the bodies' forces leave " + short_number(std::abs(report.out_of_plane)) +
         " N. That is not judged: a planar scene has no balance there.\n";
}

std::string hint_line(const VerifyReport& report) {
  return report.hint.empty() ? "" : report.hint + "\n";
}

/// How well the laws hold, beside what is allowed.
/// `size`: the worst row's in SI units, or nothing.
std::string fit_sentence(const JudgedAnswer& report, const std::string& size = "") {
  return (is_valid(report.verdict) ? "Every law holds: the worst row's error is "
                                   : "The worst row's error is ") +
         (size.empty() ? "" : size + ", ") + residual_text(report.residual) +
         " in scaled units, where " + short_number(report.tolerance) + " is allowed.\n";
}

Fact tolerance_fact(const JudgedAnswer& report) {
  return {"Tolerance", short_number(report.tolerance) + "; the worst row's error is " +
                           residual_text(report.residual) + " in scaled units"};
}

Fact metrics_fact(const ForeignMetrics& metrics) {
  return {"Natural map",
          short_number(metrics.natural_map) + " (max |min(z, w)|); Fischer-Burmeister " +
              short_number(metrics.fischer_burmeister) + "; z'w " + short_number(metrics.products)};
}

Fact basis_fact(const RefinedAnswer& refined) {
  if (!(refined.residual <= VerifySettings::solves))
    return {"Its basis", "is no solution's: solved exactly it is off " + by(refined.residual, "")};
  return {"Its basis", "solved exactly, moves " +
                           (refined.force ? "a force " + by(*refined.force, "N") + " and " : "") +
                           "the motion " + by(refined.acceleration, "m/s^2")};
}

std::string around_words(const VerifyReport& report) {
  if (report.motion_proved) return "this scene has one motion only: every normal force is known";
  const FinalBasis& basis = report.basis;
  if (!basis.studied) return "not studied: too many contact points";
  std::string text = basis.motion_open ? "the motion is open" : "no other motion";
  text += basis.wrench_open ? ", the pushers' wrench is open" : ", no other wrench of the pushers";
  if (basis.tied_contacts > 0)
    text += "; " + counted(basis.tied_contacts, "contact") +
            (basis.tied_contacts == 1 ? " is" : " are") +
            " between two modes, where more may begin";
  return text;
}

std::string own_words(const OwnAnswer& own) {
  if (own.status != Status::solved)
    return std::string("ended with \"") + status_text(own.status) +
           "\": there is nothing to compare with";
  return "differs " + (own.force ? by(*own.force, "N") + " in a contact's force and " : "") +
         by(own.acceleration, "m/s^2") + " in the motion";
}

/// How far lcpush's own answer is, if it is another.
std::string own_sentence(const VerifyReport& report) {
  if (report.verdict == Verdict::same_solution) return "";
  return "lcpush's own answer " + own_words(report.own) + ".\n";
}

/// Without what forces that were fitted to a wrong given number are off by.
std::vector<BrokenRow> broken_rows(const VerifyReport& report) {
  std::vector<BrokenRow> broken;
  for (const BrokenRow& row : report.rows) {
    const bool is_fitted = !broken.empty() && !broken.front().law &&
                           row.unit == broken.front().unit &&
                           row.si < VerifySettings::of_given * broken.front().si;
    if (!(row.scaled <= report.tolerance) && !is_fitted) broken.push_back(row);
  }
  return broken;
}

/// The rows that break a law: "  dissipation, by 0.14 m/s^2: friction of left.1 ..".
std::string broken_lines(const std::vector<BrokenRow>& rows) {
  std::string text;
  for (const BrokenRow& row : rows)
    text +=
        std::string("  ") + law_text(row) + ", " + by(row.si, row.unit) + ": " + row.name + "\n";
  return text;
}

/// Of an answer that is off by no more than numbers of three digits are, a number told for itself.
std::string rounding_sentence(const SceneFile& file, const VerifyReport& report) {
  const BrokenRow& told = report.rows[report.told];
  const bool is_motion = told.unit == "m/s^2"; // small beside weights, not beside the push
  const double size = told.found ? std::max(std::abs(*told.found), std::abs(*told.lawful))
                                 : std::max(push_size(file.view()), report.acceleration.norm());
  const bool is_number_off = (told.found || is_motion) && told.si > VerifySettings::rounded * size;
  if (!report.in_few_digits || !report.hint.empty() || is_number_off ||
      !(report.residual <= VerifySettings::rounded))
    return "";
  return "That is within the rounding of " + counted(VerifySettings::told_digits, "digit") +
         ": --tolerance " + next_tolerance(report.residual) + " takes it.\n";
}

/// In SI units, of the row that is worst in scaled ones.
std::string worst_size(const VerifyReport& report) {
  const auto worst =
      std::max_element(report.rows.begin(), report.rows.end(),
                       [](const BrokenRow& a, const BrokenRow& b) { return a.scaled < b.scaled; });
  return short_number(worst->si) + " " + worst->unit;
}

std::string brief_verdict(const SceneFile& file, const VerifyReport& report) {
  const bool valid = is_valid(report.verdict);
  std::string text = headline(report) + hint_line(report) + imbalance_sentence(report) +
                     fit_sentence(report, valid ? "" : worst_size(report));
  for (const std::string& what : report.completed) text += "Filled in: " + what + ".\n";
  text += plane_sentence(report);
  if (valid) return text + own_sentence(report);
  const std::vector<BrokenRow> broken = broken_rows(report);
  // Of a single law the first sentence has said it.
  text += rounding_sentence(file, report);
  if (broken.size() < 2) return text;
  return text + "\nThe laws that do not hold, and their worst rows:\n" + broken_lines(broken);
}

std::string law_table(const VerifyReport& report) {
  std::vector<std::vector<std::string>> rows = {{"law", "scaled", "SI", "", ""}};
  for (const BrokenRow& row : report.rows) {
    const bool exact = is_rounding(row.scaled);
    rows.push_back({law_text(row), short_number(row.scaled), exact ? "" : short_number(row.si),
                    exact ? "" : row.unit, row.scaled <= report.tolerance ? "holds" : "broken"});
  }
  return table_text(rows);
}

} // namespace

std::string verify_text(const SceneFile& file, const VerifyReport& report, Telling telling) {
  const std::string text = title_line(file);
  if (report.verdict == Verdict::other_data) return text + headline(report);
  if (telling == Telling::brief) return text + brief_verdict(file, report);
  std::vector<Fact> facts{tolerance_fact(report)};
  for (const std::string& what : report.completed) facts.push_back({"Filled in", what});
  if (report.refined.found) facts.push_back(basis_fact(report.refined));
  if (is_valid(report.verdict)) {
    facts.push_back({"Around it", around_words(report)});
    facts.push_back({"lcpush's own", own_words(report.own)});
  }
  facts.push_back(metrics_fact(report.metrics));
  facts.push_back({"Paper's objective", short_number(report.objective) + " N m/s^2"});
  const std::string broken = broken_lines(broken_rows(report));
  return text + headline(report) + hint_line(report) + imbalance_sentence(report) +
         plane_sentence(report) + "\n" + facts_text(facts) + "\n" + law_table(report) +
         (broken.empty() ? "" : "\nThe worst rows of the broken laws:\n" + broken);
}

std::string verify_text(const RawVerifyReport& report, Telling telling) {
  const std::string text = headline(report);
  if (report.verdict == Verdict::other_data) return text;
  if (telling == Telling::brief) return text + fit_sentence(report);
  std::vector<Fact> facts{tolerance_fact(report)};
  if (report.row >= 0)
    facts.push_back({"Worst row", std::to_string(report.row + 1) + ": z = " + number(*report.z) +
                                      ", w = " + number(*report.w)});
  if (report.refined.found)
    facts.push_back({"Its basis", "solved exactly, moves z " + by(report.refined.moved, "") +
                                      " and is off " + by(report.refined.residual, "")});
  if (is_valid(report.verdict))
    facts.push_back({"lcpush's own",
                     report.own.status == Status::solved
                         ? "differs " + by(*report.own.force, "")
                         : std::string("ended with \"") + status_text(report.own.status) + "\""});
  facts.push_back(metrics_fact(report.metrics));
  return text + "\n" + facts_text(facts);
}

} // namespace lcpush::desktop
