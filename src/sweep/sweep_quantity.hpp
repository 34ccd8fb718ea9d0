// What a picture of a sweep shows.
#pragma once

#include "lcpush/desktop/sweep.hpp"

namespace lcpush::desktop {

/// Of the question that the quantity belongs to.
const SweepAnswer& answer_of(const SweepQuantity& quantity, const SweepValue& at);
double value_of(const SweepQuantity& quantity, const SweepValue& at);
bool is_force(const SweepQuantity& quantity);
/// "push along x": for the legend.
std::string words_of(const SweepQuantity& quantity);
/// "push along x, N".
std::string axis_label(const SweepQuantity& quantity);

/// Of a sweep over two parameters; one quantity, or the breaking force.
std::string sweep_map_svg(const Sweep& sweep, const std::string& title,
                          const std::vector<SweepQuantity>& shown);

} // namespace lcpush::desktop
