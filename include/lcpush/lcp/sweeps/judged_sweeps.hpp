// What both kinds of sweeps share: how far they are, and the referee whom they ask now and then.
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/residual.hpp"
#include "lcpush/lcp/sweeps/settings.hpp"
#include "lcpush/lcp/trace.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

template <class S> struct SweepOptions {
  S tolerance = Tolerances<S>().residual; ///< scaled natural residual to stop at
  Index max_sweeps = GaussSeidelSettings::iterations;
  Index check_every = GaussSeidelSettings::between_checks; ///< sweeps between residual checks
  S relaxation{1};        ///< omega of SOR, 0 < omega < 2; component-wise sweeps only
  bool accelerate = true; ///< block sweeps: go on with Newton's method on what the groups share
};

template <class S> class JudgedSweeps {
public:
  Status status() const { return status_; }
  Index sweeps() const { return sweeps_; } ///< passes over all unknowns so far
  const WorstRow<S>& residual() const { return residual_; }
  const S* z() const { return z_.data; } ///< block sweeps: multipliers as of the last check

protected:
  Problem<S> problem_;
  SweepOptions<S> options_;
  Status status_ = Status::bad_input;
  Index sweeps_ = 0, best_sweep_ = 0;
  WorstRow<S> residual_;
  S best_residual_{0};
  Span<S> z_, unit_, check_w_, check_scratch_;

  void begin(const Problem<S>& problem, const SweepOptions<S>& options) {
    problem_ = problem;
    options_ = options;
    sweeps_ = best_sweep_ = 0;
  }

  bool is_last() const { return sweeps_ > 0 && sweeps_ >= options_.max_sweeps; }
  bool is_check_due() const { return is_last() || sweeps_ % options_.check_every == 0; }

  /// check_w_ becomes M z + q.
  void ask_referee() {
    residual_ = natural_residual(
        problem_, problem_.q, z_.data, unit_.data,
        [&](Index i) { return i >= problem_.free_begin; }, check_w_.data, check_scratch_.data);
  }

  /// It does not pass yet. Stagnated: no finite residual, or none that fell for `patience` sweeps.
  void go_on(Index patience) {
    if (sweeps_ == 0 || residual_.residual < best_residual_) {
      best_residual_ = residual_.residual;
      best_sweep_ = sweeps_;
    }
    const bool finite = residual_.residual - residual_.residual == S(0);
    if (!finite || sweeps_ - best_sweep_ > patience)
      status_ = Status::stagnated;
    else if (is_last())
      status_ = Status::sweep_limit;
  }
};

} // namespace lcpush
