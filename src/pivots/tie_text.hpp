// The comparison of the lexicographic rule, in words.
#pragma once

#include "lcpush/desktop/pivots.hpp"

namespace lcpush::desktop {

/// "  with q + (e, e^2, ..), e small: w2 at 1/3 e + ..; z3 at e; the least leaves", a line; empty
/// where the tableau is left out, or too many tie. Pre: that rule has decided.
std::string lexicographic_text(const PivotTrace& trace, const TracedPivot& pivot);

} // namespace lcpush::desktop
