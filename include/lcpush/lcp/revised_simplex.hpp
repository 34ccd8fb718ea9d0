// A linear program of few rows, whose columns nobody stores, in a bounded number of exchanges:
//
//   min c x   subject to   C z + x e = b,   z >= 0,   x >= 0,   c = 1 or -1.
//
// A revised simplex method in two phases: the basis has one unknown a row, first a rest of each,
// and is factored afresh at every exchange, which costs about what its prices do. Nothing is
// believed that its proof does not show: feasible unknowns as dear as the dual, a direction without
// end, or Farkas' y.
#pragma once

#include <limits>
#include <utility>

#include "lcpush/lcp/loops.hpp"
#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// The caller's memory, `rows` each, but rows^2 for the inverse.
template <class S> struct SimplexMemory {
  Span<S> inverse, b, e, x, y, step, column;
  Span<Index> basis;
};

/// `Columns`: count(), write(j, column) for 0 <= j < count() of entries near 1, and
/// for_each_product(y, visit) with visit(j, y' column j) in their order.
template <class S, class Columns> class RevisedSimplex {
public:
  RevisedSimplex(const Columns& columns, const SimplexMemory<S>& memory)
      : columns_(columns), m_(memory), rows_(memory.b.size) {}

  /// Pre: b and e are set, and will be overwritten. solved: the least c x, at x = `value`; ray: it
  /// has no end; does_not_hold: no z >= 0 with x, or unless `with_x` with x = 0, is feasible. In
  /// both y is the dual, y' C <= 0 but for rounding. pivot_limit: not known after so many
  /// exchanges.
  Status minimise(S c, bool with_x, Index most_exchanges, S& value) {
    const S demand = normalise(m_.b), unit = normalise(m_.e);
    exchanges_ = 0;
    for (Index row = 0; row < rows_; ++row) m_.basis[row] = first_rest() + row;
    takes_x_ = with_x;
    cost_ = S(0);
    Status status = descend(most_exchanges);
    if (status == Status::solved) status = judge_rests();
    if (status != Status::solved) return status;
    takes_x_ = true;
    cost_ = c;
    status = descend(most_exchanges);
    if (status == Status::solved) status = judge_value(value);
    value *= demand / unit;
    return status;
  }
  Index exchanges() const { return exchanges_; }

private:
  const Columns& columns_;
  SimplexMemory<S> m_;
  Index rows_, exchanges_ = 0;
  S cost_{0};           ///< of x; 0: what counts is the sum of rests
  bool takes_x_ = true; ///< may x be basic?

  // Unknowns are x, then z, then a rest a row.
  Index first_rest() const { return columns_.count() + 1; }
  bool is_rest(Index row) const { return m_.basis[row] >= first_rest(); }
  /// A rest that is 0 and has to be.
  bool stays(Index row) const { return cost_ != S(0) && is_rest(row); }

  VectorMap<S> map(const Span<S>& numbers) const { return {numbers.data, rows_}; }
  static S size_of(const S& x) { return Eigen::numext::abs(x); }
  static S largest(const Span<S>& numbers) {
    S size(0);
    for (const S& x : numbers) size = Eigen::numext::maxi(size, size_of(x));
    return size;
  }
  /// Divided by its largest entry, which is returned; 1 of zeros.
  S normalise(const Span<S>& numbers) const {
    const S size = largest(numbers);
    if (!(size > S(0))) return S(1);
    map(numbers) /= size;
    return size;
  }

  void write_column(Index unknown) {
    const Index row = unknown - first_rest();
    map(m_.column).setZero();
    if (unknown == 0)
      map(m_.column) = map(m_.e);
    else if (row >= 0)
      m_.column[row] = m_.b[row] < S(0) ? S(-1) : S(1);
    else
      columns_.write(unknown - 1, m_.column);
  }

  /// out = inverse times v.
  void solve(const Span<S>& v, const Span<S>& out) const {
    map(out).setZero();
    for (Index j = 0; j < rows_; ++j)
      detail::add_scaled(out.data, m_.inverse.data + j * rows_, v[j], rows_);
  }

  /// Gauss and Jordan, with the largest pivot of each column. False: the basis is singular.
  bool factor() {
    MatrixMap<S>(m_.inverse.data, rows_, rows_).setIdentity();
    for (Index k = 0; k < rows_; ++k) {
      write_column(m_.basis[k]);
      solve(m_.column, m_.step);
      Index pivot = k;
      for (Index i = k; i < rows_; ++i)
        if (size_of(m_.step[i]) > size_of(m_.step[pivot])) pivot = i;
      if (!(size_of(m_.step[pivot]) > Tolerances<S>().pivot)) return false;
      std::swap(m_.step[k], m_.step[pivot]);
      for (Index j = 0; j < rows_; ++j) {
        S* const entries = m_.inverse.data + j * rows_;
        std::swap(entries[k], entries[pivot]);
        const S scaled = entries[k] / m_.step[k];
        detail::add_scaled(entries, m_.step.data, S(-scaled), rows_);
        entries[k] = scaled;
      }
    }
    solve(m_.b, m_.x);
    return true;
  }

  /// y' = costs' inverse.
  void find_dual() {
    map(m_.y).setZero();
    for (Index k = 0; k < rows_; ++k) {
      const S cost = m_.basis[k] == 0 ? cost_ : S(cost_ == S(0) && is_rest(k) ? 1 : 0);
      for (Index j = 0; cost != S(0) && j < rows_; ++j) m_.y[j] += cost * m_.inverse[j * rows_ + k];
    }
  }

  /// The unknown that lowers the cost most, or the first that does; -1: none does.
  Index entering(bool first) const {
    Index found = -1;
    S best = Tolerances<S>().tie * largest(m_.y);
    const auto offer = [&](Index unknown, const S& gain) {
      if (!(gain > best) || (first && found >= 0)) return;
      best = gain;
      found = unknown;
    };
    if (takes_x_) offer(0, S(map(m_.y).dot(map(m_.e)) - cost_));
    columns_.for_each_product(m_.y, [&](Index j, const S& gain) { offer(j + 1, gain); });
    return found;
  }

  /// The row whose unknown is the first at 0 along -step; of those that tie the one of the largest
  /// pivot, or the first. -1: none ends it.
  Index leaving(bool first) const {
    const S least = Tolerances<S>().pivot * largest(m_.step);
    const auto ends = [&](Index k) {
      return m_.step[k] > least || (stays(k) && -m_.step[k] > least);
    };
    const auto ratio = [&](Index k, const S& slack) {
      const S left = stays(k) || m_.x[k] < S(0) ? S(0) : m_.x[k];
      return S((left + slack) / size_of(m_.step[k]));
    };
    S bound = std::numeric_limits<S>::infinity();
    for (Index k = 0; k < rows_; ++k)
      if (ends(k)) bound = Eigen::numext::mini(bound, ratio(k, Tolerances<S>().tie));
    Index found = -1;
    for (Index k = 0; k < rows_; ++k) {
      if (!ends(k) || ratio(k, S(0)) > bound) continue;
      if (found < 0 ||
          (first ? m_.basis[k] < m_.basis[found] : size_of(m_.step[k]) > size_of(m_.step[found])))
        found = k;
    }
    return found;
  }

  /// solved: no unknown lowers the cost. ray: along -step it falls without end. After as many idle
  /// exchanges as rows, Bland's rule takes the first unknowns, and they come to an end.
  Status descend(Index most_exchanges) {
    for (Index idle = 0;;) {
      if (!factor()) return Status::numerical_breakdown;
      find_dual();
      const Index enters = entering(idle > rows_);
      if (enters < 0) return Status::solved;
      if (exchanges_ >= most_exchanges) return Status::pivot_limit;
      write_column(enters);
      solve(m_.column, m_.step);
      const Index row = leaving(idle > rows_);
      if (row < 0) return is_endless(enters) ? Status::ray : Status::numerical_breakdown;
      idle = m_.x[row] > Tolerances<S>().tie * size_of(m_.step[row]) ? 0 : idle + 1;
      m_.basis[row] = enters;
      ++exchanges_;
    }
  }

  // Proofs.

  /// Are the rests 0? Else y is Farkas': y' C <= 0, as no unknown enters, and y' b > 0.
  Status judge_rests() const {
    S rests(0);
    for (Index k = 0; k < rows_; ++k)
      if (is_rest(k)) rests += size_of(m_.x[k]);
    if (rests <= Tolerances<S>().residual) return Status::solved;
    return map(m_.y).dot(map(m_.b)) > Tolerances<S>().residual * largest(m_.y)
               ? Status::does_not_hold
               : Status::numerical_breakdown;
  }

  /// The largest entry of sum - basis times x.
  S left_of(const Span<S>& sum, const Span<S>& x) {
    for (Index k = 0; k < rows_; ++k) {
      write_column(m_.basis[k]);
      map(sum) -= x[k] * map(m_.column);
    }
    return largest(sum);
  }

  /// The unknowns are feasible, and c x = y' b.
  Status judge_value(S& value) {
    const Tolerances<S> tolerances;
    map(m_.step) = map(m_.b);
    S error = left_of(m_.step, m_.x);
    for (Index k = 0; k < rows_; ++k) {
      error = Eigen::numext::maxi(error, stays(k) ? size_of(m_.x[k]) : S(-m_.x[k]));
      if (m_.basis[k] == 0) value = Eigen::numext::maxi(m_.x[k], S(0));
    }
    const S gap = size_of(cost_ * value - map(m_.y).dot(map(m_.b)));
    return error <= tolerances.residual * (S(1) + tolerances.noise * largest(m_.x)) &&
                   gap <= tolerances.residual * (S(1) + value + tolerances.noise * largest(m_.y))
               ? Status::solved
               : Status::numerical_breakdown;
  }

  /// column - basis times step = 0, -step lowers no unknown, as none ends it, and the cost falls.
  bool is_endless(Index enters) {
    S falls = enters == 0 ? S(-cost_) : S(0);
    for (Index k = 0; k < rows_; ++k)
      if (m_.basis[k] == 0) falls += cost_ * m_.step[k];
    write_column(enters);
    map(m_.y) = map(m_.column);
    const S most = Tolerances<S>().residual * Eigen::numext::maxi(S(1), largest(m_.step));
    return falls > most && left_of(m_.y, m_.step) <= most;
  }
};

} // namespace lcpush
