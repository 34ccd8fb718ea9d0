// The tolerances of the solvers. They apply to equilibrated data (every row, column and
// right-hand side scaled to 1), so they depend on the precision alone; docs/theory/numerics.md has
// the measurements behind the multiples of the machine epsilon.
#pragma once

#include <limits>

namespace lcpush {

/// An exact scalar needs no tolerance.
template <class S> struct Tolerances {
  S pivot{0};    ///< a pivot below this fraction of its column's largest entry is no pivot
  S tie{0};      ///< basic values within this of the smallest ratio are tied (Harris)
  S finish{0};   ///< the artificial variable wins a tie, too, that would leave this of it
  S residual{0}; ///< the largest scaled natural residual of an answer called solved
  S settled{0};  ///< the scaled change between two rounds of an outer iteration that ends it
  S noise{0};    ///< residual * noise is what rounding may leave of the largest unknowns (64 eps;
                 ///< float: 48)
  S independent{0}; ///< a guessed unknown whose pivot is below this depends on the others
};

template <> struct Tolerances<double> {
  double pivot = 0x1p22 * std::numeric_limits<double>::epsilon(); // 9.3e-10
  double tie = 0x1p15 * std::numeric_limits<double>::epsilon();   // 7.3e-12
  double finish = 0;
  double residual = 0x1p22 * std::numeric_limits<double>::epsilon(); // 9.3e-10
  double settled = 0x1p16 * std::numeric_limits<double>::epsilon();  // 1.5e-11
  double noise = 0x1p-16;
  double independent = 0x1p-16;
};

template <> struct Tolerances<float> {
  float pivot = 0x1p10F * std::numeric_limits<float>::epsilon(); // 1.2e-4
  float tie = 0x1p4F * std::numeric_limits<float>::epsilon();    // 1.9e-6
  float finish = 0;
  float residual = 0x1.8p9F * std::numeric_limits<float>::epsilon(); // 9.2e-5
  float settled = 0x1p9F * std::numeric_limits<float>::epsilon();    // 6.1e-5
  float noise = 0x1p-4F;
  float independent = 0x1p-10F;
};

/// Of nonnegative least squares over columns near 1.
struct LeastSquaresSettings {
  /// Left of a column's product with the residual: rows of some hundred terms.
  template <class S> static constexpr S rounding() {
    return S(1000) * std::numeric_limits<S>::epsilon();
  }
  /// More exchanges than these are none that settle; random cones of 40 columns take 3 a row.
  static constexpr int exchanges = 100, exchanges_a_row = 10;
  static constexpr double ray_dependent =
      1e-5; ///< the part of a ray that is new, or it helps nobody
  static constexpr double force_dependent = 1e-3; ///< the same of forces that are to be basic
  static constexpr int rays_tried = 8; ///< that help nothing, before an expected motion is given up
};

} // namespace lcpush
