// Sweeps as text.
#include <algorithm>
#include <cmath>

#include "lcpush/desktop/sweep.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

std::string with_unit(const Parameter& parameter) {
  return parameter.path + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

/// "20.02", or why there is none.
std::string number_or(Status status, double value, double zero = 0) {
  if (status == Status::solved) return number(value, zero);
  return status == Status::does_not_hold ? "does not hold"
         : status == Status::bad_input   ? "-"
                                         : status_text(status);
}
std::string breaking_text(const SweepValue& value, double zero) {
  return number_or(value.breaking.status, value.breaking.normal, zero);
}
std::string push_text(const SweepValue& value, double zero) {
  return number_or(value.push.status, value.push.force.norm(), zero);
}

/// What rounding leaves of a zero, in the size of the largest answer.
double force_noise(const Sweep& sweep) {
  double largest = 0;
  for_each_value(sweep, [&](const SweepValue& value) {
    largest = std::max({largest, std::abs(value.breaking.normal), value.push.force.norm()});
  });
  return 1e-12 * largest;
}

std::string change_line(const Sweep& sweep, double value, const std::string& change) {
  if (change.empty()) return "";
  return "  at " + sweep.variations[0].parameter.path + " = " + number(value) + ": " + change +
         "\n";
}

std::string change_lines(const Sweep& sweep, const std::vector<SweepSegment>& segments) {
  std::string text;
  for (const SweepSegment& segment : segments)
    text += change_line(sweep, segment.to, change_text(sweep, segment));
  return text;
}

std::string segment_table(const Sweep& sweep, const std::vector<SweepSegment>& segments) {
  const Parameter& parameter = sweep.variations[0].parameter;
  const double zero = force_noise(sweep);
  std::vector<std::vector<std::string>> rows{
      {with_unit(parameter), "to", "break N", "to", "slope", "push N", "to", "found"}};
  for (const SweepSegment& segment : segments) {
    const SweepValue &a = segment.at_from, &b = segment.at_to;
    const double rise = b.breaking.normal - a.breaking.normal;
    const std::string slope =
        a.breaking.is_solved()
            ? number(std::abs(rise) <= zero ? 0 : rise / (segment.to - segment.from))
            : "-";
    rows.push_back({number(segment.from), number(segment.to), breaking_text(a, zero),
                    breaking_text(b, zero), slope, push_text(a, zero), push_text(b, zero),
                    segment_kind_text(segment.kind)});
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
    row.push_back(breaking_text(point.at, zero));
    row.push_back(push_text(point.at, zero));
    const SweepAnswer& push = point.at.push;
    const double linear = push.twist.head<3>().norm(), angular = push.twist.tail<3>().norm();
    row.push_back(number_or(push.status, linear, 1e-12 * angular));
    row.push_back(number_or(push.status, angular, 1e-9 * linear));
    rows.push_back(row);
    changes += change_line(sweep, point.value, change_text(sweep, point));
  }
  return table_text(rows) + (changes.empty() ? "" : "\n" + changes);
}

/// "the object's acceleration along x is zero from 1 to 2".
std::string zero_text(const Sweep& sweep, const SweepZero& zero) {
  const std::string path = sweep.variations[0].parameter.path;
  const std::string what = std::string("  twist[") + std::to_string(zero.component) +
                           "], the object's acceleration " +
                           (zero.component < 3 ? "along " : "about ") + "xyz"[zero.component % 3];
  const double small = 1e-9 * std::abs(sweep.variations[0].to - sweep.variations[0].from);
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
    const std::string changes = change_lines(sweep, sweep.segments);
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
            change_lines(sweep, sweep.back);
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

} // namespace lcpush::desktop
