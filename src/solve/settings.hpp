// The numbers of solving on the desktop, and why they are what they are.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct SolveSettings {
  /// Unknowns from which on the structured basis is faster than the whole dictionary
  /// (docs/theory/numerics.md).
  Index structured = 200;
  /// Unknowns of pads from which on a round that pivots do not end is left to Gauss-Seidel: of 60
  /// points a cold start is dear, and of so many stiff pads the digits lose the last basis.
  Index wide = 600;
  /// An unknown that Gauss-Seidel leaves above this is basic; forces are of order 1.
  double swept_force = 1e-9;
  /// `hybrid`: a warm start for pivots is near enough where sweeps agree to six digits; and what
  /// they have not reached by then, pivots reach sooner.
  double swept_near = 1e-6;
  Index swept_most = 200;
  /// From a neighbour's basis: more pivots may end at another answer than the neighbour's goes on
  /// to.
  Index near_pivots = 4;
  /// The residual of a sweep's answer is divided by this where the laws refuse it.
  double stricter = 100;
  /// More rounds of round friction that has settled, until a slow push stands out from what it is
  /// off by: Newton's method is exact to rounding after one or two.
  Index fine_rounds = 3;
  // Does it hold? (rest_verdict.cpp)
  /// A load that needs this much more grip falls: what rounding leaves of the least factor.
  double short_of_load = 1e-6;
  /// Statics holds the load with this much of the grip to spare.
  double room = 1e-3;
  /// Then what pushes leave is a fall only where the law moves so at rest, but for this part of it.
  double same_fall = 0.1;
  /// Of F: a pull of less is what the line through pushes leaves of no force (straight, of
  /// breaking).
  double no_pull = 1e-6;
  /// A load below this part of the grip is measured beside the grip.
  double least_load = 1.0 / 16;
  /// A pad's last compliance looks like a slow fall, by at most so many times the noise; then the
  /// rounds go on until they leave this part of it.
  double slow_fall = 1e5, finer_pads = 1e-4;

  /// Of a ray's largest entry: what is below has no part in it.
  double ray_noise = 1e-9;
  /// Two answers are one where motions and forces differ by no more than this, relative: pads
  /// settle to 1.5e-11, and the worst conditioned of 10,000 random grasps lose five digits.
  double same = 1e-5;
  /// Parts of what sticks' friction, with which another answer is looked for: hardly any, as who
  /// counts by hand, with half, or where that slips with hardly less.
  double less_friction[3] = {1e-6, 0.5, 0.9};
  /// Of the time there is, after which no further search is begun: each may take as long as the
  /// answer took, and what is there is to be written.
  double search_time = 0.5;
  /// A derivative follows pads and turning friction in so many passes at most, until one changes it
  /// by no more than this part: each leaves a pad's last compliance of it, mostly 1e-4.
  Index most_passes = 60;
  double settled_passes = 1e-12;
  /// Of the unit that its closing is measured in: a finger that is slower does not move.
  double hand_moves = 1e-3;
};

/// Statics as a cone program (grip_statics.cpp). Forces are measured in the scene's largest,
/// lengths in its grasp's.
struct StaticsSettings {
  /// Of all contacts' normal forces together, in the largest force of the scene: what takes more is
  /// called unlimited. Of fingers that keep their forces the sum is known, and is the limit.
  double most_force = 1000;
  double beyond_sum = 1.001; ///< that known sum is not to bind
  /// A ray is added where it would shorten the dual's slack by more, and enters where it lowers the
  /// cost by more; rays nearer to each other than that would cost digits.
  double missing = 1e-11, price = 1e-12;
  double closed = 1e-9;   ///< of a program's value: its bounds meet
  double worth = 0.5;     ///< of a pad's rays those are added that lack so much of what most lacks
  Index most_rounds = 60; ///< in which rays are added; the angle's error is squared in each
  /// From so many rays on, and so many a cone, those without force are dropped.
  Index most_rays = 48, rays_a_cone = 6;
  double carries = 1e-9;  ///< of the load's part that no force balances: forces are found
  double flat = 1e-8;     ///< of its size: a set thinner than that has no inside
  double slips = 1e-6;    ///< of the fastest point of a motion: it moves
  Index stress_rays = 24; ///< of a round cone, to ask for forces that balance without load
  double line = 1e-3;     ///< of its length: a patch is no wider, and its pressure varies along it
};

constexpr StaticsSettings statics_settings;

} // namespace lcpush::desktop
