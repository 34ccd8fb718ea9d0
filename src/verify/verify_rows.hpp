// The worst row of each law, with a name.
#pragma once

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/verify.hpp"

namespace lcpush::desktop {

/// One row a law, in Law's order, and one for the numbers of the file that the rest contradicts:
/// its bodies' sums and its points' spins.
std::vector<BrokenRow> broken_rows(const Push& push, const ForeignAnswer& given,
                                   const Answer<double>& answer, bool is_completed);

} // namespace lcpush::desktop
