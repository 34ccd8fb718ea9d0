// Raw problems by component-wise Gauss-Seidel, alone or before Lemke's pivots.
#include <algorithm>
#include <cmath>

#include "lcpush/lcp/sweeps/gauss_seidel.hpp"
#include "raw/raw_parts.hpp"

namespace lcpush::desktop {
namespace {

/// The residual at which sweeps leave the rest to pivots, and the part of the largest unknown
/// below which one counts as zero then.
constexpr double near_enough = 1e-6;

Index first_bad_diagonal(const RawProblem& problem) {
  for (Index i = 0; i < problem.M.rows; ++i)
    if (!(problem.M(i, i) > 0)) return i;
  return -1;
}

/// All rows, those of free unknowns last.
Submatrix free_last(const RawProblem& problem) {
  Submatrix sorted;
  for (const bool free : {false, true})
    for (Index i = 0; i < problem.M.rows; ++i)
      if ((problem.free[static_cast<std::size_t>(i)] != 0) == free) sorted.rows.push_back(i);
  sorted.columns = sorted.rows;
  const auto pairs = std::count(problem.free.begin(), problem.free.end(), 0);
  sorted.cut(problem, static_cast<Index>(pairs));
  return sorted;
}

/// Back to the order of the problem as given, and measured there.
void take(const RawProblem& problem, const Submatrix& sorted, const double* z, RawAnswer& answer) {
  answer.z.resize(sorted.rows.size());
  for (std::size_t k = 0; k < sorted.rows.size(); ++k)
    answer.z[static_cast<std::size_t>(sorted.rows[k])] = z[k];
  answer.residual = raw_residual(problem, answer.z, answer.w).residual;
}

/// Sweeps until the residual of the problem as given is `tolerance`. The solver's own check knows
/// other units: it only watches over the progress.
void sweep(const RawProblem& problem, const Submatrix& sorted, const RawOptions& given,
           double tolerance, RawAnswer& answer) {
  SweepOptions<double> options = given.sweeps;
  std::vector<double> scalars(static_cast<std::size_t>(gauss_seidel_scalars(sorted.problem.size)));
  GaussSeidel<double> solver(span_of(scalars));
  options.tolerance = 0;
  answer.status = solver.init(sorted.problem, options);
  for (;;) {
    answer.sweeps = solver.sweeps();
    if (answer.status != Status::running || answer.sweeps % options.check_every == 0) {
      take(problem, sorted, solver.z(), answer);
      answer.history.push_back({answer.sweeps, answer.residual});
      given.watcher->swept(answer.sweeps, solver.z(), answer.residual);
      if (answer.residual <= tolerance)
        answer.status = Status::solved;
      else if (answer.status == Status::solved)
        answer.status = Status::stagnated; // as far as the solver's units can tell, this is it
    }
    if (answer.status != Status::running) return;
    answer.status = solver.sweep();
  }
}

RawAnswer solve_by_sweeps(const RawProblem& problem, const RawOptions& options) {
  RawAnswer answer;
  answer.bad_diagonal = first_bad_diagonal(problem);
  if (answer.bad_diagonal >= 0) return answer;
  sweep(problem, free_last(problem), options, options.lemke.tolerances.residual, answer);
  for (std::size_t i = 0; i < answer.z.size(); ++i)
    answer.basic.push_back(problem.free[i] != 0 || answer.z[i] > 0 ? 1 : 0);
  return answer;
}

/// Pivots from the positive unknowns of `near`. False if they do not end in a solution.
bool pivot_from(const RawProblem& problem, const Submatrix& sorted, const std::vector<double>& near,
                const RawOptions& options, RawAnswer& answer) {
  double largest = 0;
  for (const double x : near) largest = std::max(largest, std::abs(x));
  std::vector<unsigned char> active;
  for (const Index i : sorted.rows) {
    const auto at = static_cast<std::size_t>(i);
    active.push_back(problem.free[at] != 0 || near[at] > near_enough * largest ? 1 : 0);
  }
  OwnedLemke<double> lemke(sorted.problem.size);
  LemkeOptions<double> single = options.lemke;
  single.covers = 1;
  answer.status = lemke.init(sorted.problem, single, active.data(), Guess::near);
  if (answer.status == Status::running) answer.status = lemke.solve(*options.watcher);
  answer.pivots = lemke.pivots();
  if (answer.status != Status::solved) return false;
  answer.covers = 1;
  take(problem, sorted, lemke.z(), answer);
  answer.basic.resize(active.size());
  for (std::size_t k = 0; k < active.size(); ++k)
    answer.basic[static_cast<std::size_t>(sorted.rows[k])] =
        lemke.is_basic(static_cast<Index>(k)) ? 1 : 0;
  return answer.residual <= options.lemke.tolerances.residual;
}

RawAnswer solve_hybrid(const RawProblem& problem, const RawOptions& options) {
  RawAnswer near;
  if (first_bad_diagonal(problem) < 0) {
    const Submatrix sorted = free_last(problem);
    sweep(problem, sorted, options, near_enough, near);
    RawAnswer answer = near;
    if (pivot_from(problem, sorted, near.z, options, answer)) return answer;
    near.pivots = answer.pivots;
  }
  RawAnswer answer = solve_by_pivots(problem, options);
  answer.pivots += near.pivots;
  answer.sweeps = near.sweeps;
  answer.history = near.history;
  return answer;
}

} // namespace

RawAnswer solve_raw(const RawProblem& problem, const RawOptions& given) {
  Watcher nobody;
  RawOptions options = given;
  if (options.watcher == nullptr) options.watcher = &nobody;
  switch (options.solver) {
  case Solver::gauss_seidel: return solve_by_sweeps(problem, options);
  case Solver::hybrid: return solve_hybrid(problem, options);
  case Solver::lemke: break;
  }
  return solve_by_pivots(problem, options);
}

} // namespace lcpush::desktop
