// The numbers of this room.
#pragma once

#include "lcpush/types.hpp"

#include <cstddef>
#include <cstdint>

namespace lcpush::desktop {

struct CertifySettings {
  /// What counts as zero of an answer in doubles, over the largest force or acceleration; tried in
  /// this order. The first proves nine of ten random grasps.
  double zeros[3] = {1e-9, 1e-12, 1e-7};
  /// Over the largest: in exact numbers an equality. What doubles leave of one is below 1e-12.
  double equality = 1e-9;
  /// An answer is rounded to so many bits of its largest number where the equations leave it open:
  /// far below what is printed, and short fractions.
  int guess_bits = 40;
  /// Bases of pivots in doubles: under so many covering vectors, whose numbers are so far apart
  /// that what one tries after a failure is not the next one. Of 18 random grasps whose first three
  /// bases fail, eight prove half.
  Index bases = 8, bases_apart = 20;
  /// Exact pivots go on from the first so many of them, under so many covering vectors each, and
  /// end after so many, each of which solves a system anew: 4 s in all of 300 unknowns. The longest
  /// run that 1,500 random grasps need has 35.
  std::size_t pivoted_bases = 3, pivots = 40;
  std::uint32_t covers = 2;
  std::size_t pivots_by_turns = 6; ///< before the next basis goes on
};

constexpr CertifySettings certify_settings;

} // namespace lcpush::desktop
