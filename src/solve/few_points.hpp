// A few of a scene's points, and what their answer means for all of them.
#pragma once

#include <utility>
#include <vector>

#include "solve/part_of_problem.hpp"

namespace lcpush::desktop {

/// Rigid patches press at no more points than there are motions, however many they have. So the
/// problem is solved for a few points of every body that lie far apart; a point that its body would
/// be pressed into then joins them, one a body at a time, until there is none.
class FewPoints : PartOfProblem {
public:
  using PartOfProblem::Flags;

  /// `body`: whose each point is. `whole` outlives the call.
  FewPoints(const Problem<double>& whole, Span<const Index> body);

  /// Fills `active`: 1 where z_i of the whole problem is basic in the answer. False: the few have
  /// none. Cost: O(forces) for every point that joins.
  bool solve(const LemkeOptions<double>& options, Flags& active);

private:
  /// Accelerations of the object and closings of the actuators, or what a vanishing push adds.
  struct Motion {
    Vector6<double> object = Vector6<double>::Zero();
    std::vector<double> closing;
    double size = 0; ///< of what `object` is the sum of
  };
  Span<const Index> body_;
  std::vector<std::vector<std::pair<Index, double>>> sums_of_; // by unknown: group and coupling
  std::vector<Motion> motions_;                                // at rest, of the push

  void take(Index i);
  void choose();
  Status pivot(Part& few, const LemkeOptions<double>& options, const Flags& active) const;
  void read_motions(const StructuredLemke<double>& lemke);
  int sign_of_rate(Index i, Index k, double (&rate)[2]) const;
  bool join();
  void mark(const StructuredLemke<double>& lemke, Flags& active) const;
  Index most_opposed(Index i) const;
};

} // namespace lcpush::desktop
