// Every number of the Gauss-Seidel iterations that is not a tolerance (tolerances.hpp), with its
// reason. docs/theory/gauss_seidel.md has the measurements.
#pragma once

#include <Eigen/Core>

#include "lcpush/types.hpp"

namespace lcpush {

struct GaussSeidelSettings {
  /// Iterations, at most, and between two residual checks, each of which costs about one.
  static constexpr Index iterations = 5000, between_checks = 10;
  /// Iterations without a better residual that end a run: by components, and by groups. Not
  /// measured.
  static constexpr Index patience = 1000, patience_of_groups = 2000;
  /// Moves of one cone's friction an iteration, at most. Not measured.
  static constexpr int friction_moves = 6;
  /// Iterations that bring the forces near before Newton's method takes over.
  static constexpr Index warming = 10;
  /// Normal forces so many times what the problem's numbers ask for are a squeeze that grows.
  static constexpr int runaway = 10000;
};

/// Of the proximal Newton iterations. eps is the weight of the proximal term, for data about 1.
struct ProximalSettings {
  /// eps begins here and falls by `factor` when an iteration has settled. Above `most` nothing is
  /// gained; below the fourth root of the precision rates drown in rounding.
  static constexpr double first = 10, factor = 0.5, most = 1000;
  /// eps rises by this where it does not settle, and falls more slowly from then on, down to
  /// `slowest`; then the factor is `factor` again.
  static constexpr double rise = 5, slowest = 0.97;
  static constexpr Index passes_each = 60; ///< over all groups, at one eps
  static constexpr int halvings = 12;      ///< of one Newton step
  static constexpr int decrease = 10000;   ///< a step t has to take t over this off the residual
  static constexpr int most_stuck = 5;     ///< a kink may stop a step; the next starts beyond it
  /// Of the largest force: what is left of the shared equations when they count as solved.
  template <class S> static S rounding() { return S(512) * Eigen::NumTraits<S>::epsilon(); }
  template <class S> static S least() {
    return Eigen::numext::sqrt(Eigen::numext::sqrt(Eigen::NumTraits<S>::epsilon()));
  }
};

} // namespace lcpush
