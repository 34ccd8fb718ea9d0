#include "move/motion_phases.hpp"

#include "move/move_words.hpp"
#include "move/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Settings = MoveSettings;

void append(MotionPhase& phase, const MotionPhase& next) {
  phase.until = next.until;
  phase.path += next.path;
  phase.angle += next.angle;
  phase.along += next.along;
  phase.turn += next.turn;
}

/// How much of the motion it is, m.
double amount(const MotionPhase& phase, double size) { return phase.path + size / 2 * phase.angle; }

/// The word of the larger one stays.
MotionPhase as_one(MotionPhase a, const MotionPhase& b, double size) {
  if (amount(b, size) > amount(a, size)) a.kind = b.kind;
  append(a, b);
  return a;
}

bool is_same(const MotionPhase& a, const MotionPhase& b) {
  if (a.kind != b.kind) return false;
  if (a.kind == MotionKind::rest) return true;
  const bool slides = a.kind == MotionKind::slide;
  const Vector3<double>&x = slides ? a.along : a.turn, &y = slides ? b.along : b.turn;
  return x.dot(y) >= Settings::same_axis * x.norm() * y.norm();
}

std::vector<MotionPhase> joined_neighbours(const std::vector<MotionPhase>& phases) {
  std::vector<MotionPhase> merged;
  for (const MotionPhase& phase : phases)
    if (!merged.empty() && is_same(merged.back(), phase))
      append(merged.back(), phase);
    else
      merged.push_back(phase);
  return merged;
}

/// A turn that is next to nothing beside the path is none.
void name_by_whole(MotionPhase& phase, double size) {
  const bool may_slide = phase.kind == MotionKind::turn || phase.kind == MotionKind::pivot;
  if (may_slide && size / 2 * phase.angle < Settings::no_turn * phase.path)
    phase.kind = MotionKind::slide;
}

/// Without those that are less than this part of the whole.
std::vector<MotionPhase> without_slight(std::vector<MotionPhase> phases, double size, double part) {
  double whole = 0, length = 0;
  for (const MotionPhase& phase : phases) {
    whole += amount(phase, size);
    length += phase.until - phase.from;
  }
  const auto is_slight = [&](const MotionPhase& phase) {
    const bool is_short = phase.until - phase.from < 2 * part * length;
    return phase.kind == MotionKind::rest ? is_short : amount(phase, size) < part * whole;
  };
  while (phases.size() > 1) {
    const auto least = std::min_element(phases.begin(), phases.end(),
                                        [&](const MotionPhase& a, const MotionPhase& b) {
                                          return std::pair(!is_slight(a), amount(a, size)) <
                                                 std::pair(!is_slight(b), amount(b, size));
                                        });
    if (!is_slight(*least)) break;
    const auto next = least + 1;
    const bool to_next = least == phases.begin() ||
                         (next != phases.end() && amount(*next, size) > amount(*(least - 1), size));
    const auto first = to_next ? least : least - 1;
    *first = as_one(*first, *(first + 1), size);
    phases.erase(first + 1);
    phases = joined_neighbours(phases);
  }
  return phases;
}

} // namespace

MotionPhase phase_of(MotionKind kind, const MotionFrame& end) {
  MotionPhase phase;
  phase.kind = kind;
  phase.from = end.time - end.step;
  phase.until = end.time;
  phase.along = end.step * end.twist.head<3>();
  phase.path = phase.along.norm();
  phase.turn = end.step * end.twist.tail<3>();
  phase.angle = phase.turn.norm();
  return phase;
}

MotionPhase phase_of(MotionKind kind, const MotionFrame& begin, const MotionFrame& end) {
  MotionPhase phase = phase_of(kind, end);
  phase.along = end.pose.position - begin.pose.position;
  phase.path = phase.along.norm();
  phase.turn = rotation_vector(end.pose.rotation * begin.pose.rotation.transpose());
  phase.angle = phase.turn.norm();
  return phase;
}

void Phases::add(const MotionPhase& step) {
  if (!phases_.empty() && is_same(phases_.back(), step))
    append(phases_.back(), step);
  else
    phases_.push_back(step);
  if (phases_.size() < Settings::kept_phases) return;
  std::vector<MotionPhase> fewer;
  for (std::size_t k = 0; k + 1 < phases_.size(); k += 2)
    fewer.push_back(as_one(phases_[k], phases_[k + 1], size_));
  phases_ = std::move(fewer);
}

std::vector<MotionPhase> Phases::take() {
  for (MotionPhase& phase : phases_) name_by_whole(phase, size_);
  std::vector<MotionPhase> phases = joined_neighbours(phases_);
  for (double part = Settings::least_part; part < 1; part *= 2) {
    phases = without_slight(std::move(phases), size_, part);
    if (phases.size() <= Settings::most_phases) break;
  }
  return phases;
}

void ForceJumps::add(double time, double h, double force, double others) {
  const auto& [before, jump] = last_;
  const Step now{time, h, force, steps_ > 0 ? std::abs(force - jump.force) / h : 0};
  // The first step sets everything going: a change to the second is not one of the push.
  if (steps_ >= 4) {
    const double change = std::abs(jump.force - before.force);
    const bool is_large =
        change > Settings::least_jump * std::max(before.force, jump.force) &&
        change > std::max(Settings::worth_a_jump * largest_, Settings::exact * others);
    if (is_large && jump.rate > Settings::times_neighbours * std::max(before.rate, now.rate))
      found_.push_back({jump.time, jump.h, before.force, jump.force});
  }
  if (steps_ > 0) largest_ = std::max(largest_, force);
  last_[0] = jump;
  last_[1] = now;
  ++steps_;
}

} // namespace lcpush::desktop
