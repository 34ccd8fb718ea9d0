// In which order contacts are eliminated.
#pragma once

#include "lcpush/desktop/matrix_market.hpp"

namespace lcpush::desktop {

/// Contacts that move each other beside each other, three rows of W each: what eliminates them row
/// after row fills a band in. [Cuthill and McKee 1969, turned round as George 1971]
/// Cost: a pass over W and its contacts' links sorted.
std::vector<Index> contact_order(const SparseRows& W);

} // namespace lcpush::desktop
