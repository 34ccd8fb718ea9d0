// Sweeps as text: what they show, then what changes where, then numbers.
#include <algorithm>
#include <cmath>

#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "sweep/settings.hpp"
#include "sweep/sweep_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// A line after another.
std::string paragraph(const std::string& lines) { return lines.empty() ? "" : "\n" + lines; }

/// Has the message said it: where the grasp holds, and where there is an answer?
bool is_in_message(const SweepEvent& event) {
  return std::all_of(event.changes.begin(), event.changes.end(), [](const ToldChange& change) {
    return change.is_of_holding() || change.kind != AnswerChange::Kind::modes;
  });
}

/// The first ones; how many more there are.
std::string few_lines(const std::vector<std::string>& lines, std::size_t most,
                      const std::string& what) {
  std::string text;
  for (std::size_t k = 0; k < std::min(lines.size(), most); ++k) text += lines[k] + "\n";
  if (lines.size() > most)
    text += "  (" + counted(static_cast<Index>(lines.size() - most), "more " + what) + ": -v.)\n";
  return text;
}

/// "at *.grip_force = 6.54 N: wall sticks": a line a place.
std::string event_lines(const Sweep& sweep, const std::vector<SweepEvent>& events,
                        Telling telling) {
  const bool is_full = telling == Telling::full;
  const Variation& variation = sweep.variations[0];
  std::vector<std::string> lines;
  const SweepEvent* last = nullptr;
  for (const SweepEvent& event : events) {
    if (!is_full && is_in_message(event)) continue;
    const bool is_next = last == nullptr ||
                         !are_one_place(variation, last->value(), event.value()) ||
                         (is_full && last->value() != event.value());
    if (is_next)
      lines.push_back("  at " + variation.parameter.path + " = " +
                      (is_full ? number(event.value()) : event_place(variation, event)) + ": ");
    else
      lines.back() += "; ";
    lines.back() += event_text(sweep, event);
    last = &event;
  }
  return few_lines(lines, is_full ? lines.size() : SweepSettings::most_changes, "change");
}

template <class List>
std::string change_lines(const Sweep& sweep, const List& list, Telling telling) {
  return event_lines(sweep, events_of(sweep, list, telling), telling);
}

/// "twist[0], the object's acceleration along x, is zero from 1 to 2".
std::string zero_line(const Sweep& sweep, const SweepZero& zero, Telling telling) {
  const Variation& variation = sweep.variations[0];
  const bool is_full = telling == Telling::full;
  const double small = SweepSettings::merge_distance * std::abs(variation.to - variation.from);
  const auto value = [&](double x) {
    return is_full ? number(x, small) : value_text(variation, x);
  };
  const std::string axis =
      std::string(zero.component < 3 ? "along " : "about ") + "xyz"[zero.component % 3];
  const std::string what =
      (is_full ? "  twist[" + std::to_string(zero.component) + "], the object's acceleration "
               : std::string(zero.component < 3 ? "  the acceleration of " : "  the turn of ") +
                     object_name(sweep.scene) + " ") +
      axis + (is_full ? ", " : " ");
  const std::string unit =
      is_full || variation.parameter.unit.empty() ? "" : " " + variation.parameter.unit;
  const std::string at = "at " + variation.parameter.path + " = " + value(zero.to) + unit;
  if (!is_full && zero.changes_sign())
    return what + (zero.jumps ? "jumps" : "goes") +
           (zero.before < 0 ? " from - to + " : " from + to - ") + at;
  if (zero.jumps) return what + "changes its sign by a jump " + at;
  if (zero.from == zero.to) return what + "is zero " + at;
  return what + "is zero from " + value(zero.from) + " to " + value(zero.to) + unit;
}

std::string zero_lines(const Sweep& sweep, Telling telling) {
  std::vector<std::string> lines;
  for (const SweepZero& zero : sweep.zeros) lines.push_back(zero_line(sweep, zero, telling));
  return few_lines(lines, telling == Telling::full ? lines.size() : SweepSettings::most_zeros,
                   "zero");
}

std::string bistable_lines(const Sweep& sweep, Telling telling) {
  std::string text;
  for (const BistableRange& range : sweep.bistable) text += bistable_text(sweep, range, telling);
  return text;
}

/// What is told of one curve before its numbers.
std::string brief_words(const Sweep& sweep) {
  std::string text = message_text(sweep);
  if (sweep.is_map()) return text;
  const bool has_segments = !sweep.segments.empty();
  text += paragraph((has_segments ? change_lines(sweep, sweep.segments, Telling::brief)
                                  : change_lines(sweep, sweep.points, Telling::brief)) +
                    zero_lines(sweep, Telling::brief));
  const std::string bistable = bistable_lines(sweep, Telling::brief);
  if (bistable.empty()) return text;
  const std::string changes = has_segments ? change_lines(sweep, sweep.back, Telling::brief)
                                           : change_lines(sweep, sweep.points_back, Telling::brief);
  return text + "\n" + bistable + (changes.empty() ? "" : "On the way back:\n" + changes);
}

/// "30 more values: -v, or --format csv.".
std::string more_text(std::size_t count) {
  if (count == 0) return "";
  return "(" + counted(static_cast<Index>(count), "more value") + ": -v, or --format csv.)\n";
}

std::string brief_numbers(const Sweep& sweep) {
  std::size_t left_out = 0;
  if (!sweep.is_map()) {
    const std::string table = brief_table(sweep, left_out);
    return table + more_text(left_out);
  }
  const std::string table = map_table(sweep, left_out);
  const auto named = [](const Parameter& parameter) {
    return parameter.path + (parameter.unit.empty() ? "" : " in " + parameter.unit);
  };
  return std::string(asked(sweep) == Question::breaking ? "The breaking force" : "The push") +
         " in N, " + named(sweep.variations[0].parameter) + " across, " +
         named(sweep.variations[1].parameter) + " down:\n\n" + table + more_text(left_out);
}

std::string full_text(const Sweep& sweep) {
  std::string text = message_text(sweep);
  if (!sweep.segments.empty())
    text += "\n" + segment_table(sweep, sweep.segments) +
            paragraph(change_lines(sweep, sweep.segments, Telling::full));
  if (!sweep.points.empty())
    text += "\n" + point_table(sweep, sweep.points) +
            paragraph(change_lines(sweep, sweep.points, Telling::full));
  text += paragraph(zero_lines(sweep, Telling::full));
  text += paragraph(bistable_lines(sweep, Telling::full));
  if (!sweep.back.empty())
    text += "\nThe way back:\n" + segment_table(sweep, sweep.back) +
            paragraph(change_lines(sweep, sweep.back, Telling::full));
  if (!sweep.points_back.empty())
    text += "\nThe way back:\n" + point_table(sweep, sweep.points_back) +
            paragraph(change_lines(sweep, sweep.points_back, Telling::full));
  return text;
}

} // namespace

std::string sweep_text(const std::vector<SweepCurve>& given, Telling telling) {
  std::vector<SweepCurve> curves = given;
  for (SweepCurve& curve : curves) curve.sweep = in_typed_units(std::move(curve.sweep));
  const bool is_full = telling == Telling::full, is_one = curves.size() == 1;
  const bool is_one_scene = std::all_of(curves.begin(), curves.end(), [&](const SweepCurve& curve) {
    return curve.scene == curves.front().scene;
  });
  std::string text = is_one_scene ? title_line(curves.front().sweep.scene) : "";
  for (const SweepCurve& curve : curves) {
    const bool is_first = &curve == &curves.front();
    if (!is_one) text += (is_first ? "" : "\n") + curve.label + "\n";
    text += is_full ? full_text(curve.sweep) : brief_words(curve.sweep);
    if (!is_full && is_one) text += "\n" + brief_numbers(curve.sweep);
  }
  if (!is_full && !is_one)
    text += "\n" + curves_table(curves) + "(All values: -v, or --format csv.)\n";
  text += "\nbreak: the force at which the object starts to move, the pusher's normal force, as in "
          "`lcpush break`; push: its whole force, friction included, for the motion as prescribed, "
          "as in `lcpush solve`.";
  return text + (is_full ? " Every answer has been checked apart from the solver.\n" : "\n");
}

} // namespace lcpush::desktop
