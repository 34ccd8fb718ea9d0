// Does a point lie in a finitely generated cone? Both answers come with their proof.
#pragma once

#include "lcpush/lcp/nonnegative_least_squares.hpp"
#include "lcpush/lcp/tolerances.hpp"

namespace lcpush {

/// Scalars for m rows and n columns; ints: least_squares_integers.
constexpr Index cone_membership_scalars(Index m, Index n) {
  return m * n + 2 * m + n + least_squares_scalars(m, n);
}

/// Does b lie in the cone of A's columns?
template <class S> struct ConeMembership {
  MatrixMap<S> A{nullptr, 0, 0};
  VectorMap<S> b{nullptr, 0}, residual{nullptr, 0}, x{nullptr, 0};
  Span<S> scalars;
  Span<int> integers;
  bool fits;
  S steepest{0}; ///< at most residual' times a column; 0 or less is a proof

  /// All zeros.
  ConeMembership(const Span<S>& scalars_given, const Span<int>& integers_given, Index rows,
                 Index columns)
      : integers(integers_given) {
    Block<S> block(scalars_given);
    block.seat(A, rows, columns);
    for (VectorMap<S>* map : {&b, &residual}) block.seat(*map, rows);
    block.seat(x, columns);
    scalars = block.take(least_squares_scalars(rows, columns));
    fits = !block.exhausted() && integers.size >= least_squares_integers(rows, columns);
    if (!fits) return;
    A.setZero();
    b.setZero();
  }

  /// Of the first `columns` columns. Post: solved, b = A x; ray, the residual proves that there is
  /// none: both checked on A itself; or neither is certain.
  [[nodiscard]] Status ask(Index columns) {
    const MatrixMap<S> given(A.data(), A.rows(), columns);
    NonnegativeLeastSquares<S> solver(scalars, integers);
    const Status status = solver.solve(given, b);
    if (status != Status::solved) return status;
    S largest(0);
    steepest = S(0);
    residual = b;
    for (Index j = 0; j < columns; ++j) {
      x[j] = solver.x()[j];
      residual -= x[j] * given.col(j);
      largest = Eigen::numext::maxi(largest, S(x[j]));
    }
    const S tolerance = Tolerances<S>().residual;
    if (residual.norm() <= tolerance * (S(1) + Tolerances<S>().noise * largest))
      return Status::solved;
    for (Index j = 0; j < columns; ++j)
      steepest = Eigen::numext::maxi(steepest, S(given.col(j).dot(residual)));
    return steepest <= tolerance * residual.squaredNorm() ? Status::ray
                                                          : Status::numerical_breakdown;
  }
};

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template struct ConeMembership<double>;
#endif

} // namespace lcpush
