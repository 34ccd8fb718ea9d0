#include <algorithm>
#include <cmath>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/spread.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "spread/spread_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// What the file's own law has to do with it, or nothing.
std::string file_law_text(const SceneFile& file) {
  if (file.pressure == Pressure::rigid) return "";
  return std::string("the file's law \"") + pressure_text(file.pressure) +
         (file.pressure == Pressure::pad ? "\" chooses one of these answers"
                                         : "\" spreads each patch's force: other equations");
}

Fact law_fact(const SceneFile& file) {
  const std::string other = file_law_text(file), pyramids = pyramid_text(file);
  return {"Laws", "the paper's, literally (pressure = \"rigid\")" +
                      (other.empty() ? "" : ";\n" + other) +
                      (pyramids.empty() ? "" : ";\n" + pyramids)};
}

/// What may be missing.
std::vector<std::string> doubts_of(const SpreadReport& report) {
  std::vector<std::string> list;
  if (report.stop != Stop::none)
    list.push_back(report.stop == Stop::time ? "the time was up before all was seen"
                                             : "interrupted before all was seen");
  if (!report.enumeration.empty() && report.asked == Enumeration::thorough)
    list.push_back("not enumerated to the end: " + report.enumeration);
  if (report.faces_left > 0 && !report.complete)
    list.push_back(counted(report.faces_left, "more face") +
                   " known but not studied (limit of work): the bounds may be wider");
  if (report.failures > 0)
    list.push_back(counted(report.failures, "bound") +
                   " could not be settled: the set may be wider than printed");
  return list;
}

/// Which answers the bounds speak of.
Fact reach_fact(const SpreadReport& report) {
  std::string text;
  if (report.complete) {
    text = "every solution: all contact modes enumerated, " +
           counted(report.faces, "complementary face");
  } else {
    const Index failed = report.covering_vectors - report.covering_vectors_solved;
    text = "the solutions that were reached: " + counted(report.faces, "face") + " from " +
           counted(report.covering_vectors, "covering vector");
    if (failed > 0) text += " (" + std::to_string(failed) + " ended in none)";
  }
  for (const std::string& doubt : doubts_of(report)) text += "\n" + doubt;
  return {"Answers", text};
}

Fact verdict_fact(const SpreadReport& report) {
  const std::string among = report.complete ? "" : " among these";
  switch (report.verdict) {
  case SpreadVerdict::unique: return {"Verdict", "unique: one motion, one set of forces" + among};
  case SpreadVerdict::same_motion:
    return {"Verdict", "same motion, other forces: the motion is one" + among};
  case SpreadVerdict::ambiguous: break;
  }
  return {"Verdict", "ambiguous: several motions"};
}

std::string motion_table(const SpreadReport& report, int digits) {
  const char* const names[] = {"linear x",  "linear y",  "linear z",
                               "angular x", "angular y", "angular z"};
  const char* const head =
      report.breaking ? "motion per m/s^2 of the push" : "motion of the object";
  std::vector<std::vector<std::string>> rows{{head, "", ""}};
  for (Index k = 0; k < 6; ++k) {
    const double zero = same_acceleration(report) / (k < 3 ? 1 : report.scales.length);
    rows.push_back(
        {names[k], interval_text(report.twist[k], zero, digits), k < 3 ? "m/s^2" : "rad/s^2"});
  }
  return table_text(rows);
}

std::string contact_table(const SceneFile& file, const SpreadReport& report, int most_digits) {
  const double zero = same_force(report);
  return fitted_table(most_digits, [&](int digits, bool is_long) {
    std::vector<std::vector<std::string>> rows{
        {"contact", "normal N", "friction along t N", "along o = n x t N"}};
    if (!is_long) rows[0] = {"contact", "normal N", "along t N", "along o N"};
    for (std::size_t i = 0; i < report.contacts.size(); ++i) {
      const ContactSpread& contact = report.contacts[i];
      const auto text = [&](const Interval& interval) {
        return interval_text(interval, zero, digits, is_long);
      };
      rows.push_back({point_name(file, static_cast<Index>(i)), text(contact.normal),
                      text(contact.tangential[0]), text(contact.tangential[1])});
    }
    return rows;
  });
}

/// "is 20 N", "is 18.4 to 20 N", "is 3 N or more"; "ranges at least from 18.4 to 20 N" where other
/// answers may lie outside.
std::string force_words(const Interval& force, double same, bool complete) {
  const std::string low = in_digits(force.low, 3, same), high = in_digits(force.high, 3, same);
  if (!std::isfinite(force.high)) return "is " + low + " N or more";
  if (is_single(force, same)) return "is " + high + " N";
  return (complete ? "is " : "ranges at least from ") + low + " to " + high + " N";
}

/// No motion in any answer?
bool is_still(const SpreadReport& report) {
  for (Index k = 0; k < 6; ++k) {
    const double zero = same_acceleration(report) / (k < 3 ? 1 : report.scales.length);
    if (!(std::max(-report.twist[k].low, report.twist[k].high) <= zero)) return false;
  }
  return true;
}

/// How hard each pusher pushes, or what breaks the grasp.
std::string push_sentences(const SceneFile& file, const SpreadReport& report) {
  std::string text;
  for (const PusherSpread& pusher : report.pushers)
    text += sentence((!report.breaking   ? "the push by "
                      : is_still(report) ? "the force, which breaks nothing, of "
                                         : "the breaking force of ") +
                     file.body_name(pusher.body) + " " +
                     force_words(pusher.force, same_force(report), report.complete) +
                     ", the sum of its normal forces");
  return text;
}

/// What the laws leave open, and how hard the push is.
std::string message(const SceneFile& file, const SpreadReport& report) {
  const std::string moves = is_still(report)  ? " does not move"
                            : report.breaking ? " begins to move in one way"
                                              : " moves in one way";
  const std::string one_way =
      (report.complete ? "" : "in all answers that were reached, ") + object_name(file) + moves;
  std::string text;
  switch (report.verdict) {
  case SpreadVerdict::unique: text = sentence(one_way + ", under one set of forces"); break;
  case SpreadVerdict::same_motion:
    text = sentence(one_way + "; the laws leave its forces open");
    break;
  case SpreadVerdict::ambiguous:
    text = sentence("the laws leave open how " + object_name(file) +
                    (report.breaking ? " begins to move" : " moves"));
    break;
  }
  if (report.falls)
    text += sentence("there are answers too in which " + object_name(file) +
                     " moves before it is pushed; they are left out");
  return text + push_sentences(file, report);
}

/// Of which answers the ranges speak, and what may be missing.
std::string brief_end(const SceneFile& file, const SpreadReport& report) {
  std::string text = "These are the ranges of every solution.\n";
  if (!report.complete)
    text = std::string("The ranges are at least these, of the solutions that were reached; there "
                       "may be others") +
           (report.asked == Enumeration::thorough ? "" : " (--enumerate looks longer for all)") +
           ".\n";
  for (const std::string& doubt : doubts_of(report)) text += sentence(doubt);
  const std::string law = file_law_text(file);
  const std::string pyramids = pyramid_text(file);
  return text + (law.empty() ? "" : sentence(law)) + (pyramids.empty() ? "" : sentence(pyramids));
}

std::string failed_text(const SceneFile& file, const SpreadReport& report, Telling telling) {
  RunReport failure = report.failure;
  failure.status = report.status;
  if (failure.reason.empty()) failure.reason = "no answer was reached";
  std::string text = telling == Telling::full ? facts_text({law_fact(file)}) : "";
  text += failure_text(file, failure) + "\n";
  if (report.complete)
    return text + "No solution: every assignment of contact modes was refuted.\n";
  text +=
      "No solution was reached from " + counted(report.covering_vectors, "covering vector") + ".\n";
  for (const std::string& doubt : doubts_of(report)) text += sentence(doubt);
  return text;
}

} // namespace

std::string spread_text(const SceneFile& file, const SpreadReport& report, Telling telling) {
  const bool is_full = telling == Telling::full;
  std::string text = title_line(file);
  if (report.status != Status::solved) return text + failed_text(file, report, telling);
  text += message(file, report) + "\n";
  if (!is_full)
    return text + motion_table(report, 3) + "\n" + contact_table(file, report, 3) + "\n" +
           brief_end(file, report);
  std::vector<Fact> facts{law_fact(file), reach_fact(report), verdict_fact(report)};
  for (const PusherSpread& pusher : report.pushers)
    facts.push_back({report.breaking ? "Breaking force" : "Push",
                     interval_text(pusher.force, same_force(report), 6) +
                         " N, the sum of the normal forces of " + file.body_name(pusher.body)});
  return text + facts_text(facts) + "\n" + motion_table(report, 6) + "\n" +
         contact_table(file, report, 6) +
         "\nBoth ends of each range belong to answers that were checked apart from the solver: "
         "scaled residual " +
         residual_text(report.residual) + ". Not every value in between need belong to one. " +
         counted(report.programs, "linear program") + ".\n";
}

std::string spread_json(const SceneFile& file, const SpreadReport& report) {
  const bool solved = report.status == Status::solved;
  JsonWriter json;
  json.begin_object().member("status", status_text(report.status));
  write_warnings(json, check_scene(file));
  json.member("verdict", when(solved, verdict_text(report.verdict)));
  json.member("laws", "rigid").member("pressure", pressure_text(file.pressure));
  json.member("breaking", report.breaking);
  json.member("faces", report.faces).member("covers", report.covering_vectors);
  json.member("covers_solved", report.covering_vectors_solved).member("complete", report.complete);
  json.member("enumeration", unless_empty(report.enumeration));
  json.member("stopped", unless_empty(std::string(stop_text(report.stop))));
  json.member("faces_left", report.faces_left).member("failures", report.failures);
  json.member("linear_programs", report.programs).member("assignments", report.assignments);
  if (!solved) {
    write_failure(json, file, report.failure);
    return json.end_object().text();
  }
  json.member("residual", report.residual);
  const auto write_ends = [&](const Interval& interval) { json.value(ends_of(interval)); };
  if (report.breaking) json.member("falls", report.falls);
  json.key(report.breaking ? "break_force" : "push_force").begin_object();
  for (const PusherSpread& pusher : report.pushers)
    json.member(file.body_name(pusher.body), ends_of(pusher.force));
  json.end_object().list("twist", report.twist, write_ends);
  json.objects("contacts", static_cast<Index>(report.contacts.size()), [&](Index i) {
    const ContactSpread& contact = report.contacts[static_cast<std::size_t>(i)];
    json.member("name", point_name(file, i)).member("body", file.body_name(file.body_of(i)));
    json.member("normal_force", ends_of(contact.normal));
    json.list("tangential_force", contact.tangential, write_ends);
    json.member("torsion", ends_of(contact.torsion));
  });
  return json.end_object().text();
}

} // namespace lcpush::desktop
