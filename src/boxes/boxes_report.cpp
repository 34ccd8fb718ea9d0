// The answer for a box in words, and as JSON.
#include "boxes/settings.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/naming.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
std::string margin_words(const BoxAnswer& answer) {
  if (answer.is_indifferent) return "; it does not depend on these numbers";
  if (!answer.margin || !(*answer.margin > 0)) return "";
  const std::string percent = in_digits(100 * *answer.margin, 4) + " % off";
  if (answer.verdict != BoxVerdict::always)
    return "; with all of these numbers at most " + percent + " it would not";
  return *answer.margin > box_settings.no_margin
             ? "; it would still if all of these numbers were up to 100 % off"
             : "; it would still if all of these numbers were " + percent;
}

std::string box_sentence(const BoxAnswer& answer, const std::string& subject,
                         const std::string& does, const std::string& fails,
                         const std::string& where) {
  const std::string margin = margin_words(answer) + ".";
  switch (answer.verdict) {
  case BoxVerdict::always: return subject + " " + does + " for every value in the ranges" + margin;
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
  std::vector<std::string> words;
  for (const auto& [path, value] : answer.corner) words.push_back(path + " = " + brief(value));
  return "at " + listed(words, "and");
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
  std::vector<std::string> idle;
  const bool has_corner = !answer.corner.empty();
  if (has_corner) rows[0].push_back("at the corner");
  for (std::size_t k = 0; k < answer.box.size(); ++k) {
    const BoxRange& range = answer.box[k];
    if (!range.counts) {
      idle.push_back(range.path);
      continue;
    }
    rows.push_back({range.path, brief(range.low), brief(range.high)});
    if (has_corner) rows.back().push_back(brief(answer.corner[k].second));
  }
  if (rows.size() > 1) text += table_text(rows) + "\n";
  std::vector<Fact> facts{{"Friction", friction_law_text(middle)}};
  if (!idle.empty()) facts.push_back({"No part in it", listed(idle, "and")});
  return text + facts_text(facts);
}

} // namespace lcpush::desktop
