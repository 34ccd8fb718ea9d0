// What a sweep shows, in a few sentences.
#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/sentence.hpp"
#include "sweep/settings.hpp"
#include "sweep/sweep_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

using ForceCurve = std::vector<std::pair<double, double>>;

/// The answers in the sweep's order.
ForceCurve solved_forces(const Sweep& sweep, Question question) {
  ForceCurve curve;
  const auto add = [&](double x, const SweepValue& value) {
    if (value[question].has_force()) curve.emplace_back(x, force_of(value, question));
  };
  for (const SweepSegment& segment : sweep.segments) {
    add(segment.from, segment.at_from);
    add(segment.to, segment.at_to);
  }
  if (!sweep.segments.empty()) return curve;
  bool jumped = false; // next to a jump either of its sides may be what a solve finds
  for (const SweepPoint& point : sweep.points) {
    if (!(jumped && point.refined)) add(point.value, point.at);
    jumped = point.change.jumps;
  }
  return curve;
}

bool by_force(const ForceCurve::value_type& a, const ForceCurve::value_type& b) {
  return a.second < b.second;
}

bool never_falls(ForceCurve::const_iterator begin, ForceCurve::const_iterator end, double noise,
                 int sign) {
  double largest = sign * begin->second;
  for (; begin != end; ++begin) {
    if (sign * begin->second < largest - noise) return false;
    largest = std::max(largest, sign * begin->second);
  }
  return true;
}

std::string newtons(double force, double zero) { return in_digits(force, 3, zero) + " N"; }

/// "at 8.36 N", or "from -5 to 5 degrees" where the force stays as it is there.
std::string extreme_place(const Variation& variation, const ForceCurve& curve,
                          ForceCurve::const_iterator extreme, double noise) {
  const auto is_there = [&](const ForceCurve::value_type& point) {
    return std::abs(point.second - extreme->second) <= noise;
  };
  auto first = extreme, last = extreme;
  while (first != curve.begin() && is_there(*(first - 1))) --first;
  while (last + 1 != curve.end() && is_there(*(last + 1))) ++last;
  const double length = std::abs(last->first - first->first);
  return length <= SweepSettings::short_stretch * std::abs(variation.to - variation.from)
             ? "at " + with_unit(variation, extreme->first)
             : "from " + value_text(variation, first->first) + " to " +
                   with_unit(variation, last->first);
}

/// "grows from 0.333 to 30 N", "falls from 5 to 2 N (at 8 N) and grows to 3 N".
std::string course_text(const Sweep& sweep, const ForceCurve& curve) {
  const Variation& variation = sweep.variations[0];
  const auto [lowest, most] = std::minmax_element(curve.begin(), curve.end(), by_force);
  const double noise =
      SweepSettings::unsaid * std::max(std::abs(lowest->second), std::abs(most->second));
  const double size = noise / SweepSettings::unsaid;
  const auto digits = [size](double force) { return in_digits(told_force(force, size), 3); };
  const auto place = [&](ForceCurve::const_iterator at) {
    return " N (" + extreme_place(variation, curve, at, noise) + ")";
  };
  const std::string from = digits(curve.front().second), to = digits(curve.back().second);
  const std::string low = digits(lowest->second), high = digits(most->second);
  if (most->second - lowest->second <= noise || low == high) return "stays at " + from + " N";
  if (never_falls(curve.begin(), curve.end(), noise, 1))
    return "grows from " + from + " to " + to + " N";
  if (never_falls(curve.begin(), curve.end(), noise, -1))
    return "falls from " + from + " to " + to + " N";
  if (never_falls(curve.begin(), lowest + 1, noise, -1) &&
      never_falls(lowest, curve.end(), noise, 1))
    return "falls from " + from + " to " + low + place(lowest) + " and grows to " + to + " N";
  if (never_falls(curve.begin(), most + 1, noise, 1) && never_falls(most, curve.end(), noise, -1))
    return "grows from " + from + " to " + high + place(most) + " and falls to " + to + " N";
  return "lies between " + low + place(lowest) + " and " + high + place(most);
}

std::string percent(double share) { return in_digits(100 * share, 2) + " %"; }

/// "hardly changes: it " or "changes by 20 % at most: it " of a force that changes little.
std::string share_text(const ForceCurve& curve) {
  const auto [lowest, most] = std::minmax_element(curve.begin(), curve.end(), by_force);
  const double share =
      (most->second - lowest->second) / std::max(std::abs(lowest->second), std::abs(most->second));
  if (!(share > SweepSettings::unsaid && share <= SweepSettings::little)) return "";
  return share <= SweepSettings::hardly ? "hardly changes: it "
                                        : "changes by " + percent(share) + " at most: it ";
}

/// ", by 1 to 8.76 N per N", where the force is a straight line between breakpoints.
std::string slope_text(const Sweep& sweep, Question question, const ForceCurve& curve) {
  if (question != Question::breaking || sweep.segments.empty()) return "";
  const Variation& variation = sweep.variations[0];
  const double range = std::abs(variation.to - variation.from);
  double lowest = 0, most = 0;
  bool any = false, jumps = false;
  for (const SweepSegment& segment : sweep.segments) {
    for (const AnswerChange& change : segment.change[question])
      jumps = jumps || (change.jumps && change.from == change.to);
    const double width = segment.to - segment.from;
    if (segment.kind != SegmentKind::exact || !segment.at_from.breaking.has_force() ||
        std::abs(width) < SweepSettings::short_piece * range)
      continue;
    const double slope = (segment.at_to.breaking.normal - segment.at_from.breaking.normal) / width;
    lowest = any ? std::min(lowest, slope) : slope;
    most = any ? std::max(most, slope) : slope;
    any = true;
  }
  const auto largest = std::max_element(curve.begin(), curve.end(), by_force);
  const double zero = SweepSettings::unsaid * std::abs(largest->second) / range;
  if (!any || std::max(std::abs(lowest), std::abs(most)) <= zero) return "";
  if (most <= zero && lowest < -zero) std::tie(lowest, most) = std::pair(-most, -lowest);
  const std::string a = in_digits(lowest, 3, zero), b = in_digits(most, 3, zero);
  const std::string& unit = variation.parameter.unit;
  const bool turns = lowest < -zero && most > zero;
  return (turns ? ", with slopes from " : ", by ") + (a == b ? a : a + " to " + b) + " N per " +
         (unit.empty() ? "1" : unit) + (jumps ? (turns ? " and jumps" : " and by jumps") : "");
}

std::string range_text(const Variation& variation) {
  return variation.parameter.path + " goes from " + value_text(variation, variation.from) + " to " +
         with_unit(variation, variation.to);
}

/// "the force of wall that breaks the grasp".
std::string subject(const Sweep& sweep, Question question) {
  return question == Question::breaking ? "the force of " + sweep.pusher + " that breaks the grasp"
                                        : "the push by " + sweep.pusher + ", as prescribed,";
}

/// Values one after the other without an answer to a question, for one reason.
struct Gap {
  double from, to;
  Status status; ///< solved: the push breaks nothing
  bool to_end;   ///< to the end of the sweep

  bool operator==(const Gap& other) const {
    return from == other.from && to == other.to && status == other.status;
  }
};

std::vector<Gap> gaps_of(const Sweep& sweep, Question question) {
  std::vector<Gap> gaps;
  bool goes_on = false;
  const auto add = [&](double from, double to, const SweepAnswer& answer) {
    const Status status = answer.status;
    const bool is_gap = !answer.has_force() && status != Status::bad_input;
    const bool same = goes_on && is_gap && gaps.back().status == status;
    if (is_gap && !same) gaps.push_back({from, to, status, false});
    if (is_gap) gaps.back().to = to;
    goes_on = is_gap;
  };
  for (const SweepSegment& segment : sweep.segments)
    add(segment.from, segment.to, segment.at_from[question]);
  if (sweep.segments.empty())
    for (const SweepPoint& point : sweep.points) add(point.value, point.value, point.at[question]);
  if (goes_on) gaps.back().to_end = true;
  return gaps;
}

/// "Up to 3.92 N", "From 7 N on", "From 3 to 4 N", "At 3 N", or "Nowhere".
std::string stretch_text(const Variation& variation, const Gap& gap) {
  const bool rises = variation.to > variation.from;
  const bool from_begin = gap.from == variation.from;
  if (from_begin && gap.to_end) return "In the whole range";
  if (value_text(variation, gap.from) == value_text(variation, gap.to))
    return "At " + with_unit(variation, gap.from);
  if (rises ? from_begin : gap.to_end)
    return "Up to " + with_unit(variation, rises ? gap.to : gap.from);
  if (rises ? gap.to_end : from_begin)
    return "From " + with_unit(variation, rises ? gap.from : gap.to) + " on";
  return "From " + value_text(variation, std::min(gap.from, gap.to)) + " to " +
         with_unit(variation, std::max(gap.from, gap.to));
}

std::string gap_text(const Sweep& sweep, const Gap& gap, const std::string& what) {
  const std::string where = stretch_text(sweep.variations[0], gap);
  if (gap.status == Status::does_not_hold)
    return where + " the grasp does not hold " + object_name(sweep.scene) +
           ": it moves before it is pushed.\n";
  if (gap.status == Status::solved)
    return where + " the push does not break the grasp: " + object_name(sweep.scene) +
           " does not move.\n";
  if (gap.status == Status::not_settled)
    return where + " round friction does not settle" + what + ".\n";
  return where + " there is no answer" + what + " (" + status_text(gap.status) + ").\n";
}

/// Is it between two steps and narrow, and not known?
bool is_sliver(const Sweep& sweep, const Gap& gap) {
  if (gap.status == Status::does_not_hold || gap.status == Status::solved) return false;
  const Variation& variation = sweep.variations[0];
  const double low = std::min(gap.from, gap.to), high = std::max(gap.from, gap.to);
  const double range = std::abs(variation.to - variation.from);
  return high - low < SweepSettings::sliver * range &&
         std::none_of(sweep.points.begin(), sweep.points.end(), [&](const SweepPoint& point) {
           return !point.refined && low <= point.value && point.value <= high;
         });
}

/// What both questions leave open is said once.
std::string gaps_text(const Sweep& sweep) {
  const std::vector<Gap> pushed = gaps_of(sweep, Question::push);
  const std::vector<Gap> broken = gaps_of(sweep, Question::breaking);
  std::string text;
  for (const Gap& gap : broken) {
    if (is_sliver(sweep, gap)) continue;
    const bool both = std::find(pushed.begin(), pushed.end(), gap) != pushed.end();
    text += gap_text(sweep, gap, both ? "" : " for the breaking force");
  }
  for (const Gap& gap : pushed)
    if (!is_sliver(sweep, gap) && std::find(broken.begin(), broken.end(), gap) == broken.end())
      text += gap_text(sweep, gap, " for the push as prescribed");
  return text;
}

std::string stopped_text(const Sweep& sweep) {
  return sweep.stop == Stop::time ? "before the time was up" : "before the interruption";
}

std::string capital(std::string text) {
  if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string map_message(const Sweep& sweep, Question question) {
  const Variation &x = sweep.variations[0], &y = sweep.variations[1];
  std::string text =
      "As " + range_text(x) + " and " + range_text(y) + ", " + subject(sweep, question) + " ";
  const SweepPoint *lowest = nullptr, *most = nullptr;
  std::size_t loose = 0, idle = 0, unsolved = 0, bistable = 0;
  for (const SweepPoint& point : sweep.points) {
    bistable += point.bistable ? 1 : 0;
    const SweepAnswer& answer = point.at[question];
    const Status status = answer.status;
    loose += status == Status::does_not_hold ? 1 : 0;
    idle += answer.is_solved() && !answer.breaks ? 1 : 0;
    unsolved += answer.is_known() ? 0 : 1;
    if (!answer.has_force()) continue;
    const double force = force_of(point.at, question);
    if (lowest == nullptr || force < force_of(lowest->at, question)) lowest = &point;
    if (most == nullptr || force > force_of(most->at, question)) most = &point;
  }
  const auto at = [&](const SweepPoint& point) {
    return newtons(force_of(point.at, question), 0) + " (at " + with_unit(x, point.value) +
           " and " + with_unit(y, *point.second) + ")";
  };
  text += lowest == nullptr ? "has no value.\n"
                            : "lies between " + at(*lowest) + " and " + at(*most) + ".\n";
  const std::string of_all = " of the " + std::to_string(sweep.points.size()) + " places ";
  if (loose > 0)
    text += "At " + std::to_string(loose) + of_all + "the grasp does not hold " +
            object_name(sweep.scene) + ": it moves before it is pushed.\n";
  if (idle > 0)
    text += "At " + std::to_string(idle) + of_all +
            "the push does not break the grasp: " + object_name(sweep.scene) + " does not move.\n";
  if (unsolved > 0) text += "At " + std::to_string(unsolved) + of_all + "there is no answer.\n";
  if (bistable > 0)
    text += "At " + std::to_string(bistable) + of_all + "there are two answers: solved from " +
            "nothing, " + object_name(sweep.scene) + " moves in another way.\n";
  return text;
}

} // namespace

Question asked(const Sweep& sweep) {
  bool breaks = false;
  for_each_value(sweep, [&](const SweepValue& at) { breaks = breaks || at.breaking.has_force(); });
  return breaks ? Question::breaking : Question::push;
}

double force_of(const SweepValue& value, Question question) {
  return question == Question::breaking ? value.breaking.normal : value.push.force.norm();
}

double told_force(double force, double largest) {
  const double zero =
      (force < 0 ? SweepSettings::told_negative : SweepSettings::told_zero) * largest;
  return std::abs(force) <= zero ? 0 : force;
}

std::string message_text(const Sweep& sweep) {
  const Question question = asked(sweep);
  if (sweep.points.empty() && sweep.segments.empty())
    return "Nothing was found " + stopped_text(sweep) + ".\n";
  const std::string end =
      sweep.stop == Stop::none ? "" : "More was not looked at " + stopped_text(sweep) + ".\n";
  if (sweep.is_map()) return map_message(sweep, question) + end;
  const ForceCurve curve = solved_forces(sweep, question);
  const std::string head = "As " + range_text(sweep.variations[0]) + ", ";
  std::string text;
  if (curve.empty())
    text = head + "no push has an answer.\n";
  else
    text = head + subject(sweep, question) + " " + share_text(curve) + course_text(sweep, curve) +
           slope_text(sweep, question, curve) + ".\n";
  if (sweep.open && question == Question::breaking)
    text += "That is one answer of many: the laws leave open how much friction something has, and "
            "at " +
            with_unit(sweep.variations[0], sweep.open->value) + " " +
            in_digits(sweep.open->other, 3) + " N is lawful as well as " +
            newtons(sweep.open->one, 0) + ".\n";
  return text + gaps_text(sweep) + end;
}

std::string bistable_text(const Sweep& sweep, const BistableRange& range, Telling telling) {
  const bool is_minor = !range.motion && range.force_share < SweepSettings::worth_a_word;
  if (is_minor && telling == Telling::brief) return "";
  const Variation& variation = sweep.variations[0];
  const std::string where = range.from == range.to
                                ? "At " + with_unit(variation, range.from)
                                : "From " + value_text(variation, std::min(range.from, range.to)) +
                                      " to " + with_unit(variation, std::max(range.from, range.to));
  const std::string forces =
      "by up to " + newtons(range.force_difference, 0) + " (" + percent(range.force_share) + ")";
  return capital(where) + " there are two answers: on the way back " +
         (range.motion ? object_name(sweep.scene) + " moves in another way" +
                             (range.force_share < SweepSettings::worth_a_word
                                  ? ""
                                  : ", and the force is another " + forces)
                       : "the force is another " + forces + ", the motion is the same") +
         ".\n";
}

} // namespace lcpush::desktop
