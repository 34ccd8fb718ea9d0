// The numbers of the search for all answers. Forces are parts of the scene's, pushes of F / m.
#pragma once

#include <cstddef>

namespace lcpush::desktop {

struct SpreadSettings {
  // Faces.
  static constexpr double far = 1000;        ///< along a direction that has no end
  static constexpr double carries = 1e-7;    ///< an edge that carries more is one that can
  static constexpr double no_push = 1e-8;    ///< the largest push of a face that has rest alone
  static constexpr double small_push = 1e-3; ///< the modes of the instant of breaking are its own
  // Modes.
  static constexpr double tie = 1e-9;    ///< of the largest force, or motion: at the limit
  static constexpr double motion = 1e-5; ///< of accelerations that cancel: rounding leaves less
  static constexpr double smallest_part = 1e-5; ///< of the push: as for an answer of Push::solve
  static constexpr double slip_alike = 1e-9;    ///< rows of rates near 1
  // Elimination of a mode's equations, rows of numbers near 1.
  static constexpr int usual_rows = 64;         ///< memory for so many at once
  static constexpr double nothing = 1e-10;      ///< what elimination leaves of a zero
  static constexpr double contradiction = 1e-9; ///< of the push
  static constexpr double parallel = 1e-12;     ///< entries of two signs that are the same
  static constexpr double own_motion = 1e-9;    ///< of the push: the least that a strict sign keeps
  static constexpr double own_answer = 1e-6; ///< of the push: the least that an answer keeps of it
  static constexpr std::size_t combinations_told = 8; ///< of modes, in brief: 20 lines in all
  static constexpr std::size_t slips_named = 2;       ///< directions: more are counted
  // Answers.
  static constexpr double same = 1e-7;  ///< of the scale of forces, or of motions: one answer
  static constexpr double wider = 1e-6; ///< the same: what a range must gain to be another
  static constexpr double zero = 1e-9;  ///< of the unknowns of a corner that is met again
  // How far enumeration goes.
  static constexpr double thorough_factor = 40;      ///< times the usual work: a minute
  static constexpr double part_of_time = 0.8;        ///< of the seconds asked for, before the walk
  static constexpr double part_of_enumeration = 0.5; ///< of the progress, before the walk
  /// Multiplications in the time that it takes to read a contact at a corner: 150 ns.
  static constexpr double work_of_a_contact = 100;
  /// Small scenes have done a hundredth of the tree after this part of the work.
  static constexpr double judged_after = 0.1;
  // How stiff supports share a load: what bears at more points is a pad's matter; and enough to see
  // that there is another answer.
  static constexpr Index few_points = 3, sharing_faces = 16, sharing_covers = 4;
};

} // namespace lcpush::desktop
