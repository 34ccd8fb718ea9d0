// Pivots on the structured basis that begin where all points have moved at once.
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush::desktop {

/// Many points share few motions: a basis made for another motion is wrong at most of them, and
/// each is a pivot or more. So where the basis to start from is against more than a few points, a
/// better one is looked for before any pivot: pads move by Newton's method (ProximalNewton), which
/// ends near the answer; rigid patches press at a few of their points (FewPoints). It is a start
/// and no more: pivots go on from there. Where a pad's compliance is so small that they end
/// nowhere, do not end, or end on an answer that barely passes, sweeps have a try.
class SettledPivots {
public:
  using Flags = std::vector<unsigned char>; ///< unknowns: 1 where z_i is basic
  static constexpr Index smallest = 600;    ///< unknowns: fewer are left to the pivots
  static constexpr bool carries_push = true;

  /// After `pivots_left`, if there is a number, which it counts down, it is lost.
  SettledPivots(StructuredLemke<double>& lemke, const Assembly<double>& assembly,
                std::optional<Index>& pivots_left)
      : lemke_(lemke), assembly_(assembly), pivots_left_(pivots_left) {}

  Status init(const Problem<double>& problem, const LemkeOptions<double>& options) {
    is_lost_ = gives_up(problem);
    return is_lost_ ? status() : begin(problem, lemke_.init(problem, options));
  }
  Status init(const Problem<double>& problem, const LemkeOptions<double>& options,
              const unsigned char* active, Guess guess);

  template <class Watcher> Status step(Watcher& watcher) {
    if (!is_lost_ && pivots_left_) is_lost_ = --*pivots_left_ <= 0;
    is_lost_ = is_lost_ || lemke_.pivots() > last_patience_;
    return is_lost_ ? status() : note(lemke_.step(watcher));
  }
  template <class Watcher> Status solve(Watcher& watcher) {
    while (step(watcher) == Status::running) continue;
    return status();
  }
  Status status() const {
    if (is_lost_) return Status::numerical_breakdown;
    return is_swept_ ? Status::solved : lemke_.status();
  }
  Reason reason() const { return lemke_.reason(); }
  bool is_spent() const { return pivots_left_ && *pivots_left_ <= 0; }
  Index pivots() const { return lemke_.pivots(); }
  Index sweeps() const { return sweeps_; } ///< of all rounds
  bool is_basic(Index i) const {
    return is_swept_ ? swept_basis_[static_cast<std::size_t>(i)] != 0 : lemke_.is_basic(i);
  }
  const double* z() const { return is_swept_ ? swept_.data() : lemke_.z(); }
  const double* z_push() const { return lemke_.z_push(); }
  double valid_to() const { return lemke_.valid_to(); }

private:
  static constexpr Index few = 8;              ///< points, as well
  static constexpr Index patience = 100;       ///< pivots, before sweeps have a try
  static constexpr Index more_patience = 1000; ///< pivots, after sweeps have failed
  static constexpr double barely = Tolerances<double>().residual / 16;
  StructuredLemke<double>& lemke_;
  const Assembly<double>& assembly_;
  std::optional<Index>& pivots_left_;
  std::vector<double> values_;

  Problem<double> problem_{};
  bool is_swept_ = false;                                   ///< this round's answer is sweeps'
  bool may_sweep_ = false;                                  ///< in this round
  Index last_patience_ = std::numeric_limits<Index>::max(); ///< pivots of this round
  int sweeps_that_failed_ = 0;
  bool is_lost_ = false;       ///< this round is not tried
  double lost_compliance_ = 0; ///< of the round that sweeps lost last, in this solve
  Index sweeps_ = 0;
  std::vector<double> swept_; ///< where sweeps begin, and their answer
  Flags swept_basis_;

  Status begin(const Problem<double>& problem, Status status);
  Status note(Status status) {
    if (status == Status::solved) {
      keep_answer();
      if (may_sweep_ && lemke_.residual().residual > barely)
        (void)try_sweeps(); // or the laws refuse it
    }
    const bool is_slow = status == Status::running && lemke_.pivots() > patience;
    const bool has_failed = status != Status::running && status != Status::solved;
    return may_sweep_ && (is_slow || has_failed) && sweep() ? Status::solved : status;
  }
  void keep_answer();
  bool sweep();
  bool try_sweeps();
  bool gives_up(const Problem<double>& problem) const;
  bool find_better(const Problem<double>& problem, const LemkeOptions<double>& options, Guess guess,
                   Flags& basis);
};

} // namespace lcpush::desktop
