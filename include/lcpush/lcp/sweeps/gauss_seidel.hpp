// Projected Gauss-Seidel, component by component: init, sweep, solve.
//
// Each row is solved for its own unknown, z_i = max(0, z_i - omega w_i / M_ii), with the others as
// they are now. [Cottle, Pang, Stone 1992, chapter 5] It needs a positive diagonal, and
// converges for symmetric positive definite and for strictly diagonally dominant matrices. The
// problems of mechanics/ have zeros on it (xi and s): block_gauss_seidel.hpp is for those.
#pragma once

#include "lcpush/lcp/sweeps/judged_sweeps.hpp"

namespace lcpush {

constexpr Index gauss_seidel_scalars(Index n) { return 6 * n; }

template <class S> class GaussSeidel : public JudgedSweeps<S> {
public:
  /// Memory of at least gauss_seidel_scalars(n) elements.
  explicit GaussSeidel(Span<S> scalars) : scalars_(scalars) {}

  /// `problem` is dense and outlives the run; starts at z = 0. Post: running; or bad_input if the
  /// diagonal is not positive or the memory is too small.
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status init(const Problem<S>& problem, const SweepOptions<S>& options = {},
                            Watcher& watcher = unwatched) {
    using Eigen::numext::sqrt;
    this->begin(problem, options);
    const Index n = problem.size;
    Block<S> block(scalars_);
    for (Span<S>* span : {&z_, &w_, &unit_, &check_w_}) *span = block.take(n);
    check_scratch_ = block.take(2 * n);
    if (block.exhausted() || (n > 0 && problem.matrix == nullptr))
      return status_ = Status::bad_input;
    for (Index i = 0; i < n; ++i) {
      if (!(diagonal(i) > S(0))) return status_ = Status::bad_input;
      unit_[i] = S(1) / sqrt(diagonal(i));
      z_[i] = S(0);
      w_[i] = problem.q[i];
    }
    status_ = Status::running;
    return check(watcher);
  }

  /// One pass over all rows. Post: running, or how the run ended. Cost: n^2 multiply-adds.
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status sweep(Watcher& watcher = unwatched) {
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
    return this->is_check_due() ? check(watcher) : status_;
  }

  /// Sweeps to the end. Post: solved (the check was passed), sweep_limit or stagnated.
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status solve(Watcher& watcher = unwatched) {
    while (status_ == Status::running) (void)sweep(watcher);
    return status_;
  }

private:
  using Judged = JudgedSweeps<S>;
  using Judged::problem_, Judged::options_, Judged::status_, Judged::sweeps_, Judged::residual_;
  using Judged::z_, Judged::unit_, Judged::check_w_, Judged::check_scratch_;
  Span<S> scalars_;
  Span<S> w_;

  S diagonal(Index i) const { return problem_.matrix[i * problem_.size + i]; }

  /// The referee's word; w_ is taken from it, as rounding has piled up in ours.
  template <class Watcher> Status check(Watcher& watcher) {
    this->ask_referee();
    for (Index i = 0; i < problem_.size; ++i) w_[i] = check_w_[i];
    if (residual_.residual <= options_.tolerance)
      status_ = Status::solved;
    else
      this->go_on(GaussSeidelSettings::patience);
    watcher.checked(*this);
    return status_;
  }
};

} // namespace lcpush
