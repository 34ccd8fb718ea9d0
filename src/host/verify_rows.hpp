// The worst row of each law, with a name.
#pragma once

#include "lcpush/host/push.hpp"
#include "lcpush/host/verify.hpp"

namespace lcpush::host {

/// One row a law, in Law's order, and one for the numbers of the file that the rest contradicts:
/// its bodies' sums and its points' spins.
std::vector<BrokenRow> broken_rows(const Push& push, const ForeignAnswer& given,
                                   const Answer<double>& answer);

} // namespace lcpush::host
