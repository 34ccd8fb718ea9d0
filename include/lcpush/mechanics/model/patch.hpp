// Points that stand for a contact patch: a line, a disc, a ring, a rectangle.
//
// Positions and lengths are in metres, in whatever frame the caller's centre is given in; t and o
// are unit vectors that span the contact plane, o = n x t. The points are spread evenly, so equal
// forces on them stand for a uniform pressure; their centroid is the patch's centre.
#pragma once

#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/types.hpp"

#include <cmath>

namespace lcpush {

namespace detail {

/// k even steps from -1 to 1, opposite ones exact negatives; the middle if k is 1.
template <class S> S even_step(Index i, Index k) {
  return k == 1 ? S(0) : S(2 * i - (k - 1)) / S(k - 1);
}

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

/// Points in a disc, from the inside out; a single point is the centre, which no torque can load.
///
/// For two points or more their mean distance from the centre is exactly 2R/3, as under a uniform
/// pressure: with equal forces the disc carries the torque 2/3 mu F R of a flat pivot bearing. The
/// disc is cut into rings whose areas are in proportion to their points; each ring's points lie at
/// the mean radius of its area, (2/3)(a^2 + ab + b^2)/(a + b) between the radii a and b.
/// Precondition: points.size >= 1.
template <class S>
void sample_disc(const Vector3<S>& center, const Vector3<S>& t, const Vector3<S>& o,
                 const S& radius, Span<Vector3<S>> points) {
  using std::sqrt;
  const Index k = points.size;
  if (k == 1) {
    points[0] = center;
    return;
  }
  // Rings as wide as their points are apart, which leaves at least three points on the innermost.
  Index rings = 1;
  while (3 * (rings + 1) * (rings + 1) <= k) ++rings;

  Index begin = 0;
  S inner(0);
  for (Index ring = 1; ring <= rings; ++ring) {
    const Index end = ring * ring * k / (rings * rings);
    const S outer = radius * sqrt(S(end) / S(k));
    const S mean = S(2) / S(3) * (inner * inner + inner * outer + outer * outer) / (inner + outer);
    sample_ring<S>(center, t, o, mean, {points.data + begin, end - begin}, ring - 1);
    begin = end;
    inner = outer;
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

} // namespace lcpush
