// The answer for a box in words, and as JSON.
#include "boxes/settings.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/naming.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

std::string key_of(const BoxRange& range) { return range.path.substr(range.path.rfind('.') + 1); }

/// The range of all numbers that count, where it is one and the same quantity's.
const BoxRange* shared_range(const BoxAnswer& answer) {
  const BoxRange* shared = nullptr;
  for (const BoxRange& range : answer.box) {
    if (!range.counts) continue;
    if (shared != nullptr && (key_of(range) != key_of(*shared) || range.low != shared->low ||
                              range.high != shared->high))
      return nullptr;
    shared = &range;
  }
  return shared;
}

bool is_wide(const BoxAnswer& answer) {
  return std::any_of(answer.box.begin(), answer.box.end(),
                     [](const BoxRange& range) { return range.low < range.high; });
}

/// " for every friction from 0.5 to 0.9"; nothing where the margin alone is asked.
std::string every(const BoxAnswer& answer) {
  if (!is_wide(answer)) return "";
  const BoxRange* const shared = shared_range(answer);
  if (shared == nullptr) return " for every value in the ranges";
  const bool is_alone = std::count_if(answer.box.begin(), answer.box.end(),
                                      [](const auto& range) { return range.counts; }) == 1;
  return " for every " + (is_alone ? shared->path : key_of(*shared)) + " from " +
         brief(shared->low) + " to " + brief(shared->high);
}

std::string values_words(const BoxAnswer& answer,
                         const std::vector<std::pair<std::string, double>>& values) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (answer.box[k].counts) words.push_back(values[k].first + " = " + brief(values[k].second));
  return listed(words, "and");
}

/// ": worst at 0.5, with 40.5 times the grip it needs (0.618 of 25 N per finger)".
std::string worst_words(const BoxAnswer& answer) {
  if (!answer.worst) return "";
  const auto& [grip, factor, at] = *answer.worst;
  const std::string values = values_words(answer, at);
  const std::string where = !is_wide(answer) || values.empty() ? ""
                            : shared_range(answer) != nullptr
                                ? "worst at " + brief(at.front().second) + ", "
                                : "worst at " + values + ", ";
  return (where.empty() ? " " : ": " + where) + "with " + brief(1 / factor) +
         " times the grip it needs (" + brief(factor * grip.force) + " of " + brief(grip.force) +
         (grip.of_actuator ? " " : " N ") + grip.of + ")";
}

} // namespace

std::string margin_words(const BoxAnswer& answer) {
  if (answer.is_indifferent) return "; it does not depend on these numbers";
  if (!answer.margin || !(*answer.margin > 0)) return "";
  const BoxRange* const shared =
      answer.worst && *answer.margin <= box_settings.no_margin ? shared_range(answer) : nullptr;
  if (shared != nullptr && key_of(*shared) == "friction") // least friction is worst
    return "; it would still down to a friction of " +
           brief((1 - *answer.margin) * (shared->low + shared->high) / 2);
  const std::string percent = in_digits(100 * *answer.margin, 4) + " % off";
  if (answer.verdict != BoxVerdict::always)
    return "; while all of these numbers are at most " + percent + ", that cannot happen";
  return *answer.margin > box_settings.no_margin
             ? "; it would still if all of these numbers were up to 100 % off"
             : "; it would still if all of these numbers were " + percent;
}

std::string box_sentence(const BoxAnswer& answer, const std::string& subject,
                         const std::string& does, const std::string& fails,
                         const std::string& where) {
  const std::string margin = margin_words(answer) + ".";
  switch (answer.verdict) {
  case BoxVerdict::always:
    return subject + " " + does + every(answer) + worst_words(answer) + margin;
  case BoxVerdict::never:
    return subject + " " + does + " for no value in the ranges: " + answer.reason + margin;
  case BoxVerdict::may_slip:
    return subject + " " + fails + ": " + where + " " + answer.reason + margin;
  case BoxVerdict::not_known: break;
  }
  return "Not known for every value in the ranges: " + answer.reason + margin;
}

std::string modes_sentence(const SceneFile& file, const BoxAnswer& answer) {
  const bool pushes = file.bodies.back().role == Role::pusher;
  return box_sentence(answer, pushes ? "Pushed slowly, the pusher" : "The grasp",
                      pushes ? "sticks" : "holds", pushes ? "may slip" : "may give way",
                      corner_words(answer));
}

std::string corner_words(const BoxAnswer& answer) {
  return "at " + values_words(answer, answer.corner);
}

void write_box(JsonWriter& json, const BoxAnswer& answer) {
  json.member("verdict", box_verdict_text(answer.verdict))
      .member("margin", answer.margin)
      .member("reason", unless_empty(answer.reason));
  if (answer.corner.empty()) {
    json.member("corner", nullptr);
  } else {
    json.key("corner").begin_object();
    for (const auto& [path, value] : answer.corner) json.member(path, value);
    json.end_object();
  }
  json.member("corner_scene", unless_empty(answer.corner_scene)).key("box").begin_object();
  for (const BoxRange& range : answer.box)
    json.member(range.path, std::vector<double>{range.low, range.high});
  json.end_object();
}

std::string box_text(const SceneFile& middle, const BoxAnswer& answer, const std::string& subject,
                     const std::string& does, const std::string& fails) {
  std::string text = title_line(middle) +
                     box_sentence(answer, subject, does, fails, "at the corner below") + "\n\n";
  TableRows rows{{"number", "from", "to"}};
  std::vector<std::string> idle, asked;
  const bool has_corner = !answer.corner.empty();
  if (has_corner) rows[0].push_back("at the corner");
  for (std::size_t k = 0; k < answer.box.size(); ++k) {
    const BoxRange& range = answer.box[k];
    if (!range.counts) {
      idle.push_back(range.path);
      continue;
    }
    if (range.low == range.high) {
      asked.push_back(range.path + " = " + brief(range.low));
      continue;
    }
    rows.push_back({range.path, brief(range.low), brief(range.high)});
    if (has_corner) rows.back().push_back(brief(answer.corner[k].second));
  }
  if (rows.size() > 1 && (has_corner || shared_range(answer) == nullptr))
    text += table_text(rows) + "\n";
  std::vector<Fact> facts{{"Friction", friction_law_text(middle)}};
  if (!asked.empty()) facts.push_back({"As they stand", listed(asked, "and")});
  if (!idle.empty()) facts.push_back({"No part in it", listed(idle, "and")});
  return text + facts_text(facts);
}

} // namespace lcpush::desktop
