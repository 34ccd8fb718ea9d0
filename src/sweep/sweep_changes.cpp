// What changes at a value of a sweep, in words.
#include <algorithm>

#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// A change as one contact makes it, and as several do: "wall.1 sticks", "wall.1 and wall.2 stick".
struct Words {
  std::string one, many;
  std::vector<Index> contacts; ///< that make it
};

Words words_of(const ContactChange& change) {
  const bool touches = change.from == Mode::separate;
  const std::string along =
      change.slip.norm() > 0 ? " along " + direction_text(change.slip) : std::string();
  if (change.from == change.to) {
    if (change.was_pressed == change.is_pressed)
      return {"slides with friction in another direction",
              "slide with friction in another direction",
              {}};
    if (change.is_pressed) return {"takes load", "take load", {}};
    return {"is relieved of its load", "are relieved of their load", {}};
  }
  switch (change.to) {
  case Mode::separate: return {"separates", "separate", {}};
  case Mode::stick:
    if (touches) return {"touches and sticks", "touch and stick", {}};
    return {"sticks", "stick", {}};
  case Mode::slide: break;
  }
  if (touches) return {"touches and slides" + along, "touch and slide" + along, {}};
  return {"starts to slide" + along, "start to slide" + along, {}};
}

/// The contacts that do this: a body's name where all of its points do.
std::string sentence(const SceneFile& file, const Words& words) {
  const std::vector<Index>& points = words.contacts;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < points.size();) {
    const auto b = static_cast<std::size_t>(file.body_of(points[k]));
    const Index count = file.bodies[b].point_count;
    const std::size_t last = k + static_cast<std::size_t>(count) - 1;
    const bool whole = points[k] == file.bodies[b].first_point && last < points.size() &&
                       points[last] == points[k] + count - 1;
    names.push_back(whole && count > 1 ? file.body_names[b] : point_name(file, points[k]));
    k = whole ? last + 1 : k + 1;
  }
  return listed(names, "and") + " " + (names.size() > 1 ? words.many : words.one);
}

/// Adds to a list of sentences.
void add(std::string& text, const char* separator, const std::string& sentence) {
  text += (text.empty() ? "" : separator) + sentence;
}

std::string modes_text(const SceneFile& file, const AnswerChange& change) {
  std::string text;
  if (change.from != change.to && change.to == Status::does_not_hold)
    add(text, ", ", "the grasp no longer holds the object");
  if (change.from == Status::does_not_hold && change.to == Status::solved)
    add(text, ", ", "the grasp holds the object");
  std::vector<Words> different;
  for (const ContactChange& contact : change.contacts) {
    const Words words = words_of(contact);
    auto same = std::find_if(different.begin(), different.end(),
                             [&](const Words& other) { return other.one == words.one; });
    if (same == different.end()) same = different.insert(same, words);
    same->contacts.push_back(contact.contact);
  }
  for (const Words& words : different) add(text, ", ", sentence(file, words));
  return text.empty() ? "forces are shared in another way" : text;
}

std::string answer_text(const SceneFile& file, const AnswerChange& change) {
  switch (change.kind) {
  case AnswerChange::Kind::lost:
    return std::string("from here on no answer is found (") + status_text(change.to) + ")";
  case AnswerChange::Kind::found: return "from here on there is an answer again";
  case AnswerChange::Kind::modes: break;
  }
  const std::string text = modes_text(file, change) + (change.jumps ? "; the answer jumps" : "");
  switch (change.jumps ? change.path : PathBreak::none) {
  case PathBreak::none: break;
  case PathBreak::jump: return text + ": all answers in between are answers here";
  case PathBreak::turned_back: return text + ": the solution path turns back here";
  case PathBreak::ray: return text + ": the solution path ends here in a ray";
  }
  return text;
}

std::string answer_text(const SceneFile& file, const std::vector<AnswerChange>& changes) {
  std::string text;
  for (const AnswerChange& change : changes) add(text, "; ", answer_text(file, change));
  return text;
}

} // namespace

std::string change_text(const Sweep& sweep, const SweepSegment& segment) {
  const std::string pushed = answer_text(sweep.scene, segment.change.push);
  const std::string broken = answer_text(sweep.scene, segment.change.breaking);
  // What happens to both alike is said once.
  if (pushed == broken) return pushed;
  std::string text;
  if (!pushed.empty()) text = (sweep.asks_breaking ? "as prescribed: " : "") + pushed;
  if (!broken.empty()) add(text, "; ", "at breaking: " + broken);
  return text;
}

std::string change_text(const Sweep& sweep, const SweepPoint& point) {
  std::string text = answer_text(sweep.scene, point.change.push);
  const std::string broken = answer_text(sweep.scene, point.change.breaking);
  if (!broken.empty() && broken != text) add(text, "; ", "at breaking: " + broken);
  return text + (point.change.jumps ? "; the answer jumps" : "");
}

} // namespace lcpush::desktop
