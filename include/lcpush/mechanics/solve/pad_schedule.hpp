// How stiff pads become from one proximal iteration to the next.
#pragma once

#include "lcpush/mechanics/solve/settings.hpp"

namespace lcpush {

/// The compliance eps falls by a factor a round. After a round that failed it falls by the square
/// root of that factor, from the last round that was solved; each solved one squares it again, up
/// to the first factor.
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
