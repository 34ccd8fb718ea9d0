#include "sweep/sweep_pieces.hpp"
#include "sweep/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

double force_size(const SweepAnswer& a) { return std::max(std::abs(a.normal), a.force.norm()); }

bool other_motion(const SweepAnswer& a, const SweepAnswer& b, double tolerance) {
  const double motion = tolerance * std::max(a.twist.norm(), b.twist.norm()) +
                        std::max(a.motion_noise, b.motion_noise);
  return (a.twist - b.twist).norm() > motion;
}

template <class Equal>
bool same_contacts(const DetailedAnswer& a, const DetailedAnswer& b, Equal equal) {
  return std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(),
                    equal);
}

void note_difference(BistableRange& range, const SweepAnswer& a, const SweepAnswer& b) {
  if (!a.has_force() || !b.has_force()) return;
  const double difference = std::max(std::abs(a.normal - b.normal), (a.force - b.force).norm());
  const double size = std::max(force_size(a), force_size(b));
  if (difference > range.force_difference) range.force_difference = difference;
  if (difference > range.force_share * size) range.force_share = difference / size;
}

/// Does `piece` go on in the line and in the modes of `last`?
bool goes_on(const Piece& last, const Piece& piece, Question question, double tolerance) {
  const bool same_states =
      same_contacts(last.at_from, piece.at_from, [](const ContactState& a, const ContactState& b) {
        return a.mode == b.mode && a.pressed == b.pressed;
      });
  if (last.kind != piece.kind || !same_states || last.at_from.breaks != piece.at_from.breaks ||
      differ(last.at_to, piece.at_from, question, tolerance))
    return false;
  // A short piece says little about the direction of a long one.
  const double reach = (piece.to - last.from) / (last.to - last.from);
  return !differ(last.at(piece.to), piece.at_to, question, tolerance * std::max(1.0, reach));
}

} // namespace

DetailedAnswer on_line(const DetailedAnswer& first, double t0, const DetailedAnswer& second,
                       double t1, double t) {
  DetailedAnswer answer = first;
  const double share = (t - t0) / (t1 - t0);
  answer.normal += share * (second.normal - first.normal);
  answer.force += share * (second.force - first.force);
  answer.twist += share * (second.twist - first.twist);
  answer.residual = std::max(first.residual, second.residual);
  return answer;
}

bool differ(const SweepAnswer& a, const SweepAnswer& b, Question question, double tolerance) {
  if (a.status != b.status) return true;
  if (!a.breaks && !b.breaks) return false;
  const double noise = std::max(a.force_noise, b.force_noise);
  if (std::abs(a.normal - b.normal) >
      tolerance * std::max(std::abs(a.normal), std::abs(b.normal)) + noise)
    return true;
  if (question == Question::breaking) return false;
  const double force = tolerance * std::max(force_size(a), force_size(b)) + noise;
  return (a.force - b.force).norm() > force || other_motion(a, b, tolerance);
}

bool same_modes(const DetailedAnswer& a, const DetailedAnswer& b) {
  return a.status == b.status &&
         same_contacts(a, b, [](const ContactState& one, const ContactState& other) {
           return one.mode == other.mode;
         });
}

std::vector<Piece> joined(const std::vector<Piece>& pieces, Question question, double tolerance) {
  std::vector<Piece> list;
  for (const Piece& piece : pieces) {
    if (!list.empty() && list.back().is_unsolved() && piece.is_unsolved()) {
      list.back().to = piece.to;
    } else if (!list.empty() && goes_on(list.back(), piece, question, tolerance)) {
      Piece& last = list.back();
      const double residual = std::max(last.at_to.residual, piece.at_to.residual);
      last.to = piece.to;
      last.at_to = piece.at_to;
      last.path = piece.path;
      last.at_from.residual = last.at_to.residual = residual;
    } else {
      list.push_back(piece);
    }
  }
  return list;
}

AnswerChange change_between(const DetailedAnswer& before, const DetailedAnswer& after) {
  AnswerChange change;
  change.from = before.status;
  change.to = after.status;
  const std::size_t count = std::min(before.contacts.size(), after.contacts.size());
  const auto note_where = [&](auto changes) {
    for (std::size_t i = 0; i < count; ++i) {
      const ContactState &was = before.contacts[i], &is = after.contacts[i];
      if (changes(was, is))
        change.contacts.push_back(
            {static_cast<Index>(i), was.mode, is.mode, was.pressed, is.pressed, is.slip});
    }
  };
  note_where([](const ContactState& was, const ContactState& is) {
    return was.mode != is.mode || was.pressed != is.pressed;
  });
  const auto holds = [](Status status) { return status != Status::does_not_hold; };
  // Friction that turns is worth a word only where nothing else happens.
  if (change.contacts.empty() && holds(change.from) == holds(change.to))
    note_where([](const ContactState& was, const ContactState& is) {
      return is.mode == Mode::slide && was.with_friction != is.with_friction;
    });
  return change;
}

SweepAnswer told(const DetailedAnswer& answer) {
  if (!answer.is_solved()) return {answer.status};
  SweepAnswer told = answer;
  const auto but_for_noise = [](double& value, double zero, double noise) {
    if (std::abs(value) <= std::max(zero, noise)) value = 0;
  };
  but_for_noise(told.normal, answer.zero.force, answer.force_noise);
  for (double& force : told.force) but_for_noise(force, answer.zero.force, answer.force_noise);
  const double length = answer.zero.moment / answer.zero.force;
  for (Index k = 0; k < 6; ++k)
    but_for_noise(told.twist[k], answer.zero.acceleration / (k < 3 ? 1 : length),
                  answer.twist_noise(k));
  return told;
}

bool same_answer(const SweepAnswer& a, const SweepAnswer& b, Question question) {
  return !differ(a, b, question, SweepSettings::equal_answers);
}

bool moves_otherwise(const SweepValue& a, const SweepValue& b) {
  return a.push.is_solved() && b.push.is_solved() &&
         other_motion(a.push, b.push, SweepSettings::equal_answers);
}

std::vector<BistableRange> disagreements(const std::vector<TwoWays>& list, double near) {
  std::vector<BistableRange> ranges;
  bool disagreed = false;
  for (const TwoWays& ways : list) {
    const bool before = disagreed, motion = moves_otherwise(ways.there, ways.back);
    disagreed = false;
    for (const Question question : questions)
      disagreed = disagreed || !same_answer(ways.there[question], ways.back[question], question);
    if (!disagreed) continue;
    const bool goes_on =
        before || (!ranges.empty() && std::abs(ways.from - ranges.back().to) <= near);
    if (!goes_on || ranges.back().motion != motion)
      ranges.push_back({ways.from, ways.to, motion, 0, 0});
    ranges.back().to = ways.to;
    for (const Question question : questions)
      note_difference(ranges.back(), ways.there[question], ways.back[question]);
  }
  return ranges;
}

} // namespace lcpush::desktop
