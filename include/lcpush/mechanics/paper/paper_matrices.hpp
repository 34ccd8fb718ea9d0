// The paper's matrices: grasp matrix G, its polyhedral form G-bar, hand Jacobian J, friction
// generators D. Nothing in the solver needs them; they are for reading, exporting and comparing.
//
// SI units, scene axes, wrenches and twists at the object's centre of mass. A contact point has
// three components, along n, t and o = n x t of its body; a soft point has a fourth, the rotation
// about n. Components stand point by point in the scene's order. With f the contact forces in
// components, forces along the generators in y, a twist A of the object, closings s of the
// actuators and the bodies' prescribed twists A_b:
//
//   M a = w + G f                                                                         [P.8]
//   f = E y, y >= 0,  so that G f = G-bar y, G-bar = G E, E = diag(n, D)                  [P.3]
//   r = G' a - J s - v,  v = G' A_b, point by point                                  [P.9, P.10]
//
// The columns of J are the hand's and, in the paper, the environment's too: a pusher's block is G'
// of its own points, six columns that its prescribed twist multiplies. Those products, with the
// columns of actuators whose acceleration is prescribed, are v, the right-hand side of [P.10].
//
// Every matrix is written into a view of exactly its shape, which the caller owns.
#pragma once

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush {

/// Components of the force or the acceleration at one point of this body: 3, or 4 at a soft point.
template <class S> constexpr Index contact_components(const Body<S>& body) {
  return body.torsion_radius > S(0) ? 4 : 3;
}

/// Rows of f and J, columns of G.
template <class S> Index contact_components(const Scene<S>& scene) {
  Index count = 0;
  for (const Body<S>& body : scene.bodies) count += body.point_count * contact_components(body);
  return count;
}

/// Normals of one point: 1, or 2 (n and -n) where a bilateral body may pull.
template <class S> constexpr Index normal_count(const Body<S>& body) {
  return body.bilateral ? 2 : 1;
}

/// Column c of the part of G that belongs to a point at p: W(n), W(t), W(o), and [0 ; n], the
/// wrench of a unit moment about the normal. Times a twist it is that component of the point's
/// acceleration, m/s^2, or of the spin, rad/s^2.
template <class S>
Vector6<S> contact_column(const Body<S>& body, const Vector3<S>& p, Index component) {
  Vector6<S> column = Vector6<S>::Zero();
  if (component == 3) {
    column.template tail<3>() = body.normal;
    return column;
  }
  if (component == 0) return wrench_column(p, body.normal);
  if (component == 1) return wrench_column(p, body.tangent);
  return wrench_column<S>(p, cross(body.normal, body.tangent));
}

/// The object's inertia: 6 x 6, [m I_3, 0 ; 0, inertia tensor], kg and kg m^2.
template <class S> Matrix6<S> inertia_matrix(const Scene<S>& scene) {
  Matrix6<S> M = Matrix6<S>::Zero();
  for (Index k = 0; k < 3; ++k) M(k, k) = scene.object.mass;
  M.template bottomRightCorner<3, 3>() = scene.object.inertia;
  return M;
}

/// The load [N ; N m]: the object's weight, and the wrench that is applied to it beside.
template <class S> Vector6<S> load(const Scene<S>& scene) {
  Vector6<S> w = scene.object.wrench;
  w.template head<3>() += scene.object.mass * scene.gravity;
  w.template tail<3>() += scene.object.turning;
  return w;
}

/// Calls use(row, body, W) for every component of every contact point: W is its column of G.
template <class S, class Use> void for_each_component(const Scene<S>& scene, const Use& use) {
  Index row = 0;
  for (Index b = 0; b < scene.bodies.size; ++b)
    for (const Index i : points_of(scene.bodies[b]))
      for (Index c = 0; c < contact_components(scene.bodies[b]); ++c)
        use(row++, b, contact_column(scene.bodies[b], scene.points[i], c));
}

/// G: 6 x contact_components(scene). Column: the wrench of a unit component of contact force on the
/// object; rows 1-3 without unit (1 for the torsion column: rows 4-6), rows 4-6 in m.
template <class S> void grasp_matrix(const Scene<S>& scene, MatrixMap<S> G) {
  for_each_component(scene, [&](Index column, Index, const Vector6<S>& W) { G.col(column) = W; });
}

/// The wrench of a unit of force k at a point p: n, -n where the body may pull, then generators.
template <class S>
Vector6<S> polyhedral_column(const Scene<S>& scene, const Body<S>& body, const Vector3<S>& p,
                             Index k) {
  if (k < normal_count(body))
    return k == 0 ? wrench_column(p, body.normal) : wrench_column<S>(p, -body.normal);
  const Generator<S> d = generator(body, k - normal_count(body), scene.facets);
  Vector6<S> column = wrench_column(p, d.force);
  column.template tail<3>() += d.torque * body.normal;
  return column;
}

/// G-bar: 6 x forces. Columns point by point: W(n), (-W(n) at bilateral bodies), then
/// W(d_j) of each generator; units as in G. Force >= 0 along each column.
template <class S> void polyhedral_grasp_matrix(const Scene<S>& scene, MatrixMap<S> G_bar) {
  Index column = 0;
  for (const Body<S>& body : scene.bodies)
    for (const Index i : points_of(body))
      for (Index k = 0; k < normal_count(body) + generator_count(scene, body); ++k)
        G_bar.col(column++) = polyhedral_column(scene, body, scene.points[i], k);
}

/// J [P.9]: contact_components(scene) x the actuators of `drives`. Entry: acceleration of the
/// *body's* point along a component (m/s^2; rad/s^2 for a spin) per unit of the actuator's closing
/// acceleration. Positive closes along the component. J' f is the load that the contact forces put
/// on the actuators, [T.5]: J' f + m_a s = tau.
template <class S>
void hand_jacobian(const Scene<S>& scene, Span<const Drive<S>> drives, MatrixMap<S> J) {
  J.setZero();
  for_each_component(scene, [&](Index row, Index b, const Vector6<S>& W) {
    for (const Drive<S>& drive : drives)
      if (drive.body == b) J(row, drive.actuator) += W.dot(drive.twist);
  });
}

template <class S> void hand_jacobian(const Scene<S>& scene, MatrixMap<S> J) {
  hand_jacobian(scene, scene.drives, J);
}

/// A body's own block of J: components of its points x 6. Times a twist of the body (at the
/// object's centre of mass) it is the acceleration of its points.
template <class S> void body_jacobian(const Scene<S>& scene, const Body<S>& body, MatrixMap<S> J) {
  Index row = 0;
  for (const Index i : points_of(body))
    for (Index c = 0; c < contact_components(body); ++c)
      J.row(row++) = contact_column(body, scene.points[i], c).transpose();
}

/// v, the right-hand side of [P.10]: contact_components(scene) x 1. How each body's points move as
/// prescribed, along each component.
template <class S> void prescribed_motion(const Scene<S>& scene, MatrixMap<S> v) {
  for_each_component(scene, [&](Index row, Index b, const Vector6<S>& W) {
    v(row, 0) = W.dot(scene.bodies[b].acceleration);
  });
}

/// D of one point of this body: (contact_components(body) - 1) x generator_count(scene, body).
/// Column: friction on the object per unit along a generator, in components t, o (1) and, at a soft
/// point, the moment about n (m).
template <class S>
void friction_generators(const Scene<S>& scene, const Body<S>& body, MatrixMap<S> D) {
  const Vector3<S> o = cross(body.normal, body.tangent);
  for (Index j = 0; j < generator_count(scene, body); ++j) {
    const Generator<S> d = generator(body, j, scene.facets);
    D(0, j) = d.force.dot(body.tangent);
    D(1, j) = d.force.dot(o);
    if (contact_components(body) == 4) D(2, j) = d.torque;
  }
}

} // namespace lcpush
