// The answer of one complementary basis: a small linear system instead of pivots, and the checks
// that say whether it is the answer.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "lcpush/lcp/problem.hpp"

namespace lcpush::desktop {

using Basis = std::vector<unsigned char>; ///< an unknown: is z_i basic?

struct BasisSolution {
  Eigen::VectorXd z, z_push; ///< z_push: only of a problem with a push
  double valid_to = -1;      ///< as Lemke::valid_to
};

/// Solves `problem` on `basis`: z_i = 0 outside of it, w_i = 0 inside. False if that is no answer:
/// a singular system, a wrong sign, or a residual that the referee of lcp/ does not let pass. Cost:
/// O(k n + k^3) for k basic z.
bool solve_on_basis(const Problem<double>& problem, const Basis& basis, BasisSolution& solution);

} // namespace lcpush::desktop
