// What the solvers of raw problems share.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::desktop {

/// Some rows and columns of the problem, in a given order.
struct Submatrix {
  std::vector<Index> rows, columns;
  std::vector<double> M, q;
  Problem<double> problem;

  void cut(const RawProblem& from, Index free_begin) {
    for (const Index j : columns)
      for (const Index i : rows) M.push_back(from.M(i, j));
    for (const Index i : rows) q.push_back(from.q(i, 0));
    problem.size = static_cast<Index>(rows.size());
    problem.free_begin = free_begin;
    problem.matrix = M.data();
    problem.q = q.data();
  }
};

/// Lemke's pivots from zero. Precondition: options.watcher is set.
RawAnswer solve_by_pivots(const RawProblem& problem, const RawOptions& options);

} // namespace lcpush::desktop
