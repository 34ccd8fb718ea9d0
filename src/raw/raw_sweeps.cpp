// Raw problems by component-wise Gauss-Seidel over the rows of M, which are never stored whole:
// z_i = z_i - omega w_i / M_ii, brought back into its box.
#include <algorithm>
#include <cmath>

#include "raw/raw_parts.hpp"

namespace lcpush::desktop {
namespace {

constexpr Index patience = 1000; // sweeps without a better residual

std::vector<double> diagonal_of(const SparseRows& M) {
  std::vector<double> diagonal;
  for (Index i = 0; i < M.rows(); ++i) diagonal.push_back(M(i, i));
  return diagonal;
}

void sweep_once(const RawProblem& problem, const std::vector<double>& diagonal, double relaxation,
                std::vector<double>& z) {
  for (Index i = 0; i < problem.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    double w = problem.q[at];
    for (const SparseEntry& entry : problem.M.row(i))
      w += entry.value * z[static_cast<std::size_t>(entry.column)];
    const BoxEnds ends = ends_of(problem, i, z);
    z[at] = std::min(std::max(z[at] - relaxation * w / diagonal[at], ends.lo), ends.hi);
  }
}

/// A point inside of all fixed ends to begin with: zero where it may be.
std::vector<double> start_of(const RawProblem& problem) {
  std::vector<double> z(problem.q.size(), 0.0);
  for (Index i = 0; i < problem.size(); ++i) {
    if (problem.bounds.leader(i) >= 0) continue;
    const BoxEnds ends = ends_of(problem, i, z);
    z[static_cast<std::size_t>(i)] = std::min(std::max(0.0, ends.lo), ends.hi);
  }
  return z;
}

} // namespace

Index first_bad_diagonal(const RawProblem& problem) {
  for (Index i = 0; i < problem.size(); ++i)
    if (!(problem.M(i, i) > 0)) return i;
  return -1;
}

void sweep_rows(const RawProblem& problem, const RawOptions& options, double tolerance,
                RawAnswer& answer) {
  const std::vector<double> diagonal = diagonal_of(problem.M);
  Referee referee(problem);
  answer.z = start_of(problem);
  double best = 0;
  Index best_sweep = 0;
  for (answer.sweeps = 0;; ++answer.sweeps) {
    const bool is_last = answer.sweeps > 0 && answer.sweeps >= options.sweeps.max_sweeps;
    if (is_last || answer.sweeps % options.sweeps.check_every == 0) {
      answer.residual = referee.judge(answer.z, answer.w).residual;
      answer.history.push_back({answer.sweeps, answer.residual});
      options.watcher->swept(answer.sweeps, answer.z.data(), answer.residual);
      if (answer.sweeps == 0 || answer.residual < best) {
        best = answer.residual;
        best_sweep = answer.sweeps;
      }
      const bool is_stuck =
          !std::isfinite(answer.residual) || answer.sweeps - best_sweep > patience;
      answer.status = answer.residual <= tolerance ? Status::solved
                      : is_stuck                   ? Status::stagnated
                      : is_last                    ? Status::sweep_limit
                                                   : Status::running;
      if (answer.status != Status::running) return;
    }
    sweep_once(problem, diagonal, options.sweeps.relaxation, answer.z);
  }
}

} // namespace lcpush::desktop
