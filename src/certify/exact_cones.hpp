// Exact proofs about cones of forces.
#pragma once

#include "certify/mixed_problem.hpp"

#include <optional>
#include <vector>

namespace lcpush::desktop {

/// y with y'c <= 0 for every column c and y'b > 0: b is no sum of the columns with weights >= 0.
/// nullopt where doubles find none, or exact numbers do not confirm it.
std::optional<Column> separation(const std::vector<Column>& columns, const Column& b);

/// Forces f >= 0 next to `guess` (largest 1; of every unknown, what is no force 0) that balance,
/// load no actuator, lie inside the friction cones, and against which the push does work.
/// `problem` is scene_problem(scene).
std::optional<Column> squeeze_near(const MixedProblem& problem, const std::vector<double>& guess);

/// The columns of Newton's and the actuators' rows for all extreme forces, and what they must make
/// up for: the scene without a push holds still only if it is one of their sums.
/// `problem` is scene_problem(scene).
void holding_question(const MixedProblem& problem, std::vector<Column>& columns, Column& b);

} // namespace lcpush::desktop
