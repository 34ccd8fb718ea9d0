// The answer of a basis, or its ray: read from the dictionary, refined on the problem as given, and
// checked. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

/// Is every basic value >= 0, the right-hand sides taken in order? Then there is nothing to cover.
template <class S, class B> bool Lemke<S, B>::is_feasible() const {
  for (Index i = 0; i < n_; ++i)
    for (Index k = 0; k < rhs_count_; ++k) {
      const S value = basis_.dictionary.values(i, k);
      if (value > tie_tolerance_) break;
      if (!(value >= -tie_tolerance_)) return false;
    }
  return true;
}

/// z0 has left (or was never needed): refine the answer on the problem as given and check it. One
/// that passes barely sits on a basis with a small violation, that a tie has hidden: look closer
/// once, unless no other covering vector is left if that fails.
template <class S, class B> Status Lemke<S, B>::accept() {
  if (!settles_bound()) {
    reason_ = Reason::retreat;
    return reject();
  }
  for (Index k = finite_rhs(); k < rhs_count_; ++k) refine(k);
  if (!passes_check()) return reject();
  const bool barely = residual_.residual > options_.tolerances.residual / S(LemkeSettings::barely);
  if (barely && repairs_ == 0 && !is_last_try()) return reject();
  return end(Status::solved);
}

/// The check failed: factor the basis afresh, look closer (what was tied at zero may be a small
/// violation) and cover what is left; the next step pivots on from here.
template <class S, class B> Status Lemke<S, B>::reject() {
  constexpr Index repairs_allowed = LemkeSettings::repairs;
  if (repairs_ >= repairs_allowed || !refactorise())
    return end(Status::numerical_breakdown, reason_);
  ++repairs_;
  tie_tolerance_ = repairs_ < repairs_allowed ? S(tie_tolerance_ / S(LemkeSettings::closer)) : S(0);
  cover_here();
  entering_ = -1;
  return status_;
}

/// z at one right-hand side, from the dictionary.
template <class S, class B> void Lemke<S, B>::read(Index rhs) {
  VectorMap<S> z = solution_of(rhs);
  z.setZero();
  for (Index i = 0; i < n_; ++i)
    if (basis_.dictionary.basic[i] >= n_ && basis_.dictionary.basic[i] < artificial(n_)) {
      const Index j = basis_.dictionary.basic[i] - n_;
      z[j] = basis_.dictionary.values(i, rhs) * rhs_scale_[rhs] * column_scale_[j];
    }
}

/// The same, refined on the problem as given: the basis' response to a residual in the nonbasic w
/// removes it.
template <class S, class B> void Lemke<S, B>::refine(Index rhs) {
  const Index n = n_;
  VectorMap<S> z = solution_of(rhs), left = tie_column(0), response = tie_column(1);
  read(rhs);
  const S barely = options_.tolerances.residual / S(LemkeSettings::barely);
  S before(-1);
  for (int pass = 0; pass < LemkeSettings::refinements || before > barely; ++pass) {
    basis_.product(z.data(), left.data());
    const S* const given = right_hand_side(rhs);
    for (Index j = 0; j < n; ++j) left[j] = (left[j] + given[j]) * row_scale_[j];
    for (const Int variable : basis_.dictionary.basic) // what is left in a basic w is its value
      if (variable < n) left[variable] = S(0);
    const S largest = n > 0 ? S(left.cwiseAbs().maxCoeff()) : S(0);
    const S most = before > barely ? S(before / S(2)) : before;
    if (!(largest > S(0)) || (before >= S(0) && !(largest < most))) return;
    before = largest;
    basis_.respond(left, response);
    for (Index i = 0; i < n; ++i)
      if (basis_.dictionary.basic[i] >= n && basis_.dictionary.basic[i] < artificial(n)) {
        const Index j = basis_.dictionary.basic[i] - n;
        z[j] -= response[i] * column_scale_[j];
      }
  }
}

/// Does the bound's own solution, in the place of the finite one to come, do what it has to? Its
/// values are written down, not computed: mostly nothing has to be refined.
template <class S, class B> bool Lemke<S, B>::settles_bound() {
  if (finite_rhs() == 0) return true;
  read(0);
  if (bound_is_slack()) return true;
  refine(0);
  return bound_is_slack();
}

/// Is every free unknown at S plus something finite, and nothing else of order S?
template <class S, class B> bool Lemke<S, B>::bound_is_slack() const {
  for (Index i = 0; i < n_; ++i) {
    const S off = solution_(i, 0) - (i >= problem_.free_begin ? S(1) : S(0));
    if (!(Eigen::numext::abs(off) <= options_.tolerances.residual)) return false;
  }
  return true;
}

/// The range 0 <= sigma <= valid_to_ in which this basis is feasible. False if it is empty: some
/// variable is 0 now and falls with the push.
template <class S, class B> bool Lemke<S, B>::find_range() {
  const Index finite = finite_rhs(), push = finite + 1;
  valid_to_ = S(-1);
  for (Index i = 0; i < n_; ++i) {
    const bool is_free = basis_.dictionary.basic[i] >= n_ + problem_.free_begin;
    const S rate = basis_.dictionary.values(i, push), value = basis_.dictionary.values(i, finite);
    if (is_free || !(rate < -tie_tolerance_)) continue;
    if (!(value > tie_tolerance_)) return false;
    const S reach = value * rhs_scale_[finite] / (-rate * rhs_scale_[push]);
    if (valid_to_ < S(0) || reach < valid_to_) valid_to_ = reach;
  }
  return true;
}

/// The residual of z as an answer for q + sigma push. It overwrites the covering vector and the
/// tie columns, which a run that goes on after a check computes afresh.
template <class S, class B> WorstRow<S> Lemke<S, B>::referee(const S& sigma, const S* z) {
  struct Pushed { // there may be no push where sigma is 0
    const Problem<S>& problem;
    const S& sigma;
    S operator[](Index i) const {
      return sigma != S(0) ? S(problem.q[i] + sigma * problem.push[i]) : problem.q[i];
    }
  };
  return natural_residual<B::takes_matrix>(
      problem_, Pushed{problem_, sigma}, z, column_scale_.data(),
      [&](Index i) { return i >= problem_.free_begin; }, covering_.data(), tie_column(0).data());
}

/// Every right-hand side against the referee. With a push, at rest and half-way through the range
/// in which this basis claims to hold: the answer is linear, and find_range has seen to its signs.
template <class S, class B> bool Lemke<S, B>::passes_check() {
  const Index finite = finite_rhs(), push = finite + 1;
  const S tolerance = options_.tolerances.residual;
  reason_ = Reason::residual;
  for (Index i = 0; i < problem_.free_begin; ++i) {
    // Rounding may leave a basic value of zero on the wrong side of it.
    S& z = solution_(i, 0);
    if (z < S(0) && -z <= tolerance * column_scale_[i] * rhs_scale_[finite]) z = S(0);
  }
  residual_ = referee(S(0), z());
  if (!(residual_.residual <= tolerance)) return false;
  if (!has_push()) return true;
  if (!find_range()) return false;
  // Not the very end of the range: there the answer may be all zeros, and rounding its scale.
  const S sigma = valid_to_ < S(0) ? rhs_scale_[finite] / rhs_scale_[push] : valid_to_ / S(2);
  for (Index i = 0; i < n_; ++i) scratch_[i] = solution_(i, 0) + sigma * solution_(i, 1);
  const WorstRow<S> pushed = referee(sigma, scratch_.data());
  if (!(pushed.residual <= residual_.residual)) residual_ = pushed;
  return pushed.residual <= tolerance;
}

/// Nothing blocks the entering variable. Believe it only from a fresh factorisation, and only with
/// its certificate: v >= 0, u = M v + d v0 >= 0, v_i u_i = 0, all on the problem as given.
template <class S, class B> Status Lemke<S, B>::conclude_ray(Index column) {
  if (!fresh_) {
    if (!refactorise()) return end_unfactored();
    return status_;
  }
  const Index n = n_;
  // In trial_ until it is certified: an earlier try's verified ray may stand in ray_.
  trial_.setZero();
  S v0 = entering_ == artificial(n) ? S(1) : S(0);
  const auto record = [&](Index variable, const S& rate) {
    if (variable == artificial(n))
      v0 = rate;
    else if (variable >= n)
      trial_[variable - n] = rate;
  };
  record(entering_, S(1));
  for (Index i = 0; i < n; ++i)
    record(basis_.dictionary.basic[i], basis_.dictionary.table(i, column));

  const S largest = trial_.cwiseAbs().maxCoeff();
  if (!(largest > S(0))) return end(Status::numerical_breakdown, Reason::false_ray);
  trial_ /= largest;
  v0 /= largest;
  scaled_product(trial_.data(), product_.data());
  basis_.row_sums(column_scale_, row_sum_);
  const S tolerance = options_.tolerances.residual;
  bool certified = v0 >= -tolerance;
  for (Index i = 0; i < n; ++i) {
    const S u = product_[i] + covering_[i] * v0;
    const S row_tolerance = tolerance * (S(1) + row_sum_[i] * row_scale_[i]);
    certified = certified && trial_[i] >= -tolerance && u >= -row_tolerance &&
                (trial_[i] <= tolerance || u <= row_tolerance);
  }
  if (!certified) return end(Status::numerical_breakdown, Reason::false_ray);
  if constexpr (B::Memory::keeps_ray) { // in the problem's own units, largest entry 1
    S own_largest(0);
    for (Index i = 0; i < n; ++i) {
      ray_[i] = Eigen::numext::maxi(S(trial_[i] * column_scale_[i]), S(0));
      own_largest = Eigen::numext::maxi(own_largest, ray_[i]);
    }
    ray_ /= own_largest;
    ray_artificial_ = v0 / own_largest;
  }
  return end(Status::ray);
}

} // namespace lcpush
