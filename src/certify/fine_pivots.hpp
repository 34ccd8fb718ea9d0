// Lemke's pivots in more digits than a double's: what 16 call a tie, 32 or 77 decide as fractions
// do.
#pragma once

#include "certify/exact_pivots.hpp"
#include "exact/double_double.hpp"
#include "exact/wide_float.hpp"
#include "lcpush/desktop/owned.hpp"

namespace lcpush::desktop {

/// Final bases of pivots on these fractions, rounded to S: a DoubleDouble or a WideFloat. Memory:
/// two dense matrices. Cost: the square of `unknowns` a pivot.
template <class S> class FinePivots {
public:
  explicit FinePivots(const MixedProblem& problem);
  FinePivots(const FinePivots&) = delete;
  FinePivots& operator=(const FinePivots&) = delete;

  /// Under the generic covering vector of this number; empty if they end otherwise than with an
  /// answer, or need more than `most_pivots`.
  Basis basis(Index cover, Index most_pivots);
  /// The same from a basis that is nearly one.
  Basis basis_from(const Basis& near, Index most_pivots);
  Index pivots() const { return pivots_; } ///< so far
  Index unknowns() const { return problem_.size; }

private:
  std::size_t size_;
  std::vector<std::size_t> pairs_; // of the mixed problem
  std::vector<S> matrix_, q_;
  Problem<S> problem_;
  OwnedLemke<S> lemke_;
  Index pivots_ = 0;

  Basis pivoted();
};

extern template class FinePivots<DoubleDouble>;
extern template class FinePivots<WideFloat>;

} // namespace lcpush::desktop
