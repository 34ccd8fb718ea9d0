#include "spread/first_motion.hpp"

#include <algorithm>

namespace lcpush::desktop {

FirstMotion::FirstMotion(const LiteralProblem& problem, const ModeMotions& motions,
                         const std::vector<ConeEdge>& edges, const std::vector<bool>& carries)
    : problem_(problem), span_(motions.span) {
  // What has no sign goes first: motions, then the edges that carry.
  for (const bool carrying : {true, false})
    for (std::size_t k = 0; k < edges.size(); ++k)
      if (carries[k] == carrying) edges_.push_back(edges[k]);
  const Index still = span_.cols() - 1, signs = motions.signs.rows();
  const Index free = still + static_cast<Index>(std::count(carries.begin(), carries.end(), true));
  const Index balances = problem.load().size(), a = problem.moving();
  Eigen::MatrixXd kinetic = span_.topRows(balances);
  kinetic.bottomRows(balances - a) =
      problem.inertia().asDiagonal() * span_.middleRows(a, balances - a);
  const auto count = static_cast<Index>(edges_.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(balances + signs, still + count + signs);
  Eigen::VectorXd b(A.rows());
  A.topLeftCorner(balances, still) = kinetic.leftCols(still);
  A.block(balances, 0, signs, still) = motions.signs.leftCols(still);
  A.bottomRightCorner(signs, signs).diagonal().setConstant(-1);
  b << -kinetic.col(still), -motions.signs.col(still);
  for (Index k = 0; k < count; ++k) {
    Eigen::VectorXd effect = effect_of(problem, edges_[static_cast<std::size_t>(k)]);
    effect.head(a) *= -1;
    A.col(still + k).head(balances) = effect;
  }
  program_.emplace(A, b, free);
  first_ = program_->find_point();
}

Simplex::Ending FirstMotion::lowest(Index k, double sign, Answer& answer) {
  if (first_ != Simplex::Ending::found) return Simplex::Ending::failed;
  const Index still = span_.cols() - 1;
  Eigen::VectorXd c = Eigen::VectorXd::Zero(program_->point().size());
  c.head(still) = sign * span_.row(k).head(still).transpose();
  const Simplex::Ending ending = program_->minimise(c);
  if (ending != Simplex::Ending::found) return ending;
  const Eigen::VectorXd& v = program_->point();
  Eigen::VectorXd y(still + 1);
  y << v.head(still), 1;
  const Eigen::VectorXd x = span_ * y;
  answer = {x[k], Eigen::VectorXd::Zero(problem_.layout().size),
            x.segment(problem_.moving(), problem_.actuators())};
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const double along = v[still + static_cast<Index>(e)];
    answer.forces[edges_[e].normal] += along;
    if (edges_[e].friction >= 0) answer.forces[edges_[e].friction] += edges_[e].mu * along;
  }
  return ending;
}

} // namespace lcpush::desktop
