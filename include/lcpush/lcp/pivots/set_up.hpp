// Lemke's set-up: memory, scales, starts, and the present basis factored afresh from the problem as
// given when rounding has moved it. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

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
  load_values();
  basis_.load(row_scale_, column_scale_, covering_);
  for (Index i = 0; i < n_; ++i)
    target_[i] = static_cast<Int>(active[i] != 0 ? unknown(i, n_) : slack(i));
  const Tolerances<S>& tolerances = options.tolerances;
  const S smallest =
      guess == Guess::basis ? S(tolerances.pivot * tolerances.tie) : tolerances.independent;
  const Index left = factor(smallest);
  const auto drop = [&] {
    return basis_.drop_pairs(left, target_, candidates_, smallest, scratch_);
  };
  if (left > 0 && (guess == Guess::basis || !drop())) return end_unfactored();
  if (finite_rhs() > 0) basis_.set_bound_rhs(problem_.free_begin, column_scale_, rhs_scale_[0]);
  covered_ = false;
  entering_ = -1;
  return status_;
}

template <class S, class B> bool Lemke<S, B>::carve() {
  Block<S> scalars(scalars_);
  Block<Int> integers(integers_);
  scalars.seat(solution_, n_, 2);
  new (&trial_) VectorMap<S>(column(solution_, 0));
  new (&product_) VectorMap<S>(column(solution_, 1));
  basis_.carve(problem_, rhs_count_ + detail::tie_columns, options_.exchanges, scalars, integers);
  scalars.seat(covering_, n_);
  basis_.seat({row_scale_, column_scale_, row_sum_, scratch_, candidates_, target_}, scalars,
              integers);
  if constexpr (B::Memory::keeps_ray)
    scalars.seat(ray_, n_);
  else
    new (&ray_) VectorMap<S>(trial_);
  return !scalars.exhausted() && !integers.exhausted();
}

template <class S, class B>
Status Lemke<S, B>::prepare(const Problem<S>& problem, const LemkeOptions<S>& options) {
  new (&problem_) Problem<S>(problem);
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
  S finite_sum = basis_.scale(options_.equilibrate, row_scale_, column_scale_, row_sum_, scratch_);
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

/// As given; that of the bound, M (0, -1), is computed, and scratch_ holds it.
template <class S, class B> const S* Lemke<S, B>::right_hand_side(Index rhs) {
  if (rhs >= finite_rhs()) return rhs > finite_rhs() ? problem_.push : problem_.q;
  multiply_bound(problem_, scratch_);
  return scratch_.data();
}

/// The right-hand sides of the basis of all w, from the problem as given.
template <class S, class B> void Lemke<S, B>::load_values() {
  for (Index k = 0; k < rhs_count_; ++k) {
    const S* const given = right_hand_side(k);
    for (Index i = 0; i < n_; ++i)
      basis_.dictionary.values(i, k) = given[i] * row_scale_[i] / rhs_scale_[k];
  }
}

/// out = R M C z.
template <class S, class B> void Lemke<S, B>::scaled_product(const S* z_scaled, S* out) {
  for (Index i = 0; i < n_; ++i) scratch_[i] = z_scaled[i] * column_scale_[i];
  basis_.product(scratch_.data(), out);
  for (Index i = 0; i < n_; ++i) out[i] *= row_scale_[i];
}

/// From the basis of all w to the one in target_. How many of its unknowns it could not take.
template <class S, class B> Index Lemke<S, B>::factor(const S& smallest_pivot) {
  const Wanted wanted{finite_rhs(), rhs_count_, rhs_count_};
  return basis_.factor(target_, candidates_, smallest_pivot, scratch_, wanted);
}

template <class S, class B> bool Lemke<S, B>::must_refactor() {
  constexpr Index between = LemkeSettings::pivots_between_looks;
  if (basis_.must_refactor()) return true;
  return pivots_of_try_ % between == between - 1 && !fresh_ && drifted();
}

/// The present basis, factored afresh from the problem as given.
template <class S, class B> bool Lemke<S, B>::refactorise() {
  for (Index i = 0; i < n_; ++i) target_[i] = basis_.dictionary.basic[i];
  S of_artificial[detail::tie_columns] = {};
  load_values();
  move_ties(true, of_artificial);
  basis_.load(row_scale_, column_scale_, covering_);
  fresh_ = factor(options_.tolerances.pivot * options_.tolerances.tie) == 0;
  if (!fresh_) return false;
  if (finite_rhs() > 0) basis_.set_bound_rhs(problem_.free_begin, column_scale_, rhs_scale_[0]);
  move_ties(false, of_artificial);
  return true;
}

template <class S, class B> Status Lemke<S, B>::end_unfactored() {
  return end(Status::numerical_breakdown,
             basis_.is_too_long() ? Reason::memory_too_small : Reason::singular_basis);
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

/// Has rounding in the dictionary moved the finite basic values away from w = q + M z + d z0?
template <class S, class B> bool Lemke<S, B>::drifted() {
  const Index k = finite_rhs();
  S z0(0), largest(1);
  trial_.setZero();
  for (Index i = 0; i < n_; ++i) {
    const Index variable = basis_.dictionary.basic[i];
    const S value = basis_.dictionary.values(i, k);
    largest = value > largest ? value : largest;
    if (variable == artificial(n_))
      z0 = value;
    else if (variable >= n_)
      trial_[variable - n_] = value;
  }
  scaled_product(trial_.data(), product_.data());
  for (Index i = 0; i < n_; ++i)
    product_[i] += problem_.q[i] * row_scale_[i] / rhs_scale_[k] + covering_[i] * z0;
  for (Index i = 0; i < n_; ++i)
    if (const Index variable = basis_.dictionary.basic[i]; variable < n_)
      product_[variable] -= basis_.dictionary.values(i, k);
  const S allowed = S(LemkeSettings::drift) * options_.tolerances.tie * largest;
  return !(product_.cwiseAbs().maxCoeff() <= allowed);
}

} // namespace lcpush
