// Sweeps as text, CSV and JSON.
#include <algorithm>
#include <cmath>

#include "lcpush/host/json.hpp"
#include "lcpush/host/sweep.hpp"
#include "message.hpp"
#include "report_format.hpp"

namespace lcpush::host {
namespace {

bool is_solved(Status status) { return status == Status::solved; }

std::string with_unit(const Parameter& parameter) {
  return parameter.path + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

/// "20.02", or why there is none.
std::string number_or(Status status, double value, double zero = 0) {
  if (is_solved(status)) return number(value, zero);
  return status == Status::does_not_hold ? "does not hold"
         : status == Status::bad_input   ? "-"
                                         : status_text(status);
}

double force_of(const SweepValue& value) { return value.force.norm(); }

/// What rounding leaves of a zero, in the size of the largest answer.
double force_noise(const Sweep& sweep) {
  double largest = 0;
  const auto see = [&](const SweepValue& value) {
    largest = std::max(largest, std::max(std::abs(value.break_force), force_of(value)));
  };
  for (const SweepSegment& segment : sweep.segments) {
    see(segment.at_from);
    see(segment.at_to);
  }
  for (const SweepPoint& point : sweep.points) see(point.at);
  return 1e-12 * largest;
}

std::string change_lines(const Parameter& parameter, const std::vector<SweepSegment>& segments) {
  std::string text;
  for (const SweepSegment& segment : segments)
    if (!segment.change.empty())
      text += "  at " + parameter.path + " = " + number(segment.to) + ": " + segment.change + "\n";
  return text;
}

std::string segment_table(const Sweep& sweep, const std::vector<SweepSegment>& segments) {
  const Parameter& parameter = sweep.variations[0].parameter;
  const double zero = force_noise(sweep);
  std::vector<std::vector<std::string>> rows{
      {with_unit(parameter), "to", "break N", "to", "slope", "push N", "to", "found"}};
  for (const SweepSegment& segment : segments) {
    const SweepValue &a = segment.at_from, &b = segment.at_to;
    const double rise = b.break_force - a.break_force;
    const std::string slope =
        is_solved(a.breaking)
            ? number(std::abs(rise) <= zero ? 0 : rise / (segment.to - segment.from))
            : "-";
    rows.push_back(
        {number(segment.from), number(segment.to), number_or(a.breaking, a.break_force, zero),
         number_or(b.breaking, b.break_force, zero), slope, number_or(a.push, force_of(a), zero),
         number_or(b.push, force_of(b), zero), segment_kind_text(segment.kind)});
  }
  return table_text(rows);
}

std::string point_table(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const double zero = force_noise(sweep);
  std::vector<std::vector<std::string>> rows{{with_unit(sweep.variations[0].parameter)}};
  if (sweep.is_map()) rows[0].push_back(with_unit(sweep.variations[1].parameter));
  for (const char* name : {"break N", "push N", "motion m/s^2", "rad/s^2"}) rows[0].push_back(name);
  std::string changes;
  for (const SweepPoint& point : points) {
    std::vector<std::string> row{number(point.value)};
    if (point.second) row.push_back(number(*point.second));
    const SweepValue& at = point.at;
    row.push_back(number_or(at.breaking, at.break_force, zero));
    row.push_back(number_or(at.push, force_of(at), zero));
    const double linear = at.twist.head<3>().norm(), angular = at.twist.tail<3>().norm();
    row.push_back(number_or(at.push, linear, 1e-12 * angular));
    row.push_back(number_or(at.push, angular, 1e-9 * linear));
    rows.push_back(row);
    if (!point.change.empty())
      changes += "  at " + sweep.variations[0].parameter.path + " = " + number(point.value) + ": " +
                 point.change + "\n";
  }
  return table_text(rows) + (changes.empty() ? "" : "\n" + changes);
}

void write_vector(JsonWriter& json, const char* key, Status status, const double* first,
                  Index count) {
  json.key(key);
  if (is_solved(status))
    json.numbers(first, count);
  else
    json.value(nullptr);
}

std::optional<double> known(Status status, double value) {
  return is_solved(status) ? std::optional<double>(value) : std::nullopt;
}

std::string status_of(const SweepValue& value) { return status_text(value.push); }

/// null where no pusher moves, so that nothing breaks.
void write_break_status(JsonWriter& json, Status status) {
  json.key("break_status");
  if (status == Status::bad_input)
    json.value(nullptr);
  else
    json.value(status_text(status));
}

void write_segment(JsonWriter& json, const SweepSegment& segment) {
  const SweepValue &a = segment.at_from, &b = segment.at_to;
  json.begin_object().member("from", segment.from).member("to", segment.to);
  json.member("kind", segment_kind_text(segment.kind));
  json.member("status", status_of(a));
  write_break_status(json, a.breaking);
  json.key("break_force").begin_array();
  json.value(known(a.breaking, a.break_force)).value(known(b.breaking, b.break_force)).end_array();
  const auto pair = [&](const char* key, const double* first, const double* second, Index count) {
    json.key(key);
    if (!is_solved(a.push)) {
      json.value(nullptr);
      return;
    }
    json.begin_array().numbers(first, count).numbers(second, count).end_array();
  };
  pair("force", a.force.data(), b.force.data(), 3);
  pair("twist", a.twist.data(), b.twist.data(), 6);
  json.member("residual", std::max(a.residual, b.residual));
  json.key("change");
  if (segment.change.empty())
    json.value(nullptr);
  else
    json.value(segment.change);
  json.member("jumps", segment.jumps).end_object();
}

void write_point(JsonWriter& json, const SweepPoint& point) {
  json.begin_object().member("value", point.value);
  if (point.second) json.member("second_value", *point.second);
  json.member("status", status_of(point.at));
  write_break_status(json, point.at.breaking);
  json.member("break_force", known(point.at.breaking, point.at.break_force));
  write_vector(json, "force", point.at.push, point.at.force.data(), 3);
  write_vector(json, "twist", point.at.push, point.at.twist.data(), 6);
  write_vector(json, "break_twist", point.at.breaking, point.at.break_twist.data(), 6);
  std::vector<std::string> modes;
  for (const Mode mode : point.modes) modes.emplace_back(mode_text(mode));
  json.key("modes");
  if (modes.empty())
    json.value(nullptr);
  else
    json.strings(modes);
  json.member("refined", point.refined);
  if (point.second) json.member("bistable", point.bistable);
  json.key("change");
  if (point.change.empty())
    json.value(nullptr);
  else
    json.value(point.change);
  json.end_object();
}

template <class List, class Write>
void write_list(JsonWriter& json, const char* key, const List& list, Write write) {
  json.key(key).begin_array();
  for (const auto& entry : list) write(json, entry);
  json.end_array();
}

std::vector<std::string> csv_numbers(const SweepValue& at, bool for_break, bool for_push) {
  std::vector<std::string> cells;
  cells.push_back(for_break ? shown(at.break_force) : "");
  for (Index k = 0; k < 3; ++k) cells.push_back(for_push ? shown(at.force[k]) : "");
  for (Index k = 0; k < 6; ++k) cells.push_back(for_push ? shown(at.twist[k]) : "");
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

namespace {

/// "the object's acceleration along x is zero from 1 to 2".
std::string zero_text(const Sweep& sweep, const SweepZero& zero) {
  const std::string path = sweep.variations[0].parameter.path;
  const std::string what = std::string("  twist[") + std::to_string(zero.component) +
                           "], the object's acceleration " +
                           (zero.component < 3 ? "along " : "about ") + "xyz"[zero.component % 3];
  const double range = std::abs(sweep.variations[0].to - sweep.variations[0].from);
  const double small = 1e-9 * range;
  if (zero.jumps)
    return what + ", changes its sign by a jump at " + path + " = " + number(zero.to, small) + "\n";
  return what + ", is zero " +
         (zero.from == zero.to
              ? "at " + path + " = " + number(zero.from, small)
              : "from " + number(zero.from, small) + " to " + number(zero.to, small)) +
         "\n";
}

std::string bistable_text(const BistableRange& range) {
  return "\nBistable from " + number(range.from) + " to " + number(range.to) +
         ": the way back ends in another answer there" +
         (range.motion ? ", and in another motion.\n" : "; the motion is the same.\n");
}

std::string map_note(const Sweep& sweep) {
  const auto count = std::count_if(sweep.points.begin(), sweep.points.end(),
                                   [](const SweepPoint& point) { return point.bistable; });
  return count == 0 ? ""
                    : "\nBistable at " + std::to_string(count) +
                          " of these: solved from nothing, the object moves in another way.\n";
}

std::string body_text(const Sweep& sweep) {
  std::string text;
  if (!sweep.segments.empty()) {
    text += segment_table(sweep, sweep.segments);
    const std::string changes = change_lines(sweep.variations[0].parameter, sweep.segments);
    if (!changes.empty()) text += "\n" + changes;
  }
  if (!sweep.points.empty())
    text += (sweep.segments.empty() ? "" : "\n") + point_table(sweep, sweep.points);
  if (!sweep.zeros.empty()) text += "\n";
  for (const SweepZero& zero : sweep.zeros) text += zero_text(sweep, zero);
  for (const BistableRange& range : sweep.bistable) text += bistable_text(range);
  text += map_note(sweep);
  if (!sweep.back.empty())
    text += "\nThe way back:\n" + segment_table(sweep, sweep.back) + "\n" +
            change_lines(sweep.variations[0].parameter, sweep.back);
  if (!sweep.points_back.empty())
    text += "\nThe way back:\n" + point_table(sweep, sweep.points_back);
  return text;
}

} // namespace

std::string sweep_text(const std::vector<SweepCurve>& curves) {
  const Sweep& first = curves.front().sweep;
  std::string text = "How the push by " + first.pusher + " changes with ";
  for (std::size_t k = 0; k < first.variations.size(); ++k)
    text += (k > 0 ? " and " : "") + first.variations[k].parameter.path;
  text += "\n";
  for (const SweepCurve& curve : curves)
    text += (curve.label.empty() ? "" : "\n" + curve.label + "\n") + "\n" + body_text(curve.sweep);
  text += "\nbreak: the force at which the object starts to move, as in `lcpush break`; push: the "
          "force for the\nmotion as prescribed, as in `lcpush solve`. Every answer has been "
          "checked apart from the solver.\n";
  return text;
}

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
      for (const std::string& cell : csv_numbers(at, is_solved(at.breaking), is_solved(at.push)))
        row.push_back(cell);
      row.push_back(status_of(at));
      row.push_back(change);
      text += csv_row(row);
    };
    for (const SweepPoint& point : curve.sweep.points)
      add(point.value, point.second, point.at, point.change);
    if (!curve.sweep.points.empty()) continue;
    // The two ends of every segment: at a breakpoint two rows, before and after.
    for (const SweepSegment& segment : curve.sweep.segments) {
      add(segment.from, std::nullopt, segment.at_from, "");
      add(segment.to, std::nullopt, segment.at_to, segment.change);
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
  json.key("contacts").strings(sweep.contacts);
  write_list(json, "segments", sweep.segments, write_segment);
  write_list(json, "segments_back", sweep.back, write_segment);
  write_list(json, "points", sweep.points, write_point);
  write_list(json, "points_back", sweep.points_back, write_point);
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

} // namespace lcpush::host
