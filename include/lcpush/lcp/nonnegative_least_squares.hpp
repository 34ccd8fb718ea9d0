// Nonnegative least squares by an active set: minimise |A x - b| over x >= 0.
//
// Either A x = b, x >= 0 has a solution, and this is one, or the residual r = b - A x proves that
// it has none: A' r <= 0 and b' r > 0 (Farkas). For few rows and many columns: only as many columns
// as there are rows are ever in use. [Lawson, Hanson 1974, ch. 23]
#pragma once

#include <algorithm>

#include "lcpush/lcp/independent_columns.hpp"
#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// The method, for columns that are made when they are asked for. `Key`: what names a column.
template <class S, class Key> class ActiveColumns {
public:
  static constexpr Index scalars(Index m) { return 2 * m * m + 4 * m; }

  /// `used`: memory for m keys. `barred`: for columns that were tried and help nothing; where it
  /// is full, no others are tried.
  ActiveColumns(Block<S>& block, Span<Key> used, Span<Key> barred)
      : used_(used), barred_(barred), basis_(block.take(used.size * used.size), used.size) {
    const Index m = used.size;
    block.seat(R_, m, m);
    for (VectorMap<S>* map : {&x_, &along_, &z_, &residual_}) block.seat(*map, m);
  }

  Index count() const { return basis_.count(); }             ///< columns in use
  const Key& key(Index k) const { return used_[k]; }         ///< the k-th of them
  const S& x(Index k) const { return x_[k]; }                ///< its share of b
  const VectorMap<S>& residual() const { return residual_; } ///< m, b - A x

  /// Goes on from the columns in use. `columns.steepest(residual, is_barred, key)` finds the column
  /// whose product with the residual is largest, if one counts; `columns.column(key)` is that
  /// column. One with no more new than the part `dependent` of it stays outside.
  /// Post: solved, no column lessens the residual, or it is at most `met`; pivot_limit (the sets
  /// did not settle). Cost: O(m) a column and exchange, as many as columns in use and a few more.
  template <class B, class Columns>
  [[nodiscard]] Status solve(const B& b, const Columns& columns, const S& dependent, const S& met) {
    const Index most = Settings::exchanges + Settings::exchanges_a_row * used_.size;
    for (Index step = 0; step < most; ++step) {
      residual_ = b;
      basis_.remove_from(residual_);
      if (!(residual_.norm() > met) || !let_in(b, columns, dependent)) return Status::solved;
    }
    return Status::pivot_limit;
  }

private:
  using Settings = LeastSquaresSettings;
  Span<Key> used_, barred_;
  IndependentColumns<S> basis_; // Q of the columns in use, A = Q R
  MatrixMap<S> R_{nullptr, 0, 0};
  VectorMap<S> x_{nullptr, 0}, along_{nullptr, 0}, z_{nullptr, 0}, residual_{nullptr, 0};

  /// The column that lessens the residual most steeply comes into use; those that it makes negative
  /// leave. False: none would, the answer is optimal.
  template <class B, class Columns>
  bool let_in(const B& b, const Columns& columns, const S& dependent) {
    Index tried = 0;
    const auto is_barred = [&](const Key& key) {
      return std::find(used_.data, used_.data + count(), key) != used_.data + count() ||
             std::find(barred_.data, barred_.data + tried, key) != barred_.data + tried;
    };
    while (count() < used_.size && tried < barred_.size) {
      Key best{};
      if (!columns.steepest(residual_, is_barred, best)) return false;
      if (append(best, b, columns, dependent)) {
        solve_in_use();
        if (z_[count() - 1] > S(0)) {
          move_to_least_squares(b, columns, dependent);
          return true;
        }
        basis_.keep(count() - 1); // rounding alone made it look useful
      }
      barred_[tried++] = best;
    }
    return false;
  }

  template <class B, class Columns>
  bool append(const Key& key, const B& b, const Columns& columns, const S& dependent) {
    const Index k = count();
    if (!basis_.take(columns.column(key), dependent, R_.data() + k * R_.rows())) return false;
    along_[k] = basis_.direction(k).dot(b);
    x_[k] = S(0);
    used_[k] = key;
    return true;
  }

  /// z of R z = Q' b: the least squares of the columns in use.
  void solve_in_use() {
    for (Index k = count() - 1; k >= 0; --k) {
      S sum = along_[k];
      for (Index l = k + 1; l < count(); ++l) sum -= R_(k, l) * z_[l];
      z_[k] = sum / R_(k, k);
    }
  }

  /// From x towards z as far as nothing turns negative; what reaches zero leaves, until z is
  /// reached.
  template <class B, class Columns>
  void move_to_least_squares(const B& b, const Columns& columns, const S& dependent) {
    const auto blocks = [&](Index k) { return !(z_[k] > S(0)) && x_[k] > z_[k]; };
    const auto reach = [&](Index k) { return S(x_[k] / (x_[k] - z_[k])); };
    for (;;) {
      S share(1);
      for (Index k = 0; k < count(); ++k)
        if (blocks(k) && reach(k) < share) share = reach(k);
      if (!(share < S(1))) break;
      const Index before = count();
      basis_.keep(0); // what stays is made orthogonal afresh
      for (Index k = 0; k < before; ++k) {
        if (blocks(k) && !(reach(k) > share)) continue;
        const S moved = x_[k] + share * (z_[k] - x_[k]);
        if (append(used_[k], b, columns, dependent)) x_[count() - 1] = moved;
      }
      solve_in_use();
    }
    for (Index k = 0; k < count(); ++k) x_[k] = Eigen::numext::maxi(z_[k], S(0));
  }
};

/// Scalars and ints for m rows and n columns.
constexpr Index least_squares_scalars(Index m, Index n) {
  return ActiveColumns<double, int>::scalars(m) + n;
}
constexpr Index least_squares_integers(Index m, Index n) { return m + n; }

template <class S> class NonnegativeLeastSquares {
public:
  /// Memory of at least least_squares_scalars and -_integers elements; it is the caller's.
  NonnegativeLeastSquares(Span<S> scalars, Span<int> integers)
      : scalars_(scalars), integers_(integers) {}

  /// A: m x n, columns of size about 1; b: m, of size about 1.
  /// Post: as ActiveColumns; bad_input (memory too small).
  [[nodiscard]] Status solve(const MatrixMap<S>& A, const VectorMap<S>& b) {
    const Index m = A.rows(), n = A.cols();
    if (scalars_.size < least_squares_scalars(m, n) ||
        integers_.size < least_squares_integers(m, n))
      return Status::bad_input;
    Block<S> scalars(scalars_);
    Block<int> integers(integers_);
    scalars.seat(x_, n);
    const Span<int> used = integers.take(m), barred = integers.take(n);
    ActiveColumns<S, int> active(scalars, used, barred);
    const Status status = active.solve(b, Columns{A}, rounding(), S(0));
    x_.setZero();
    for (Index k = 0; k < active.count(); ++k) x_[active.key(k)] = active.x(k);
    new (&residual_) VectorMap<S>(active.residual());
    return status;
  }

  const VectorMap<S>& x() const { return x_; }               ///< n
  const VectorMap<S>& residual() const { return residual_; } ///< m, b - A x

private:
  static constexpr S rounding() { return LeastSquaresSettings::rounding<S>(); }
  struct Columns {
    const MatrixMap<S>& A;

    auto column(int j) const { return A.col(j); }
    template <class IsBarred>
    bool steepest(const VectorMap<S>& residual, const IsBarred& is_barred, int& best) const {
      S largest = rounding();
      for (Index j = 0; j < A.cols(); ++j) {
        const S slope = A.col(j).dot(residual);
        if (!(slope > largest) || is_barred(static_cast<int>(j))) continue;
        largest = slope;
        best = static_cast<int>(j);
      }
      return largest > rounding();
    }
  };

  Span<S> scalars_;
  Span<int> integers_;
  VectorMap<S> x_{nullptr, 0}, residual_{nullptr, 0};
};

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class NonnegativeLeastSquares<double>;
#endif

} // namespace lcpush
