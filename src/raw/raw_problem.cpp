#include "lcpush/desktop/raw_problem.hpp"

#include <algorithm>

#include "lcpush/lcp/pivots/reduce.hpp"
#include "raw/raw_parts.hpp"

namespace lcpush::desktop {
namespace {

/// Runs the pivots; `answer` receives how they ended.
void pivot(Lemke<double>& lemke, const Problem<double>& problem, const RawOptions& options,
           RawAnswer& answer) {
  if (lemke.init(problem, options.lemke) == Status::running) (void)lemke.solve(*options.watcher);
  answer.status = lemke.status();
  answer.reason = lemke.reason();
  answer.pivots = lemke.pivots();
  answer.covers = lemke.covers_tried();
}

Problem<double> as_given(const RawProblem& problem) {
  Problem<double> given;
  given.size = given.free_begin = problem.M.rows;
  given.matrix = problem.M.values.data();
  given.q = problem.q.values.data();
  return given;
}

RawAnswer solve_standard(const RawProblem& problem, const RawOptions& options) {
  const Index n = problem.M.rows;
  RawAnswer answer;
  OwnedLemke<double> lemke(n);
  pivot(lemke, as_given(problem), options, answer);
  if (answer.status == Status::ray) answer.ray.assign(lemke.ray(), lemke.ray() + n);
  if (answer.status != Status::solved) return answer;
  answer.z.assign(lemke.z(), lemke.z() + n);
  for (Index i = 0; i < n; ++i) answer.basic.push_back(lemke.is_basic(i) ? 1 : 0);
  return answer;
}

/// The basis that the reduced problem found, refined and checked on the problem as given: its
/// complementary pairs first, then the equalities and free unknowns that are independent.
bool certify(const RawProblem& problem, const Reduction<double>& reduction,
             const RawOptions& options, RawAnswer& answer) {
  const Index n = problem.M.rows;
  const auto contains = [](const Span<const int>& list, Index i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  Submatrix whole;
  for (Index i = 0; i < n; ++i)
    if (problem.free[static_cast<std::size_t>(i)] == 0) whole.rows.push_back(i);
  whole.columns = whole.rows;
  const Index pairs = static_cast<Index>(whole.rows.size());
  for (Index i = 0; i < n; ++i) {
    if (problem.free[static_cast<std::size_t>(i)] == 0) continue;
    if (!contains(reduction.redundant_rows(), i)) whole.rows.push_back(i);
    if (!contains(reduction.fixed_unknowns(), i)) whole.columns.push_back(i);
  }
  whole.cut(problem, pairs);
  std::vector<unsigned char> active;
  for (const Index j : whole.columns) active.push_back(answer.basic[static_cast<std::size_t>(j)]);
  OwnedLemke<double> lemke(whole.problem.size);
  if (lemke.init(whole.problem, options.lemke, active.data()) != Status::running) return false;
  if (lemke.solve(*options.watcher) != Status::solved) return false;
  answer.pivots += lemke.pivots();
  answer.z.assign(static_cast<std::size_t>(n), 0.0);
  for (std::size_t k = 0; k < whole.columns.size(); ++k) {
    const auto j = static_cast<std::size_t>(whole.columns[k]);
    answer.z[j] = lemke.z()[k];
    answer.basic[j] = lemke.is_basic(static_cast<Index>(k)) ? 1 : 0;
  }
  return true;
}

RawAnswer solve_mixed(const RawProblem& problem, const RawOptions& options,
                      SingularBlock singular) {
  const Index n = problem.M.rows;
  RawAnswer answer;
  Owned<Reduction<double>> reduction(reduction_scalars(n), reduction_integers(n));
  if (reduction.init(n, problem.M.values.data(), problem.q.values.data(), problem.free.data(),
                     singular) != Status::solved) {
    answer.inconsistent_row = reduction.inconsistent_row();
    return answer;
  }
  for (const int row : reduction.redundant_rows()) answer.redundant_rows.push_back(row);

  OwnedLemke<double> lemke(reduction.problem().size);
  pivot(lemke, reduction.problem(), options, answer);
  if (answer.status == Status::ray) {
    answer.ray.resize(static_cast<std::size_t>(n));
    reduction.recover_direction(lemke.ray(), answer.ray.data());
  }
  if (answer.status != Status::solved) return answer;
  answer.z.resize(static_cast<std::size_t>(n));
  reduction.recover(lemke.z(), answer.z.data());
  answer.basic.assign(problem.free.begin(), problem.free.end());
  for (const int j : reduction.fixed_unknowns()) answer.basic[static_cast<std::size_t>(j)] = 0;
  for (Index k = 0; k < reduction.problem().free_begin; ++k) {
    const ReducedUnknown pair = reduction.unknown_of(k);
    answer.basic[static_cast<std::size_t>(pair.index)] = lemke.is_basic(k) != pair.swapped ? 1 : 0;
  }
  if (!certify(problem, reduction, options, answer)) {
    answer.status = Status::numerical_breakdown;
    answer.reason = Reason::residual;
  }
  return answer;
}

/// Lemke's pivots from zero.
RawAnswer solve_cold(const RawProblem& problem, const RawOptions& options) {
  const auto pairs = std::count(problem.free.begin(), problem.free.end(), 0);
  if (pairs == problem.M.rows) return solve_standard(problem, options);
  // Bounding keeps the class that Lemke is proved for; exchanging reaches what it leaves out.
  RawAnswer answer = solve_mixed(problem, options, SingularBlock::bound);
  if (answer.status == Status::solved || answer.inconsistent_row >= 0) return answer;
  RawAnswer other = solve_mixed(problem, options, SingularBlock::exchange);
  other.pivots += answer.pivots;
  other.covers += answer.covers;
  return other.status == Status::solved || answer.status != Status::ray ? other : answer;
}

} // namespace

WorstRow<double> raw_residual(const RawProblem& problem, const std::vector<double>& z,
                              std::vector<double>& w) {
  const std::size_t n = z.size();
  std::vector<double> unit(n, 1.0), scratch(2 * n);
  w.resize(n);
  const auto is_free = [&](Index i) { return problem.free[static_cast<std::size_t>(i)] != 0; };
  return natural_residual(as_given(problem), problem.q.values.data(), z.data(), unit.data(),
                          is_free, w.data(), scratch.data());
}

RawAnswer solve_by_pivots(const RawProblem& problem, const RawOptions& options) {
  RawAnswer answer = solve_cold(problem, options);
  if (answer.status != Status::solved) return answer;
  answer.residual = raw_residual(problem, answer.z, answer.w).residual;
  if (!(answer.residual <= options.lemke.tolerances.residual)) {
    answer.status = Status::numerical_breakdown;
    answer.reason = Reason::residual;
  }
  return answer;
}

} // namespace lcpush::desktop
