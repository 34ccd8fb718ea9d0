// Raw problems by component-wise Gauss-Seidel over the rows of M, which are never stored whole:
// z_i = z_i - omega w_i / M_ii, brought back into its box.
#include <algorithm>
#include <cmath>

#include "raw/raw_parts.hpp"
#include "raw/settings.hpp"

namespace lcpush::desktop {
namespace {

/// What a sweep reads of each row besides its entries; fixed ends are looked up once.
struct SweptRow {
  double step, q, lo, hi; ///< step: relaxation / M_ii
  Index leader;
};

std::vector<SweptRow> rows_to_sweep(const RawProblem& problem, double relaxation) {
  std::vector<SweptRow> rows;
  for (Index i = 0; i < problem.size(); ++i) {
    const Index leader = problem.bounds.leader(i);
    const BoxEnds ends = leader < 0 ? ends_of(problem, i, {}) : BoxEnds{0, 0};
    rows.push_back({relaxation / problem.M(i, i), problem.q[static_cast<std::size_t>(i)], ends.lo,
                    ends.hi, leader});
  }
  return rows;
}

void sweep_once(const RawProblem& problem, const std::vector<SweptRow>& rows,
                std::vector<double>& z) {
  double* const values = z.data();
  for (Index i = 0; i < problem.size(); ++i) {
    const SweptRow& row = rows[static_cast<std::size_t>(i)];
    double w = row.q;
    for (const SparseEntry& entry : problem.M.row(i)) w += entry.value * values[entry.column];
    double lo = row.lo, hi = row.hi;
    if (row.leader >= 0) {
      const BoxEnds ends = ends_of(problem, i, z);
      lo = ends.lo;
      hi = ends.hi;
    }
    values[i] = std::min(std::max(values[i] - w * row.step, lo), hi);
  }
}

/// Zero, or the end next to it.
std::vector<double> start_of(const std::vector<SweptRow>& rows) {
  std::vector<double> z;
  for (const SweptRow& row : rows) z.push_back(std::min(std::max(0.0, row.lo), row.hi));
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
  const std::vector<SweptRow> rows = rows_to_sweep(problem, options.sweeps.relaxation);
  Referee referee(problem);
  answer.z = start_of(rows);
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
          !std::isfinite(answer.residual) || answer.sweeps - best_sweep > raw_settings.patience;
      answer.status = answer.residual <= tolerance ? Status::solved
                      : is_stuck                   ? Status::stagnated
                      : is_last                    ? Status::sweep_limit
                                                   : Status::running;
      if (answer.status != Status::running) return;
    }
    sweep_once(problem, rows, answer.z);
  }
}

} // namespace lcpush::desktop
