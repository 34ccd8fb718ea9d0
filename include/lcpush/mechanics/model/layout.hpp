// Layout: what each index of the complementarity problem means physically, and in which unit.
#pragma once

#include "lcpush/lcp/problem.hpp"
#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush {

/// The problem is solved in these units; SI value = scaled value times unit.
template <class S> struct Scales {
  S force;  ///< N: F, the largest of grip forces, loads and m * push / 1000; if none, m * push
  S length; ///< m: the largest distance of a contact point from the centre of mass
  S acceleration; ///< m/s^2: F / m
};

/// How fast a body with this twist, or acceleration, moves at most within L of the centre of mass.
template <class S> S size_of_twist(const Vector6<S>& twist, const S& length) {
  return twist.template head<3>().norm() + length * twist.template tail<3>().norm();
}
/// Of the bodies' prescribed twists the largest, or `least`.
template <class S> S fastest_body(const Scene<S>& scene, const S& length, S least) {
  for (const Body<S>& body : scene.bodies)
    least = Eigen::numext::maxi(least, size_of_twist(body.acceleration, length));
  return least;
}

template <class S> struct Layout {
  Scales<S> scales;
  Index points = 0;               ///< contact points, in the scene's order
  Index forces = 0;               ///< columns of G: normals and friction generators
  Index actuators = 0;            ///< free unknowns s
  Index size = 0;                 ///< n
  Span<Index> body;               ///< per point: its body
  Span<const ConeGroup<S>> cones; ///< per point: where its lambda, beta and xi stand
  Span<S> reach;                  ///< per actuator: largest speed of a driven point per unit of s

  Index normal_index(Index point) const { return cones[point].variable; }
  Index friction_index(Index point, Index j) const {
    return cones[point].variable + cones[point].normals + j;
  }
  Index slip_index(Index point) const { return cones[point].slip(); }
  Index closing_index(Index actuator) const { return size - actuators + actuator; }
};

enum class Meaning { normal, pull, friction, slip, closing };

/// The physical name of unknown i: which quantity, of which point (or actuator), which generator.
struct Name {
  Meaning meaning;
  Index of;        ///< point, or actuator for `closing`
  Index generator; ///< for `friction`
};

template <class S> Name name_of(const Layout<S>& layout, Index i) {
  if (i >= layout.size - layout.actuators)
    return {Meaning::closing, i - (layout.size - layout.actuators), 0};
  const Index point = cone_of(layout.cones, i), offset = i - layout.normal_index(point);
  if (offset == 0) return {Meaning::normal, point, 0};
  if (offset < layout.cones[point].normals) return {Meaning::pull, point, 0};
  if (i == layout.slip_index(point)) return {Meaning::slip, point, 0};
  return {Meaning::friction, point, offset - layout.cones[point].normals};
}

/// SI value of unknown i = its scaled value times this: N, m/s^2, or a unit of its actuator.
template <class S> S unknown_unit(const Layout<S>& layout, Index i) {
  const Name name = name_of(layout, i);
  if (name.meaning == Meaning::closing) return layout.scales.acceleration / layout.reach[name.of];
  return name.meaning == Meaning::slip ? layout.scales.acceleration : layout.scales.force;
}

/// The same for row i: m/s^2, N, or the actuator's generalised force.
template <class S> S row_unit(const Layout<S>& layout, Index i) {
  const Name name = name_of(layout, i);
  if (name.meaning == Meaning::closing) return layout.scales.force * layout.reach[name.of];
  return name.meaning == Meaning::slip ? layout.scales.force : layout.scales.acceleration;
}

} // namespace lcpush
