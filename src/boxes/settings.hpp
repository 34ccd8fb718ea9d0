// The numbers of boxes.
#pragma once

#include <cstddef>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct BoxSettings {
  /// Fractions longer than that become intervals between multiples of 2^-grid_bits, 1e-72 of SI
  /// units: far finer than any condition that is not zero.
  std::size_t short_bits = 320, grid_bits = 240;
  /// How far a coordinate of an irrational normal is cut off, and a point of a disc or a direction
  /// of eight facets, of its size (see SceneOf::inexact).
  double cut_normal = 1e-15, rounded = 1e-12;
  std::size_t most_sides = 14; ///< numbers of a box: 16,384 corners are a second
  /// Corners of a plan's box, each a grip of its own at every look: 64 make a search 20 times as
  /// long. Not measured.
  std::size_t plan_corners = 64;
  int halvings = 60, quick_halvings = 30; ///< of a margin; quick: where each is a program
  double tie = 1e-30;   ///< N and N m: corners that differ by less do so by their intervals' roots
  double inside = 1e-9; ///< so far below a margin it is proved in fractions
  double no_margin = 1 - 1e-6; ///< of a margin: frictions and forces that vanish make no difference
  double holding = 1e-6; ///< a load that takes so much less than the grip is held, whatever rounds
};

constexpr BoxSettings box_settings;

} // namespace lcpush::desktop
