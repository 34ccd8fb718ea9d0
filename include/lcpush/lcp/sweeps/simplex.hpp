// The sets that the groups of a factored problem live on: points nearest to them.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

/// The theta >= 0 for which max(0, y_j - theta) sums up to `total`, if max(0, y_j) sums up to more;
/// 0 otherwise. max(0, y_j - theta) is then the point of { beta >= 0, sum beta <= total } nearest
/// to y. Pre: total > 0. Cost: a few passes over y, at most count + 1. [Michelot 1986]
template <class S> S simplex_threshold(const S* y, Index count, const S& total) {
  S theta(0);
  for (Index pass = 0; pass <= count; ++pass) {
    S sum(0);
    Index support = 0;
    for (Index j = 0; j < count; ++j) {
      if (!(y[j] > theta)) continue;
      sum += y[j];
      ++support;
    }
    const S next = support > 0 ? S((sum - total) / S(support)) : theta;
    if (!(next > theta)) break; // every pass drops entries for good
    theta = next;
  }
  return theta;
}

} // namespace lcpush
