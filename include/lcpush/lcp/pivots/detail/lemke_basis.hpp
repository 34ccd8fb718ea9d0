// Lemke's housekeeping: set-up, scaling, covering vectors, factoring a basis from the problem as
// given, refining an answer and having it checked. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

template <class S, class B> bool Lemke<S, B>::carve() {
  Block<S> scalars(scalars_);
  Block<Int> integers(integers_);
  const Index n = n_;
  scalars.seat(solution_, n, 2);
  new (&trial_) VectorMap<S>(column(solution_, 0));
  new (&product_) VectorMap<S>(column(solution_, 1));
  basis_.carve(problem_, rhs_count_ + detail::tie_columns, options_.exchanges, scalars, integers);
  for (VectorMap<S>* map : {&covering_, &row_scale_}) scalars.seat(*map, n);
  if (keeps_ray)
    scalars.seat(ray_, n);
  else
    share(ray_, trial_);
  if (B::has_table)
    scalars.seat(scratch_, n);
  else
    new (&scratch_) VectorMap<S>(basis_.dictionary.table.data(), n);
  if (B::one_scale) {
    share(column_scale_, row_scale_);
    share(rowsum_, scratch_);
  } else {
    for (VectorMap<S>* map : {&column_scale_, &rowsum_}) scalars.seat(*map, n);
  }
  candidates_ = integers.take(n);
  // Without a table the basis has read its target before anything is a candidate.
  target_ = B::has_table ? integers.take(n) : candidates_;
  return !scalars.exhausted() && !integers.exhausted();
}

template <class S, class B>
Status Lemke<S, B>::prepare(const Problem<S>& problem, const LemkeOptions<S>& options) {
  problem_ = problem;
  options_ = options;
  n_ = problem.size;
  rhs_count_ = finite_rhs() + 1 + (has_push() ? 1 : 0);
  tries_ = pivots_ = pivots_of_try_ = repairs_ = 0;
  tie_tolerance_ = options.tolerances.tie;
  status_ = Status::running;
  reason_ = worst_reason_ = Reason::none;
  worst_ = Status::running;
  if (!B::supports(problem, options.tie_rule))
    return end(Status::bad_input, Reason::unsupported_problem);
  if (!carve()) return end(Status::bad_input, Reason::memory_too_small);

  row_scale_.setOnes();
  column_scale_.setOnes();
  // x - x is NaN, not 0, for every x that is not finite.
  S finite_sum = basis_.scale(options_.equilibrate, row_scale_, column_scale_, rowsum_, scratch_);
  for (Index i = 0; i < n_; ++i) {
    finite_sum += problem_.q[i] - problem_.q[i];
    if (has_push()) finite_sum += problem_.push[i] - problem_.push[i];
  }
  if (!(finite_sum == S(0))) return end(Status::bad_input, Reason::not_finite);
  for (Index k = 0; k < rhs_count_; ++k) {
    const S* const given = right_hand_side(k);
    S largest(0);
    for (Index i = 0; i < n_; ++i)
      largest = Eigen::numext::maxi(largest, S(Eigen::numext::abs(S(given[i] * row_scale_[i]))));
    rhs_scale_[k] = options_.equilibrate ? power_below(largest) : S(1);
  }
  return status_;
}

/// The right-hand sides of the basis of all w, from the problem as given: those from `first_rhs`
/// on.
template <class S, class B> void Lemke<S, B>::load_values(Index first_rhs) {
  for (Index k = first_rhs; k < rhs_count_; ++k) {
    const S* const given = right_hand_side(k);
    for (Index i = 0; i < n_; ++i)
      basis_.dictionary.values(i, k) = given[i] * row_scale_[i] / rhs_scale_[k];
  }
}

/// Generic tie columns.
template <class S, class B> void Lemke<S, B>::draw_ties() {
  for (Index k = 0; k < detail::tie_columns; ++k) {
    VectorMap<S> ties = tie_column(k);
    for (Index i = 0; i < n_; ++i) ties[i] = generic_number<S>(seed(k + 1), i);
  }
}

/// A start at z = 0 under a generic covering vector and tie columns.
template <class S, class B> void Lemke<S, B>::cover_cold() {
  for (Index i = 0; i < n_; ++i)
    covering_[i] =
        has_cover() ? S(options_.cover[i] * row_scale_[i]) : generic_number<S>(seed(0), i);
  draw_ties();
  load_values(0);
  basis_.load(row_scale_, column_scale_, covering_);
  covered_ = true;
  entering_ = -1;
  tie_tolerance_ = options_.tolerances.tie;
  pivots_of_try_ = repairs_ = 0;
}

/// A covering vector and tie columns that are generic and positive in the present complementary
/// basis. In the problem as given the vector is w - M z of the point (z, w) that it describes.
template <class S, class B> void Lemke<S, B>::cover_here() {
  const Index n = n_;
  covered_ = true;
  trial_.setZero();
  covering_.setZero();
  for (Index i = 0; i < n; ++i) {
    const Index variable = basis_.dictionary.basic[i];
    (variable < n ? covering_[variable] : trial_[variable - n]) = generic_number<S>(seed(0), i);
  }
  if (is_wide() && options_.rubs) rub_more();
  VectorMap<S> here = tie_column(0);
  for (Index i = 0; i < n; ++i) {
    const Index variable = basis_.dictionary.basic[i];
    here[i] = variable < n ? covering_[variable] : trial_[variable - n];
  }
  scaled_product(trial_.data(), product_.data());
  covering_ -= product_;
  basis_.set_covering_vector(covering_, [&](Index i) { return here[i]; });
  draw_ties();
}

/// Of the point that a covering vector is made of, trial_ and covering_: friction beyond
/// every cone's limit. Then d > 0 in the cones' rows, and no slip can grow alone while z0 > 0: its
/// point's friction would have to vanish, and 0 = mu lambda + d z0.
template <class S, class B> void Lemke<S, B>::rub_more() {
  if (problem_.factored == nullptr) return;
  for (const ConeGroup<S>& cone : problem_.factored->cones) {
    if (cone.generators == 0) continue;
    const Index first = cone.variable + cone.normals, slip = cone.slip();
    S limit(0), friction(0);
    for (Index j = cone.variable; j < first; ++j)
      limit += cone.friction * trial_[j] * column_scale_[j];
    for (Index j = first; j < slip; ++j) friction += trial_[j] * column_scale_[j];
    if (covering_[slip] > S(0))
      covering_[slip] += limit * row_scale_[slip];
    else if (friction > S(0))
      for (Index j = first; j < slip; ++j) trial_[j] *= S(1) + limit / friction;
  }
}

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

/// out = R M C z.
template <class S, class B> void Lemke<S, B>::scaled_product(const S* z_scaled, S* out) {
  for (Index i = 0; i < n_; ++i) scratch_[i] = z_scaled[i] * column_scale_[i];
  product(scratch_.data(), out);
  for (Index i = 0; i < n_; ++i) out[i] *= row_scale_[i];
}

/// The tie columns are generic, so that a basis that is factored afresh keeps them. They move to
/// trial_ and product_, where rows are numbered by their variable's pair, and back.
template <class S, class B> void Lemke<S, B>::move_ties(bool out, S* of_artificial) {
  for (Index k = 0; k < detail::tie_columns; ++k) {
    VectorMap<S> ties = tie_column(k), kept = column(solution_, k);
    for (Index i = 0; i < n_; ++i) {
      const Index variable = basis_.dictionary.basic[i];
      S& at = variable == artificial(n_) ? of_artificial[k]
                                         : kept[variable < n_ ? variable : variable - n_];
      (out ? at : ties[i]) = out ? ties[i] : at;
    }
  }
}

/// The present basis, factored afresh from the problem as given.
template <class S, class B> bool Lemke<S, B>::refactorise() {
  for (Index i = 0; i < n_; ++i) target_[i] = basis_.dictionary.basic[i];
  S of_artificial[detail::tie_columns] = {};
  load_values(first_to_load());
  move_ties(true, of_artificial);
  basis_.load(row_scale_, column_scale_, covering_);
  const S smallest = options_.tolerances.pivot * options_.tolerances.tie;
  // The right-hand side of the bound is written down.
  const Wanted wanted{finite_rhs(), rhs_count_, rhs_count_};
  fresh_ = basis_.factor(target_, candidates_, smallest, scratch_, wanted) == 0;
  if (fresh_) bound_rhs();
  if (fresh_) move_ties(false, of_artificial);
  if (fresh_ && is_wide() && drifted()) correct_values();
  return fresh_;
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

template <class S, class B>
Status Lemke<S, B>::init(const Problem<S>& problem, const LemkeOptions<S>& options) {
  if (prepare(problem, options) == Status::running) cover_cold();
  return status_;
}

template <class S, class B>
Status Lemke<S, B>::init(const Problem<S>& problem, const LemkeOptions<S>& options,
                         const unsigned char* active, Guess guess) {
  if (prepare(problem, options) != Status::running) return status_;
  covering_.setOnes();
  for (Index k = 0; k < detail::tie_columns; ++k) tie_column(k).setZero(); // cover_here brings them
  load_values(first_to_load());
  basis_.load(row_scale_, column_scale_, covering_);
  for (Index i = 0; i < n_; ++i)
    target_[i] = static_cast<Int>(active[i] != 0 ? unknown(i, n_) : slack(i));
  const Tolerances<S>& tolerances = options.tolerances;
  const S smallest =
      guess == Guess::basis ? S(tolerances.pivot * tolerances.tie) : tolerances.independent;
  const Wanted wanted{finite_rhs(), rhs_count_, rhs_count_};
  const Index left = basis_.factor(target_, candidates_, smallest, scratch_, wanted);
  const auto drop = [&] {
    return basis_.drop_pairs(left, target_, candidates_, smallest, scratch_);
  };
  if (left > 0 && (guess == Guess::basis || !drop())) return end_unfactored();
  bound_rhs();
  covered_ = false;
  entering_ = -1;
  return status_;
}

} // namespace lcpush
