#include "contacts/contact_order.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

using Links = std::vector<std::vector<Index>>; // of a contact: those that it moves

Links links_of(const SparseRows& W) {
  Links links(static_cast<std::size_t>(W.rows() / 3));
  for (Index c = 0; c < W.rows() / 3; ++c) {
    std::vector<Index>& own = links[static_cast<std::size_t>(c)];
    for (Index row = 3 * c; row < 3 * c + 3; ++row)
      for (const SparseEntry& entry : W.row(row)) own.push_back(entry.column / 3);
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  }
  return links;
}

/// All that is linked with `start`, from near to far, of a neighbour's own the least linked first.
std::vector<Index> reached_from(Index start, const Links& links) {
  const auto degree = [&](Index c) { return links[static_cast<std::size_t>(c)].size(); };
  std::vector<bool> is_reached(links.size());
  std::vector<Index> order{start};
  is_reached[static_cast<std::size_t>(start)] = true;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto first = static_cast<std::ptrdiff_t>(order.size());
    for (const Index next : links[static_cast<std::size_t>(order[k])])
      if (!is_reached[static_cast<std::size_t>(next)]) {
        is_reached[static_cast<std::size_t>(next)] = true;
        order.push_back(next);
      }
    std::stable_sort(order.begin() + first, order.end(),
                     [&](Index a, Index b) { return degree(a) < degree(b); });
  }
  return order;
}

} // namespace

std::vector<Index> contact_order(const SparseRows& W) {
  const Links links = links_of(W);
  std::vector<Index> order;
  std::vector<bool> has_place(links.size());
  for (Index c = 0; c < static_cast<Index>(links.size()); ++c) {
    if (has_place[static_cast<std::size_t>(c)]) continue;
    // The farthest from anywhere is at an end, where a band is narrow.
    const Index end = reached_from(c, links).back();
    for (const Index reached : reached_from(end, links)) {
      has_place[static_cast<std::size_t>(reached)] = true;
      order.push_back(reached);
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

} // namespace lcpush::desktop
