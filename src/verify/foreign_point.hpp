// A point z of a complementarity problem that somebody else found.
#pragma once

#include "lcpush/desktop/verify.hpp"

#include <Eigen/Core>

#include <optional>

namespace lcpush::desktop {

/// w = M z + q, 0 <= z _|_ w >= 0; rows marked free: w = 0. Numbers near 1.
struct DenseProblem {
  Eigen::MatrixXd M;
  Eigen::VectorXd q;
  std::vector<unsigned char> free;

  bool is_free(Index i) const { return free[static_cast<std::size_t>(i)] != 0; }
  Eigen::VectorXd w(const Eigen::VectorXd& z) const { return M * z + q; }
};

ForeignMetrics measure_point(const DenseProblem& problem, const Eigen::VectorXd& z);

/// The nearest point of the basis that z names: z_i basic where z_i > w_i, or free. Nothing above
/// 2000 unknowns. Cost: O(n^3) in the basic unknowns.
std::optional<Eigen::VectorXd> refine_point(const DenseProblem& problem, const Eigen::VectorXd& z);

/// Does z, which satisfies all but the products, lie at a stationary point of sum z_i w_i over
/// z >= 0, w >= 0? The steepest feasible descent, a linear program, would not take a hundredth off.
/// False above 400 unknowns, where nobody looked.
bool is_stationary(const DenseProblem& problem, const Eigen::VectorXd& z);

} // namespace lcpush::desktop
