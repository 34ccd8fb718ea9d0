// What bounds are asked for, each as a functional of the unknowns and as an interval of the report.
#pragma once

#include "lcpush/desktop/spread.hpp"
#include "spread/spread_problem.hpp"

namespace lcpush::desktop {

struct Quantity {
  Interval* bounds; ///< in the report
  Eigen::VectorXd f;
  bool is_motion = false; ///< of the twist, else a force
  double unit, load;      ///< SI

  double value(const Eigen::VectorXd& z) const { return unit * (f.dot(z) + load); }
};

/// Without an answer yet: its pushers and contacts, its scales, what is nothing.
SpreadReport begin_report(const LiteralProblem& problem, bool breaking = false);

/// The push of each pusher first, then the twist, then point by point; report.pushers and
/// report.contacts have their final size by then, and stay where they are.
std::vector<Quantity> list_quantities(const LiteralProblem& problem, SpreadReport& report);

/// Widens all intervals of forces, or all, by one answer.
void include_forces(const Answer<double>& answer, const Scene<double>& scene, SpreadReport& report);
void include(const Answer<double>& answer, const Scene<double>& scene, SpreadReport& report);

/// Does one report's range of a force, or of the motion, go beyond the other's by what counts?
bool is_wider(const SpreadReport& wider, const SpreadReport& than);

/// What is less than the report's noise becomes 0; the motion's scale, at least `push` (m/s^2), and
/// the verdict.
void conclude(double push, SpreadReport& report);

} // namespace lcpush::desktop
