#include "sweep/basis_solution.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "lcpush/lcp/residual.hpp"

namespace lcpush::desktop {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Solves K x = -q on the basis and refines it once on the problem as given; w = q + M z.
void solve_level(const Problem<double>& problem, const std::vector<Index>& rows, const double* q,
                 const Eigen::PartialPivLU<MatrixXd>& lu, VectorXd& z, VectorXd& w) {
  const auto k = static_cast<Index>(rows.size());
  z.setZero(problem.size);
  w = Eigen::Map<const VectorXd>(q, problem.size);
  VectorXd product(problem.size);
  for (int round = 0; round < 2; ++round) {
    VectorXd r(k);
    for (Index i = 0; i < k; ++i) r[i] = -w[rows[static_cast<std::size_t>(i)]];
    const VectorXd x = lu.solve(r);
    for (Index i = 0; i < k; ++i) z[rows[static_cast<std::size_t>(i)]] += x[i];
    multiply(problem, z.data(), product.data());
    w = Eigen::Map<const VectorXd>(q, problem.size) + product;
  }
}

/// The rows and columns of M that are basic, straight from the factors: far fewer than M's.
MatrixXd basic_block(const Problem<double>& problem, const std::vector<Index>& rows) {
  const auto k = static_cast<Index>(rows.size());
  MatrixXd K(k, k);
  if (problem.factored == nullptr) {
    for (Index j = 0; j < k; ++j)
      for (Index i = 0; i < k; ++i)
        K(i, j) = problem.matrix[rows[static_cast<std::size_t>(j)] * problem.size +
                                 rows[static_cast<std::size_t>(i)]];
    return K;
  }
  const FactoredProblem<double>& factors = *problem.factored;
  std::vector<Index> place(static_cast<std::size_t>(problem.size), -1);
  for (Index i = 0; i < k; ++i)
    place[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])] = i;
  Eigen::Matrix<double, 6, Eigen::Dynamic> G(6, k);
  G.setZero();
  for (const ConeGroup<double>& cone : factors.cones)
    for (Index f = 0; f < cone.forces(); ++f) {
      const Index at = place[static_cast<std::size_t>(cone.variable + f)];
      if (at >= 0) G.col(at) = factors.wrenches[cone.force + f];
    }
  const Eigen::Matrix<double, 6, Eigen::Dynamic> moved = factors.mobility * G;
  K.noalias() = G.transpose() * moved;
  for_each_group_entry(factors, problem.free_begin, [&](Index row, Index column, double entry) {
    const Index i = place[static_cast<std::size_t>(row)];
    const Index j = place[static_cast<std::size_t>(column)];
    if (i >= 0 && j >= 0) K(i, j) += entry;
  });
  return K;
}

bool passes(const Problem<double>& problem, const VectorXd& q, const VectorXd& z) {
  const VectorXd unit = VectorXd::Ones(problem.size);
  VectorXd w(problem.size), scratch(2 * problem.size);
  const WorstRow<double> worst = natural_residual(
      problem, q.data(), z.data(), unit.data(), [&](Index i) { return i >= problem.free_begin; },
      w.data(), scratch.data());
  return worst.residual <= Tolerances<double>().residual;
}

} // namespace

bool solve_on_basis(const Problem<double>& problem, const Basis& basis, BasisSolution& solution) {
  const Index n = problem.size;
  if (static_cast<Index>(basis.size()) != n) return false;
  std::vector<Index> rows;
  for (Index i = 0; i < n; ++i)
    if (basis[static_cast<std::size_t>(i)] != 0) rows.push_back(i);
  const Eigen::PartialPivLU<MatrixXd> lu(basic_block(problem, rows));
  VectorXd w, w_push;
  solve_level(problem, rows, problem.q, lu, solution.z, w);
  if (problem.push != nullptr)
    solve_level(problem, rows, problem.push, lu, solution.z_push, w_push);
  solution.valid_to = -1;
  const double tie = Tolerances<double>().tie;
  const double size = std::max(1.0, solution.z.cwiseAbs().maxCoeff());
  const double push_size =
      problem.push == nullptr
          ? 1
          : std::max(Eigen::Map<const VectorXd>(problem.push, n).cwiseAbs().maxCoeff(),
                     solution.z_push.cwiseAbs().maxCoeff());
  for (Index i = 0; i < problem.free_begin; ++i) {
    const bool basic = basis[static_cast<std::size_t>(i)] != 0;
    double& value = basic ? solution.z[i] : w[i];
    if (!(value >= -tie * size)) return false; // NaN too
    if (basic) value = std::max(value, 0.0);
    if (problem.push == nullptr) continue;
    const double rate = basic ? solution.z_push[i] : w_push[i];
    if (!(rate < -tie * push_size)) continue;
    if (!(value > tie * size)) return false;
    const double reach = value / -rate;
    if (solution.valid_to < 0 || reach < solution.valid_to) solution.valid_to = reach;
  }
  const Eigen::Map<const VectorXd> q(problem.q, n);
  return passes(problem, q, solution.z);
}

} // namespace lcpush::desktop
