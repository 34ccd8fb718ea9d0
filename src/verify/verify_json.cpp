#include "formats/json_writer.hpp"
#include "lcpush/desktop/verify.hpp"
#include "scenes/warnings_json.hpp"

namespace lcpush::desktop {
namespace {

void write_verdict(JsonWriter& json, const JudgedAnswer& report) {
  json.begin_object().member("verdict", verdict_text(report.verdict));
  json.member("valid", is_valid(report.verdict)).member("because", unless_empty(report.because));
  json.member("tolerance", report.tolerance);
}

void write_metrics(JsonWriter& json, const ForeignMetrics& metrics) {
  json.member("natural_map", metrics.natural_map);
  json.member("fischer_burmeister", metrics.fischer_burmeister);
  json.member("products", metrics.products);
}

} // namespace

std::string verify_json(const VerifyReport& report, const std::vector<SceneDoubt>& warnings) {
  JsonWriter json;
  write_verdict(json, report);
  write_warnings(json, warnings);
  if (report.verdict == Verdict::other_data) return json.end_object().text();
  json.member("residual", report.residual);
  json.key("laws").begin_object();
  for (const BrokenRow& row : report.rows) {
    json.key(law_text(row)).begin_object().member("scaled", row.scaled).member("si", row.si);
    json.member("unit", row.unit).member("holds", row.scaled <= report.tolerance);
    json.member("row", row.name);
    if (!row.law) json.member("found", row.found).member("lawful", row.lawful);
    json.end_object();
  }
  json.end_object().member("completed", report.completed);
  json.member("imbalance", report.imbalance).member("hint", unless_empty(report.hint));
  write_metrics(json, report.metrics);
  json.member("objective", report.objective);
  json.key("basis").begin_object().member("refined", report.refined.found);
  json.member("residual", report.refined.residual).member("moved_force", report.refined.force);
  json.member("moved_acceleration", report.refined.acceleration).end_object();
  json.key("unique").begin_object().member("motion_proved", report.motion_proved);
  json.member("studied", report.basis.studied).member("motion_open", report.basis.motion_open);
  json.member("wrench_open", report.basis.wrench_open);
  json.member("tied_contacts", report.basis.tied_contacts).end_object();
  if (!is_valid(report.verdict)) return json.member("own", nullptr).end_object().text();
  json.key("own").begin_object().member("status", status_text(report.own.status));
  json.member("force_difference", report.own.force);
  json.member("acceleration_difference", report.own.acceleration).end_object();
  return json.end_object().text();
}

std::string verify_json(const RawVerifyReport& report) {
  JsonWriter json;
  write_verdict(json, report);
  if (report.verdict == Verdict::other_data) return json.end_object().text();
  json.member("residual", report.residual);
  json.member("row", when(report.row >= 0, report.row + 1));
  json.member("z", report.z).member("w", report.w);
  write_metrics(json, report.metrics);
  json.key("basis").begin_object().member("refined", report.refined.found);
  json.member("residual", report.refined.residual).member("moved", report.refined.moved);
  json.end_object();
  if (!is_valid(report.verdict)) return json.member("own", nullptr).end_object().text();
  json.key("own").begin_object().member("status", status_text(report.own.status));
  json.member("difference", report.own.force).end_object();
  return json.end_object().text();
}

} // namespace lcpush::desktop
