// How stiff pads become from one proximal iteration to the next.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/types.hpp"

#include <Eigen/Core>

namespace lcpush {

template <class S> struct PressureOptions {
  S first_compliance{S(1) / S(100)}; ///< eps of round 1: a hundredth of the grip's force over mass,
                                     ///< so that a pad's modes are nearly those of the end
  S factor{S(0.31622776601683794)};  ///< eps falls by this a round, 10^-1/2; the fewest pivots of
                                     ///< 10^-1/4 to 10^-1 on random grasps
  S slowest{S(7) / S(10)};           ///< .. and by no larger one after rounds that were lost
  Index max_rounds = 60;             ///< a median of 7 is enough (docs/theory/numerics.md)
  Index stiff_starts = 2;       ///< from the literal basis, if the rounds from nothing are lost
  S stiff_start{S(1) / S(100)}; ///< the first compliance of each, beside the one before
  Index max_turns = 32;         ///< of round friction's pyramids; Newton's method takes 4
  Index max_pivots = 0;              ///< of all rounds together; 0: the solver's limits alone
  S runaway{1000}; ///< a squeeze that rounds only tighten: a normal force beyond this, in what the
                   ///< scene's forces and prescribed motions ask for
  S tolerance = Tolerances<S>().settled; ///< scaled violation of the literal [T.2] allowed
  Index fine_rounds = 0; ///< so many more at most, while the violation is above `finest`
  S finest{0};
  bool exact_limit = true; ///< a breaking force by an infinitesimal push, where rounds carry one
  bool goes_on = false;    ///< `pad`: from the memory's last answer, as if this were its next round
};

/// The compliance eps falls by a factor a round. A round that is lost is tried again at a larger
/// compliance, and from there eps comes down more slowly; each one that is solved makes it faster
/// again.
template <class S> class PadSchedule {
public:
  void begin(const PressureOptions<S>& options) {
    options_ = &options;
    eps_ = last_ = options.first_compliance;
    factor_ = options.factor;
    rounds_ = 0;
  }

  const S& compliance() const { return eps_; }
  /// Counts the rounds; false: that was the last.
  bool has_next() { return ++rounds_ < options_->max_rounds; }

  /// After a round that was solved: the same compliance once more, or less.
  void keep() { last_ = eps_; }
  void fall() {
    last_ = eps_;
    factor_ = Eigen::numext::maxi(options_->factor, S(factor_ * factor_));
    eps_ *= factor_;
  }
  /// After one that was lost; false: it cannot fall any slower.
  bool fall_slower() {
    if (!(factor_ < options_->slowest)) return false;
    factor_ = Eigen::numext::sqrt(factor_);
    eps_ = last_ * factor_;
    return true;
  }

private:
  const PressureOptions<S>* options_ = nullptr;
  S eps_{0}, last_{0}, factor_{0}; // of this round, of the last that was solved, between rounds
  Index rounds_ = 0;
};

} // namespace lcpush
