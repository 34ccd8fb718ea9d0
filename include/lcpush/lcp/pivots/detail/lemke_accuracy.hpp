// How far rounding has moved Lemke's dictionary, and what takes it back: values and answers
// corrected on the problem as given. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

/// product_ = q + M z + d z0 of the dictionary's finite values, as it is scaled. Returns the
/// largest value, at least 1.
template <class S, class B> S Lemke<S, B>::evaluate() {
  const Index n = n_, k = finite_rhs();
  S z0(0), largest(1);
  trial_.setZero();
  for (Index i = 0; i < n; ++i) {
    const Index variable = basis_.dictionary.basic[i];
    const S value = basis_.dictionary.values(i, k);
    largest = value > largest ? value : largest;
    if (variable == artificial(n))
      z0 = value;
    else if (variable >= n)
      trial_[variable - n] = value;
  }
  scaled_product(trial_.data(), product_.data());
  for (Index i = 0; i < n; ++i)
    product_[i] += problem_.q[i] * row_scale_[i] / rhs_scale_[k] + covering_[i] * z0;
  return largest;
}

/// Has rounding in the dictionary moved the finite basic values away from w = q + M z + d z0?
template <class S, class B> bool Lemke<S, B>::drifted() {
  const Index n = n_, k = finite_rhs();
  const S largest = evaluate();
  for (Index i = 0; i < n; ++i)
    if (basis_.dictionary.basic[i] < n)
      product_[basis_.dictionary.basic[i]] -= basis_.dictionary.values(i, k);
  const S allowed = S(100) * options_.tolerances.tie * largest;
  return !(product_.cwiseAbs().maxCoeff() <= allowed);
}

/// An ill-conditioned basis has values that are off however fresh it is, and a value below 0 may
/// then look like one above. The basis' response to what is left in the nonbasic w corrects them.
template <class S, class B> void Lemke<S, B>::correct_values() {
  const Index n = n_, k = finite_rhs();
  S before(-1);
  for (int round = 0; round < 4; ++round) {
    (void)evaluate();
    for (Index i = 0; i < n; ++i) {
      const Index variable = basis_.dictionary.basic[i];
      if (variable >= n) continue;
      basis_.dictionary.values(i, k) = product_[variable];
      product_[variable] = S(0);
    }
    const S largest = product_.cwiseAbs().maxCoeff();
    if (!(largest > S(0)) || round == 3 || (before >= S(0) && !(largest < before))) return;
    before = largest;
    basis_.respond(product_, trial_);
    for (Index i = 0; i < n; ++i)
      if (basis_.dictionary.basic[i] >= n) basis_.dictionary.values(i, k) -= trial_[i];
  }
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
  S before(-1);
  for (int round = 0; round < 4; ++round) {
    product(z.data(), left.data());
    const S* const given = right_hand_side(rhs);
    for (Index j = 0; j < n; ++j) left[j] = (left[j] + given[j]) * row_scale_[j];
    for (const Int variable : basis_.dictionary.basic) // what is left in a basic w is its value
      if (variable < n) left[variable] = S(0);
    const S largest = n > 0 ? S(left.cwiseAbs().maxCoeff()) : S(0);
    if (!(largest > S(0)) || (before >= S(0) && !(largest < before))) return;
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

} // namespace lcpush
