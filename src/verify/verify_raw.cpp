#include "lcpush/desktop/verify.hpp"
#include "verify/foreign_point.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

bool is_feasible(const DenseProblem& problem, const Eigen::VectorXd& z, double tolerance) {
  const Eigen::VectorXd w = problem.w(z);
  const double z_size = z.cwiseAbs().maxCoeff();
  const Eigen::VectorXd w_size = problem.M.cwiseAbs() * z.cwiseAbs() + problem.q.cwiseAbs();
  for (Index i = 0; i < z.size(); ++i) {
    const double least = -tolerance * w_size[i];
    if (problem.is_free(i) ? !(std::abs(w[i]) <= -least)
                           : !(w[i] >= least && z[i] >= -tolerance * z_size))
      return false;
  }
  return true;
}

} // namespace

RawVerifyReport verify_raw(const RawProblem& problem, const std::vector<double>& z,
                           const VerifyOptions& options) {
  const Index n = problem.M.rows;
  RawVerifyReport report;
  report.tolerance = options.tolerance;
  if (static_cast<Index>(z.size()) != n) {
    report.because = "z has " + std::to_string(z.size()) + " numbers, the problem " +
                     std::to_string(n) + " unknowns";
    return report;
  }
  const DenseProblem dense{Eigen::Map<const Eigen::MatrixXd>(problem.M.values.data(), n, n),
                           Eigen::Map<const Eigen::VectorXd>(problem.q.values.data(), n),
                           problem.free};
  const Eigen::VectorXd point = Eigen::Map<const Eigen::VectorXd>(z.data(), n);
  std::vector<double> w;
  const WorstRow<double> worst = raw_residual(problem, z, w);
  report.residual = worst.residual;
  report.row = worst.row;
  report.metrics = measure_point(dense, point);
  if (report.row >= 0) {
    report.z = point[report.row];
    report.w = dense.w(point)[report.row];
  }
  std::vector<double> nearest = z;
  if (const auto refined = refine_point(dense, point)) {
    report.refined.found = true;
    const std::vector<double> found(refined->data(), refined->data() + n);
    report.refined.residual = raw_residual(problem, found, w).residual;
    report.refined.moved = (*refined - point).cwiseAbs().maxCoeff();
    if (report.refined.residual < report.residual) nearest = found;
  }
  if (!(report.residual <= options.tolerance)) {
    const bool stuck = is_feasible(dense, point, options.tolerance) && is_stationary(dense, point);
    report.verdict = stuck ? Verdict::spurious_minimum : Verdict::not_a_solution;
    report.because = "row " + std::to_string(report.row + 1);
    return report;
  }
  report.verdict = Verdict::other_solution;
  const RawAnswer own = solve_raw(problem, RawOptions());
  report.own.status = own.status;
  if (own.status != Status::solved) return report;
  const Eigen::Map<const Eigen::VectorXd> near(nearest.data(), n), mine(own.z.data(), n);
  report.own.force = (near - mine).cwiseAbs().maxCoeff();
  if (report.own.force <= std::max(1e-6, 10 * options.tolerance) * mine.cwiseAbs().maxCoeff())
    report.verdict = Verdict::same_solution;
  return report;
}

} // namespace lcpush::desktop
