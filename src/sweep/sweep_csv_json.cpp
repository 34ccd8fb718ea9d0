// Sweeps as CSV and JSON.
#include <algorithm>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

void write_vector(JsonWriter& json, const char* key, const SweepAnswer& answer, const double* first,
                  Index count) {
  json.key(key);
  if (answer.is_solved())
    json.numbers(first, count);
  else
    json.value(nullptr);
}

std::optional<double> break_force(const SweepValue& value) {
  return value.breaking.is_solved() ? std::optional<double>(value.breaking.normal) : std::nullopt;
}

std::string status_of(const SweepValue& value) { return status_text(value.push.status); }

/// null where no pusher moves, so that nothing breaks.
void write_break_status(JsonWriter& json, const SweepValue& value) {
  const Status status = value.breaking.status;
  json.key("break_status");
  if (status == Status::bad_input)
    json.value(nullptr);
  else
    json.value(status_text(status));
}

void write_change(JsonWriter& json, const std::string& change) {
  json.member("change", change.empty() ? std::nullopt : std::optional(change));
}

void write_segment(JsonWriter& json, const Sweep& sweep, const SweepSegment& segment) {
  const SweepValue &a = segment.at_from, &b = segment.at_to;
  json.begin_object().member("from", segment.from).member("to", segment.to);
  json.member("kind", segment_kind_text(segment.kind));
  json.member("status", status_of(a));
  write_break_status(json, a);
  json.key("break_force").begin_array();
  json.value(break_force(a)).value(break_force(b)).end_array();
  const auto pair = [&](const char* key, const double* first, const double* second, Index count) {
    json.key(key);
    if (!a.push.is_solved()) {
      json.value(nullptr);
      return;
    }
    json.begin_array().numbers(first, count).numbers(second, count).end_array();
  };
  pair("force", a.push.force.data(), b.push.force.data(), 3);
  pair("twist", a.push.twist.data(), b.push.twist.data(), 6);
  json.member("residual", std::max(a.residual(), b.residual()));
  write_change(json, change_text(sweep, segment));
  json.member("jumps", segment.change.jumps).end_object();
}

void write_point(JsonWriter& json, const Sweep& sweep, const SweepPoint& point) {
  json.begin_object().member("value", point.value);
  if (point.second) json.member("second_value", *point.second);
  json.member("status", status_of(point.at));
  const SweepAnswer &push = point.at.push, &breaking = point.at.breaking;
  write_break_status(json, point.at);
  json.member("break_force", break_force(point.at));
  write_vector(json, "force", push, push.force.data(), 3);
  write_vector(json, "twist", push, push.twist.data(), 6);
  write_vector(json, "break_twist", breaking, breaking.twist.data(), 6);
  std::vector<std::string> modes;
  for (const Mode mode : point.modes) modes.emplace_back(mode_text(mode));
  json.key("modes");
  if (modes.empty())
    json.value(nullptr);
  else
    json.strings(modes);
  json.member("refined", point.refined);
  if (point.second) json.member("bistable", point.bistable);
  write_change(json, change_text(sweep, point));
  json.end_object();
}

template <class List, class Write>
void write_list(JsonWriter& json, const char* key, const List& list, Write write) {
  json.key(key).begin_array();
  for (const auto& entry : list) write(json, entry);
  json.end_array();
}

std::vector<std::string> csv_numbers(const SweepValue& at) {
  const bool pushed = at.push.is_solved();
  std::vector<std::string> cells;
  cells.push_back(at.breaking.is_solved() ? shown(at.breaking.normal) : "");
  for (Index k = 0; k < 3; ++k) cells.push_back(pushed ? shown(at.push.force[k]) : "");
  for (Index k = 0; k < 6; ++k) cells.push_back(pushed ? shown(at.push.twist[k]) : "");
  return cells;
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
      for (const std::string& cell : csv_numbers(at)) row.push_back(cell);
      row.push_back(status_of(at));
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
  std::vector<std::string> contacts;
  for (std::size_t i = 0; i < sweep.scene.points.size(); ++i)
    contacts.push_back(point_name(sweep.scene, static_cast<Index>(i)));
  json.key("contacts").strings(contacts);
  const auto segment = [&](JsonWriter& to, const SweepSegment& one) {
    write_segment(to, sweep, one);
  };
  const auto point = [&](JsonWriter& to, const SweepPoint& one) { write_point(to, sweep, one); };
  write_list(json, "segments", sweep.segments, segment);
  write_list(json, "segments_back", sweep.back, segment);
  write_list(json, "points", sweep.points, point);
  write_list(json, "points_back", sweep.points_back, point);
  write_list(json, "bistable", sweep.bistable, [](JsonWriter& to, const BistableRange& range) {
    to.begin_object().member("from", range.from).member("to", range.to);
    to.member("motion", range.motion).end_object();
  });
  write_list(json, "zeros", sweep.zeros, [](JsonWriter& to, const SweepZero& zero) {
    to.begin_object().member("of", "twist[" + std::to_string(zero.component) + "]");
    to.member("from", zero.from).member("to", zero.to).member("jumps", zero.jumps).end_object();
  });
  json.member("cold_solves", sweep.cold).member("warm_solves", sweep.warm);
}

} // namespace

std::string sweep_json(const std::vector<SweepCurve>& curves) {
  JsonWriter json;
  json.begin_object();
  if (curves.size() == 1) {
    write_sweep(json, curves.front().sweep);
    return json.end_object().text();
  }
  json.key("curves").begin_array();
  for (const SweepCurve& curve : curves) {
    json.begin_object().member("label", curve.label).member("scene", curve.scene);
    json.member("each",
                curve.each ? std::optional<std::string>(curve.each->parameter.path) : std::nullopt);
    json.member("each_value", curve.each ? std::optional<double>(curve.each->from) : std::nullopt);
    write_sweep(json, curve.sweep);
    json.end_object();
  }
  return json.end_array().end_object().text();
}

} // namespace lcpush::desktop
