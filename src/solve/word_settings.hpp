// What words leave out, as parts of a whole: no units.
#pragma once

#include <cstddef>

namespace lcpush::desktop {

struct WordSettings {
  /// Of the loads and what they do: a full report shows less as 0. An answer that is called solved
  /// may be off by 9.3e-10 of them (Tolerances::residual).
  double rounding = 1e-9;
  /// `rounding` over this is what a full report shows of the file's smallest load: 1e-6 of it, the
  /// last of six digits, however large another force is.
  double smallest_load = 1e-3;
  /// A component of a unit vector in a full report, of six digits.
  double component = 1e-6;
  /// A force or a motion in a table of three digits, of the loads or of the fastest motion: a
  /// thousandth of its last digit.
  double table = 1e-6;
  /// Of a witness's largest entry: bodies with less take no part in it.
  double witness = 1e-6;
  /// The last of three digits: what is less beside the rest of a sentence is not mentioned.
  double digit = 1e-3;
  /// Of the scene's force: two answers whose forces differ by more are told with both forces; by
  /// less, they differ in how the force is shared.
  double other_force = 1e-5;
  /// Of what rounding alone may leave of the scene's acceleration: a slower push would show motions
  /// a tenth as fast as noise.
  double slowest_push = 10;
  /// Of the referee's residual beside the scene's force: a push stands out by five digits.
  double push_digits = 1e5;
  /// Of the referee's residual: so much larger a load stands out by one digit.
  double load_digits = 10;

  /// Of the push: more inertia of a velocity that is taken as an acceleration is told.
  double inertia = 1e-2;

  double places = 1e3;        ///< of unit vectors in sentences: three places after the point
  double least_remedy = 1e-3; ///< N/kg: what a jam's remedy presses with where nothing else does

  std::size_t label_width = 18; ///< characters, of a fact's label
};

constexpr WordSettings word_settings;

} // namespace lcpush::desktop
