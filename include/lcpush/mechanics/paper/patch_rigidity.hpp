// [T.6] Patch rigidity by hand: references, affine weights, and the rank of the conditions.
//
// A patch of k points whose relative accelerations r_i are unknowns of their own moves as one rigid
// piece [P.5] if every point follows m + 1 reference points,
//
//   r_j = sum_c alpha_c r_c,   sum_c alpha_c = 1,   p_j = sum_c alpha_c p_c,
//
// and the references keep their distances, (r_c - r_d)' (p_c - p_d) = 0. m is the affine rank: 0,
// 1, 2 for the paper's vertex, edge and face; 3 for points that are not in one plane.
#pragma once

#include "lcpush/lcp/complete_pivoting.hpp"
#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/check.hpp"

namespace lcpush {

constexpr Index most_references = 4;

/// Which points of a patch the others follow. Points count from 0 within the patch.
template <class S> struct PatchReferences {
  Index rank = 0; ///< m
  Index point[most_references]{};
  S size{1};          ///< m: from the first reference to the point farthest from it
  Vector3<S> axis[3]; ///< orthonormal: axis[c] leads from references 0..c to reference c + 1

  Index count() const { return rank + 1; }
  /// Which reference point j is, or -1.
  Index reference_of(Index j) const {
    for (Index c = 0; c <= rank; ++c)
      if (point[c] == j) return c;
    return -1;
  }
};

template <class S> Span<const Vector3<S>> patch_points(const Scene<S>& scene, const Body<S>& body) {
  return {scene.points.data + body.first_point, body.point_count};
}

namespace detail {

/// The point with the largest distance; of those that are equal but for rounding, the first.
template <class S, class Distance>
Index farthest(Span<const Vector3<S>> points, const Distance& distance) {
  const S margin = S(1) + ModelSettings<S>::equal_distance();
  Index best = 0;
  S largest = distance(points[0]);
  for (Index i = 1; i < points.size; ++i) {
    const S x = distance(points[i]);
    if (!(x > margin * largest)) continue;
    largest = x;
    best = i;
  }
  return best;
}

} // namespace detail

/// Greedy: first the point farthest from the middle, then whatever is farthest from the span of
/// those before, so that no weight exceeds 4 in size (8 for points that fill space). Points whose
/// distance to the span is below Tolerances::pivot of the patch's size, or below what rounding
/// leaves of coordinates as large as theirs, count as in it. Precondition: points.size >= 1. O(k).
template <class S> PatchReferences<S> choose_references(Span<const Vector3<S>> points) {
  PatchReferences<S> chosen;
  Vector3<S> middle = Vector3<S>::Zero();
  S largest(0);
  for (const Vector3<S>& p : points) {
    middle += p / S(points.size);
    largest = Eigen::numext::maxi(largest, S(p.norm()));
  }
  const S rounding = ModelSettings<S>::coordinates() * largest;
  chosen.point[0] =
      detail::farthest(points, [&](const Vector3<S>& p) { return (p - middle).norm(); });
  const Vector3<S> origin = points[chosen.point[0]];
  // What is left of p outside the span of the axes found so far.
  const auto off = [&](const Vector3<S>& p) {
    Vector3<S> d = p - origin;
    for (int pass = 0; pass < 2; ++pass) // the second pass takes what rounding left of the first
      for (Index c = 0; c < chosen.rank; ++c) d -= chosen.axis[c].dot(d) * chosen.axis[c];
    return d;
  };
  while (chosen.rank < 3) {
    const Index next = detail::farthest(points, [&](const Vector3<S>& p) { return off(p).norm(); });
    const Vector3<S> away = off(points[next]);
    const S distance = away.norm();
    const S size = chosen.rank == 0 ? distance : chosen.size;
    if (!(distance > Eigen::numext::maxi(rounding, S(Tolerances<S>().pivot * size)))) break;
    chosen.size = size;
    chosen.axis[chosen.rank] = away / distance;
    chosen.point[++chosen.rank] = next;
  }
  return chosen;
}

/// The weights alpha of every point, most_references a point: weights[most_references j + c] is how
/// much point j follows reference c. References follow themselves, unused places are 0. O(k).
template <class S>
void interpolation_weights(Span<const Vector3<S>> points, const PatchReferences<S>& at,
                           Span<S> weights) {
  const Vector3<S> origin = points[at.point[0]];
  const auto along = [&](Index c, Index i) { return at.axis[c - 1].dot(points[i] - origin); };
  for (Index j = 0; j < points.size; ++j) {
    S* const alpha = &weights[most_references * j];
    for (Index c = 0; c < most_references; ++c) alpha[c] = S(c == 0 ? 1 : 0);
    for (Index c = at.rank; c > 0; --c) { // the axes see the references as a triangle
      S rest = along(c, j);
      for (Index e = c + 1; e <= at.rank; ++e) rest -= alpha[e] * along(c, at.point[e]);
      alpha[c] = rest / along(c, at.point[c]);
      alpha[0] -= alpha[c];
    }
    const Index own = at.reference_of(j);
    for (Index c = 0; own >= 0 && c < most_references; ++c) alpha[c] = S(c == own ? 1 : 0);
  }
}

/// Independent conditions on the 3k accelerations of a patch: 3 (k - m - 1) interpolations and
/// m (m + 1) / 2 distances. For edges and faces that is the paper's 3k - m - 4; a single point has
/// none, and points that fill space as many as a face.
constexpr Index rigidity_count(Index k, Index m) { return 3 * (k - m - 1) + m * (m + 1) / 2; }

/// Writes C: the rigidity_count rows of C r = 0. Column 3 i + axis is a component of r_i in the
/// axes of `points`.
template <class S>
void fill_rigidity(Span<const Vector3<S>> points, const PatchReferences<S>& at,
                   Span<const S> weights, MatrixMap<S> C) {
  Index row = 0;
  C.setZero();
  for (Index j = 0; j < points.size; ++j) {
    if (at.reference_of(j) >= 0) continue;
    for (Index axis = 0; axis < 3; ++axis, ++row) {
      C(row, 3 * j + axis) = S(1);
      for (Index c = 0; c < at.count(); ++c)
        C(row, 3 * at.point[c] + axis) = -weights[most_references * j + c];
    }
  }
  for (Index c = 0; c < at.count(); ++c)
    for (Index d = 0; d < c; ++d, ++row) {
      const Vector3<S> between = points[at.point[c]] - points[at.point[d]];
      const S distance = between.norm();
      for (Index axis = 0; axis < 3; ++axis) {
        C(row, 3 * at.point[c] + axis) = between[axis] / distance;
        C(row, 3 * at.point[d] + axis) = -between[axis] / distance;
      }
    }
}

/// The rank by elimination with complete pivoting; A is used up. Entries below an eighth of
/// Tolerances::pivot of A's largest are zero: the distance conditions of references that are just
/// not in one line or plane have pivots as small as that distance. Cost: rows cols rank.
template <class S> Index rank_of(MatrixMap<S> A) {
  const Index most = Eigen::numext::mini(A.rows(), A.cols());
  S zero(0);
  for (Index rank = 0; rank < most; ++rank) {
    const LargestEntry<S> largest =
        largest_entry(A.rows() - rank, A.cols() - rank, S(0),
                      [&](Index i, Index j) { return A(rank + i, rank + j); });
    if (rank == 0) zero = Tolerances<S>().pivot / S(8) * largest.size;
    if (!(largest.size > zero)) return rank;
    A.row(rank).swap(A.row(rank + largest.row));
    A.col(rank).swap(A.col(rank + largest.column));
    for (Index j = rank + 1; j < A.cols(); ++j) {
      if (A(rank, j) == S(0)) continue;
      const S factor = A(rank, j) / A(rank, rank);
      for (Index i = rank + 1; i < A.rows(); ++i) A(i, j) -= factor * A(i, rank);
    }
  }
  return most;
}

/// Are the conditions as many as they should be, and do all rigid motions meet them?
template <class S> struct RigidityCheck {
  Index count = 0; ///< rigidity_count
  Index rank = -1; ///< of C; should be `count`
  S residual{0};   ///< largest entry of C times the patch's six unit motions; 0 is right

  bool holds() const { return rank == count && residual <= Tolerances<S>().pivot; }
};

/// Scalars that check_rigidity needs for a patch of k points.
constexpr Index rigidity_scalars(Index k) { return 3 * k * 3 * k; }

/// Judges the references and weights of a patch. With less than rigidity_scalars(k) of memory
/// nothing is computed and holds() is false. Cost: about (3k)^3 multiply-adds.
template <class S>
RigidityCheck<S> check_rigidity(Span<const Vector3<S>> points, const PatchReferences<S>& at,
                                Span<const S> weights, Span<S> memory) {
  RigidityCheck<S> result;
  result.count = rigidity_count(points.size, at.rank);
  if (memory.size < rigidity_scalars(points.size)) return result;
  MatrixMap<S> C(memory.data, result.count, 3 * points.size);
  fill_rigidity(points, at, weights, C);
  // A rigid motion [P.10]: r_i = v + omega x (p_i - p_0), p_0 the first reference.
  for (Index row = 0; row < C.rows(); ++row) {
    Vector6<S> sum = Vector6<S>::Zero();
    for (Index i = 0; i < points.size; ++i)
      sum += wrench_column<S>((points[i] - points[at.point[0]]) / at.size,
                              C.template block<1, 3>(row, 3 * i).transpose());
    for (Index motion = 0; motion < 6; ++motion)
      detail::keep_worst(result.residual, S(sum[motion]));
  }
  result.rank = rank_of(C);
  return result;
}

} // namespace lcpush
