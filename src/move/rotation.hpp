// The axis and the angle of a rotation.
#pragma once

#include "lcpush/types.hpp"
#include "move/settings.hpp"

#include <cmath>

namespace lcpush::desktop {

/// rad, a rotation's axis times its angle, up to half a turn.
inline Vector3<double> rotation_vector(const Matrix3<double>& R) {
  const Vector3<double> twice(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double sine = twice.norm() / 2, cosine = (R.trace() - 1) / 2;
  const double angle = std::atan2(sine, cosine);
  if (sine > MoveSettings::half_turn) return twice * (angle / (2 * sine));
  if (cosine > 0) return twice / 2;
  // Half a turn: R + 1 is twice the axis' square.
  const Matrix3<double> square = (R + Matrix3<double>::Identity()) / 2;
  Index k = 0;
  square.diagonal().maxCoeff(&k);
  return angle * square.col(k) / std::sqrt(square(k, k));
}

/// rad, the same of all vectors that stand for R the nearest to `last`, the turn a step before.
inline Vector3<double> turn_after(const Vector3<double>& last, const Matrix3<double>& R) {
  constexpr double whole = 2 * M_PI;
  const Vector3<double> turn = rotation_vector(R);
  const Vector3<double> axis = turn.norm() > MoveSettings::half_turn ? turn.normalized()
                               : last.norm() > 0                     ? last.normalized()
                                                                     : Vector3<double>::Zero();
  return turn + whole * std::round((last - turn).dot(axis) / whole) * axis;
}

} // namespace lcpush::desktop
