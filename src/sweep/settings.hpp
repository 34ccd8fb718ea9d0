// The numbers of a sweep. Parts of the range are written t, 0 to 1; relative ones are parts of the
// larger answer. Where no figure stands, none was recorded.
#pragma once

#include <cstddef>
#include <limits>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct SweepSettings {
  // How finely a change is found, in t.
  static constexpr double bisection_width = 1e-6;
  static constexpr double breaking_blur = 1e-4;  ///< where small pushes lie on both sides of it
  static constexpr double zero_width = 1e-10;    ///< then the line through both sides
  static constexpr double merge_distance = 1e-9; ///< of exact ends: nearer ones are one
  static constexpr double shortest_told = 4;     ///< merge distances: a shorter stretch is unknown
  static constexpr double shortest_segment = 1e-10; ///< by parametric pivots
  static constexpr double inside_segment = 1e-3;    ///< of a segment: where its ends are checked
  static constexpr double gap_width = 1e-6;         ///< of the end of a range without an answer
  static constexpr double beyond[] = {1e-9, 1e-7, 1e-5}; ///< where the next start is tried
  static constexpr double near_middle = 0.487;           ///< of a segment: where its modes are read
  static double rounding_of_steps() { return 64 * std::numeric_limits<double>::epsilon(); }
  static constexpr double looked_at[] = {0, 0.3, 1}; ///< does anything move there?
  static constexpr double value_rounding = 1e-12;    ///< of the range: a value of less is 0
  static constexpr Index pivots_a_look = 64;         ///< .. at the clock
  // How far: no sweep has more.
  static constexpr Index most_pieces = 1000;
  static constexpr Index steps_a_piece = 4;
  static constexpr Index probes = 64; ///< where nothing was found, look in so many places
  static constexpr Index usual_steps = 51, usual_map_steps = 11;
  /// Of the range: where a narrower part between two steps has no answer, words pass over it. Where
  /// a point begins to stick round friction may not settle in 0.4 % of a shipped sweep.
  static constexpr double sliver = 0.01;
  // What is another answer, relative.
  static constexpr double jump = 1e-6;           ///< between exact segments
  static constexpr double sampled_jump = 1e-3;   ///< over the width of bisection
  static constexpr double steepest_change = 100; ///< over the range: what is steeper is a jump
  static constexpr double one_line = 1e-10;      ///< a segment goes on in the line of the last
  static constexpr double breaking_lines = 10;   ///< the same at breaking: times as far
  /// Of both ways: answers of one branch agree so well; of a connector's four sampled points beside
  /// pads they differ by 1.4e-5.
  static constexpr double equal_answers = 1e-4;
  // What is no motion, force or event.
  static constexpr double rounding = 1e-11;    ///< of F and F / m
  static constexpr double residuals = 2;       ///< times the residual: what it leaves open
  static constexpr double slowest_slip = 5e-6; ///< of the fastest contact
  static constexpr double pressed = 1000;      ///< ties of F: a contact that carries load
  static constexpr double line_errors = 10;  ///< what extrapolating from finite pushes leaves open
  static constexpr double negligible = 1e-9; ///< of a component's largest value: zero
  static constexpr double steepest_zero = 1e-3; ///< of a change of sign: more is left at a jump
  static constexpr double shoulder = 0.1;       ///< of a change of sign: not yet on its slope
  /// A squeeze is proved where it does more than this; the referee lets a separation be below zero
  /// by a thousandth of it.
  static constexpr double proven_squeeze = 1e-6;
  // Words.
  static constexpr double direction_places = 1000; ///< of unit vectors: three places
  static constexpr double alike = 1e-2;            ///< of the range: both questions' events are one
  static constexpr double one_place = 1e-5;     ///< of the range: ten times what bisection leaves
  static constexpr double unsaid = 5e-4;        ///< of the largest force: not seen in three digits
  static constexpr double hardly = 0.05;        ///< of the largest force: less than is measured
  static constexpr double little = 0.25;        ///< .. less than friction is known
  static constexpr double short_piece = 1e-3;   ///< of the range: too short to tell its slope
  static constexpr double short_stretch = 1e-2; ///< of the range: an extreme is at a place
  static constexpr double worth_a_word = 0.01;  ///< of the force, where the forces alone differ
  static constexpr double told_zero = 1e-4;     ///< of the largest force
  static constexpr double told_negative = 1e-3; ///< the same below zero: how far off breaking is
  static constexpr double table_rounding = 1e-12; ///< of the largest force
  static constexpr double unfelt = 1e-6; ///< of the motion: what rounding and bisection leave of 0
  static constexpr std::size_t most_rows = 12, most_columns = 8, most_changes = 8, most_zeros = 4;
  static constexpr Index rows_of_curves = 11;
  static constexpr std::size_t fewest_even_rows = 6;
  static constexpr int digits_more = 9; ///< for a range far from zero
};

} // namespace lcpush::desktop
