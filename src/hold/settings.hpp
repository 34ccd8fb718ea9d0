// The numbers of holding. Forces are measured in the scene's largest, lengths in its grasp's.
#pragma once

#include "solve/settings.hpp"

namespace lcpush::desktop {

struct HoldSettings {
  /// Of a nearest distance: its bracket is closed; and the directions that are asked for that.
  double bracket = 9e-7;
  Index most_directions = 4200;
  /// Multiplications of its programs, about a third of a second; then its bracket is told open.
  double nearest_work = 3e8;
  double rounding = 1e-13; ///< of its size: a point is on a plane
  double beside = 4; ///< of the least reach along an axis: what is held beyond does not matter
  /// The scene's own law: its limit is pads' where it holds with so much less; else it is searched
  /// from so far below, to a bracket of this, relative. Told beside statics' where they differ by
  /// more.
  double same = 5e-4, first_step = 5e-3, law = 1e-3, told = 1e-2;
  double stride = 4; ///< of its search from the largest force on, where statics bounds nothing
  double less[4] = {0.9, 0.75, 0.5, 0.25};   ///< of the load that its search ends at: held as well?
  double more[4] = {1.003, 1.01, 1.03, 1.1}; ///< of the least grip: held as well?
  double more_share = 0.05;                  ///< of the law's work, for that
  Index section_steps = 72, pad_steps = 24;  ///< directions in a plane of a picture; of pads
  double least_unit = 1e-3; ///< of the grip: from there on the law's least grip is searched
  Index most_patterns = 40; ///< of touching points, one after the other
  Index most_pivots = 4000; ///< of one load; a law that takes more has no answer that is found
  /// Points of pads' surfaces: friction they bear together is off by 8e-4 at most for a
  /// disc, 1.1e-3 for a square; those of scenes, 12 and 16, by 2.4 and 2.7 per cent.
  Index disc_points = 144, side_points = 18, line_points = 48;
  Index unused_facets = 4; ///< where friction is round
  /// The law, of the scene's own points, is asked with so much less than its surfaces hold.
  double of_points = 0.03;
  double astray = 0.9; ///< of the few points' limit: less is a wrong pattern of the surfaces
  /// Of a limit: what a load so much larger does is told; points bear at most `of_points` less.
  double beyond = 0.05;
  /// Of the law's work: what a direction that is asked for may take. Of a screwdriver in three
  /// lines of points one took all that was left, and the weakest direction was not known.
  double asked_share = 0.2;
  double pad_work = 1e9; ///< multiplications of pads' programs: then their limits are not known
};

constexpr HoldSettings hold_settings;

} // namespace lcpush::desktop
