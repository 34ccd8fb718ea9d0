// Sweeps as CSV and JSON.
#include <algorithm>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "scenes/warnings_json.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// null where no pusher moves, so that nothing breaks.
std::optional<std::string> break_status(const SweepValue& at) {
  const Status status = at.breaking.status;
  return when(status != Status::bad_input, std::string(status_text(status)));
}

void write_segment(JsonWriter& json, const Sweep& sweep, const SweepSegment& segment) {
  const SweepValue &a = segment.at_from, &b = segment.at_to;
  json.member("from", segment.from).member("to", segment.to);
  json.member("kind", segment_kind_text(segment.kind)).member("status", status_text(a.push.status));
  json.member("break_status", break_status(a)).key("break_force").begin_array();
  json.value(when(a.breaking.has_force(), a.breaking.normal));
  json.value(when(b.breaking.has_force(), b.breaking.normal)).end_array();
  json.member("breaks", when(a.breaking.is_solved(), a.breaking.breaks));
  const auto pair = [&](const char* key, const auto& first, const auto& second) {
    if (a.push.is_solved())
      json.key(key).begin_array().value(first).value(second).end_array();
    else
      json.member(key, nullptr);
  };
  pair("force", a.push.force, b.push.force);
  pair("twist", a.push.twist, b.push.twist);
  json.member("residual", std::max(a.residual(), b.residual()));
  json.member("change", unless_empty(change_text(sweep, segment)));
  json.member("jumps", segment.change.jumps);
}

void write_point(JsonWriter& json, const Sweep& sweep, const SweepPoint& point) {
  const SweepAnswer &push = point.at.push, &breaking = point.at.breaking;
  const bool pushed = push.is_solved(), broken = breaking.is_solved();
  json.member("value", point.value);
  if (point.second) json.member("second_value", *point.second);
  json.member("status", status_text(push.status)).member("break_status", break_status(point.at));
  json.member("break_force", when(breaking.has_force(), breaking.normal));
  json.member("breaks", when(broken, breaking.breaks));
  json.member("force", when(pushed, push.force)).member("twist", when(pushed, push.twist));
  json.member("break_twist", when(broken, breaking.twist));
  std::vector<std::string> modes;
  for (const Mode mode : point.modes) modes.emplace_back(mode_text(mode));
  json.member("modes", unless_empty(modes)).member("refined", point.refined);
  if (point.second) json.member("bistable", point.bistable);
  json.member("change", unless_empty(change_text(sweep, point)));
}

/// RFC 4180.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) row += (i > 0 ? "," : "") + csv_text(cells[i]);
  return row + "\n";
}

} // namespace

std::string sweep_csv(const std::vector<SweepCurve>& curves) {
  const Sweep& only = curves.front().sweep;
  std::vector<std::string> head;
  if (curves.size() > 1) head.emplace_back("curve");
  for (const Variation& variation : only.variations) head.push_back(variation.parameter.path);
  for (const char* name : {"break_force", "force_x", "force_y", "force_z", "twist_1", "twist_2",
                           "twist_3", "twist_4", "twist_5", "twist_6", "status", "change"})
    head.emplace_back(name);
  std::string text = csv_row(head);
  for (const SweepCurve& curve : curves) {
    const auto add = [&](double value, const std::optional<double>& second, const SweepValue& at,
                         const std::string& change) {
      std::vector<std::string> row;
      if (curves.size() > 1) row.push_back(curve.label);
      row.push_back(shown(value));
      if (second) row.push_back(shown(*second));
      const bool pushed = at.push.is_solved();
      row.push_back(at.breaking.has_force() ? shown(at.breaking.normal) : "");
      for (Index i = 0; i < 3; ++i) row.push_back(pushed ? shown(at.push.force[i]) : "");
      for (Index i = 0; i < 6; ++i) row.push_back(pushed ? shown(at.push.twist[i]) : "");
      row.push_back(status_text(at.push.status));
      row.push_back(change);
      text += csv_row(row);
    };
    for (const SweepPoint& point : curve.sweep.points)
      add(point.value, point.second, point.at, change_text(curve.sweep, point));
    if (!curve.sweep.points.empty()) continue;
    // The two ends of every segment: at a breakpoint two rows, before and after.
    for (const SweepSegment& segment : curve.sweep.segments) {
      add(segment.from, std::nullopt, segment.at_from, "");
      add(segment.to, std::nullopt, segment.at_to, change_text(curve.sweep, segment));
    }
  }
  return text;
}

namespace {

void write_sweep(JsonWriter& json, const Sweep& sweep) {
  const Variation& first = sweep.variations[0];
  json.member("parameter", first.parameter.path);
  json.member("unit", first.parameter.unit).member("from", first.from).member("to", first.to);
  if (sweep.is_map()) {
    const Variation& second = sweep.variations[1];
    json.member("second_parameter", second.parameter.path);
    json.member("second_unit", second.parameter.unit);
    json.member("second_from", second.from).member("second_to", second.to);
  }
  json.member("pusher", sweep.pusher).member("complete", sweep.complete);
  json.key("friction").begin_object();
  json.member("law", sweep.scene.is_round ? "round" : "pyramids");
  json.member("facets", when(!sweep.scene.is_round, sweep.scene.facets)).end_object();
  json.member("stopped", unless_empty(std::string(stop_text(sweep.stop))));
  std::vector<std::string> contacts;
  for (std::size_t i = 0; i < sweep.scene.points.size(); ++i)
    contacts.push_back(point_name(sweep.scene, static_cast<Index>(i)));
  json.member("contacts", contacts);
  const auto segment = [&](const SweepSegment& entry) { write_segment(json, sweep, entry); };
  const auto point = [&](const SweepPoint& entry) { write_point(json, sweep, entry); };
  json.objects("segments", sweep.segments, segment).objects("segments_back", sweep.back, segment);
  json.objects("points", sweep.points, point).objects("points_back", sweep.points_back, point);
  json.objects("bistable", sweep.bistable, [&](const BistableRange& range) {
    json.member("from", range.from).member("to", range.to).member("motion", range.motion);
    json.member("force_difference", range.force_difference);
    json.member("force_share", range.force_share);
  });
  json.objects("zeros", sweep.zeros, [&](const SweepZero& zero) {
    json.member("of", "twist[" + std::to_string(zero.component) + "]");
    json.member("from", zero.from).member("to", zero.to).member("jumps", zero.jumps);
  });
  json.key("open_force");
  if (sweep.open)
    json.begin_object()
        .member("value", sweep.open->value)
        .member("break_force", sweep.open->one)
        .member("other", sweep.open->other)
        .end_object();
  else
    json.value(nullptr);
  json.member("cold_solves", sweep.cold).member("warm_solves", sweep.warm);
}

} // namespace

std::string sweep_json(const std::vector<SweepCurve>& curves,
                       const std::vector<SceneDoubt>& warnings) {
  JsonWriter json;
  json.begin_object();
  write_warnings(json, warnings);
  if (curves.size() == 1) {
    write_sweep(json, curves.front().sweep);
    return json.end_object().text();
  }
  json.objects("curves", curves, [&](const SweepCurve& curve) {
    json.member("label", curve.label).member("scene", curve.scene);
    json.member("each", curve.each ? std::optional(curve.each->parameter.path) : std::nullopt);
    json.member("each_value", curve.each ? std::optional(curve.each->from) : std::nullopt);
    write_sweep(json, curve.sweep);
  });
  return json.end_object().text();
}

} // namespace lcpush::desktop
