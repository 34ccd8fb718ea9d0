// All assignments of modes that may have an answer: contact by contact, branch and prune.
#pragma once

#include <functional>

#include "spread/spread_problem.hpp"

namespace lcpush::desktop {

class ModeTree {
public:
  explicit ModeTree(const LiteralProblem& problem);

  std::function<bool(const FaceModes&)> may_have_answers; ///< a part of the contacts decided
  std::function<void(const FaceModes&)> leaf;             ///< all decided
  std::function<bool()> is_used_up;                       ///< asked before every branch

  /// Visits all leaves, each set of modes once, unless it is used up.
  void visit();

  Index assignments() const { return assignments_; } ///< looked at, whole or in part
  /// What part of the tree is done, if all branches of a node were equally large.
  double share() const { return share_; }

private:
  const LiteralProblem& problem_;
  std::vector<Index> order_;
  Index assignments_ = 0;
  double share_ = 0;

  void visit(std::size_t depth, FaceModes& modes, double share);
};

} // namespace lcpush::desktop
