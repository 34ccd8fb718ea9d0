// The numbers of holding. Forces are measured in the scene's largest, lengths in its grasp's.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct HoldSettings {
  /// Of all contacts' normal forces together, in the largest force of the scene: what takes more is
  /// called unlimited. Of fingers that keep their forces the sum is known, and is the limit.
  double most_force = 1000;
  double beyond_sum = 1.001; ///< that known sum is not to bind
  /// A ray is added where it would shorten the dual's slack by more, and enters where it lowers the
  /// cost by more; rays nearer to each other than that would cost digits.
  double missing = 1e-11, price = 1e-12;
  double closed = 1e-9;   ///< of a program's value: its bounds meet
  Index most_rounds = 60; ///< in which rays are added; the angle's error is squared in each
  /// From so many rays on, and so many a cone, those without force are dropped.
  Index most_rays = 48, rays_a_cone = 6;
  double carries = 1e-9; ///< of the load's part that no force balances: forces are found
  /// Of a nearest distance: its bracket is closed; and the directions that are asked for that.
  double bracket = 9e-7;
  Index most_directions = 4200;
  double flat = 1e-8;      ///< of its size: a set thinner than that has no inside
  double rounding = 1e-13; ///< of its size: a point is on a plane
  double beside = 4;   ///< of the least reach along an axis: what is held beyond does not matter
  double slips = 1e-6; ///< of the fastest point of a motion: it moves
  /// The scene's own law: its limit is pads' where it holds with so much less; else it is searched
  /// from so far below, to a bracket of this, relative. Told beside statics' where they differ by
  /// more.
  double same = 5e-4, first_step = 5e-3, law = 1e-3, told = 1e-2;
  Index section_steps = 72, pad_steps = 24; ///< directions in a plane of a picture; of pads
  double least_unit = 1e-3; ///< of the grip: from there on the law's least grip is searched
  Index most_patterns = 40; ///< of touching points, one after the other
  Index most_pivots = 4000; ///< of one load; a law that takes more has no answer that is found
  double pad_work = 1e9;    ///< multiplications of pads' programs: then their limits are not known
};

constexpr HoldSettings hold_settings;

} // namespace lcpush::desktop
