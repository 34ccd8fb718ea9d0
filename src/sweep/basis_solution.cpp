#include "sweep/basis_solution.hpp"

#include <Eigen/LU>

#include <algorithm>

#include "lcpush/lcp/residual.hpp"

namespace lcpush::desktop {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Solves K x = -q on the basis and refines it once on the problem as given; w = q + M z.
void solve_level(const Problem<double>& problem, const std::vector<Index>& rows, const double* q,
                 const Eigen::PartialPivLU<MatrixXd>& lu, VectorXd& z, VectorXd& w) {
  z.setZero(problem.size);
  w = Eigen::Map<const VectorXd>(q, problem.size);
  VectorXd product(problem.size);
  for (int round = 0; round < 2; ++round) {
    const VectorXd r = -w(rows);
    z(rows) += lu.solve(r);
    multiply(problem, z.data(), product.data());
    w = Eigen::Map<const VectorXd>(q, problem.size) + product;
  }
}

/// The rows and columns of M that are basic, straight from the factors: far fewer than M's.
MatrixXd basic_block(const Problem<double>& problem, const std::vector<Index>& rows) {
  if (problem.factored == nullptr)
    return Eigen::Map<const MatrixXd>(problem.matrix, problem.size, problem.size)(rows, rows);
  const FactoredProblem<double>& factors = *problem.factored;
  const auto k = static_cast<Index>(rows.size());
  Eigen::Matrix<Index, Eigen::Dynamic, 1> place; // of each unknown among the rows, or -1
  place.setConstant(problem.size, -1);
  for (std::size_t i = 0; i < rows.size(); ++i) place[rows[i]] = static_cast<Index>(i);
  Eigen::Matrix<double, 6, Eigen::Dynamic> G(6, k);
  G.setZero();
  for (const ConeGroup<double>& cone : factors.cones)
    for (Index f = 0; f < cone.forces(); ++f) {
      const Index at = place[cone.variable + f];
      if (at >= 0) G.col(at) = factors.wrenches[cone.force + f];
    }
  const Eigen::Matrix<double, 6, Eigen::Dynamic> moved = factors.mobility * G;
  MatrixXd K(k, k);
  K.noalias() = G.transpose() * moved;
  for_each_group_entry(factors, problem.free_begin, [&](Index row, Index column, double entry) {
    const Index i = place[row], j = place[column];
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
