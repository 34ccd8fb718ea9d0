// Lemke's pivots in fractions: include it wherever Lemke<Rational> is used.
#pragma once

#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"

/// The numbers of a row share a denominator, and a pivot seeks one divisor a row, not several an
/// entry.
template <>
void lcpush::Dictionary<lcpush::desktop::Rational>::exchange(
    Index r, Index c, VectorMap<lcpush::desktop::Rational> entering);
