// What changes at a value of a sweep, in words.
#include <algorithm>

#include "lcpush/desktop/naming.hpp"
#include "solve/sentence.hpp"
#include "sweep/settings.hpp"
#include "sweep/sweep_words.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// As one contact does it, and as several do: "wall.1 sticks", "wall.1 and wall.2 stick".
struct EventWords {
  const char *one, *many;
};
constexpr EventWords event_words[] = {
    {"slips with friction in another direction", "slip with friction in another direction"},
    {"takes load", "take load"},
    {"is relieved of its load", "are relieved of their load"},
    {"opens", "open"},
    {"touches and sticks", "touch and stick"},
    {"sticks", "stick"},
    {"touches and slips", "touch and slip"},
    {"begins to slip", "begin to slip"},
};

ContactEvent event_of(const ContactChange& change) {
  const bool touches = change.from == Mode::separate;
  if (change.from == change.to) {
    if (change.was_pressed == change.is_pressed) return ContactEvent::turns;
    return change.is_pressed ? ContactEvent::takes_load : ContactEvent::drops_load;
  }
  if (change.to == Mode::separate) return ContactEvent::separates;
  if (change.to == Mode::stick) return touches ? ContactEvent::lands : ContactEvent::sticks;
  return touches ? ContactEvent::grazes : ContactEvent::slides;
}

/// Of a direction: three, times 1000.
Vector3<double> shown_digits(const Vector3<double>& direction) {
  return (SweepSettings::direction_places * direction).array().round();
}

bool is_same(const SharedEvent& a, const SharedEvent& b) {
  return a.event == b.event && a.contacts == b.contacts &&
         shown_digits(a.along) == shown_digits(b.along);
}

/// `but_for_jumps`: how the answer jumps there may differ.
bool are_same(const std::vector<ToldChange>& a, const std::vector<ToldChange>& b,
              bool but_for_jumps) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [but_for_jumps](const ToldChange& one, const ToldChange& other) {
        return one.kind == other.kind && one.from == other.from && one.to == other.to &&
               (but_for_jumps || (one.jumps == other.jumps && one.path == other.path)) &&
               std::equal(one.events.begin(), one.events.end(), other.events.begin(),
                          other.events.end(), is_same);
      });
}

std::vector<SharedEvent> shared_events(const AnswerChange& change) {
  std::vector<SharedEvent> different;
  for (const ContactChange& contact : change.contacts) {
    const ContactEvent event = event_of(contact);
    const bool slides = event == ContactEvent::grazes || event == ContactEvent::slides;
    const Vector3<double> along = slides ? contact.slip : Vector3<double>::Zero();
    auto same = std::find_if(different.begin(), different.end(), [&](const SharedEvent& other) {
      return other.event == event && shown_digits(other.along) == shown_digits(along);
    });
    if (same == different.end()) same = different.insert(same, {event, along, {}});
    same->contacts.push_back(contact.contact);
  }
  return different;
}

/// Nothing if it is not worth a word in a brief text.
std::optional<ToldChange> told_change(const AnswerChange& change, Telling telling) {
  ToldChange told{change.kind,           change.from,  change.to,
                  shared_events(change), change.jumps, change.path};
  if (telling == Telling::full || change.kind != AnswerChange::Kind::modes) return told;
  const auto is_minor = [](const SharedEvent& shared) {
    return shared.event == ContactEvent::turns || shared.event == ContactEvent::takes_load ||
           shared.event == ContactEvent::drops_load;
  };
  if (told.is_of_holding())
    told.events.clear();
  else
    told.events.erase(std::remove_if(told.events.begin(), told.events.end(), is_minor),
                      told.events.end());
  if (told.events.empty() && !told.jumps && !told.is_of_holding()) return std::nullopt;
  return told;
}

std::vector<ToldChange> told_changes(const std::vector<AnswerChange>& changes, Telling telling) {
  std::vector<ToldChange> list;
  for (const AnswerChange& change : changes)
    if (const auto told = told_change(change, telling)) list.push_back(*told);
  return list;
}

/// The contacts that do this: a body's name where all of its points do.
std::string sentence(const SceneFile& file, const SharedEvent& shared) {
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
  const EventWords& words = event_words[static_cast<std::size_t>(shared.event)];
  return listed(names, "and") + " " + (names.size() > 1 ? words.many : words.one) +
         (shared.along.norm() > 0 ? " along " + direction_text(shared.along) : "");
}

/// Adds to a list of sentences.
void add(std::string& text, const char* separator, const std::string& sentence) {
  text += (text.empty() ? "" : separator) + sentence;
}

std::string modes_text(const SceneFile& file, const ToldChange& change) {
  std::string text;
  if (change.is_of_holding())
    add(text, ", ",
        std::string("the grasp ") +
            (change.turns_to(Status::does_not_hold) ? "no longer holds " : "holds ") +
            object_name(file));
  for (const SharedEvent& shared : change.events) add(text, ", ", sentence(file, shared));
  if (!text.empty()) return text;
  return change.jumps ? "forces change" : "forces are shared in another way";
}

/// Of a jump, in PathBreak's order.
constexpr const char* path_words[] = {"", ": all answers in between are answers here",
                                      ": the solution path turns back here",
                                      ": the solution path ends here in a ray"};

std::string answer_text(const SceneFile& file, const ToldChange& change) {
  if (change.kind == AnswerChange::Kind::lost)
    return std::string("from here on no answer is found (") + status_text(change.to) + ")";
  if (change.kind == AnswerChange::Kind::found) return "from here on there is an answer again";
  const std::string text = modes_text(file, change);
  if (!change.jumps) return text;
  return text + "; the answer jumps" + path_words[static_cast<int>(change.path)];
}

/// What happens at one value: one event if it is the same for both questions.
void add_events(std::vector<SweepEvent>& events, double value, const SweepChange& change,
                Telling telling) {
  OfBoth<SweepEvent> here;
  for (const Question question : questions) {
    here[question].at[question] = value;
    here[question].changes = told_changes(change[question], telling);
    for (const ToldChange& told : here[question].changes)
      here[question].jumps = here[question].jumps || told.jumps;
  }
  if (are_same(here.push.changes, here.breaking.changes, false)) {
    here.push.changes.clear();
    here.breaking.at.push = value;
  }
  for (const Question question : questions)
    if (!here[question].changes.empty()) events.push_back(here[question]);
}

/// Nothing but a jump of the forces.
bool is_bare_jump(const SweepEvent& event) {
  return std::all_of(event.changes.begin(), event.changes.end(), [](const ToldChange& change) {
    return change.events.empty() && change.kind == AnswerChange::Kind::modes &&
           !change.is_of_holding();
  });
}

/// The event that this one is a part of: what happens to the other question alike, a little
/// earlier.
std::vector<SweepEvent>::iterator alike_in(std::vector<SweepEvent>& list, const SweepEvent& event,
                                           double near) {
  return std::find_if(list.begin(), list.end(), [&](const SweepEvent& other) {
    const bool fits =
        (!other.at.breaking && !event.at.push) || (!other.at.push && !event.at.breaking);
    return fits && std::abs(other.value() - event.value()) <= near &&
           are_same(other.changes, event.changes, true);
  });
}

/// What happens to push and breaking alike is one event; a jump of the forces beside a change that
/// is told is a part of it.
std::vector<SweepEvent> merged(const Sweep& sweep, const std::vector<SweepEvent>& events) {
  const Variation& variation = sweep.variations[0];
  const double near = SweepSettings::alike * std::abs(variation.to - variation.from);
  std::vector<SweepEvent> list;
  for (const SweepEvent& event : events) {
    const bool is_part =
        is_bare_jump(event) && std::any_of(events.begin(), events.end(), [&](const auto& other) {
          return !is_bare_jump(other) && are_one_place(variation, other.value(), event.value());
        });
    if (is_part) continue;
    const auto same = alike_in(list, event, near);
    if (same == list.end()) {
      list.push_back(event);
      continue;
    }
    for (const Question question : questions)
      if (event.at[question]) same->at[question] = event.at[question];
    same->jumps = same->jumps || event.jumps;
    for (std::size_t k = 0; k < same->changes.size(); ++k)
      same->changes[k].jumps = same->changes[k].jumps || event.changes[k].jumps;
  }
  return list;
}

double place_of(const SweepSegment& segment) { return segment.to; }
double place_of(const SweepPoint& point) { return point.value; }

std::string joined_events(const Sweep& sweep, double value, const SweepChange& change) {
  std::vector<SweepEvent> events;
  add_events(events, value, change, Telling::full);
  std::string text;
  for (const SweepEvent& event : events) add(text, "; ", event_text(sweep, event));
  return text;
}

} // namespace

template <class List>
std::vector<SweepEvent> events_of(const Sweep& sweep, const List& list, Telling telling) {
  std::vector<SweepEvent> events;
  for (const auto& one : list) add_events(events, place_of(one), one.change, telling);
  return telling == Telling::full ? events : merged(sweep, events);
}
template std::vector<SweepEvent> events_of(const Sweep&, const std::vector<SweepSegment>&, Telling);
template std::vector<SweepEvent> events_of(const Sweep&, const std::vector<SweepPoint>&, Telling);

std::string event_text(const Sweep& sweep, const SweepEvent& event) {
  std::string text;
  for (const ToldChange& change : event.changes) add(text, "; ", answer_text(sweep.scene, change));
  if (event.at.push && event.at.breaking) return text;
  if (event.at.breaking) return "at breaking: " + text;
  return (sweep.asks_breaking ? "as prescribed: " : "") + text;
}

std::string change_text(const Sweep& sweep, const SweepSegment& segment) {
  return joined_events(sweep, segment.to, segment.change);
}

std::string change_text(const Sweep& sweep, const SweepPoint& point) {
  return joined_events(sweep, point.value, point.change);
}

} // namespace lcpush::desktop
