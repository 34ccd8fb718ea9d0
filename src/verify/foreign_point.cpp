#include "verify/foreign_point.hpp"
#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
#include "text/limits.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {

void add_pair(double z, double w, const BoxEnds& ends, ForeignMetrics& metrics, double& squares) {
  const auto burmeister = [](double a, double b) {
    return std::isinf(a) ? -b : std::hypot(a, b) - a - b;
  };
  const double above_lo = z - ends.lo, below_hi = ends.hi - z;
  const double natural = std::min(std::max(-below_hi, w), above_lo);
  metrics.natural_map = std::max(metrics.natural_map, std::abs(natural));
  const double phi = burmeister(above_lo, burmeister(below_hi, -w));
  squares += phi * phi;
  const double room = w > 0 || std::isinf(below_hi) ? above_lo : -below_hi;
  if (std::isfinite(room)) metrics.products += room * w;
}

ForeignMetrics measure_point(const DenseProblem& problem, const Eigen::VectorXd& z) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Eigen::VectorXd w = problem.w(z);
  ForeignMetrics metrics;
  double squares = 0;
  for (Index i = 0; i < z.size(); ++i)
    add_pair(z[i], w[i], {problem.is_free(i) ? -infinity : 0, infinity}, metrics, squares);
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
