// Projected Gauss-Seidel, component by component: init, sweep, solve.
//
// Each row is solved for its own unknown, z_i = max(0, z_i - omega w_i / M_ii), with the others as
// they are now. [Cottle, Pang, Stone 1992, chapter 5] It needs a positive diagonal, and
// converges for symmetric positive definite and for strictly diagonally dominant matrices. The
// problems of mechanics/ have zeros on it (xi and s): block_gauss_seidel.hpp is for those.
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/residual.hpp"
#include "lcpush/lcp/sweeps/sweep_options.hpp"
#include "lcpush/lcp/trace.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

constexpr Index gauss_seidel_scalars(Index n) { return 6 * n; }

template <class S> class GaussSeidel {
public:
  /// Memory of at least gauss_seidel_scalars(n) elements.
  explicit GaussSeidel(Span<S> scalars) : scalars_(scalars) {}

  /// `problem` is dense and outlives the run; starts at z = 0. Post: running; or bad_input, with
  /// bad_row() >= 0 if that row's diagonal is not positive, -1 if the memory is too small.
  template <class Observer = const Unobserved>
  [[nodiscard]] Status init(const Problem<S>& problem, const SweepOptions<S>& options = {},
                            Observer& observer = unobserved);

  /// One pass over all rows. Post: running, or how the run ended. Cost: n^2 multiply-adds.
  template <class Observer = const Unobserved>
  [[nodiscard]] Status sweep(Observer& observer = unobserved);

  /// Sweeps to the end. Post: solved (the check was passed), sweep_limit or stagnated.
  template <class Observer = const Unobserved>
  [[nodiscard]] Status solve(Observer& observer = unobserved) {
    while (status_ == Status::running) (void)sweep(observer);
    return status_;
  }

  Status status() const { return status_; }
  Index sweeps() const { return sweeps_; }
  Index bad_row() const { return bad_row_; }
  const WorstRow<S>& residual() const { return residual_; }
  const S* z() const { return z_.data; }

private:
  Span<S> scalars_;
  Problem<S> problem_;
  SweepOptions<S> options_;
  Status status_ = Status::bad_input;
  Index sweeps_ = 0, bad_row_ = -1, best_sweep_ = 0;
  WorstRow<S> residual_;
  S best_residual_{0};
  Span<S> z_, w_, unit_, check_w_, check_scratch_;

  S diagonal(Index i) const { return problem_.matrix[i * problem_.size + i]; }
  template <class Observer> Status check(Observer& observer, bool last = false);
  Status judge();
};

template <class S>
template <class Observer>
Status GaussSeidel<S>::init(const Problem<S>& problem, const SweepOptions<S>& options,
                            Observer& observer) {
  using Eigen::numext::sqrt;
  problem_ = problem;
  options_ = options;
  sweeps_ = best_sweep_ = 0;
  bad_row_ = -1;
  const Index n = problem.size;
  Block<S> block(scalars_);
  for (Span<S>* span : {&z_, &w_, &unit_, &check_w_}) *span = block.take(n);
  check_scratch_ = block.take(2 * n);
  if (block.exhausted() || (n > 0 && problem.matrix == nullptr)) return status_ = Status::bad_input;
  for (Index i = 0; i < n; ++i) {
    if (!(diagonal(i) > S(0))) {
      bad_row_ = i;
      return status_ = Status::bad_input;
    }
    unit_[i] = S(1) / sqrt(diagonal(i));
    z_[i] = S(0);
    w_[i] = problem.q[i];
  }
  status_ = Status::running;
  return check(observer);
}

template <class S> template <class Observer> Status GaussSeidel<S>::sweep(Observer& observer) {
  if (status_ != Status::running) return status_;
  const Index n = problem_.size;
  for (Index i = 0; i < n; ++i) {
    S next = z_[i] - options_.relaxation * w_[i] / diagonal(i);
    if (i < problem_.free_begin && !(next > S(0))) next = S(0);
    const S change = next - z_[i];
    if (change == S(0)) continue;
    z_[i] = next;
    const S* const column = problem_.matrix + i * n;
    for (Index k = 0; k < n; ++k) w_[k] += column[k] * change;
  }
  ++sweeps_;
  const bool last = sweeps_ >= options_.max_sweeps;
  if (!last && sweeps_ % options_.check_every != 0) return status_;
  return check(observer, last);
}

template <class S>
template <class Observer>
Status GaussSeidel<S>::check(Observer& observer, bool last) {
  if (judge() == Status::running && last) status_ = Status::sweep_limit;
  observer.checked(*this);
  return status_;
}

/// The referee's word; w_ is taken from it, as rounding has piled up in ours.
template <class S> Status GaussSeidel<S>::judge() {
  constexpr Index patience = 1000; // sweeps without a better residual
  residual_ = natural_residual(
      problem_, problem_.q, z_.data, unit_.data, [&](Index i) { return i >= problem_.free_begin; },
      check_w_.data, check_scratch_.data);
  for (Index i = 0; i < problem_.size; ++i) w_[i] = check_w_[i];
  if (residual_.residual <= options_.tolerance) return status_ = Status::solved;
  const bool better = sweeps_ == 0 || residual_.residual < best_residual_;
  if (better) {
    best_residual_ = residual_.residual;
    best_sweep_ = sweeps_;
  }
  const bool finite = residual_.residual - residual_.residual == S(0);
  if (!finite || sweeps_ - best_sweep_ > patience) return status_ = Status::stagnated;
  return status_;
}

} // namespace lcpush
