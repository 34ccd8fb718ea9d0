// Scaling by powers of two, which rounds nothing; generic numbers for covering vectors and ties.
#pragma once

#include <cstdint>

#include "lcpush/lcp/pivots/settings.hpp"
#include "lcpush/types.hpp"

namespace lcpush {

/// The largest power of two p with p * p * x <= 1; 1 for x = 0, so that zero rows stay as they are,
/// and for what is not finite.
template <class S> S reciprocal_root(const S& x) {
  S p(1);
  if (!(x > S(0)) || !(x - x == S(0))) return p;
  while (p * p * x > S(1)) p = p / S(2);
  while (S(4) * p * p * x <= S(1)) p = p * S(2);
  return p;
}

/// The largest power of two that is not above x; 1 for x = 0 and for what is not finite.
template <class S> S power_below(const S& x) {
  S p(1);
  if (!(x > S(0)) || !(x - x == S(0))) return p;
  while (p > x) p = p / S(2);
  while (p <= x / S(2)) p = p * S(2); // x / 2, because 2 p may overflow
  return p;
}

/// Scales M in place so that the largest entry of every row and column comes near 1, and multiplies
/// the factors into row_scale and column_scale (Ruiz's iteration). Cost: a few times three
/// sweeps over M; it ends when a pass changes nothing.
template <class S>
void equilibrate(MatrixMap<S> M, VectorMap<S> row_scale, VectorMap<S> column_scale,
                 VectorMap<S> scratch) {
  bool changes = true;
  for (int pass = 0; pass < LemkeSettings::equilibrations && changes; ++pass) {
    changes = false;
    scratch.setZero();
    for (Index j = 0; j < M.cols(); ++j) {
      const S factor = reciprocal_root(S(M.col(j).cwiseAbs().maxCoeff()));
      if (factor != S(1)) {
        M.col(j) *= factor;
        column_scale[j] *= factor;
        changes = true;
      }
      scratch = scratch.cwiseMax(M.col(j).cwiseAbs());
    }
    // The columns have taken half of the exponent; the rows take what is left of theirs.
    bool rows_change = false;
    for (Index i = 0; i < M.rows(); ++i) {
      const S factor = reciprocal_root(S(scratch[i]));
      scratch[i] = factor;
      row_scale[i] *= factor;
      rows_change = rows_change || factor != S(1);
    }
    if (!rows_change) continue;
    changes = true;
    for (Index j = 0; j < M.cols(); ++j) M.col(j) = M.col(j).cwiseProduct(scratch);
  }
}

/// A fixed pseudo-random number in [1, 2) for every (seed, i): generic, and the same on all
/// machines. 20 bits, so that float and double see the same number.
template <class S> S generic_number(std::uint32_t seed, Index i) {
  std::uint32_t x = seed * 0x9E3779B9U + static_cast<std::uint32_t>(i) * 0x85EBCA6BU + 0x165667B1U;
  x = (x ^ (x >> 16)) * 0x7FEB352DU;
  x = (x ^ (x >> 15)) * 0x846CA68BU;
  x ^= x >> 16;
  return S(1) + S(static_cast<int>(x >> 12)) / S(1 << 20);
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template void equilibrate<double>(MatrixMap<double>, VectorMap<double>, VectorMap<double>,
                                         VectorMap<double>);
#endif

} // namespace lcpush
