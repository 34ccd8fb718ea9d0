// The answer of one complementary basis: a small linear system instead of pivots, and the checks
// that say whether it is the answer.
#pragma once

#include <Eigen/LU>

#include <vector>

#include "lcpush/lcp/problem.hpp"

namespace lcpush::desktop {

using Basis = std::vector<unsigned char>; ///< an unknown: is z_i basic?

struct BasisSolution {
  Eigen::VectorXd z, z_push; ///< z_push: only of a problem with a push
  double valid_to = -1;      ///< as Lemke::valid_to
};

/// The factors of a basis at a neighbouring value: they solve the system here by a few corrections.
struct FactoredBasis {
  Basis basis;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
  bool is_new = false; ///< nobody has used them since
  bool drifts = false; ///< the system changes too much for them from one value to the next
};

/// Solves `problem` on `basis`: z_i = 0 outside of it, w_i = 0 inside. False if that is no answer:
/// a singular system, a wrong sign, or a residual that the referee of lcp/ does not let pass. Cost:
/// O(k n + k^3) for k basic z; O(k n + k^2)
/// where `near`, which receives the factors, has those of the same basis at a value nearby.
bool solve_on_basis(const Problem<double>& problem, const Basis& basis, BasisSolution& solution,
                    FactoredBasis* near = nullptr);

} // namespace lcpush::desktop
