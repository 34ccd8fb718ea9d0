// How a device pivots.
#pragma once

#include <type_traits>

#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/lcp/pivots/table_lemke.hpp"
#include "lcpush/little_flash.hpp"

namespace lcpush::c {

template <class S>
using DeviceLemke = std::conditional_t<little_flash, TableLemke<S>, SmallLemke<S>>;

} // namespace lcpush::c
