// A complementarity problem with its matrix written out, for what looks at M as a whole.
#pragma once

#include "dense/decompositions.hpp"
#include "lcpush/lcp/problem.hpp"

#include <vector>

namespace lcpush::desktop {

/// w = M z + q, 0 <= z _|_ w >= 0; rows marked free: w = 0. Numbers near 1.
struct DenseProblem {
  Eigen::MatrixXd M;
  Eigen::VectorXd q;
  std::vector<unsigned char> free;

  bool is_free(Index i) const { return free[static_cast<std::size_t>(i)] != 0; }
  Eigen::VectorXd w(const Eigen::VectorXd& z) const { return product(M, z) + q; }
};

inline DenseProblem dense(const Problem<double>& problem) {
  const Index n = problem.size;
  DenseProblem made{Eigen::MatrixXd(n, n), Eigen::Map<const Eigen::VectorXd>(problem.q, n), {}};
  fill_matrix(problem, MatrixMap<double>(made.M.data(), n, n));
  for (Index i = 0; i < n; ++i) made.free.push_back(i >= problem.free_begin ? 1 : 0);
  return made;
}

} // namespace lcpush::desktop
