// The map beside the line plot.
#pragma once

#include "lcpush/desktop/sweep.hpp"

namespace lcpush::desktop {

/// Of a sweep over two parameters; one quantity, or the breaking force.
std::string sweep_map_svg(const Sweep& sweep, const std::string& title,
                          const std::vector<SweepQuantity>& shown);

} // namespace lcpush::desktop
