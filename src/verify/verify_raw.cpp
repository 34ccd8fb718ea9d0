#include "lcpush/desktop/verify.hpp"
#include "text/limits.hpp"
#include "verify/foreign_point.hpp"
#include "verify/settings.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// Every row but the products, each by the size of its terms.
bool is_feasible(const RawProblem& problem, const std::vector<double>& z,
                 const std::vector<double>& w, double tolerance) {
  double z_size = 0;
  for (const double x : z) z_size = std::max(z_size, std::abs(x));
  for (std::size_t i = 0; i < z.size(); ++i) {
    double w_size = std::abs(problem.q[i]);
    for (const SparseEntry& entry : problem.M.row(static_cast<Index>(i)))
      w_size += std::abs(entry.value * z[static_cast<std::size_t>(entry.column)]);
    const double least = -tolerance * w_size;
    if (problem.free[i] != 0 ? !(std::abs(w[i]) <= -least)
                             : !(w[i] >= least && z[i] >= -tolerance * z_size))
      return false;
  }
  return true;
}

/// In a box as well: phi(z - lo, phi(hi - z, -w)), and z'w is what each end adds.
ForeignMetrics measure(const RawProblem& problem, const std::vector<double>& z,
                       const std::vector<double>& w) {
  ForeignMetrics metrics;
  double squares = 0;
  for (std::size_t i = 0; i < z.size(); ++i)
    add_pair(z[i], w[i], ends_of(problem, static_cast<Index>(i), z), metrics, squares);
  metrics.fischer_burmeister = std::sqrt(squares);
  return metrics;
}

/// The matrix written out, for what looks at it as a whole.
DenseProblem written_out(const RawProblem& problem) {
  const Index n = problem.size();
  DenseProblem dense{Eigen::MatrixXd::Zero(n, n),
                     Eigen::Map<const Eigen::VectorXd>(problem.q.data(), n), problem.free};
  for (Index i = 0; i < n; ++i)
    for (const SparseEntry& entry : problem.M.row(i)) dense.M(i, entry.column) = entry.value;
  return dense;
}

/// The largest |a_i - b_i|.
double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

double size_of(const std::vector<double>& z) {
  return distance(z, std::vector<double>(z.size(), 0.0));
}

/// lcpush's own answer beside `nearest`.
void compare(const RawProblem& problem, const std::vector<double>& nearest,
             RawVerifyReport& report) {
  RawAnswer own;
  if (largest_piece(problem) < large_piece)
    own = solve_raw(problem, RawOptions());
  else if (auto swept = sweep_large(problem, RawOptions())) // too large for pivots beside it
    own = std::move(*swept);
  else
    own.status = Status::sweep_limit;
  report.own.status = own.status;
  if (own.status != Status::solved) return;
  report.own.force = distance(nearest, own.z);
  if (*report.own.force <= close_by(report.tolerance) * size_of(own.z))
    report.verdict = Verdict::same_solution;
}

} // namespace

RawVerifyReport verify_raw(const RawProblem& problem, const std::vector<double>& z,
                           const VerifyOptions& options) {
  const Index n = problem.size();
  RawVerifyReport report;
  report.tolerance = options.tolerance;
  if (static_cast<Index>(z.size()) != n) {
    report.because = "z has " + std::to_string(z.size()) + " numbers, the problem " +
                     std::to_string(n) + " unknowns";
    return report;
  }
  std::vector<double> w;
  const WorstRow<double> worst = raw_residual(problem, z, w);
  report.residual = worst.residual;
  report.row = worst.row;
  report.metrics = measure(problem, z, w);
  if (report.row >= 0) {
    report.z = z[static_cast<std::size_t>(report.row)];
    report.w = w[static_cast<std::size_t>(report.row)];
  }
  const bool looks_whole = n <= limits::unknowns_refined && !problem.bounds.given();
  const DenseProblem dense = looks_whole ? written_out(problem) : DenseProblem{};
  const Eigen::VectorXd point = Eigen::Map<const Eigen::VectorXd>(z.data(), n);
  std::vector<double> nearest = z;
  if (const auto refined = looks_whole ? refine_point(dense, point) : std::nullopt) {
    report.refined.found = true;
    const std::vector<double> found(refined->data(), refined->data() + n);
    std::vector<double> found_w;
    report.refined.residual = raw_residual(problem, found, found_w).residual;
    report.refined.moved = distance(found, z);
    if (report.refined.residual < report.residual) nearest = found;
  }
  if (!(report.residual <= options.tolerance)) {
    const bool stuck =
        looks_whole && is_feasible(problem, z, w, options.tolerance) && is_stationary(dense, point);
    report.verdict = stuck ? Verdict::spurious_minimum : Verdict::not_a_solution;
    report.because = "row " + std::to_string(report.row + 1);
    return report;
  }
  report.verdict = Verdict::other_solution;
  compare(problem, nearest, report);
  return report;
}

} // namespace lcpush::desktop
