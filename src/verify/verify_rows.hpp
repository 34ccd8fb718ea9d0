// The worst row of each law, with a name.
#pragma once

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/verify.hpp"

#include <string>

namespace lcpush::desktop {

/// One row for the numbers of the file that the rest contradicts (bodies' sums, spins, and the
/// object's acceleration if the answer has another), and one a law, in Law's order.
std::vector<BrokenRow> broken_rows(const Push& push, const ForeignAnswer& given,
                                   const Answer<double>& answer, bool is_completed);

/// The power of ten, "0.001", from which on --tolerance takes what is off by this part.
std::string next_tolerance(double off);

} // namespace lcpush::desktop
