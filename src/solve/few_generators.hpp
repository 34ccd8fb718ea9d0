// A few generators of every pyramid, and the basis that they have for all.
#pragma once

#include <vector>

#include "solve/part_of_problem.hpp"

namespace lcpush::desktop {

/// Of a fine pyramid only the generators next to the slip bear friction, but the way there is a
/// pivot a generator and point, on a basis of all of them. So pads are solved for with a coarse
/// pyramid inside the fine one; the generator that is most opposed to a point's slip then joins it
/// with its neighbours, at all points at once, until there is none.
class FewGenerators : PartOfProblem {
public:
  using PartOfProblem::Flags;

  /// Has some pyramid many more generators than a few?
  static bool helps(const Problem<double>& problem);

  /// `whole` outlives the call.
  explicit FewGenerators(const Problem<double>& whole) : PartOfProblem(whole) {}

  /// From the basis `active`, what its unknowns are worth, and forces z, to basis and forces of the
  /// answer. Guess::basis: it is that of an answer nearby, whose slips say which generators to
  /// begin with. False: there is none. Cost: O(forces) whenever generators join. Pre:
  /// ModesOfForces::fits, no push.
  bool solve(const LemkeOptions<double>& options, const std::vector<double>& values, Guess guess,
             std::vector<double>& z, Flags& active);

private:
  static constexpr Index coarse = 8; ///< generators to begin with

  void choose(const Flags& active);
  Status pivot(Part& part, const LemkeOptions<double>& options, const std::vector<double>& z,
               const Flags& active) const;
  bool join(const std::vector<double>& rates, Flags& active);
  bool take(Index i, Index generator);
};

} // namespace lcpush::desktop
