// Lemke's pivots: start, step, and what becomes of a solution or a ray. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

template <class S, class B> template <class Watcher> Status Lemke<S, B>::start(Watcher& watcher) {
  const bool is_done = !covered_ && is_feasible();
  if (!covered_ && !is_done) cover_here();
  watcher.starts(*this);
  if (n_ == 0 || is_done) return accept();
  const Index column = basis_.enter(artificial(n_));
  RatioTest<S, Int> test = ratio_test();
  const Blocking worst = test.most_violated_row(column);
  for (Index k = 0; k < rhs_count_; ++k) {
    const S value = basis_.dictionary.values(worst.row, k);
    if (value > tie_tolerance_) return accept();
    if (value < -tie_tolerance_) {
      pivot({artificial(n_), column, worst, test.tied_rows(), true}, watcher);
      entering_ = complement(last_.leaving, n_);
      return status_;
    }
  }
  return accept();
}

template <class S, class B>
template <class Watcher>
void Lemke<S, B>::pivot(const PendingPivotOf<Int>& pending, Watcher& watcher) {
  const Index row = watcher.choose_leaving_row(*this, pending);
  last_ = {pending.entering, basis_.dictionary.basic[row], pending.blocking};
  last_.blocking.row = row;
  basis_.exchange(row, pending.column, pending.entering, scratch_);
  ++pivots_;
  ++pivots_of_try_;
  fresh_ = false;
}

template <class S, class B> template <class Watcher> Status Lemke<S, B>::advance(Watcher& watcher) {
  if (entering_ < 0) return start(watcher);
  if (pivots_of_try_ >= limit()) return end(Status::pivot_limit);
  const bool look = pivots_of_try_ % 64 == 63 && !fresh_;
  if ((basis_.is_long() || (look && (B::is_little || drifted()))) && !refactorise())
    return end_unfactored();

  const Index c = basis_.enter(entering_);
  RatioTest<S, Int> test = ratio_test();
  const Blocking blocking = test.blocking_row(c);
  if (blocking.row < 0) return fresh_ && artificial_leaves(watcher) ? accept() : conclude_ray(c);

  pivot({entering_, c, blocking, test.tied_rows()}, watcher);
  if (last_.leaving == artificial(n_)) return accept();
  entering_ = complement(last_.leaving, n_);
  return status_;
}

/// Nothing blocks, but z0 is zero: it should have won the last pivot's tie. What left then comes
/// back in its place, and the basis is an answer's.
template <class S, class B>
template <class Watcher>
bool Lemke<S, B>::artificial_leaves(Watcher& watcher) {
  const Index row = basis_.dictionary.row_of(artificial(n_));
  if (!is_wide() || row < 0 || pivots_of_try_ < 2) return false;
  for (Index k = 0; k < rhs_count_; ++k)
    if (!(Eigen::numext::abs(basis_.dictionary.values(row, k)) <= options_.tolerances.tie))
      return false;
  const Index back = complement(entering_, n_), column = basis_.enter(back);
  if (Eigen::numext::abs(basis_.dictionary.table(row, column)) > options_.tolerances.pivot) {
    candidates_[0] = static_cast<Int>(row);
    pivot({back, column, {row, 1, TieBreak::artificial}, {candidates_.data, 1}}, watcher);
    return true;
  }
  (void)basis_.enter(entering_); // the ray's column again
  return false;
}

template <class S, class B> template <class Watcher> Status Lemke<S, B>::step(Watcher& watcher) {
  if (status_ != Status::running) return status_;
  (void)advance(watcher);
  watcher.stepped(*this);
  if (status_ == Status::running || status_ == Status::solved) return status_;
  return try_next_covering_vector();
}

/// This covering vector has failed: a generic one that has not been tried may do better. If none is
/// left, the failure that says most is reported: a verified ray, else the last.
template <class S, class B> Status Lemke<S, B>::try_next_covering_vector() {
  if (worst_ != Status::ray) {
    worst_ = status_;
    worst_reason_ = reason_;
  }
  if (is_last_try()) return end(worst_, worst_reason_);
  ++tries_;
  cover_cold();
  return status_ = Status::running;
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
  const bool barely = residual_.residual > options_.tolerances.residual / S(16);
  if (barely && repairs_ == 0 && !is_last_try()) return reject();
  return end(Status::solved);
}

/// The check failed: factor the basis afresh, look closer (what was tied at zero may be a small
/// violation) and cover what is left; the next step pivots on from here.
template <class S, class B> Status Lemke<S, B>::reject() {
  constexpr Index repairs_allowed = 3;
  if (repairs_ >= repairs_allowed || !refactorise())
    return end(Status::numerical_breakdown, reason_);
  ++repairs_;
  tie_tolerance_ = repairs_ < repairs_allowed ? S(tie_tolerance_ / S(1024)) : S(0);
  cover_here();
  entering_ = -1;
  return status_;
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
  if constexpr (B::of_groups) // a bound on them; a dense basis has summed them when it scaled
    detail::multiply_terms(*problem_.factored, problem_.free_begin, true, column_scale_.data(),
                           rowsum_.data());
  const S tolerance = options_.tolerances.residual;
  bool certified = v0 >= -tolerance;
  for (Index i = 0; i < n; ++i) {
    const S u = product_[i] + covering_[i] * v0;
    const S row_tolerance = tolerance * (S(1) + rowsum_[i] * row_scale_[i]);
    certified = certified && trial_[i] >= -tolerance && u >= -row_tolerance &&
                (trial_[i] <= tolerance || u <= row_tolerance);
  }
  if (!certified) return end(Status::numerical_breakdown, Reason::false_ray);
  if constexpr (keeps_ray) { // in the problem's own units, largest entry 1
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
