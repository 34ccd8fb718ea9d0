#include <array>
#include <cmath>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/spread.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

std::string end_text(double x, double zero) {
  return std::isfinite(x) ? number(x, zero) : x > 0 ? "no bound" : "no bound below";
}

/// "20.02", or "8.05 .. 10" if the ends differ by more than `same`.
std::string interval_text(const Interval& interval, double same) {
  if (is_single(interval, same)) return number((interval.low + interval.high) / 2, same);
  return end_text(interval.low, same) + " .. " + end_text(interval.high, same);
}

Fact law_fact(const SceneFile& file) {
  Fact fact{"Laws", "the paper's, literally (pressure = \"rigid\")"};
  if (file.pressure == Pressure::rigid) return fact;
  fact.text += std::string(";\nthe file's law \"") + pressure_text(file.pressure) +
               (file.pressure == Pressure::pad ? "\" chooses one of these answers"
                                               : "\" spreads each patch's force: other equations");
  return fact;
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
           counted(report.covering_vectors, "cover");
    if (failed > 0) text += " (" + std::to_string(failed) + " ended in none)";
  }
  if (!report.enumeration.empty()) text += "\nnot enumerated to the end: " + report.enumeration;
  if (report.faces_left > 0 && !report.complete)
    text += "\n" + counted(report.faces_left, "more face") +
            " known but not studied (limit of work): the bounds may be wider";
  if (report.failures > 0)
    text += "\n" + counted(report.failures, "bound") +
            " could not be settled: the set may be wider than printed";
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

std::string motion_table(const SpreadReport& report) {
  const char* const names[] = {"linear x",  "linear y",  "linear z",
                               "angular x", "angular y", "angular z"};
  std::vector<std::vector<std::string>> rows{{"motion of the object", "", ""}};
  for (Index k = 0; k < 6; ++k) {
    const double zero = same_acceleration(report) / (k < 3 ? 1 : report.scales.length);
    rows.push_back({names[k], interval_text(report.twist[k], zero), k < 3 ? "m/s^2" : "rad/s^2"});
  }
  return table_text(rows);
}

std::string contact_table(const SceneFile& file, const SpreadReport& report) {
  const double zero = same_force(report);
  std::vector<std::vector<std::string>> rows{
      {"contact", "normal N", "friction along t N", "along o = n x t N"}};
  for (std::size_t i = 0; i < report.contacts.size(); ++i) {
    const ContactSpread& contact = report.contacts[i];
    rows.push_back({point_name(file, static_cast<Index>(i)), interval_text(contact.normal, zero),
                    interval_text(contact.tangential[0], zero),
                    interval_text(contact.tangential[1], zero)});
  }
  return table_text(rows);
}

/// Infinite ends become null.
std::array<double, 2> ends_of(const Interval& interval) { return {interval.low, interval.high}; }

} // namespace

std::string spread_text(const SceneFile& file, const SpreadReport& report) {
  std::string text = title_line(file) + facts_text({law_fact(file)});
  if (report.status != Status::solved) {
    RunReport failure = report.failure;
    failure.status = report.status;
    if (failure.reason.empty()) failure.reason = "no answer was reached";
    text += failure_text(file, failure);
    if (report.complete)
      return text + "\nNo solution: every assignment of contact modes was refuted.\n";
    return text + "\nNo solution was reached from " + counted(report.covering_vectors, "cover") +
           ".\n" +
           (report.enumeration.empty()
                ? ""
                : "Not enumerated to the end: " + report.enumeration + ".\n");
  }
  std::vector<Fact> facts{reach_fact(report), verdict_fact(report)};
  for (const PusherSpread& pusher : report.pushers)
    facts.push_back(
        {"Push by " + file.body_name(pusher.body),
         interval_text(pusher.force, same_force(report)) + " N, the sum of its normal forces"});
  return text + facts_text(facts) + "\n" + motion_table(report) + "\n" +
         contact_table(file, report) +
         "\nBoth ends of each range belong to answers that were checked apart from the solver: "
         "scaled\nresidual " +
         residual_text(report.residual) + ". Not every value in between need belong to one. " +
         counted(report.programs, "linear program") + ".\n";
}

std::string spread_json(const SceneFile& file, const SpreadReport& report) {
  const bool solved = report.status == Status::solved;
  JsonWriter json;
  json.begin_object().member("status", status_text(report.status));
  json.member("verdict", when(solved, verdict_text(report.verdict)));
  json.member("laws", "rigid").member("pressure", pressure_text(file.pressure));
  json.member("faces", report.faces).member("covers", report.covering_vectors);
  json.member("covers_solved", report.covering_vectors_solved).member("complete", report.complete);
  json.member("enumeration", unless_empty(report.enumeration));
  json.member("faces_left", report.faces_left).member("failures", report.failures);
  json.member("linear_programs", report.programs).member("assignments", report.assignments);
  if (!solved) {
    write_failure(json, file, report.failure);
    return json.end_object().text();
  }
  json.member("residual", report.residual);
  const auto write_ends = [&](const Interval& interval) { json.value(ends_of(interval)); };
  json.key("push_force").begin_object();
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
