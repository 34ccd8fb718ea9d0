// Pivots on the structured basis that first turn the slides of the basis they start from.
#pragma once

#include <algorithm>
#include <vector>

#include "solve/basis_values.hpp"

namespace lcpush::desktop {

/// Where the pyramids of pads have many facets, a motion that differs by a percent from the one
/// that a basis was made for opposes another generator at every point, and each is a pivot or more.
/// So before any pivot the points that slide take the generator that is most opposed to their slip
/// in the motion of the basis, all at once, until they stay. Where that turns the motion so far
/// that they would turn back, the slip lies between two generators and some of the points keep to
/// either: then half as many turn each time.
class TurningPivots {
public:
  explicit TurningPivots(StructuredLemke<double>& lemke) : lemke_(lemke) {}

  /// With fewer generators a percent of the motion turns few points: Newton's method settles them.
  static bool turns(const Problem<double>& problem) {
    constexpr Index few = 64;
    for (const ConeGroup<double>& cone : problem.factored->cones)
      if (cone.generators > few) return true;
    return false;
  }

  Status init(const Problem<double>& problem, const LemkeOptions<double>& options) {
    return lemke_.init(problem, options);
  }
  Status init(const Problem<double>& problem, const LemkeOptions<double>& options,
              const unsigned char* active, Guess guess) {
    const Status status = lemke_.init(problem, options, active, guess);
    if (status != Status::running || !has_pads(problem)) return status;
    active_.assign(active, active + problem.size);
    best_ = active_;
    if (!turn(problem, options, guess)) return lemke_.status();
    return lemke_.init(problem, options, best_.data(), guess);
  }

  template <class Watcher> Status step(Watcher& watcher) { return lemke_.step(watcher); }
  template <class Watcher> Status solve(Watcher& watcher) { return lemke_.solve(watcher); }
  Status status() const { return lemke_.status(); }
  Reason reason() const { return lemke_.reason(); }
  Index pivots() const { return lemke_.pivots(); }
  bool is_basic(Index i) const { return lemke_.is_basic(i); }
  const double* z() const { return lemke_.z(); }
  const double* z_push() const { return lemke_.z_push(); }
  double valid_to() const { return lemke_.valid_to(); }

private:
  static constexpr double clearly = 1e-12;
  static constexpr std::size_t worth_turning = 2; ///< points: fewer are left to the pivots
  StructuredLemke<double>& lemke_;
  std::vector<unsigned char> active_, best_;
  std::vector<double> values_;

  /// True: the pivots do not stand at best_, the basis that leaves the fewest to them.
  bool turn(const Problem<double>& problem, const LemkeOptions<double>& options, Guess guess) {
    constexpr int most_turns = 16, free_turns = 2;
    std::size_t most = active_.size(), fewest = 0;
    bool is_best = true;
    for (int k = 0;; ++k) {
      read_values(problem);
      const std::size_t opposed = note_turns(problem);
      // Of those that would turn to and fro, about as many as turned last are on the wrong side.
      const std::size_t left = opposed - turns_.size() + std::min(turns_.size(), most);
      is_best = k == 0 || left < fewest;
      if (is_best) {
        fewest = left;
        best_ = active_;
      }
      if (left <= worth_turning || 4 * turns_.size() < opposed || k == most_turns) break;
      if (k > free_turns) most = std::min(most, turns_.size()) / 2;
      turn_most_opposed(most);
      if (most == 0) break;
      if (lemke_.init(problem, options, active_.data(), guess) != Status::running) return true;
    }
    return !is_best;
  }

  struct Turn {
    double slack;
    std::size_t from, to; // unknowns
    bool operator<(const Turn& other) const { return slack < other.slack; }
  };
  std::vector<Turn> turns_;

  void turn_most_opposed(std::size_t most) {
    if (turns_.size() > most) {
      std::nth_element(turns_.begin(), turns_.begin() + static_cast<std::ptrdiff_t>(most),
                       turns_.end());
      turns_.resize(most);
    }
    for (const Turn& turn : turns_) {
      active_[turn.from] = 0;
      active_[turn.to] = 1;
    }
  }

  void read_values(const Problem<double>& problem) {
    values_.assign(active_.size(), 0.0);
    visit_basis(lemke_, problem, [&](Index i, double value, Index /*row*/) {
      values_[static_cast<std::size_t>(i)] = value;
    });
  }

  /// Fills turns_. Returns how many points are against the basis, in whatever way.
  std::size_t note_turns(const Problem<double>& problem) {
    turns_.clear();
    std::size_t opposed = 0;
    for (const ConeGroup<double>& cone : problem.factored->cones) {
      const auto first = values_.begin() + cone.variable;
      if (*std::min_element(first, first + cone.size()) >= -clearly) continue;
      ++opposed;
      note_turn(cone);
    }
    return opposed;
  }

  void note_turn(const ConeGroup<double>& cone) {
    const auto slip = static_cast<std::size_t>(cone.slip());
    if (cone.generators == 0 || active_[slip] == 0 || values_[slip] < -clearly) return;
    const auto first = static_cast<std::size_t>(cone.variable + cone.normals);
    const auto end = first + static_cast<std::size_t>(cone.generators);
    std::size_t least = end, most = end, most_opposed = end, count = 0;
    for (std::size_t k = first; k < end; ++k) {
      if (active_[k] == 0) {
        if (most_opposed == end || values_[k] < values_[most_opposed]) most_opposed = k;
        continue;
      }
      ++count;
      if (least == end || values_[k] < values_[least]) least = k;
      if (most == end || values_[k] > values_[most]) most = k;
    }
    if (count > 1 && values_[least] < -clearly) // the others bear it alone
      turns_.push_back({-1 / clearly, least, most});
    if (count == 1 && most_opposed < end && values_[most_opposed] < -clearly)
      turns_.push_back({values_[most_opposed], least, most_opposed});
  }
};

} // namespace lcpush::desktop
