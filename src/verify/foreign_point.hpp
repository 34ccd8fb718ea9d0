// A point z of a complementarity problem that somebody else found.
#pragma once

#include "lcpush/desktop/verify.hpp"
#include "solve/dense_problem.hpp"

#include <optional>

namespace lcpush::desktop {

/// What a pair adds to the metrics: z_i between its ends, w_i. The squares of Fischer and
/// Burmeister add up in `squares`.
void add_pair(double z, double w, const BoxEnds& ends, ForeignMetrics& metrics, double& squares);
ForeignMetrics measure_point(const DenseProblem& problem, const Eigen::VectorXd& z);

/// The nearest point of the basis that z names: z_i basic where z_i > w_i, or free. Nothing above
/// 2000 unknowns. Cost: O(n^3) in the basic unknowns.
std::optional<Eigen::VectorXd> refine_point(const DenseProblem& problem, const Eigen::VectorXd& z);

/// Does z, which satisfies all but the products, lie at a stationary point of sum z_i w_i over
/// z >= 0, w >= 0? The steepest feasible descent, a linear program, would not take a hundredth off.
/// False above 400 unknowns, where nobody looked.
bool is_stationary(const DenseProblem& problem, const Eigen::VectorXd& z);

} // namespace lcpush::desktop
