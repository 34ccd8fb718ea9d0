// Where a rigid body is, and where a twist takes it: the exponential map.
#pragma once

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush {

/// Of a rigid body: its point x goes to position + rotation x.
template <class S> struct Pose {
  Vector3<S> position = Vector3<S>::Zero();
  Matrix3<S> rotation = Matrix3<S>::Identity();

  Vector3<S> at(const Vector3<S>& x) const { return position + turned(x); }
  Vector3<S> turned(const Vector3<S>& direction) const { return rotation.lazyProduct(direction); }
  /// The point x that is at y now.
  Vector3<S> back(const Vector3<S>& y) const {
    return rotation.transpose().lazyProduct(Vector3<S>(y - position));
  }
};

/// The same twist taken at another point, `offset` from the first, both with the axes of the scene.
template <class S> Vector6<S> twist_at(const Vector6<S>& twist, const Vector3<S>& offset) {
  Vector6<S> moved = twist;
  moved.template head<3>() = acceleration_at(offset, twist);
  return moved;
}

namespace detail {

/// sum_k (-square)^k first! / (first + 2 k)!, to rounding for 0 <= square <= 1; own code, because
/// the bits of a libm differ between machines.
template <class S> S turning_series(const S& square, int first) {
  S term(1), sum(1);
  for (int k = first; k < first + 40; k += 2) {
    term = -term * square / S((k + 1) * (k + 2));
    const S next = sum + term;
    if (next == sum) break;
    sum = next;
  }
  return sum;
}

template <class S> Matrix3<S> cross_matrix(const Vector3<S>& x) {
  Matrix3<S> m;
  m << S(0), -x[2], x[1], x[2], S(0), -x[0], -x[1], x[0], S(0);
  return m;
}

/// Newton's step to the nearest rotation: what rounding has bent by e ends bent by e^2.
template <class S> Matrix3<S> straightened(const Matrix3<S>& R) {
  const Matrix3<S> bent = Matrix3<S>::Identity() * S(3) - R.transpose().lazyProduct(R);
  return R.lazyProduct(bent) / S(2);
}

} // namespace detail

/// A turn about `angle`'s direction by its length, rad. A large one is made of halves.
template <class S> Matrix3<S> rotation_by(const Vector3<S>& angle) {
  Vector3<S> x = angle;
  int doublings = 0;
  for (; doublings < ModelSettings<S>::most_halvings && x.squaredNorm() > S(1); ++doublings)
    x /= S(2);
  const S square = x.squaredNorm();
  const S sine = detail::turning_series(square, 1);           // sin |x| / |x|
  const S versine = detail::turning_series(square, 2) / S(2); // (1 - cos |x|) / |x|^2
  const Matrix3<S> K = detail::cross_matrix(x);
  Matrix3<S> R = Matrix3<S>::Identity() + sine * K + versine * K.lazyProduct(K);
  for (; doublings > 0; --doublings) {
    const Matrix3<S> half = detail::straightened(R);
    R = half.lazyProduct(half);
  }
  return R;
}

/// The object after a time h; its twist is at its centre of mass, the pose's position.
template <class S> Pose<S> moved(const Pose<S>& pose, const Vector6<S>& twist, const S& h) {
  const Vector3<S> turn = h * twist.template tail<3>();
  Pose<S> next;
  next.position = pose.position + h * twist.template head<3>();
  next.rotation = detail::straightened<S>(rotation_by(turn).lazyProduct(pose.rotation));
  return next;
}

/// A body after a time h; its twist is at the hand's origin and stays the same meanwhile, so that
/// what turns about an axis stays on its circles. A turn of more than 1 rad is done in halves.
template <class S>
Pose<S> moved_about_origin(const Pose<S>& pose, const Vector6<S>& twist, const S& h) {
  const Vector3<S> turn = h * twist.template tail<3>(), shift = h * twist.template head<3>();
  const S square = turn.squaredNorm();
  if (square > S(1)) {
    const S half = h / S(2);
    if (!(square < ModelSettings<S>::turn_squared())) return pose; // not halved for ever
    return moved_about_origin(moved_about_origin(pose, twist, half), twist, half);
  }
  // exp of the whole twist: position + V shift, V the mean rotation meanwhile.
  const S versine = detail::turning_series(square, 2) / S(2);
  const S rest = detail::turning_series(square, 3) / S(6); // (|x| - sin |x|) / |x|^3
  const Matrix3<S> R = rotation_by(turn);
  const Vector3<S> across = cross(turn, shift);
  Pose<S> next;
  next.position =
      R.lazyProduct(pose.position) + shift + versine * across + rest * cross(turn, across);
  next.rotation = detail::straightened<S>(R.lazyProduct(pose.rotation));
  return next;
}

} // namespace lcpush
