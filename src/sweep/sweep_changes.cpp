// What changes at a value of a sweep, in words.
#include <algorithm>

#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// What a contact does from here on.
enum class Deed { turns, takes_load, drops_load, separates, lands, sticks, grazes, slides };

/// As one contact does it, and as several do: "wall.1 sticks", "wall.1 and wall.2 stick".
struct DeedWords {
  const char *one, *many;
};
constexpr DeedWords deed_words[] = {
    {"slides with friction in another direction", "slide with friction in another direction"},
    {"takes load", "take load"},
    {"is relieved of its load", "are relieved of their load"},
    {"separates", "separate"},
    {"touches and sticks", "touch and stick"},
    {"sticks", "stick"},
    {"touches and slides", "touch and slide"},
    {"starts to slide", "start to slide"},
};

Deed deed_of(const ContactChange& change) {
  const bool touches = change.from == Mode::separate;
  if (change.from == change.to) {
    if (change.was_pressed == change.is_pressed) return Deed::turns;
    return change.is_pressed ? Deed::takes_load : Deed::drops_load;
  }
  if (change.to == Mode::separate) return Deed::separates;
  if (change.to == Mode::stick) return touches ? Deed::lands : Deed::sticks;
  return touches ? Deed::grazes : Deed::slides;
}

/// Of a direction: three, times 1000.
Vector3<double> shown_digits(const Vector3<double>& direction) {
  return (1000 * direction).array().round();
}

/// Several contacts that do the same.
struct SharedDeed {
  Deed deed;
  Vector3<double> along; ///< of those that begin to slide: their direction, or zero
  std::vector<Index> contacts;
};

/// The contacts that do this: a body's name where all of its points do.
std::string sentence(const SceneFile& file, const SharedDeed& shared) {
  const std::vector<Index>& points = shared.contacts;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < points.size();) {
    const Index b = file.body_of(points[k]), count = file.body(b).point_count;
    const std::size_t last = k + static_cast<std::size_t>(count) - 1;
    const bool whole = points[k] == file.body(b).first_point && last < points.size() &&
                       points[last] == points[k] + count - 1;
    names.push_back(whole && count > 1 ? file.body_name(b) : point_name(file, points[k]));
    k = whole ? last + 1 : k + 1;
  }
  const DeedWords& words = deed_words[static_cast<std::size_t>(shared.deed)];
  return listed(names, "and") + " " + (names.size() > 1 ? words.many : words.one) +
         (shared.along.norm() > 0 ? " along " + direction_text(shared.along) : "");
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
  std::vector<SharedDeed> different;
  for (const ContactChange& contact : change.contacts) {
    const Deed deed = deed_of(contact);
    const bool slides = deed == Deed::grazes || deed == Deed::slides;
    const Vector3<double> along = slides ? contact.slip : Vector3<double>::Zero();
    auto same = std::find_if(different.begin(), different.end(), [&](const SharedDeed& other) {
      return other.deed == deed && shown_digits(other.along) == shown_digits(along);
    });
    if (same == different.end()) same = different.insert(same, {deed, along, {}});
    same->contacts.push_back(contact.contact);
  }
  for (const SharedDeed& shared : different) add(text, ", ", sentence(file, shared));
  return text.empty() ? "forces are shared in another way" : text;
}

/// Of a jump, in PathBreak's order.
constexpr const char* path_words[] = {"", ": all answers in between are answers here",
                                      ": the solution path turns back here",
                                      ": the solution path ends here in a ray"};

std::string answer_text(const SceneFile& file, const AnswerChange& change) {
  if (change.kind == AnswerChange::Kind::lost)
    return std::string("from here on no answer is found (") + status_text(change.to) + ")";
  if (change.kind == AnswerChange::Kind::found) return "from here on there is an answer again";
  const std::string text = modes_text(file, change);
  if (!change.jumps) return text;
  return text + "; the answer jumps" + path_words[static_cast<int>(change.path)];
}

std::string answer_text(const SceneFile& file, const std::vector<AnswerChange>& changes) {
  std::string text;
  for (const AnswerChange& change : changes) add(text, "; ", answer_text(file, change));
  return text;
}

/// What happens to both alike is said once.
std::string both_texts(const SceneFile& file, const SweepChange& change,
                       const char* as_prescribed) {
  const std::string pushed = answer_text(file, change.push);
  const std::string broken = answer_text(file, change.breaking);
  if (pushed == broken) return pushed;
  std::string text = pushed.empty() ? "" : as_prescribed + pushed;
  if (!broken.empty()) add(text, "; ", "at breaking: " + broken);
  return text;
}

} // namespace

std::string change_text(const Sweep& sweep, const SweepSegment& segment) {
  return both_texts(sweep.scene, segment.change, sweep.asks_breaking ? "as prescribed: " : "");
}

std::string change_text(const Sweep& sweep, const SweepPoint& point) {
  return both_texts(sweep.scene, point.change, "") +
         (point.change.jumps ? "; the answer jumps" : "");
}

} // namespace lcpush::desktop
