#include "verify/foreign_point.hpp"
#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
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
    const Eigen::MatrixXd M_BB = problem.M(basic, basic);
    const PivotedQr qr(M_BB, VerifySettings::basis_dependent * longest_column(M_BB));
    for (int step = 0; step < 2; ++step) { // the second for the digits of the first
      const Eigen::VectorXd w_B = product(M_BB, z_B) + problem.q(basic);
      z_B -= qr.shortest(w_B); // where the basis leaves forces open, the least change
    }
    refined(basic) = z_B;
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
  Eigen::VectorXd gradient = product(problem.M.transpose(), products);
  double objective = 0;
  for (Index i = 0; i < n; ++i) {
    if (problem.is_free(i)) continue;
    gradient[i] += w[i];
    objective += z[i] * w[i];
  }
  // Columns: the free z, the other z, their w.
  std::vector<Index> order;
  for (const bool free : {true, false})
    for (Index i = 0; i < n; ++i)
      if (problem.is_free(i) == free) order.push_back(i);
  const Index pairs = std::count(problem.free.begin(), problem.free.end(), 0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n + pairs);
  A.leftCols(n) = problem.M(Eigen::all, order);
  for (Index k = 0; k < pairs; ++k) A(order[static_cast<std::size_t>(n - pairs + k)], n + k) = -1;
  Eigen::VectorXd c = Eigen::VectorXd::Zero(n + pairs);
  c.head(n) = gradient(order);
  const std::optional<Eigen::VectorXd> lowest = cheapest_point(A, -problem.q, c, n - pairs);
  if (!lowest) return false;
  return gradient.dot(z) - c.dot(*lowest) <= VerifySettings::stationary * objective;
}

} // namespace lcpush::desktop
