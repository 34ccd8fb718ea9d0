#include "sweep_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::host {
namespace {

std::string slip_text(const Vector3<double>& slip) {
  return slip.norm() > 0 ? " along " + direction_text(slip) : "";
}

/// What one contact does from here on that it did not do before.
std::string change_of(const std::string& name, const ContactState& before,
                      const ContactState& after) {
  if (before.mode != after.mode) {
    switch (after.mode) {
    case Mode::separate: return name + " separates";
    case Mode::stick:
      return name + (before.mode == Mode::separate ? " touches and sticks" : " sticks");
    case Mode::slide: break;
    }
    return name + (before.mode == Mode::separate ? " touches and slides" : " starts to slide") +
           slip_text(after.slip);
  }
  if (before.pressed != after.pressed)
    return name + (after.pressed ? " takes load" : " is relieved of its load");
  return "";
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

bool differ(const Outputs& a, const Outputs& b, double tolerance) {
  if (a.status != b.status) return true;
  const double force = std::max(force_size(a), force_size(b));
  const double motion = std::max(a.twist.norm(), b.twist.norm());
  return std::abs(a.normal - b.normal) > tolerance * force ||
         (a.force - b.force).norm() > tolerance * force ||
         (a.twist - b.twist).norm() > tolerance * motion;
}

std::vector<Piece> joined(const std::vector<Piece>& pieces, double tolerance) {
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
          !differ(last.at_to, piece.at_from, tolerance)) {
        const Outputs straight = on_line(last.at_from, last.from, last.at_to, last.to, piece.to);
        // A short piece says little about the direction of a long one.
        if (!differ(straight, piece.at_to,
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
  for (std::size_t i = 0; i < before.contacts.size() && i < after.contacts.size(); ++i)
    add(change_of(point_name(file, static_cast<Index>(i)), before.contacts[i], after.contacts[i]));
  if (!text.empty()) return text;
  for (std::size_t i = 0; i < before.contacts.size() && i < after.contacts.size(); ++i)
    if (after.contacts[i].mode == Mode::slide && before.contacts[i].rubs != after.contacts[i].rubs)
      add("the friction of " + point_name(file, static_cast<Index>(i)) + " turns");
  return text.empty() ? "forces are shared in another way" : text;
}

} // namespace lcpush::host
