// The numbers of contact problems, whose forces and velocities are scaled to be near 1.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct ContactSettings {
  static constexpr Index most_rows = 3000;   ///< 144 MB of W's entries, and a dense factor
  static constexpr double asymmetric = 1e-9; ///< of the larger: files are printed in ten digits
  /// Residuals: an answer is solved below the first; iterations go on to the second, which is what
  /// rounding leaves.
  static constexpr double solved = 1e-12, aimed_at = 2e-15;
  static constexpr double off_slip = 1e-6; ///< rad, of an answer that is solved
  /// Of the terms of a contact's rows: what a sum of them, and the solver's last step, may be off.
  static constexpr double rounding = 1e-14;
  /// Of the last digit of printed forces: what a contact's velocities may be off by. Of 800 heaps
  /// none is refused in 7, 8 or 10 digits.
  static constexpr double digits = 10;
  // Newton's method: a proximal term keeps forces that move nothing; tau smooths the laws.
  static constexpr double eps = 1e-8, falls = 0.1, last_tau = 1e-12;
  /// Of friction, times tau: a path that turns back with one leads to an answer with another. Of 30
  /// heaps and 12 piles these solve 29 and 12, without 100 or 10 one less, without 1 four piles.
  static constexpr double smoothers[] = {1, 10, 100};
  /// Where no path leads to an end: sides of the pyramids to begin at, how often these are turned
  /// to the slips, and of all contacts the most sides, whose pivots take about a second. Of 200
  /// heaps of 20 to 40 contacts with masses from 1 to 1e6 two do not end; two others not by 20.
  static constexpr Index facets = 8, most_turns = 4, pyramid_sides = 800;
  static constexpr double near_path = 0.1; ///< of tau: the residual that is near enough
  /// Steps along the path, and those that may fail: piles of 225 contacts with masses from 1 to 1e6
  /// took 40 and 12.
  static constexpr int outer = 80, failures = 12, newton_steps = 25, halvings = 8, patience = 6;
  static constexpr double decrease = 1e-4;   ///< of the residual, times the step
  static constexpr double settled = 1e-14;   ///< of the largest force
  static constexpr double equality = 1e-2;   ///< delta of the multipliers, whose columns are near 1
  static constexpr Index most_refuted = 200; ///< contacts of which a contradiction is looked for
  static constexpr double few_digits = 5e-3; ///< scaled: what three digits leave of the laws
  static constexpr double turned = 1e-2;     ///< of the residual: so little shows what was mistaken
  static constexpr double thousand = 1e3;    ///< kN and mN, and impulses of a millisecond
  static constexpr double along_slip =
      0.1; ///< rad: friction so near to the slip has the wrong sign
  /// Of the largest normal force where nothing holds: less is none. What is left of its velocities,
  /// of their terms, is rounding of forces that grow until they end.
  static constexpr double weight = 1e-6, balanced = 1e-7;
  static constexpr Index shown = 20; ///< lines of a table
};

} // namespace lcpush::desktop
