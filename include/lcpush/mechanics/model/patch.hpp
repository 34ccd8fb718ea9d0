// Points that stand for a contact patch: a line, a disc, a ring, a rectangle.
//
// Positions and lengths are in metres, in whatever frame the caller's centre is given in; t and o
// are unit vectors that span the contact plane, o = n x t. The weighted centroid is the patch's
// centre. A point's weight is its share of the patch's force under uniform pressure, of sum 1: with
// them a few points have the span, the second moments and the torsion of the surface
// (docs/theory/theory.md, "Weighted patches"; tests/mechanics/model/test_patch_weights.cpp).
#pragma once

#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/types.hpp"

namespace lcpush {

namespace detail {

/// k even steps from -1 to 1, opposite ones exact negatives; the middle if k is 1.
template <class S> S even_step(Index i, Index k) {
  return k == 1 ? S(0) : S(2 * i - (k - 1)) / S(k - 1);
}

/// How a disc of k points is made of rings, from the inside out; ring 0 is the innermost.
///
/// Simpson's rule along the radius for the integrand 2 r f(r), which drops the centre: exact for
/// the disc's area, mean radius 2/3 R and mean square R^2/2, with points on the rim.
struct DiscRings {
  Index points, rings;

  explicit DiscRings(Index k) : points(k), rings(k < 6 ? 1 : 2) {
    // More rings have points in proportion to their radii, about as far apart as the rings are.
    while (4 * (rings + 2) * (rings + 2) <= k) rings += 2;
  }
  /// The first point of a ring.
  Index begin(Index ring) const {
    return rings <= 2 ? ring * points / rings : ring * (ring + 1) * points / (rings * (rings + 1));
  }
  /// Over R. Too few points for two rings lie at the mean radius.
  template <class S> S radius(Index ring) const {
    return rings == 1 ? S(2) / S(3) : S(ring + 1) / S(rings);
  }
  template <class S> S weight(Index ring) const {
    if (rings == 1) return S(1);
    const Index simpson = ring + 1 == rings ? 1 : ring % 2 == 0 ? 4 : 2;
    return S(2 * (ring + 1) * simpson) / S(3 * rings * rings);
  }
};

/// Weights of points in even steps along a segment, the ends included: those of the total, the
/// second moment 1/3 and the mean distance 1/2 from the middle, over the half length. Four points
/// are Simpson's 3/8 rule, five the composite Simpson rule.
template <class S> struct LineWeights {
  S end, next, inner; ///< at the ends, beside them, between

  explicit LineWeights(Index k) {
    if (k <= 2) {
      end = next = inner = S(1) / S(k);
    } else if (k == 3) { // the mean distance is right, the second moment is not
      end = S(1) / S(4);
      next = inner = S(1) / S(2);
    } else if (k % 2 == 0) {
      end = S(1) / S(2 * k);
      next = inner = S(k - 1) / S(k * (k - 2));
    } else {
      const Index m = (k - 1) / 2;
      inner = S(2 * m - 3) / S(2 * (m - 1) * (2 * m - 1));
      next = (S(m) / S(2) - S(m * m - 2) * inner) / S(2);
      end = (S(1) - S(2) * next - S(2 * m - 3) * inner) / S(2);
    }
  }
  S at(Index i, Index k) const {
    const Index from_end = i < k - 1 - i ? i : k - 1 - i;
    return from_end == 0 ? end : from_end == 1 ? next : inner;
  }
};

} // namespace detail

/// Points from `first` to `last`, both included; one lies midway. Precondition: points.size >= 1.
template <class S>
void sample_line(const Vector3<S>& first, const Vector3<S>& last, Span<Vector3<S>> points) {
  const Vector3<S> center = (first + last) / S(2), half = (last - first) / S(2);
  for (Index i = 0; i < points.size; ++i)
    points[i] = center + half * detail::even_step<S>(i, points.size);
}

/// Points on a circle, the first along t, or `phase` half steps (from one point to the next) from
/// it. Precondition: points.size >= 2.
template <class S>
void sample_ring(const Vector3<S>& center, const Vector3<S>& t, const Vector3<S>& o,
                 const S& radius, Span<Vector3<S>> points, Index phase = 0) {
  const Index k = points.size;
  for (Index i = 0; i < k; ++i) {
    const Index half_steps = 2 * i + phase;
    points[i] = center + t * (radius * circle_cosine<S>(half_steps, 2 * k)) +
                o * (radius * circle_sine<S>(half_steps, 2 * k));
  }
}

/// Points in a disc, ring by ring from the inside out, neighbours turned against each other by half
/// a step, the outermost with a point along t; a single point is the centre, which no torque can
/// load. Precondition: points.size >= 1.
template <class S>
void sample_disc(const Vector3<S>& center, const Vector3<S>& t, const Vector3<S>& o,
                 const S& radius, Span<Vector3<S>> points) {
  if (points.size == 1) {
    points[0] = center;
    return;
  }
  const detail::DiscRings disc(points.size);
  for (Index ring = 0; ring < disc.rings; ++ring) {
    const Index begin = disc.begin(ring), end = disc.begin(ring + 1);
    sample_ring<S>(center, t, o, radius * disc.template radius<S>(ring),
                   {points.data + begin, end - begin}, disc.rings - 1 - ring);
  }
}

/// A grid of count_t x count_o points over a rectangle, corners included, t running fastest; a
/// count of 1 puts them midway. `length_t`, `length_o`: its sides along t and o.
/// Preconditions: both counts >= 1, points.size == count_t * count_o.
template <class S>
void sample_rectangle(const Vector3<S>& center, const Vector3<S>& t, const Vector3<S>& o,
                      const S& length_t, const S& length_o, Index count_t, Index count_o,
                      Span<Vector3<S>> points) {
  for (Index j = 0; j < count_o; ++j)
    for (Index i = 0; i < count_t; ++i)
      points[j * count_t + i] = center + t * (length_t / S(2) * detail::even_step<S>(i, count_t)) +
                                o * (length_o / S(2) * detail::even_step<S>(j, count_o));
}

/// Of a ring's points, and of any that no rule fits: equal weights.
template <class S> void equal_weights(Span<S> weights) {
  for (S& w : weights) w = S(1) / S(weights.size);
}

/// Of sample_line's points.
template <class S> void line_weights(Span<S> weights) {
  const detail::LineWeights<S> line(weights.size);
  for (Index i = 0; i < weights.size; ++i) weights[i] = line.at(i, weights.size);
}

/// Of sample_disc's points.
template <class S> void disc_weights(Span<S> weights) {
  const detail::DiscRings disc(weights.size);
  for (Index ring = 0; ring < disc.rings; ++ring) {
    const Index begin = disc.begin(ring), end = disc.begin(ring + 1);
    for (Index i = begin; i < end; ++i) weights[i] = disc.template weight<S>(ring) / S(end - begin);
  }
}

/// Of sample_rectangle's points. Precondition: weights.size == count_t * count_o.
template <class S> void rectangle_weights(Index count_t, Index count_o, Span<S> weights) {
  const detail::LineWeights<S> t(count_t), o(count_o);
  for (Index j = 0; j < count_o; ++j)
    for (Index i = 0; i < count_t; ++i)
      weights[j * count_t + i] = t.at(i, count_t) * o.at(j, count_o);
}

} // namespace lcpush
