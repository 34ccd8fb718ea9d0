// The numbers of this room: what is rounding in a scene and in an answer. Without units unless
// said.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/types.hpp"

#include <type_traits>

namespace lcpush {

template <class S> struct ModelSettings {
  static S rounding(Index factor) { return S(factor) * Eigen::NumTraits<S>::epsilon(); }
  /// 1 / 10^decimals, and of float 1 / 10^decimals_of_float.
  static S decimal(int decimals, int decimals_of_float) {
    S power(1);
    for (int k = std::is_same_v<S, float> ? decimals_of_float : decimals; k > 0; --k)
      power *= S(10);
    return S(1) / power;
  }

  // The scene.
  static S symmetry() { return rounding(16); }      ///< of an inertia's largest entry
  static S unit_length() { return rounding(1000); } ///< of a normal or tangent, and of their angle
  static S sum_of_weights(Index points) { return rounding(16 * points); }
  /// Two axes that a normal is as little aligned with: a normal that is a rounding error off an
  /// axis does not turn the friction pyramid.
  static S equal_components() { return decimal(9, 6); }
  static S face_plane() { return decimal(6, 6); } ///< of the scene's size, and of a unit normal
  static S face_rim() { return decimal(3, 3); } ///< of the depth that a point may be pushed out of
  static S coordinates() { return rounding(16); } ///< of the largest, in a difference of points
  static S equal_distance() { return rounding(1024); } ///< of one of two distances of points

  // A motion.
  static constexpr int most_halvings = 64;    ///< of a turn, until it is below 1 rad
  static S turn_squared() { return S(1e12); } ///< rad^2: a larger turn in a step is no number

  // The problem.
  /// m times the push, over the other forces: against more, rounding is all that is left of them.
  static S push_over_forces() { return S(1000); }
  /// Of a unit motion: a force across it does no work on it.
  static S across_drive() { return rounding(16); }

  /// In units of F / m or of the fastest body: what rounding leaves of a slip where two velocities
  /// cancel, a step's and that of steps before. Of 400 cylinders that roll between two plates 7 end
  /// without an answer; 32 epsilons, and as much as a tie, left more.
  static S no_slip() { return rounding(1024); }

  // The answer.
  static S counts() { return S(1000) * Tolerances<S>().tie; } ///< of F, or of the fastest motion
  static S motion_noise() { return rounding(64); } ///< of F / m and of the object's acceleration
  /// The same in a step in time, where slips begin from none: what several ties let pass, each of
  /// its own unit. A glass on a tray leaves 1.05 of one tie.
  static S step_noise() { return S(16) * Tolerances<S>().tie; }
  /// Of F / m: where no slip is faster, all are rounding.
  static S slip_noise() { return S(256) * Tolerances<S>().residual; }
  static S sticking() { return decimal(7, 3); } ///< of the fastest slip
  /// Of F / m: what pivots leave of the slip of a point that sticks. A tenth of it leaves a quarter
  /// more of 2,600 loads near the limit of friction unsettled.
  static S slowest_slip() { return Tolerances<S>().residual / S(8); }

  // The referee.
  static S part_of_load() { return decimal(5, 5); } ///< of a given load, what rounding may take
  /// A point's distances are judged against so many before it in its patch; all points together
  /// follow the body's motion, which bounds the others.
  static constexpr Index rigidity_neighbours = 32;
};

} // namespace lcpush
