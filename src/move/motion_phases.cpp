#include "move/motion_phases.hpp"

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
    // It goes to the larger neighbour, whose word stays.
    const auto next = least + 1;
    const bool to_next = least == phases.begin() ||
                         (next != phases.end() && amount(*next, size) > amount(*(least - 1), size));
    const auto first = to_next ? least : least - 1;
    const MotionKind kind = to_next ? next->kind : (least - 1)->kind;
    append(*first, *(first + 1));
    first->kind = kind;
    phases.erase(first + 1);
    phases = joined_neighbours(phases);
  }
  return phases;
}

} // namespace

MotionPhase phase_of(const Motion<double>& motion, const MotionFrame& end, double h) {
  MotionPhase phase;
  phase.kind = motion.kind;
  phase.from = end.time - h;
  phase.until = end.time;
  phase.along = h * end.twist.head<3>();
  phase.path = phase.along.norm();
  phase.turn = h * end.twist.tail<3>();
  phase.angle = phase.turn.norm();
  return phase;
}

std::vector<MotionPhase> merged_phases(std::vector<MotionPhase> phases, double size) {
  phases = joined_neighbours(phases);
  for (MotionPhase& phase : phases) name_by_whole(phase, size);
  phases = joined_neighbours(phases);
  for (double part = Settings::least_part; part < 1; part *= 2) {
    phases = without_slight(std::move(phases), size, part);
    if (phases.size() <= Settings::most_phases) break;
  }
  return phases;
}

void ForceJumps::add(double time, double h, double force) {
  const auto& [before, jump] = last_;
  const Step now{time, h, force, steps_ > 0 ? std::abs(force - jump.force) / h : 0};
  // The first step sets everything going: a change to the second is not one of the push.
  if (steps_ >= 4) {
    const double change = std::abs(jump.force - before.force);
    const bool is_large = change > Settings::least_jump * std::max(before.force, jump.force) &&
                          change > Settings::worth_a_jump * largest_;
    if (is_large && jump.rate > Settings::times_neighbours * std::max(before.rate, now.rate))
      found_.push_back({jump.time, jump.h, before.force, jump.force});
  }
  if (steps_ > 0) largest_ = std::max(largest_, force);
  last_[0] = jump;
  last_[1] = now;
  ++steps_;
}

} // namespace lcpush::desktop
