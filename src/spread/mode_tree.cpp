#include "spread/mode_tree.hpp"

#include <algorithm>
#include <utility>

#include "spread/settings.hpp"

namespace lcpush::desktop {
namespace {

/// Do two contacts slip alike, whatever the motion? As where two fingers are opposite each other.
bool slip_alike(const LiteralProblem& problem, Index i, Index k) {
  const Layout<double>& layout = problem.layout();
  const Index g = layout.cones[i].generators;
  if (g != layout.cones[k].generators) return false;
  if (g == 0) return true;
  const auto one = problem.rates().middleRows(layout.friction_index(i, 0), g);
  for (Index j = 0; j < g; ++j) {
    const Eigen::RowVectorXd other = problem.rates().row(layout.friction_index(k, j));
    if (!((one.rowwise() - other).rowwise().norm().minCoeff() <= SpreadSettings::slip_alike))
      return false;
  }
  return true;
}

} // namespace

/// Pushers' points first, since they say which motions follow the push; contacts that slip alike
/// one after the other, since the first decides the second.
ModeTree::ModeTree(const LiteralProblem& problem) : problem_(problem) {
  const Layout<double>& layout = problem.layout();
  std::vector<Index> left;
  for (const bool pushers : {true, false})
    for (Index i = 0; i < layout.points; ++i)
      if ((problem.scene().bodies[layout.body[i]].role == Role::pusher) == pushers)
        left.push_back(i);
  while (!left.empty()) {
    const Index first = left.front();
    const auto rest = std::stable_partition(left.begin(), left.end(), [&](Index k) {
      return k == first || slip_alike(problem, first, k);
    });
    order_.insert(order_.end(), left.begin(), rest);
    left.erase(left.begin(), rest);
  }
}

void ModeTree::visit() {
  FaceModes modes(static_cast<std::size_t>(problem_.layout().points));
  visit(0, modes, 1);
}

void ModeTree::visit(std::size_t depth, FaceModes& modes, double share) {
  if (depth == order_.size()) {
    leaf(modes);
    share_ += share;
    return;
  }
  ContactMode& mode = modes[static_cast<std::size_t>(order_[depth])];
  std::vector<ContactMode> branches;
  for (ContactMode& candidate : problem_.every_mode(order_[depth])) {
    if (is_used_up()) return;
    mode = candidate;
    ++assignments_;
    if (may_have_answers(modes)) branches.push_back(std::move(candidate));
  }
  if (branches.empty()) share_ += share;
  for (ContactMode& branch : branches) {
    if (is_used_up()) return;
    mode = std::move(branch);
    visit(depth + 1, modes, share / static_cast<double>(branches.size()));
  }
  mode = {};
}

} // namespace lcpush::desktop
