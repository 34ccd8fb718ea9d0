// Nonnegative least squares by an active set: minimise |A x - b| over x >= 0.
//
// Either A x = b, x >= 0 has a solution, and this is one, or the residual r = b - A x proves that
// it has none: A' r <= 0 and b' r > 0 (Farkas). For few rows and many columns: only as many columns
// as there are rows are ever in use. [Lawson, Hanson 1974, ch. 23]
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// Scalars and ints for m rows and n columns.
constexpr Index least_squares_scalars(Index m, Index n) { return 2 * m * m + 5 * m + n; }
constexpr Index least_squares_integers(Index m, Index n) { return m + n; }

template <class S> class NonnegativeLeastSquares {
public:
  /// Memory of at least least_squares_scalars and -_integers elements; it is the caller's.
  NonnegativeLeastSquares(Span<S> scalars, Span<int> integers)
      : scalars_(scalars), integers_(integers) {}

  /// A: m x n, columns of size about 1; b: m, of size about 1. Both outlive the solver.
  /// Post: solved; pivot_limit (the sets did not settle); bad_input (memory too small).
  /// Cost: O(m n) an exchange, as many as columns in use at the end and a few more.
  [[nodiscard]] Status solve(const MatrixMap<S>& A, const VectorMap<S>& b) {
    const Index m = A.rows(), n = A.cols();
    if (!carve(m, n)) return Status::bad_input;
    A_ = &A;
    b_ = &b;
    count_ = 0;
    x_.setZero();
    for (Index step = 0; step < 10 * m + 100; ++step) {
      find_residual();
      if (!let_in()) return Status::solved;
    }
    return Status::pivot_limit;
  }

  const VectorMap<S>& x() const { return x_; }               ///< n
  const VectorMap<S>& residual() const { return residual_; } ///< m, b - A x

private:
  Span<S> scalars_;
  Span<int> integers_;
  const MatrixMap<S>* A_ = nullptr;
  const VectorMap<S>* b_ = nullptr;
  // The columns in use, and Q R of them by Gram and Schmidt; z_ are their least squares.
  MatrixMap<S> Q_{nullptr, 0, 0}, R_{nullptr, 0, 0};
  VectorMap<S> along_{nullptr, 0}, z_{nullptr, 0}, residual_{nullptr, 0}, x_{nullptr, 0};
  Span<int> used_, barred_; // barred: the column brings nothing new
  Index count_ = 0;

  bool carve(Index m, Index n) {
    Block<S> scalars(scalars_);
    Block<int> integers(integers_);
    for (MatrixMap<S>* map : {&Q_, &R_}) scalars.seat(*map, m, m);
    for (VectorMap<S>* map : {&along_, &z_, &residual_}) scalars.seat(*map, m);
    scalars.seat(x_, n);
    used_ = integers.take(m);
    barred_ = integers.take(n);
    return !scalars.exhausted() && !integers.exhausted();
  }

  static S rounding() { return S(1000) * Eigen::NumTraits<S>::epsilon(); }

  /// r = b - Q Q' b, and nothing is barred but what is in use.
  void find_residual() {
    residual_ = *b_;
    for (int sweep = 0; sweep < 2; ++sweep)
      for (Index k = 0; k < count_; ++k) residual_ -= Q_.col(k) * Q_.col(k).dot(residual_);
    for (int& mark : barred_) mark = 0;
    for (Index k = 0; k < count_; ++k) barred_[used_[k]] = 1;
  }

  /// The column that lessens the residual most steeply comes into use; those that it makes negative
  /// leave. False: none would, the answer is optimal.
  bool let_in() {
    while (count_ < A_->rows()) {
      Index best = -1;
      S steepest = rounding();
      for (Index j = 0; j < A_->cols(); ++j) {
        if (barred_[j] != 0) continue;
        const S slope = A_->col(j).dot(residual_);
        if (!(slope > steepest)) continue;
        steepest = slope;
        best = j;
      }
      if (best < 0) return false;
      barred_[best] = 1;
      if (!append(best)) continue; // no new direction
      solve_in_use();
      if (z_[count_ - 1] > S(0)) {
        move_to_least_squares();
        return true;
      }
      --count_; // rounding alone made it look useful
    }
    return false;
  }

  /// Column j orthogonal to those in use, twice for the digits. False: it depends on them.
  bool append(Index j) {
    Q_.col(count_) = A_->col(j);
    const S size = Q_.col(count_).norm();
    R_.col(count_).setZero();
    for (int sweep = 0; sweep < 2; ++sweep)
      for (Index k = 0; k < count_; ++k) {
        const S part = Q_.col(k).dot(Q_.col(count_));
        R_(k, count_) += part;
        Q_.col(count_) -= part * Q_.col(k);
      }
    const S rest = Q_.col(count_).norm();
    if (!(rest > rounding() * size)) return false;
    Q_.col(count_) /= rest;
    R_(count_, count_) = rest;
    along_[count_] = Q_.col(count_).dot(*b_);
    used_[count_++] = static_cast<int>(j);
    return true;
  }

  /// R z = Q' b.
  void solve_in_use() {
    for (Index k = count_ - 1; k >= 0; --k) {
      S sum = along_[k];
      for (Index l = k + 1; l < count_; ++l) sum -= R_(k, l) * z_[l];
      z_[k] = sum / R_(k, k);
    }
  }

  /// From x towards z as far as nothing turns negative; what reaches zero leaves, until z is
  /// reached.
  void move_to_least_squares() {
    for (;;) {
      S share(1);
      for (Index k = 0; k < count_; ++k)
        if (!(z_[k] > S(0)) && x_[used_[k]] / (x_[used_[k]] - z_[k]) < share)
          share = x_[used_[k]] / (x_[used_[k]] - z_[k]);
      Index left = 0;
      const Index before = count_;
      const bool arrives = !(share < S(1));
      for (Index k = 0; k < before; ++k) {
        const int j = used_[k];
        const bool leaves = !arrives && !(z_[k] > S(0)) && !(x_[j] / (x_[j] - z_[k]) > share);
        x_[j] = leaves ? S(0) : arrives ? S(z_[k]) : S(x_[j] + share * (z_[k] - x_[j]));
        if (!leaves) used_[left++] = j;
      }
      if (arrives) return;
      count_ = 0; // factor what stays afresh
      for (Index k = 0; k < left; ++k)
        if (!append(used_[k])) x_[used_[k]] = S(0);
      solve_in_use();
    }
  }
};

} // namespace lcpush
