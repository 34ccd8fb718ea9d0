#include "hold/pad_limits.hpp"

#include <limits>
#include <utility>

#include "hold/pad_statics.hpp"
#include "hold/settings.hpp"

namespace lcpush::desktop {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The answer for the points that touch, which become those that touch at its end.
double best_of(const SceneFile& hand, const PadQuestion& question, std::vector<bool>& touching,
               double& work) {
  const PadStatics statics(hand, touching);
  const Eigen::MatrixXd& gaps = statics.gaps();
  const Index moves = statics.displacement().cols();
  Eigen::VectorXd column =
      question.of_grip ? statics.grip_column() : statics.wrench_column(question.wrench);
  const double unit = question.of_grip ? 1 : column.cwiseAbs().maxCoeff();
  Eigen::MatrixXd D(statics.rows(), moves + 1 + gaps.cols());
  D << statics.displacement(), column / unit, gaps;
  StaticsProgram program(statics, D, moves, statics.load(question.of_grip ? 0 : 1));
  const bool is_found = program.find_point() == StaticsProgram::Ending::found;
  work += program.work();
  if (!is_found) return nothing;
  const double sign = question.of_least ? 1 : -1;
  const double before = program.work();
  const auto end = program.minimise(sign * Eigen::VectorXd::Unit(D.cols(), moves));
  work += program.work() - before;
  if (end.ending == StaticsProgram::Ending::failed) return nothing;
  if (end.ending == StaticsProgram::Ending::unlimited)
    return std::numeric_limits<double>::infinity();
  const auto contacts = program.contacts();
  std::vector<double> forces(touching.size(), 0);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    forces[static_cast<std::size_t>(statics.cones()[c].point)] += contacts[c].normal;
  const double factor = question.of_grip ? end.x[moves] : 1;
  for (std::size_t i = 0; i < touching.size(); ++i)
    touching[i] = touching[i] ? forces[i] > statics_settings.slips
                              : statics.presses(static_cast<Index>(i), end.x.head(moves), factor) >
                                    -statics_settings.slips;
  return end.x[moves] * (question.of_grip ? 1 : statics.scales().force / unit);
}

/// From the points that touch to those that do at the end, as long as that is better; `touching`
/// becomes the best ones.
double climb(const SceneFile& hand, const PadQuestion& question, std::vector<bool>& touching,
             double& work) {
  double best = nothing;
  std::vector<bool> next = touching;
  for (Index k = 0; k < hold_settings.most_patterns; ++k) {
    const std::vector<bool> now = next;
    if (work > hold_settings.pad_work) return nothing;
    const double found = best_of(hand, question, next, work);
    const double gain = question.of_least ? best - found : found - best;
    if (std::isnan(found) || gain <= hold_settings.law * std::abs(best)) break;
    best = found;
    touching = now;
    if (next == now) break;
  }
  return best;
}

} // namespace

/// The scene's few points say quickly which parts touch, its surfaces what they hold.
double PadLimits::best(const PadQuestion& question, double& work) const {
  std::vector<bool> touching = touching_;
  const double few = climb(hand_, question, touching, work);
  std::vector<bool> there = touching_beside(hand_, touching, surfaces_);
  const double found = climb(surfaces_, question, there, work);
  // A pattern of the surfaces that bears much less has gone astray: the law shall be asked of more.
  return std::isnan(found) || (!question.of_least && found < hold_settings.astray * few) ? few
                                                                                         : found;
}

double PadLimits::limit(const Vector6<double>& wrench, bool for_picture) const {
  double uncounted = 0;
  return best({wrench}, for_picture ? uncounted : work_);
}

double PadLimits::grip(bool least) const {
  std::vector<bool> touching(touching_.size(), true); // whatever the present grip presses
  return climb(hand_, {Vector6<double>::Zero(), true, least}, touching, work_);
}

} // namespace lcpush::desktop
