// Sweeps as tables of at most 80 columns.
#include <algorithm>
#include <cmath>

#include "sweep/settings.hpp"
#include "sweep/sweep_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// "*.grip_force N", or the unit alone.
std::string head_of(const Parameter& parameter, bool is_long) {
  if (!is_long) return parameter.unit.empty() ? "value" : parameter.unit;
  return parameter.path + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

/// "20.02", or why there is none.
std::string answer_cell(const SweepAnswer& answer, double value, int digits, double zero) {
  if (answer.has_force()) return in_digits(value, digits, zero);
  const bool is_said = answer.is_known() || answer.status == Status::bad_input;
  return is_said ? "-" : status_text(answer.status);
}
std::string force_cell(const SweepValue& at, Question question, int digits, double zero) {
  return answer_cell(at[question], force_of(at, question), digits, zero);
}

std::string brief_force_cell(const SweepValue& at, Question question, double largest) {
  return answer_cell(at[question], told_force(force_of(at, question), largest), 3, 0);
}

double largest_force(const Sweep& sweep) {
  double largest = 0;
  for_each_value(sweep, [&](const SweepValue& value) {
    largest = std::max({largest, std::abs(value.breaking.normal), value.push.force.norm()});
  });
  return largest;
}

/// Of the push: linear and angular acceleration, of a turn about one axis with its sign. Either is
/// zero beside the other, over the scene's length, where it is unfelt.
void add_motion(std::vector<std::string>& row, const SweepAnswer& push,
                const std::optional<Index>& axis, int digits) {
  const Vector3<double> turn = push.twist.tail<3>();
  const double linear = push.twist.head<3>().norm(), angular = turn.norm();
  const double length = push.turning_noise > 0 ? push.motion_noise / push.turning_noise : 1;
  row.push_back(answer_cell(push, linear, digits,
                            std::max(push.motion_noise, SweepSettings::unfelt * angular * length)));
  row.push_back(answer_cell(push, axis ? turn[*axis] : angular, digits,
                            std::max(push.turning_noise, SweepSettings::unfelt * linear / length)));
}

/// "rad/s^2 z" of a turn about one axis.
std::string turn_head(const std::optional<Index>& axis) {
  return "rad/s^2" + (axis ? std::string(" ") + "xyz"[*axis] : "");
}

/// A row of the brief table.
struct ShownValue {
  double value;
  const SweepValue* at;
  bool matters; ///< an end, or beside a change that is told
};

std::vector<ShownValue> shown_of(const std::vector<SweepSegment>& segments,
                                 const std::vector<SweepEvent>& events) {
  const auto is_told = [&](double value) {
    return std::any_of(events.begin(), events.end(), [&](const SweepEvent& event) {
      return event.at.push == value || event.at.breaking == value;
    });
  };
  std::vector<ShownValue> list = {{segments.front().from, &segments.front().at_from, true}};
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const bool last = k + 1 == segments.size(), matters = last || is_told(segments[k].to);
    list.push_back({segments[k].to, &segments[k].at_to, matters});
    if (last) break;
    const SweepValue &before = segments[k].at_to, &after = segments[k + 1].at_from;
    if (segments[k].change.jumps || before.push.status != after.push.status ||
        before.breaking.status != after.breaking.status)
      list.push_back({segments[k].to, &after, matters});
  }
  return list;
}

/// What matters, if that is few enough; else evenly chosen.
std::vector<ShownValue> chosen(const std::vector<ShownValue>& all) {
  if (all.size() <= SweepSettings::most_rows) return all;
  std::vector<ShownValue> list;
  for (const ShownValue& shown : all)
    if (shown.matters) list.push_back(shown);
  if (list.size() > 2 && list.size() <= SweepSettings::most_rows) return list;
  list.clear();
  for (const std::size_t k : evenly(all.size(), SweepSettings::most_rows)) list.push_back(all[k]);
  return list;
}

} // namespace

std::vector<std::size_t> evenly(std::size_t n, std::size_t most) {
  std::size_t count = std::min(n, most);
  // Steps of the same size, if a few fewer make that possible.
  for (std::size_t fewer = count; n > most && fewer >= SweepSettings::fewest_even_rows; --fewer)
    if ((n - 1) % (fewer - 1) == 0) {
      count = fewer;
      break;
    }
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < count; ++k)
    list.push_back(count < 2 ? 0 : (2 * k * (n - 1) + count - 1) / (2 * (count - 1)));
  return list;
}

std::string value_text(const Variation& variation, double value) {
  // What is stopped after its first value has no range.
  const double range = std::abs(variation.to - variation.from);
  const double size = std::max(std::abs(variation.from), std::abs(variation.to));
  const double more = range > 0 ? std::log10(size / range) : SweepSettings::digits_more;
  const int digits = 3 + static_cast<int>(std::clamp<double>(more, 0, SweepSettings::digits_more));
  // The ends are as somebody has typed them.
  const bool is_end = value == variation.from || value == variation.to;
  return is_end ? number(value) : in_digits(value, digits, SweepSettings::merge_distance * range);
}

std::string with_unit(const Variation& variation, double value) {
  const std::string& unit = variation.parameter.unit;
  return value_text(variation, value) + (unit.empty() ? "" : " " + unit);
}

bool are_one_place(const Variation& variation, double a, double b) {
  return std::abs(a - b) <= SweepSettings::one_place * std::abs(variation.to - variation.from);
}

std::string event_place(const Variation& variation, const SweepEvent& event) {
  const std::string place = with_unit(variation, event.value());
  if (!event.at.push || !event.at.breaking) return place;
  const std::string pushed = with_unit(variation, *event.at.push);
  return pushed == place ? place : place + " (as prescribed at " + pushed + ")";
}

std::optional<Index> axis_of_turn(const Sweep& sweep) {
  Vector3<double> most = Vector3<double>::Zero();
  double noise = 0;
  for_each_value(sweep, [&](const SweepValue& value) {
    most = most.cwiseMax(value.push.twist.tail<3>().cwiseAbs());
    noise = std::max(noise, value.push.turning_noise);
  });
  const double zero = std::max(noise, SweepSettings::unfelt * most.maxCoeff());
  Index axis = 0;
  if ((most.array() > zero).count() != 1) return std::nullopt;
  most.maxCoeff(&axis);
  return axis;
}

std::string brief_table(const Sweep& sweep, std::size_t& left_out) {
  const Variation& variation = sweep.variations[0];
  std::vector<ShownValue> all;
  for (const SweepPoint& point : sweep.points)
    if (!point.refined) all.push_back({point.value, &point.at, false});
  if (sweep.points.empty())
    all = shown_of(sweep.segments, events_of(sweep, sweep.segments, Telling::brief));
  const std::vector<ShownValue> list = chosen(all);
  left_out = (sweep.points.empty() ? all.size() : sweep.points.size()) - list.size();
  const double largest = largest_force(sweep);
  const std::optional<Index> axis = axis_of_turn(sweep);
  return fitted_table(3, [&](int digits, bool long_head) {
    Rows rows{{head_of(variation.parameter, long_head)}};
    if (sweep.asks_breaking) rows[0].push_back("break N");
    rows[0].insert(rows[0].end(), {"push N", "m/s^2", turn_head(axis)});
    for (const ShownValue& shown : list) {
      std::vector<std::string> row{value_text(variation, shown.value)};
      if (sweep.asks_breaking)
        row.push_back(brief_force_cell(*shown.at, Question::breaking, largest));
      row.push_back(brief_force_cell(*shown.at, Question::push, largest));
      add_motion(row, shown.at->push, axis, digits);
      rows.push_back(row);
    }
    return rows;
  });
}

std::string map_table(const Sweep& sweep, std::size_t& left_out) {
  const Variation &x = sweep.variations[0], &y = sweep.variations[1];
  std::size_t columns = 0;
  while (columns < sweep.points.size() &&
         sweep.points[columns].second == sweep.points.front().second)
    ++columns;
  const std::vector<std::size_t> across = evenly(columns, SweepSettings::most_columns);
  const std::vector<std::size_t> down =
      evenly(sweep.points.size() / columns, SweepSettings::most_rows);
  left_out = sweep.points.size() - across.size() * down.size();
  const Question question = asked(sweep);
  const double largest = largest_force(sweep);
  return fitted_table(3, [&](int, bool long_head) {
    Rows rows{{long_head ? y.parameter.path : ""}};
    for (const std::size_t k : across) rows[0].push_back(value_text(x, sweep.points[k].value));
    for (const std::size_t row : down) {
      const std::size_t first = row * columns;
      rows.push_back({value_text(y, *sweep.points[first].second)});
      for (const std::size_t k : across)
        rows.back().push_back(brief_force_cell(sweep.points[first + k].at, question, largest));
    }
    return rows;
  });
}

std::string segment_table(const Sweep& sweep, const std::vector<SweepSegment>& segments) {
  const double zero = SweepSettings::table_rounding * largest_force(sweep);
  return fitted_table(6, [&](int digits, bool long_head) {
    Rows rows{{head_of(sweep.variations[0].parameter, long_head), "to", "break N", "to", "slope",
               "push N", "to", "found"}};
    for (const SweepSegment& segment : segments) {
      const SweepValue &a = segment.at_from, &b = segment.at_to;
      const double rise = b.breaking.normal - a.breaking.normal;
      const double slope = std::abs(rise) <= zero ? 0 : rise / (segment.to - segment.from);
      rows.push_back({in_digits(segment.from, digits), in_digits(segment.to, digits),
                      force_cell(a, Question::breaking, digits, zero),
                      force_cell(b, Question::breaking, digits, zero),
                      a.breaking.has_force() ? in_digits(slope, digits) : "-",
                      force_cell(a, Question::push, digits, zero),
                      force_cell(b, Question::push, digits, zero),
                      segment_kind_text(segment.kind)});
    }
    return rows;
  });
}

std::string point_table(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const double zero = SweepSettings::table_rounding * largest_force(sweep);
  const std::optional<Index> axis = axis_of_turn(sweep);
  return fitted_table(6, [&](int digits, bool long_head) {
    Rows rows{{head_of(sweep.variations[0].parameter, long_head)}};
    if (sweep.is_map()) rows[0].push_back(head_of(sweep.variations[1].parameter, long_head));
    rows[0].insert(rows[0].end(), {"break N", "push N", "m/s^2", turn_head(axis)});
    for (const SweepPoint& point : points) {
      std::vector<std::string> row{in_digits(point.value, digits)};
      if (point.second) row.push_back(in_digits(*point.second, digits));
      for (const Question question : {Question::breaking, Question::push})
        row.push_back(force_cell(point.at, question, digits, zero));
      add_motion(row, point.at.push, axis, digits);
      rows.push_back(row);
    }
    return rows;
  });
}

} // namespace lcpush::desktop
