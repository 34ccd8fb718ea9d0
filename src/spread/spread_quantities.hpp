// What bounds are asked for, each as a functional of the unknowns and as an interval of the report.
#pragma once

#include "lcpush/desktop/spread.hpp"
#include "spread/spread_problem.hpp"

namespace lcpush::desktop {

struct Quantity {
  enum class Kind { twist, normal, tangential, torsion, push } kind;
  Index of = 0;   ///< component, point or pusher
  Index axis = 0; ///< of tangential
  Eigen::VectorXd f;
};

/// The push of each pusher first, then the twist, then point by point.
std::vector<Quantity> list_quantities(const LiteralProblem& problem,
                                      const std::vector<PusherSpread>& pushers);

Interval& interval_of(const Quantity& quantity, SpreadReport& report);

/// Widens all intervals by one answer.
void include(const Answer<double>& answer, const Scene<double>& scene, SpreadReport& report);

/// The verdict on the intervals; report.motion is known by then.
SpreadVerdict verdict_on(const SpreadReport& report);

} // namespace lcpush::desktop
