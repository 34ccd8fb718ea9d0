#include "dense/basis_solution.hpp"

#include <algorithm>

#include "lcpush/lcp/residual.hpp"

namespace lcpush::desktop {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

using Factors = Eigen::PartialPivLU<MatrixXd>;

/// K x = -q on the basis; w = q + M z.
struct Level {
  const Problem<double>& problem;
  const std::vector<Index>& rows;
  const double* q;
  VectorXd &z, &w;
  VectorXd r{}, dz{};

  void begin() {
    z.setZero(problem.size);
    w = Eigen::Map<const VectorXd>(q, problem.size);
  }
  /// By how much it has moved z.
  double correct(const Factors& lu) {
    r = -w(rows);
    dz.noalias() = lu.solve(r);
    z(rows) += dz;
    multiply(problem, z.data(), w.data());
    w += Eigen::Map<const VectorXd>(q, problem.size);
    return rows.empty() ? 0 : dz.cwiseAbs().maxCoeff();
  }
  /// By the factors of K: what they find is refined once on the problem as given.
  void solve(const Factors& lu) {
    begin();
    correct(lu);
    correct(lu);
  }
  /// By factors of a matrix near K, down to rounding; false: it is not near enough.
  bool approach(const Factors& lu) {
    constexpr int most = 7;
    constexpr double rounding = 8 * Eigen::NumTraits<double>::epsilon();
    constexpr double noise = 1e-11; // what rounding makes of an ill-conditioned basis
    begin();
    double last = correct(lu), best = 1;
    for (int k = 1; k < most; ++k) {
      const double step = correct(lu), size = z.cwiseAbs().maxCoeff();
      best = std::min(best, step / last);
      if (step == 0 || step * best <= rounding * size) return true;
      if (!(step < 0.1 * last)) return step <= noise * size; // NaN: false
      last = step;
    }
    return false;
  }
};

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

/// Both levels, by the factors nearby if they will do.
void solve_levels(const Problem<double>& problem, const Basis& basis,
                  const std::vector<Index>& rows, BasisSolution& solution, FactoredBasis* near,
                  VectorXd& w, VectorXd& w_push) {
  Level level{problem, rows, problem.q, solution.z, w};
  Level push{problem, rows, problem.push, solution.z_push, w_push};
  FactoredBasis own;
  FactoredBasis& fresh = near != nullptr ? *near : own;
  const bool is_known = fresh.basis == basis && !rows.empty();
  if (is_known && level.approach(fresh.lu) &&
      (problem.push == nullptr || push.approach(fresh.lu))) {
    fresh.is_new = false;
    return;
  }
  fresh.drifts = is_known && fresh.is_new;
  fresh.is_new = true;
  fresh.basis = basis;
  fresh.lu.compute(basic_block(problem, rows));
  level.solve(fresh.lu);
  if (problem.push != nullptr) push.solve(fresh.lu);
}

} // namespace

bool solve_on_basis(const Problem<double>& problem, const Basis& basis, BasisSolution& solution,
                    FactoredBasis* near) {
  const Index n = problem.size;
  if (static_cast<Index>(basis.size()) != n) return false;
  std::vector<Index> rows;
  for (Index i = 0; i < n; ++i)
    if (basis[static_cast<std::size_t>(i)] != 0) rows.push_back(i);
  VectorXd w, w_push;
  solve_levels(problem, basis, rows, solution, near, w, w_push);
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
