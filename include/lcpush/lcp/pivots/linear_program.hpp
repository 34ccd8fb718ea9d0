// Linear programs by Lemke's pivots:
//
//     minimise c x    subject to    A x = b,   H x >= 0,   x >= 0.
//
// The equalities are eliminated first (Gauss and Jordan, largest pivot), which drops those that
// follow from the others. What is left has inequalities only, R x + r >= 0, and its optimality
// conditions 0 <= (x, y) _|_ (c - R' y, R x + r) >= 0 have a skew matrix: Lemke's method ends in a
// solution if there is one. [Cottle, Pang, Stone 1992, 1.2 and 4.4]
#pragma once

#include "lcpush/lcp/complete_pivoting.hpp"
#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

/// Matrices dense and column-major. The caller's units: b, c and the larger entries of A and H are
/// near 1.
template <class S> struct LinearProgram {
  Index columns = 0, equalities = 0, inequalities = 0;
  const S* A = nullptr; ///< equalities x columns
  const S* b = nullptr; ///< equalities
  const S* H = nullptr; ///< inequalities x columns
  const S* c = nullptr; ///< columns
};

/// Scalars and ints for `columns` unknowns, m equalities and k inequalities.
constexpr Index linear_program_scalars(Index columns, Index m, Index k) {
  const Index n = columns + k;
  return m * (columns + 1 + m) + n * (n + 1) + columns + 2 * m + k + lemke_scalars(n);
}
constexpr Index linear_program_integers(Index columns, Index m, Index k) {
  return m + 2 * columns + lemke_integers(columns + k);
}

template <class S> class LinearProgramSolver {
public:
  /// Memory of at least linear_program_scalars and -_integers elements; it is the caller's.
  LinearProgramSolver(Span<S> scalars, Span<int> integers)
      : scalars_(scalars), integers_(integers) {}

  /// Post: solved, x() is feasible and the multipliers prove that nothing is cheaper; ray, they
  /// prove that nothing is feasible; bad_input (memory too small, numbers not finite); else the
  /// failure of the pivots or of a proof, also if the cost has no lower bound. Both proofs are
  /// read off the program as given. Cost: Lemke's on columns + inequalities unknowns.
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status solve(const LinearProgram<S>& program, const LemkeOptions<S>& options,
                             Watcher& watcher = unwatched);

  const S* x() const { return x_.data(); }
  S cost() const { return cost_; }
  /// After solved: nu and y >= 0 with A' nu + H' y <= c and b nu = c x. After ray: with
  /// A' nu + H' y <= 0 and b nu = 1.
  const S* equality_multipliers() const { return nu_.data(); }
  const S* inequality_multipliers() const { return y_.data(); }
  Index pivots() const { return pivots_; }
  Reason reason() const { return reason_; }

private:
  Span<S> scalars_;
  Span<int> integers_;
  LinearProgram<S> program_;
  Index rank_ = 0, pivots_ = 0;
  Reason reason_ = Reason::none;
  S cost_{0};
  MatrixMap<S> table_{nullptr, 0, 0}; // [A | b | row operations]
  MatrixMap<S> M_{nullptr, 0, 0};
  VectorMap<S> q_{nullptr, 0}, x_{nullptr, 0}, nu_{nullptr, 0}, y_{nullptr, 0}, row_{nullptr, 0};
  Span<int> basic_, place_, nonbasic_; // place_: column j is nonbasic_[place_[j]], or basic in row
                                       // -1 - place_[j]
  Span<S> lemke_scalars_;
  Span<int> lemke_integers_;

  using Map = Eigen::Map<const Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>>;
  Map A() const { return Map(program_.A, program_.equalities, program_.columns); }
  Map H() const { return Map(program_.H, program_.inequalities, program_.columns); }
  /// a -= b, without what rounding leaves of a zero: a row of noise alone has no size to judge by.
  static void subtract(S& a, const S& b) {
    const S terms = Eigen::numext::abs(a) + Eigen::numext::abs(b);
    a -= b;
    if (Eigen::numext::abs(a) <= S(16) * Eigen::NumTraits<S>::epsilon() * terms) a = S(0);
  }
  /// What rounding may leave beside numbers near 1 and others up to `largest`.
  static S tolerance(const S& largest) {
    return Tolerances<S>().residual * (S(1) + Tolerances<S>().noise * largest);
  }

  S dual_infeasibility(bool with_cost) const;
  S dual_objective() const;
  bool contradicts_itself();
  bool is_feasible();
  bool is_cheapest() const;
  bool refutes();

  bool carve() {
    const Index m = program_.equalities, k = program_.inequalities, columns = program_.columns;
    const Index n = columns + k;
    Block<S> scalars(scalars_);
    Block<int> integers(integers_);
    scalars.seat(table_, m, columns + 1 + m);
    scalars.seat(M_, n, n);
    scalars.seat(q_, n);
    scalars.seat(x_, columns);
    for (VectorMap<S>* map : {&nu_, &row_}) scalars.seat(*map, m);
    scalars.seat(y_, k);
    lemke_scalars_ = scalars.take(lemke_scalars(n));
    basic_ = integers.take(m);
    for (Span<int>* span : {&place_, &nonbasic_}) *span = integers.take(columns);
    lemke_integers_ = integers.take(lemke_integers(n));
    return !scalars.exhausted() && !integers.exhausted();
  }

  /// Post: in the first rank_ rows column basic_[row] is a unit vector; the rest of A is empty.
  void eliminate() {
    const Index m = program_.equalities, columns = program_.columns, width = table_.cols();
    table_.setZero();
    for (Index j = 0; j < columns; ++j) table_.col(j) = A().col(j);
    for (Index i = 0; i < m; ++i) {
      table_(i, columns) = program_.b[i];
      table_(i, columns + 1 + i) = S(1);
    }
    for (rank_ = 0; rank_ < m; ++rank_) {
      const LargestEntry<S> largest =
          largest_entry(m - rank_, columns, Tolerances<S>().pivot,
                        [&](Index i, Index j) { return S(table_(rank_ + i, j)); });
      if (largest.row < 0) break;
      const Index row = rank_ + largest.row, column = largest.column;
      row_ = table_.col(column);
      const S pivot = row_[row];
      row_[row] = row_[rank_];
      row_[rank_] = S(0);
      for (Index j = 0; j < width; ++j) {
        S own = table_(row, j);
        table_(row, j) = table_(rank_, j);
        table_(rank_, j) = own / pivot;
        own = table_(rank_, j);
        for (Index i = 0; own != S(0) && i < m; ++i)
          if (row_[i] != S(0)) subtract(table_(i, j), own * row_[i]);
      }
      basic_[rank_] = static_cast<int>(column);
    }
    for (Index j = 0; j < columns; ++j) place_[j] = 0;
    for (Index row = 0; row < rank_; ++row) place_[basic_[row]] = static_cast<int>(-1 - row);
    int k = 0;
    for (Index j = 0; j < columns; ++j) {
      if (place_[j] < 0) continue;
      nonbasic_[k] = static_cast<int>(j);
      place_[j] = k++;
    }
  }

  /// M and q over [x nonbasic; y of basic x >= 0; y of H x >= 0].
  void condense() {
    const Index columns = program_.columns, free = columns - rank_;
    M_.setZero();
    q_.setZero();
    for (Index k = 0; k < free; ++k) q_[k] = program_.c[nonbasic_[k]];
    // Row `row` of [R r], or c, gets a multiple of x_j, which a basic x_j passes on to the others.
    for (Index j = 0; j < columns; ++j) {
      const Index from = -1 - place_[j];
      if (from < 0) {
        M_.col(place_[j]).tail(program_.inequalities) += H().col(j);
        continue;
      }
      q_[free + from] = table_(from, columns);
      for (Index i = 0; i < program_.inequalities; ++i)
        subtract(q_[columns + i], -H()(i, j) * table_(from, columns));
      for (Index k = 0; k < free; ++k) {
        const S share = table_(from, nonbasic_[k]);
        if (share == S(0)) continue;
        M_(free + from, k) = -share;
        for (Index i = 0; i < program_.inequalities; ++i)
          subtract(M_(columns + i, k), share * H()(i, j));
        subtract(q_[k], share * program_.c[j]);
      }
    }
    for (Index k = 0; k < free; ++k)
      for (Index row = free; row < q_.size(); ++row) M_(k, row) = -M_(row, k);
  }

  void take_point(const S* z) {
    const Index free = program_.columns - rank_;
    for (Index k = 0; k < free; ++k) x_[nonbasic_[k]] = Eigen::numext::maxi(z[k], S(0));
    for (Index row = 0; row < rank_; ++row) {
      S x = table_(row, program_.columns);
      for (Index k = 0; k < free; ++k) x -= table_(row, nonbasic_[k]) * x_[nonbasic_[k]];
      x_[basic_[row]] = Eigen::numext::maxi(x, S(0));
    }
  }

  /// nu and y of the program as given from the multipliers of the condensed one.
  void take_multipliers(const S* y, bool with_cost) {
    for (Index i = 0; i < program_.inequalities; ++i)
      y_[i] = Eigen::numext::maxi(y[rank_ + i], S(0));
    nu_.setZero();
    for (Index row = 0; row < rank_; ++row) {
      S left = (with_cost ? program_.c[basic_[row]] : S(0)) - y[row];
      for (Index i = 0; i < program_.inequalities; ++i) left -= H()(i, basic_[row]) * y_[i];
      for (Index i = 0; i < program_.equalities; ++i)
        nu_[i] += left * table_(row, program_.columns + 1 + i);
    }
  }

  /// Lemke's word on the condensed program, believed only with its proof.
  template <class Watcher> Status pivot(const LemkeOptions<S>& options, Watcher& watcher) {
    Problem<S> problem;
    problem.size = problem.free_begin = q_.size();
    problem.matrix = M_.data();
    problem.q = q_.data();
    Lemke<S> lemke(lemke_scalars_, lemke_integers_);
    Status status = lemke.init(problem, options);
    if (status == Status::running) status = lemke.solve(watcher);
    pivots_ += lemke.pivots();
    reason_ = lemke.reason();
    const Index free = program_.columns - rank_;
    if (status == Status::ray) {
      take_multipliers(lemke.ray() + free, false);
      if (refutes()) return Status::ray;
      reason_ = Reason::false_ray;
      return Status::numerical_breakdown;
    }
    if (status != Status::solved) return status;
    take_point(lemke.z());
    take_multipliers(lemke.z() + free, true);
    cost_ = S(0);
    for (Index j = 0; j < program_.columns; ++j) cost_ += program_.c[j] * x_[j];
    if (is_feasible() && is_cheapest()) return Status::solved;
    reason_ = Reason::residual;
    return Status::numerical_breakdown;
  }
};

template <class S>
template <class Watcher>
Status LinearProgramSolver<S>::solve(const LinearProgram<S>& program,
                                     const LemkeOptions<S>& options, Watcher& watcher) {
  program_ = program;
  pivots_ = 0;
  reason_ = Reason::memory_too_small;
  if (!carve()) return Status::bad_input;
  reason_ = Reason::false_ray;
  eliminate();
  if (contradicts_itself()) return refutes() ? Status::ray : Status::numerical_breakdown;
  condense();
  const Status status = pivot(options, watcher);
  if (status == Status::solved || status == Status::ray || status == Status::bad_input)
    return status;
  // Where more conditions meet than there are unknowns, rounding alone can keep them apart. A part
  // of what the proofs allow lets them meet again.
  const S slack = Tolerances<S>().residual / S(64);
  for (Index i = 0; i < q_.size(); ++i) q_[i] += slack;
  return pivot(options, watcher);
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class LinearProgramSolver<double>;
#endif

} // namespace lcpush

#include "lcpush/lcp/pivots/detail/linear_program_proofs.hpp"
