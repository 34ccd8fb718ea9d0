// The numbers by which a motion is stepped and put into words.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct MoveSettings {
  // Faces. Directions and places are typed with three or four digits; lengths are parts of the
  // scene's size.
  static constexpr double typed_direction = 1e-3, typed_place = 1e-3;
  static constexpr double typed_side = 1e-2; ///< on a round side, whose points are computed by hand
  static constexpr double turned_face = 0.76; ///< of a unit vector: a face up to 45 degrees off
  static constexpr double inside = 1e-6;      ///< of the object's size: a stroke that begins deeper
  // Steps, as parts of the whole time.
  static constexpr double first_step = 1e-3, longest_step = 0.02;
  static constexpr double event_step = 1.0 / 4096; ///< how closely events are located
  static constexpr double shortest_step = 0x1p-16; ///< what chatters must not take for ever either
  /// Steps in which round friction has not settled: then it will not in others either.
  static constexpr Index most_unsettled = 64;
  /// Of the tolerance, for a step in which velocities change at once: its error is a part of its
  /// length however short it is, and below 2e-6 s of 0.1 the jump's forces of 2 kN leave noise.
  static constexpr double share_of_start = 1.0 / 64;
  /// Of a step's way, what an extrapolated end may be off its faces: the next step makes that up,
  /// at this part of its speed.
  static constexpr double unfelt = 1e-4;
  static constexpr double slow_slip = 0.1;   ///< of the fastest: where that turns round is no event
  static constexpr double at_rest = 1e-9;    ///< of the speed before
  static constexpr double same_time = 1e-12; ///< rounding of a sum of steps
  static constexpr double whole_steps = 1e-6; ///< of a step, as which nothing is left over
  static constexpr Index most_located =
      64; ///< events; a patch that flickers must not take for ever
  static constexpr double tolerance = 1e-3; ///< of the object's size, if nobody says: a thousandth
  static constexpr int halvings = 4;        ///< of a fixed step that has no answer
  static constexpr int landing_halvings = 30; ///< of a step of a blow: to 1e-9 of its way
  /// Of one that turns back or rests: nearer to its end no slip has a direction.
  static constexpr int turning_halvings = 14;
  static constexpr int distance_halvings = 40; ///< until a step's end is exact to 1e-12 of it
  /// Of the object's size, that it goes untouched until nobody expects that to end: what is thrown
  /// or dropped from its place comes back within less, or not at all.
  static constexpr double free_way = 10;
  // Phases: what moves the object by less than this part of the whole motion is none of its own;
  // where that leaves more than a sentence holds, twice that, and so on.
  static constexpr double least_part = 0.02;
  static constexpr std::size_t most_phases = 4;
  static constexpr std::size_t kept_phases = 1024; ///< chatter has more: neighbours are joined
  static constexpr double same_axis = 0.95;        ///< cosine: beyond 18 degrees it is another turn
  static constexpr double no_turn = 1e-3;          ///< of the path: it slides
  static constexpr double to_and_fro = 0.7; ///< of all turning: whose sum is less went back as well
  // A push that changes by so much in so much of the whole time is still getting going.
  static constexpr double begun = 0.05, start = 0.03;
  // Jumps of the push: less than this part of the force is none, nor what is next to nothing in the
  // whole motion; at once is so many times as fast as the changes before and after. A force that
  // changes gradually has steps alike, a blow goes up and down at the same rate.
  static constexpr double least_jump = 0.1, worth_a_jump = 1e-3, times_neighbours = 8;
  // Words.
  static constexpr std::size_t brief_rows = 6, brief_events = 4; ///< of a text without -v: all of
                                                                 ///< it on twenty lines
  static constexpr double over_surface = 1e-2; ///< of the object's size, or rad: so far a body goes
                                               ///< over the object until its shape is asked for
  static constexpr double worth_a_word = 1e-3; ///< of the rest: less is left out
  static constexpr double unseen = 0.1;        ///< of the least that has a column: 0 in four digits
  static constexpr double unmoved = 1e-9; ///< of the object's size: rounding goes farther in no run
  static constexpr double seen_gap = 1e-5;  ///< m: what turning faces leave in short steps is less
  static constexpr double half_turn = 1e-6; ///< sine of an angle that is 0 or half a turn
  static constexpr double exact =
      1e-9; ///< residuals and depths, m, below only say how rounding went
};

} // namespace lcpush::desktop
