// What proves a linear program's answer, by the program as given. Included by linear_program.hpp.
#pragma once

#include "lcpush/lcp/pivots/linear_program.hpp"

namespace lcpush {

/// The largest entry of A' nu + H' y - c (or without c); at least 0.
template <class S> S LinearProgramSolver<S>::dual_infeasibility(bool with_cost) const {
  S worst(0);
  for (Index j = 0; j < program_.columns; ++j) {
    S excess = with_cost ? S(-program_.c[j]) : S(0);
    for (Index i = 0; i < program_.equalities; ++i) excess += A()(i, j) * nu_[i];
    for (Index i = 0; i < program_.inequalities; ++i) excess += H()(i, j) * y_[i];
    if (!(excess <= worst)) worst = excess;
  }
  return worst;
}

/// b nu.
template <class S> S LinearProgramSolver<S>::dual_objective() const {
  S sum(0);
  for (Index i = 0; i < program_.equalities; ++i) sum += program_.b[i] * nu_[i];
  return sum;
}

template <class S> bool LinearProgramSolver<S>::is_feasible() {
  using Eigen::numext::maxi;
  S largest(0);
  for (Index j = 0; j < program_.columns; ++j) largest = maxi(largest, x_[j]);
  const S allowed = tolerance(largest);
  for (Index i = 0; i < program_.equalities; ++i) row_[i] = -program_.b[i];
  for (Index j = 0; j < program_.columns; ++j) row_ += x_[j] * A().col(j);
  for (Index i = 0; i < program_.equalities; ++i)
    if (!(Eigen::numext::abs(row_[i]) <= allowed)) return false;
  for (Index i = 0; i < program_.inequalities; ++i) {
    S row(0);
    for (Index j = 0; j < program_.columns; ++j) row += H()(i, j) * x_[j];
    if (!(row >= -allowed)) return false;
  }
  return true;
}

/// The multipliers allow no cost below c x.
template <class S> bool LinearProgramSolver<S>::is_cheapest() const {
  using Eigen::numext::maxi;
  S largest(0);
  for (Index i = 0; i < program_.equalities; ++i)
    largest = maxi(largest, Eigen::numext::abs(nu_[i]));
  for (Index i = 0; i < program_.inequalities; ++i) largest = maxi(largest, y_[i]);
  const S gap = Eigen::numext::abs(cost_ - dual_objective());
  return dual_infeasibility(true) <= tolerance(largest) &&
         gap <= Tolerances<S>().residual *
                    (Eigen::numext::abs(cost_) + Tolerances<S>().noise * (S(1) + largest));
}

/// [Farkas] For x >= 0 with A x = b and H x >= 0: b nu <= (A' nu + H' y) x. Here the left is 1 and
/// the bracket at most the tolerance, so that x would have to be as large as its inverse.
template <class S> bool LinearProgramSolver<S>::refutes() {
  const S sum = dual_objective();
  if (!(sum > S(0))) return false;
  nu_ /= sum;
  y_ /= sum;
  return dual_infeasibility(false) <= Tolerances<S>().residual;
}

/// An equality without unknowns that says 0 = something.
template <class S> bool LinearProgramSolver<S>::contradicts_itself() {
  const LargestEntry<S> largest =
      largest_entry(program_.equalities - rank_, 1, Tolerances<S>().residual,
                    [&](Index i, Index) { return S(table_(rank_ + i, program_.columns)); });
  if (largest.row < 0) return false;
  const Index worst = rank_ + largest.row;
  y_.setZero();
  for (Index i = 0; i < program_.equalities; ++i)
    nu_[i] = table_(worst, program_.columns + 1 + i) / table_(worst, program_.columns);
  return true;
}

} // namespace lcpush
