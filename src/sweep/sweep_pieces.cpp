#include "sweep/sweep_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// A change as one contact makes it, and as several do: "wall.1 sticks", "wall.1 and wall.2 stick".
struct Words {
  std::string one, many;
  bool operator==(const Words& other) const { return one == other.one; }
};

/// What a contact does from here on that it did not do before; no words if nothing.
Words change_of(const ContactState& before, const ContactState& after) {
  if (before.mode != after.mode) {
    const std::string along =
        after.slip.norm() > 0 ? " along " + direction_text(after.slip) : std::string();
    const bool touches = before.mode == Mode::separate;
    switch (after.mode) {
    case Mode::separate: return {"separates", "separate"};
    case Mode::stick:
      return touches ? Words{"touches and sticks", "touch and stick"} : Words{"sticks", "stick"};
    case Mode::slide: break;
    }
    return touches ? Words{"touches and slides" + along, "touch and slide" + along}
                   : Words{"starts to slide" + along, "start to slide" + along};
  }
  if (before.pressed != after.pressed)
    return after.pressed ? Words{"takes load", "take load"}
                         : Words{"is relieved of its load", "are relieved of their load"};
  return {};
}

/// The points that do this: a body's name where all of its points do.
std::string sentence(const SceneFile& file, const std::vector<std::size_t>& points,
                     const Words& words) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < points.size();) {
    const Index b = file.body_of(static_cast<Index>(points[k]));
    const Body<double>& body = file.bodies[static_cast<std::size_t>(b)];
    const auto count = static_cast<std::size_t>(body.point_count);
    const bool whole = static_cast<Index>(points[k]) == body.first_point &&
                       k + count <= points.size() && points[k + count - 1] == points[k] + count - 1;
    names.push_back(whole && count > 1 ? file.body_names[static_cast<std::size_t>(b)]
                                       : point_name(file, static_cast<Index>(points[k])));
    k += whole ? count : 1;
  }
  return listed(names, "and") + " " + (names.size() > 1 ? words.many : words.one);
}

double force_size(const Outputs& a) { return std::max(std::abs(a.normal), a.force.norm()); }

bool same_states(const Outputs& a, const Outputs& b) {
  for (std::size_t i = 0; i < a.contacts.size() && i < b.contacts.size(); ++i)
    if (a.contacts[i].mode != b.contacts[i].mode || a.contacts[i].pressed != b.contacts[i].pressed)
      return false;
  return a.contacts.size() == b.contacts.size();
}

} // namespace

Outputs on_line(const Outputs& first, double t0, const Outputs& second, double t1, double t) {
  Outputs outputs = first;
  const double share = (t - t0) / (t1 - t0);
  outputs.normal += share * (second.normal - first.normal);
  outputs.force += share * (second.force - first.force);
  outputs.twist += share * (second.twist - first.twist);
  outputs.residual = std::max(first.residual, second.residual);
  return outputs;
}

bool differ(const Outputs& a, const Outputs& b, Quantity quantity, double tolerance) {
  if (a.status != b.status) return true;
  const double noise = std::max(a.force_noise, b.force_noise);
  if (std::abs(a.normal - b.normal) >
      tolerance * std::max(std::abs(a.normal), std::abs(b.normal)) + noise)
    return true;
  if (quantity == Quantity::breaking) return false;
  const double force = tolerance * std::max(force_size(a), force_size(b)) + noise;
  return (a.force - b.force).norm() > force || other_motion(a, b, tolerance);
}

bool other_motion(const Outputs& a, const Outputs& b, double tolerance) {
  const double motion = tolerance * std::max(a.twist.norm(), b.twist.norm()) +
                        std::max(a.motion_noise, b.motion_noise);
  return (a.twist - b.twist).norm() > motion;
}

std::vector<Piece> joined(const std::vector<Piece>& pieces, Quantity quantity, double tolerance) {
  std::vector<Piece> list;
  for (const Piece& piece : pieces) {
    if (!list.empty()) {
      Piece& last = list.back();
      const bool both_unsolved =
          last.kind == SegmentKind::unsolved && piece.kind == SegmentKind::unsolved;
      if (both_unsolved) {
        last.to = piece.to;
        continue;
      }
      if (last.kind == piece.kind && same_states(last.at_from, piece.at_from) &&
          !differ(last.at_to, piece.at_from, quantity, tolerance)) {
        const Outputs straight = on_line(last.at_from, last.from, last.at_to, last.to, piece.to);
        // A short piece says little about the direction of a long one.
        if (!differ(straight, piece.at_to, quantity,
                    tolerance * std::max(1.0, (piece.to - last.from) / (last.to - last.from)))) {
          const double residual = std::max(last.at_to.residual, piece.at_to.residual);
          last.to = piece.to;
          last.at_to = piece.at_to;
          last.why = piece.why;
          last.at_from.residual = last.at_to.residual = residual;
          continue;
        }
      }
    }
    list.push_back(piece);
  }
  return list;
}

std::string change_text(const SceneFile& file, const Outputs& before, const Outputs& after) {
  std::string text;
  const auto add = [&](const std::string& words) {
    if (!words.empty()) text += (text.empty() ? "" : ", ") + words;
  };
  if (before.status != after.status) {
    if (after.status == Status::does_not_hold) add("the grasp no longer holds the object");
    if (before.status == Status::does_not_hold && after.is_solved())
      add("the grasp holds the object");
  }
  const std::size_t contacts = std::min(before.contacts.size(), after.contacts.size());
  std::vector<Words> seen;
  std::vector<std::vector<std::size_t>> points; // of each of these
  const auto note = [&](std::size_t contact, const Words& words) {
    if (words.one.empty()) return;
    const auto at = std::find(seen.begin(), seen.end(), words) - seen.begin();
    if (at == static_cast<std::ptrdiff_t>(seen.size())) {
      seen.push_back(words);
      points.emplace_back();
    }
    points[static_cast<std::size_t>(at)].push_back(contact);
  };
  for (std::size_t i = 0; i < contacts; ++i)
    note(i, change_of(before.contacts[i], after.contacts[i]));
  std::vector<std::size_t> turned;
  for (std::size_t i = 0; i < contacts && seen.empty() && text.empty(); ++i)
    if (after.contacts[i].mode == Mode::slide && before.contacts[i].rubs != after.contacts[i].rubs)
      turned.push_back(i);
  if (!turned.empty())
    add(sentence(
        file, turned,
        {"slides with friction in another direction", "slide with friction in another direction"}));
  for (std::size_t k = 0; k < seen.size(); ++k) add(sentence(file, points[k], seen[k]));
  return text.empty() ? "forces are shared in another way" : text;
}

} // namespace lcpush::desktop
