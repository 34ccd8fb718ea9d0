// The two loops of every pivot. Eigen's expressions say the same, but compiled for size (-Os) they
// call a function for every entry.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush::detail {

/// out += x by.
template <class S> void add_scaled(S* __restrict out, const S* __restrict x, S by, Index count) {
  for (S* const end = out + count; out != end; ++out, ++x) *out += *x * by;
}

/// x' y, the entries of x `stride` apart, summed in their order.
template <class S> S dot_along(const S* x, Index stride, const S* y, Index count) {
  if (count == 0) return S(0);
  S sum = *x * *y;
  for (Index k = 1; k < count; ++k) sum += *(x += stride) * *++y;
  return sum;
}

} // namespace lcpush::detail
