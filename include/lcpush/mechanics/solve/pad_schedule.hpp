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
    eps_ = last_ = options.first_compliance;
    factor_ = fastest_ = options.factor;
    rounds_ = 0;
  }

  const S& compliance() const { return eps_; }
  /// Counts the rounds; false: that was the last.
  bool has_next() { return ++rounds_ < PadSettings::most_rounds; }

  /// After a round that was solved: the same compliance once more, or less.
  void keep() { last_ = eps_; }
  void fall() {
    last_ = eps_;
    factor_ = Eigen::numext::maxi(fastest_, S(factor_ * factor_));
    eps_ *= factor_;
  }
  /// After one that was lost; false: it cannot fall any slower.
  bool fall_slower() {
    if (!(factor_ < PadSettings::slowest<S>())) return false;
    factor_ = Eigen::numext::sqrt(factor_);
    eps_ = last_ * factor_;
    return true;
  }

private:
  S eps_{0}, last_{0};       // of this round, of the last that was solved
  S factor_{0}, fastest_{0}; // between rounds, and the least
  Index rounds_ = 0;
};

} // namespace lcpush
