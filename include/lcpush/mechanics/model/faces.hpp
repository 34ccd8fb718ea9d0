// Contact geometry of a motion: points against faces. A point rides on one of the two that touch,
// the face on the other; a cylinder's side has points of its own that are found anew at every step.
// Nothing here looks for collisions: which point may touch which face is the scene's to say.
#pragma once

#include "lcpush/mechanics/model/pose.hpp"

namespace lcpush {

/// What rides on what.
enum class Riding {
  on_body,   ///< the body's points press on a face of the object
  on_object, ///< the object's points press on a face of the body
  on_side,   ///< the object's round side presses on a plane of the body: it may roll
};

/// A plane, or the part of it inside a polygon or a circle. At the start of the motion, as the
/// scene's points are; `normal` leaves what it is a face of. Convex, corners in order either way.
template <class S> struct Face {
  Vector3<S> point = Vector3<S>::Zero();
  Vector3<S> normal = Vector3<S>::UnitZ();
  Span<const Vector3<S>> corners{}; ///< empty: a circle, or no end
  S radius{0};                      ///< 0: no circle
};

/// The round side of the object; at the start of the motion. A ball's has no axis: 0.
template <class S> struct RoundSide {
  Vector3<S> center = Vector3<S>::Zero(), axis = Vector3<S>::UnitZ(); ///< m; unit, or 0
  S radius{0};                                                        ///< m
};

/// How a body touches. `face` < 0: the plane through each of its points with its normal, without
/// end. `side`: index of a RoundSide, for on_side.
struct Touching {
  Riding riding = Riding::on_body;
  Index face = -1;
  Index side = 0;
};

/// What may touch.
template <class S> struct Surroundings {
  Span<const Touching> touching{}; ///< a body; empty: all as Touching() says
  Span<const Face<S>> faces{};
  Span<const RoundSide<S>> sides{};
  Span<const unsigned char> absent{}; ///< a body: 1 while it is not there; empty: all are
};

template <class S> bool is_absent(const Surroundings<S>& surroundings, Index body) {
  return surroundings.absent.size > 0 && surroundings.absent[body] != 0;
}

/// Why a point is no contact at present.
enum class Absence {
  none,
  outside, ///< beside its face
  behind,  ///< on the wrong side of its face: it came round an edge, which is not modelled
  far,     ///< too far away to touch within the step
  no_line, ///< a plane that does not touch the round side along a line: its end does
  away,    ///< its body is not there
};

/// Where a point touches now: all in the hand's axes.
template <class S> struct PlacedPoint {
  Vector3<S> position; ///< from the hand's origin
  Vector3<S> normal, tangent;
  S gap{0};
  Absence absence = Absence::none;
};

/// Is x, given as the face is, over the face? What lies on its rim is.
template <class S> bool is_over_face(const Face<S>& face, const Vector3<S>& x, const S& slack) {
  const Vector3<S> from = x - face.point;
  if (face.radius > S(0))
    return (from - from.dot(face.normal) * face.normal).norm() <= face.radius + slack;
  bool left = false, right = false;
  const Index k = face.corners.size;
  for (Index i = 0; i < k; ++i) {
    const Vector3<S> edge = face.corners[(i + 1) % k] - face.corners[i];
    const Vector3<S> side = cross<S>(edge, x - face.corners[i]);
    const S across = side.dot(face.normal) / edge.norm();
    left = left || across > slack;
    right = right || across < -slack;
  }
  return !(left && right);
}

namespace detail {

/// The point of a round side that a plane with this normal (into the object) touches, abreast of
/// `start`. False: the plane stands across the axis.
template <class S>
bool point_of_side(const RoundSide<S>& side, const Pose<S>& object, const Vector3<S>& normal,
                   const Vector3<S>& start, Vector3<S>& at) {
  const Vector3<S> axis = object.turned(side.axis);
  const Vector3<S> across = normal - axis * axis.dot(normal);
  const S length = across.norm();
  if (!(length > S(1) / S(8))) return false; // 83 degrees: the end touches long before
  const S along = Vector3<S>(start - side.center).dot(side.axis);
  const Vector3<S> on_axis = side.center + side.axis * along;
  at = object.at(on_axis) - across * (side.radius / length);
  return true;
}

} // namespace detail

/// Where point `start` of `body` touches when the object and the body are at these poses. `depth`:
/// how far behind its face a point may be and still be pushed out. Pre: `touching` names a face and
/// a side that there are. Cost: O(corners).
template <class S>
PlacedPoint<S> place(const Surroundings<S>& surroundings, const Touching& touching,
                     const Body<S>& body, const Vector3<S>& start, const Pose<S>& object,
                     const Pose<S>& hand, const S& depth) {
  const bool on_body = touching.riding == Riding::on_body;
  const Pose<S>& rider = on_body ? hand : object;   // the point's
  const Pose<S>& carrier = on_body ? object : hand; // the plane's, and with it the normal's
  const Face<S>* const face = touching.face < 0 ? nullptr : &surroundings.faces[touching.face];
  PlacedPoint<S> placed;
  placed.normal = carrier.turned(body.normal);
  placed.tangent = carrier.turned(body.tangent);
  placed.position = rider.at(start);
  if (touching.riding == Riding::on_side &&
      !detail::point_of_side(surroundings.sides[touching.side], object, placed.normal, start,
                             placed.position))
    placed.absence = Absence::no_line;
  const Vector3<S> plane = carrier.at(face == nullptr ? start : face->point);
  const S height = Vector3<S>(placed.position - plane).dot(placed.normal);
  placed.gap = on_body ? S(-height) : height;
  if (placed.absence != Absence::none) return placed;
  if (face != nullptr &&
      !is_over_face(*face, carrier.back(placed.position), S(depth * ModelSettings<S>::face_rim())))
    placed.absence = Absence::outside;
  else if (placed.gap < -depth)
    placed.absence = Absence::behind;
  return placed;
}

/// What is wrong with how bodies are said to touch.
enum class TouchMistake {
  none,
  index, ///< a face or a side that there is not, or not one Touching a body
  plane, ///< a face whose normal is not the body's: an edge meets it, and against another edge
         ///< nothing here can tell the normal
  apart, ///< a point that does not lie in its face's plane at the start
  side,  ///< a round side whose normal is along its axis, or without a radius
};

/// The first mistake in `surroundings`, for a motion of `scene`. Cost: O(points).
template <class S>
TouchMistake find_touch_mistake(const Scene<S>& scene, const Surroundings<S>& surroundings) {
  if (surroundings.absent.size != 0 && surroundings.absent.size != scene.bodies.size)
    return TouchMistake::index;
  if (surroundings.touching.size == 0) return TouchMistake::none;
  if (surroundings.touching.size != scene.bodies.size) return TouchMistake::index;
  const S slack = ModelSettings<S>::face_plane();
  S length(0);
  for (const Vector3<S>& p : scene.points) length = Eigen::numext::maxi(length, S(p.norm()));
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Touching& touching = surroundings.touching[b];
    const Body<S>& body = scene.bodies[b];
    const bool on_side = touching.riding == Riding::on_side;
    if (touching.face >= surroundings.faces.size) return TouchMistake::index;
    if (on_side && (touching.side < 0 || touching.side >= surroundings.sides.size))
      return TouchMistake::index;
    if (on_side) {
      const RoundSide<S>& side = surroundings.sides[touching.side];
      if (!(side.radius > S(0)) || Eigen::numext::abs(side.axis.dot(body.normal)) > S(1) / S(2))
        return TouchMistake::side;
    }
    if (touching.face < 0) continue;
    const Face<S>& face = surroundings.faces[touching.face];
    const S sign = touching.riding == Riding::on_body ? S(-1) : S(1);
    if (!((face.normal * sign - body.normal).norm() <= slack)) return TouchMistake::plane;
    for (const Index i : points_of(body)) {
      const S height = Vector3<S>(scene.points[i] - face.point).dot(body.normal);
      if (!on_side && !is_absent(surroundings, b) &&
          !(Eigen::numext::abs(height) <= slack * length))
        return TouchMistake::apart;
    }
  }
  return TouchMistake::none;
}

} // namespace lcpush
