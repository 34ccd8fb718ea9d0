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
  /// Pivots in fractions go on from the first so many of them, under so many covering vectors each,
  /// and end after so many, each of which solves a system anew. Of 33 random grasps in 700 that no
  /// basis proves, one then has no certificate; with three bases and two covering vectors six.
  std::size_t pivoted_bases = 6;
  std::uint32_t covers = 3;
  int pivots = 40;
  /// By 2^tiny times numbers up to 2^16 q is moved there: far less than fractions of doubles differ
  /// by, where they are not equal.
  int tiny = -300;
};

constexpr CertifySettings certify_settings;

} // namespace lcpush::desktop
