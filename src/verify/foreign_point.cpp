#include "verify/foreign_point.hpp"
#include "dense/decompositions.hpp"

#include "solve/owned_program.hpp"
#include "text/limits.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

ForeignMetrics measure_point(const DenseProblem& problem, const Eigen::VectorXd& z) {
  const Eigen::VectorXd w = problem.w(z);
  ForeignMetrics metrics;
  double squares = 0;
  for (Index i = 0; i < z.size(); ++i) {
    const bool is_free = problem.is_free(i);
    const double natural = is_free ? w[i] : std::min(z[i], w[i]);
    const double burmeister = is_free ? w[i] : std::hypot(z[i], w[i]) - z[i] - w[i];
    metrics.natural_map = std::max(metrics.natural_map, std::abs(natural));
    squares += burmeister * burmeister;
    if (!is_free) metrics.products += z[i] * w[i];
  }
  metrics.fischer_burmeister = std::sqrt(squares);
  return metrics;
}

std::optional<Eigen::VectorXd> refine_point(const DenseProblem& problem, const Eigen::VectorXd& z) {
  if (z.size() > limits::unknowns_refined) return std::nullopt;
  const Eigen::VectorXd w = problem.w(z);
  std::vector<Index> basic;
  for (Index i = 0; i < z.size(); ++i)
    if (problem.is_free(i) || z[i] > w[i]) basic.push_back(i);
  Eigen::VectorXd refined = Eigen::VectorXd::Zero(z.size());
  if (!basic.empty()) {
    Eigen::VectorXd z_B = z(basic);
    correct(problem.M(basic, basic), problem.q(basic), VerifySettings::basis_dependent, z_B);
    refined(basic) = z_B; // where the basis leaves forces open, the least change
  }
  if (!refined.allFinite()) return std::nullopt;
  return refined;
}

bool is_stationary(const DenseProblem& problem, const Eigen::VectorXd& z) {
  const Index n = z.size();
  if (n > limits::unknowns_stationary) return false;
  const Eigen::VectorXd w = problem.w(z);
  Eigen::VectorXd products = z;
  for (Index i = 0; i < n; ++i)
    if (problem.is_free(i)) products[i] = 0;
  Eigen::VectorXd gradient = problem.M.transpose() * products;
  double objective = 0;
  for (Index i = 0; i < n; ++i) {
    if (problem.is_free(i)) continue;
    gradient[i] += w[i];
    objective += z[i] * w[i];
  }
  // Columns: z; minus z for what is free; w.
  OwnedProgram program(3 * n, n);
  program.A.leftCols(n) = problem.M;
  program.b = -problem.q;
  program.c.head(n) = gradient;
  for (Index i = 0; i < n; ++i) {
    if (problem.is_free(i)) {
      program.A.col(n + i) = -problem.M.col(i);
      program.c[n + i] = -gradient[i];
    } else {
      program.A(i, 2 * n + i) = -1;
    }
  }
  if (program.solve() != Status::solved) return false;
  return gradient.dot(z) - program.c.dot(program.x) <= VerifySettings::stationary * objective;
}

} // namespace lcpush::desktop
