#include "lcpush/desktop/raw_problem.hpp"

#include <algorithm>
#include <cmath>

#include "raw/box_form.hpp"
#include "raw/raw_parts.hpp"
#include "raw/settings.hpp"

namespace lcpush::desktop {
namespace {

std::vector<double> at_rows(const std::vector<double>& all, const std::vector<Index>& rows) {
  std::vector<double> part;
  for (const Index i : rows) part.push_back(all[static_cast<std::size_t>(i)]);
  return part;
}

std::vector<unsigned char> positive(const std::vector<double>& z) {
  const double least = raw_settings.near_enough * largest_of(z);
  std::vector<unsigned char> active;
  for (const double x : z) active.push_back(x > least ? 1 : 0);
  return active;
}

RawAnswer solve_piece(const RawProblem& problem, const RawOptions& options,
                      const std::vector<double>& near, int level) {
  Attempts attempts(problem, options);
  const DensePiece plain(problem, DensePiece::Scaled::no);
  if (!near.empty() && attempts.from(plain, positive(near), Guess::near)) {
    attempts.answer().covers = 1;
    return attempts.answer();
  }
  if (!attempts.cold(plain, options.lemke) && !attempts.hopeless() && options.searches)
    search_further(problem, options, level, attempts);
  return attempts.answer();
}

/// The answer of a piece goes to its rows. A failure becomes that of the whole.
void merge(const std::vector<Index>& rows, const RawAnswer& part, RawAnswer& whole) {
  whole.pivots += part.pivots;
  whole.covers = std::max(whole.covers, part.covers);
  whole.search.starts += part.search.starts;
  for (const Index row : part.redundant_rows)
    whole.redundant_rows.push_back(rows[static_cast<std::size_t>(row)]);
  if (part.inconsistent_row >= 0)
    whole.inconsistent_row = rows[static_cast<std::size_t>(part.inconsistent_row)];
  const bool is_solved = part.status == Status::solved;
  if (!is_solved) {
    whole.status = part.status;
    whole.reason = part.reason;
    whole.search.whole = part.search.whole;
  }
  if (!part.ray.empty()) whole.ray.assign(whole.z.size(), 0.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto i = static_cast<std::size_t>(rows[k]);
    if (is_solved) {
      whole.z[i] = part.z[k];
      whole.basic[i] = part.basic[k];
    }
    if (!part.ray.empty()) whole.ray[i] = part.ray[k];
  }
}

/// Every answer called solved has passed the referee on the problem as given.
void judge(const RawProblem& problem, const RawOptions& options, RawAnswer& answer) {
  answer.residual = raw_residual(problem, answer.z, answer.w).residual;
  if (answer.residual <= options.lemke.tolerances.residual) return;
  answer.status = Status::numerical_breakdown;
  answer.reason = Reason::residual;
}

/// Largest entry 1.
void normalise(std::vector<double>& ray) {
  if (const double largest = largest_of(ray); largest > 0)
    for (double& x : ray) x /= largest;
}

RawAnswer solve_by_sweeps(const RawProblem& problem, const RawOptions& options) {
  RawAnswer answer;
  answer.bad_diagonal = first_bad_diagonal(problem);
  if (answer.bad_diagonal >= 0) return answer;
  sweep_rows(problem, options, options.lemke.tolerances.residual, answer);
  for (Index i = 0; i < problem.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    answer.basic.push_back(problem.is_free(i) || answer.z[at] > 0 ? 1 : 0);
  }
  return answer;
}

RawAnswer solve_with_pivots(const RawProblem& problem, const RawOptions& options,
                            const std::vector<double>& near) {
  if (!problem.bounds.given()) return solve_by_pivots(problem, options, near);
  const BoxForm form(problem);
  RawAnswer answer =
      solve_by_pivots(form.problem(), options, near.empty() ? near : form.inside(near));
  form.take_back(answer);
  if (answer.status == Status::solved) judge(problem, options, answer);
  return answer;
}

RawAnswer solve_hybrid(const RawProblem& problem, const RawOptions& options) {
  RawAnswer near;
  if (first_bad_diagonal(problem) < 0) sweep_rows(problem, options, raw_settings.near_enough, near);
  // Sweeps that have come nowhere near are no start.
  RawAnswer answer = solve_with_pivots(problem, options, near.z);
  answer.sweeps = near.sweeps;
  answer.history = near.history;
  return answer;
}

} // namespace

RawAnswer solve_by_pivots(const RawProblem& problem, const RawOptions& options,
                          const std::vector<double>& near, int level) {
  if (!options.searches) return solve_piece(problem, options, near, level);
  const auto n = static_cast<std::size_t>(problem.size());
  RawAnswer answer;
  answer.status = Status::solved;
  answer.z.assign(n, 0.0);
  answer.basic.assign(n, 0);
  const std::vector<std::vector<Index>> pieces = pieces_of(problem.M);
  answer.search.pieces = static_cast<Index>(pieces.size());
  for (const std::vector<Index>& rows : pieces) {
    const RawAnswer part = pieces.size() == 1
                               ? solve_piece(problem, options, near, level)
                               : solve_piece(cut_out(problem, rows), options,
                                             near.empty() ? near : at_rows(near, rows), level);
    merge(rows, part, answer);
    if (part.status != Status::solved) break;
  }
  std::sort(answer.redundant_rows.begin(), answer.redundant_rows.end());
  normalise(answer.ray);
  if (answer.status != Status::solved) {
    answer.z.clear();
    answer.basic.clear();
    return answer;
  }
  judge(problem, options, answer);
  return answer;
}

std::optional<RawAnswer> sweep_large(const RawProblem& problem, RawOptions options) {
  if (largest_piece(problem) < large_piece) return std::nullopt;
  options.solver = Solver::gauss_seidel;
  for (const double relaxation : {raw_settings.over_relaxation, 1.0}) {
    options.sweeps.relaxation = relaxation;
    RawAnswer answer = solve_raw(problem, options);
    if (answer.status == Status::solved) return answer;
    if (answer.bad_diagonal >= 0) break;
  }
  return std::nullopt;
}

RawAnswer solve_raw(const RawProblem& problem, const RawOptions& given) {
  Watcher nobody;
  RawOptions options = given;
  if (options.watcher == nullptr) options.watcher = &nobody;
  switch (options.solver) {
  case Solver::gauss_seidel: return solve_by_sweeps(problem, options);
  case Solver::hybrid: return solve_hybrid(problem, options);
  case Solver::lemke: break;
  }
  return solve_with_pivots(problem, options, {});
}

} // namespace lcpush::desktop
