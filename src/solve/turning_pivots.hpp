// Pivots on the structured basis that first turn the slides of the basis they start from.
#pragma once

#include <algorithm>
#include <vector>

#include "lcpush/lcp/pivots/structured_lemke.hpp"

namespace lcpush::desktop {

/// Where pyramids have many facets, a motion that differs by a percent from the one that a basis
/// was made for opposes another generator at every point, and each is a pivot or more. So before
/// any pivot the points that slide take the generator that is most opposed to their slip in the
/// motion of the basis, all at once, until they stay. Where that turns the motion so far that they
/// would turn back, the slip lies between two generators and some of the points keep to either:
/// then half as many turn each time.
class TurningPivots {
public:
  explicit TurningPivots(StructuredLemke<double>& lemke) : lemke_(lemke) {}

  Status init(const Problem<double>& problem, const LemkeOptions<double>& options) {
    return lemke_.init(problem, options);
  }
  Status init(const Problem<double>& problem, const LemkeOptions<double>& options,
              const unsigned char* active, Guess guess) {
    constexpr int most_turns = 16, free_turns = 2;
    const Status status = lemke_.init(problem, options, active, guess);
    if (status != Status::running || !is_fine(problem)) return status;
    active_.assign(active, active + problem.size);
    auto most = static_cast<std::size_t>(problem.factored->cones.size);
    for (int k = 0; k < most_turns && most > 0; ++k) {
      const std::size_t turned = turn_slides(problem, most);
      if (turned == 0) break;
      if (lemke_.init(problem, options, active_.data(), guess) != Status::running)
        return lemke_.init(problem, options, active, guess);
      if (k >= free_turns) most = turned / 2;
    }
    return lemke_.status();
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
  StructuredLemke<double>& lemke_;
  std::vector<unsigned char> active_;
  std::vector<double> values_;

  /// With fewer generators a pivot or two cost less.
  static bool is_fine(const Problem<double>& problem) {
    constexpr Index few = 16;
    for (const ConeGroup<double>& cone : problem.factored->cones)
      if (cone.generators > few) return true;
    return false;
  }

  struct Turn {
    double slack;
    std::size_t from, to; // unknowns
    bool operator<(const Turn& other) const { return slack < other.slack; }
  };
  std::vector<Turn> turns_;

  /// At most so many, those that are most opposed. Returns how many.
  std::size_t turn_slides(const Problem<double>& problem, std::size_t most) {
    read_values(problem);
    turns_.clear();
    for (const ConeGroup<double>& cone : problem.factored->cones) note_turn(cone);
    if (turns_.size() > most) {
      std::nth_element(turns_.begin(), turns_.begin() + static_cast<std::ptrdiff_t>(most),
                       turns_.end());
      turns_.resize(most);
    }
    for (const Turn& turn : turns_) {
      active_[turn.from] = 0;
      active_[turn.to] = 1;
    }
    return turns_.size();
  }

  /// z_i where it is basic, w_i where that is.
  void read_values(const Problem<double>& problem) {
    const Dictionary<double>& basis = lemke_.dictionary();
    const Index n = problem.size, finite = problem.free_begin < n ? 1 : 0;
    values_.assign(active_.size(), 0.0);
    for (Index row = 0; row < n; ++row) {
      const Index variable = basis.basic[row], i = variable < n ? variable : variable - n;
      const double unit = variable < n ? lemke_.slack_unit(i) : lemke_.unknown_unit(i);
      values_[static_cast<std::size_t>(i)] = basis.values(row, finite) * unit;
    }
  }

  void note_turn(const ConeGroup<double>& cone) {
    if (cone.generators == 0 || active_[static_cast<std::size_t>(cone.slip())] == 0) return;
    constexpr double clearly = 1e-12;
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
