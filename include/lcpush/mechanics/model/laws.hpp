// The laws of prehensile pushing, in the paper's order: one law = one function = one equation of
// docs/theory/theory.md = one test case. [P.n]: equation n of Chavan-Dafle & Rodriguez, IROS 2015.
//
//   unknowns   a object's acceleration   s closing of an actuator   lambda normal force
//              beta friction force along a generator                xi slip acceleration
//
// Everything here is in the scaled units of Layout. To change the friction model, change
// friction_direction (the generators) and friction_cone (what bounds them).
#pragma once

#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush {
namespace laws {

/// [T.1] Newton: M a = w + sum_i ( lambda_i W(n_i) + sum_j beta_ij W(d_ij) ).            [P.8]
/// Solved for a: returns the mobility B = M^-1. In a planar scene nothing moves out of the plane.
template <class S> Matrix6<S> newton(const Scene<S>& scene, const Scales<S>& scales) {
  const S unit = scene.object.mass * scales.length * scales.length;
  const Matrix3<S> I = scene.object.inertia / unit;
  Matrix6<S> B = Matrix6<S>::Zero();
  B(0, 0) = B(1, 1) = S(1);
  if (scene.planar) {
    B(5, 5) = S(1) / I(2, 2);
    return B;
  }
  B(2, 2) = S(1);
  const Adjugate<S> inverse(I);
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j) B(3 + i, 3 + j) = inverse.rows[i][j] / inverse.determinant;
  return B;
}

/// The load w of [T.1]: the object's weight, and the wrench that is applied to it beside.
template <class S> Vector6<S> load(const Scene<S>& scene, const Scales<S>& scales) {
  Vector6<S> w = scene.object.wrench / scales.force;
  w.template head<3>() += scene.object.mass * scene.gravity / scales.force;
  w.template tail<3>() += scene.object.turning / scales.force;
  w.template tail<3>() /= scales.length;
  return w;
}

/// [T.2] Normal: 0 <= lambda_i _|_ W(n_i)' (a - A_b) >= 0.                               [P.VI-A]
/// Returns W(n_i), which is both the force's column and the row's coefficients. A bilateral body
/// has both signs: lambda = lambda+ - lambda-, and - W(n_i) for the second.
template <class S>
Vector6<S> normal_direction(const Body<S>& body, const Vector3<S>& p, const Scales<S>& scales) {
  return wrench_column<S>(p / scales.length, body.normal);
}

/// [T.3] Dissipation: 0 <= beta_ij _|_ W(d_ij)' (a - A_b) + xi_i >= 0.                   [P.4]
/// Returns W(d_ij), d a generator of the body.
template <class S>
Vector6<S> friction_direction(const Body<S>& body, const Vector3<S>& p, const Generator<S>& d,
                              const Scales<S>& scales) {
  Vector6<S> column = wrench_column<S>(p / scales.length, d.force);
  column.template tail<3>() += d.torque / scales.length * body.normal;
  return column;
}

/// [T.4] Friction cone: 0 <= xi_i _|_ mu_i lambda_i - sum_j beta_ij >= 0.                [P.3]
/// Returns the group of unknowns [lambda, beta.., xi] that this couples.
template <class S>
ConeGroup<S> friction_cone(const Body<S>& body, Index generators, Index force, Index variable) {
  return {force, generators, variable, body.friction, S(0), body.bilateral ? 2 : 1};
}

/// [T.5] Grip force: s_a free, sum_b J_ba' f_b + m_a s_a - tau_a = 0.                    [P.6]
/// Returns the row's own numbers; the coefficients J_ba' W(u) are grip_coefficient's.
template <class S>
SumGroup<S> grip_force(const Scene<S>& scene, Index actuator, S reach, const Scales<S>& scales) {
  const Actuator<S>& a = scene.actuators[actuator];
  return {0, 0, a.force / (scales.force * reach), a.inertia / (scene.object.mass * reach * reach)};
}

/// The motion of a unit of the actuator, without units.
template <class S> Vector6<S> drive_twist(const Drive<S>& drive, S reach, const Scales<S>& scales) {
  Vector6<S> twist = drive.twist / reach;
  twist.template tail<3>() *= scales.length;
  return twist;
}

/// The coefficient of [T.5]: power of a unit force with this column per unit of an actuator that
/// moves its body by `twist`. The same number, with a minus sign, is what the actuator's closing
/// does to that force's row.
template <class S> S grip_coefficient(const Vector6<S>& twist, const Vector6<S>& column) {
  return column.dot(twist);
}
template <class S>
S grip_coefficient(const Drive<S>& drive, const Vector6<S>& column, S reach,
                   const Scales<S>& scales) {
  return grip_coefficient(drive_twist(drive, reach, scales), column);
}

/// [T.6] Patch rigidity: the relative accelerations of a patch's points are one rigid motion. [P.5]
/// Returns by how much two points of a patch fail it: the rate at which their distance changes,
/// (r_i - r_j)' (p_i - p_j) / |p_i - p_j|, zero for every rigid motion.
template <class S>
S patch_rigidity(const Vector3<S>& p_i, const Vector3<S>& r_i, const Vector3<S>& p_j,
                 const Vector3<S>& r_j) {
  const Vector3<S> between = p_i - p_j;
  return (r_i - r_j).dot(between) / between.norm();
}

/// [T.16] Round friction: in a point's friction space |f| <= mu lambda, and where it slips with v,
/// f = - mu lambda v / |v|. About the slip along -u of the last iteration this is
///   f = mu lambda u - k (1 - u u') v,   k = mu lambda / |v|:
/// a pyramid with a generator along u, and an inertia k across u. Adds that inertia to the
/// object's, given and returned as B = M^-1, and to the load what the body's own motion makes of
/// it.
template <class S>
void round_cone(const Body<S>& body, const Vector3<S>& p, const LinearizedCone<S>& cone,
                const S& mass, const Scales<S>& scales, Matrix6<S>& B, Vector6<S>& w) {
  if (!(cone.inertia > S(0))) return;
  const bool is_soft = body.torsion_radius > S(0);
  const Across<S> side = across(cone, is_soft);
  const S k = cone.inertia / mass;
  for (const Vector3<S>* e : {&side.first, &side.second}) {
    if (!is_soft && e == &side.second) return;
    const Vector6<S> W = friction_direction(body, p, generator_along(body, *e), scales);
    const Vector6<S> BW = B.lazyProduct(W);
    const S share = k / (S(1) + k * W.dot(BW));
    for (Index j = 0; j < 6; ++j) B.col(j) -= (share * BW[j]) * BW; // Sherman and Morrison
    w += k * e->dot(cone.body_motion) / scales.acceleration * W;
  }
}

/// The force with which that inertia resists: - k (1 - u u') v, in the point's friction space, N.
/// `twist`: the object's, m/s^2 and rad/s^2.
template <class S>
Vector3<S> resisting_force(const Body<S>& body, const Vector3<S>& p, const LinearizedCone<S>& cone,
                           const Vector6<S>& twist) {
  if (!(cone.inertia > S(0))) return Vector3<S>::Zero();
  const Vector3<S> v = slip_of(body, p, twist) - cone.body_motion;
  Vector3<S> across = v - cone.along.dot(v) * cone.along;
  if (!(body.torsion_radius > S(0))) across[2] = S(0);
  return -cone.inertia * across;
}

/// The prescribed part A_b of a body's twist in scaled units.
template <class S> Vector6<S> prescribed(const Body<S>& body, const Scales<S>& scales) {
  Vector6<S> A_b = body.acceleration / scales.acceleration;
  A_b.template tail<3>() *= scales.length;
  return A_b;
}

} // namespace laws
} // namespace lcpush
