// The problem that a certificate is about: exact numbers, the object's acceleration an unknown.
#pragma once

#include "exact/exact_system.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <algorithm>
#include <vector>

namespace lcpush::desktop {

/// w = L x + q, 0 <= x_i _|_ w_i >= 0; rows marked free: w_i = 0, x_i any number. With two columns,
/// q is q[0] + sigma q[1] with an infinitesimal sigma > 0.
struct MixedProblem {
  std::vector<ExactRow> rows;
  std::vector<std::vector<Rational>> q;
  std::vector<unsigned char> free;

  std::size_t size() const { return rows.size(); }
  bool is_free(std::size_t i) const { return free[i] != 0; }
  /// Of a scene: is row i that of a slip, which holds forces alone?
  bool limits_forces(std::size_t i) const {
    const auto is_pair = [&](const ExactEntry& entry) {
      return !is_free(static_cast<std::size_t>(entry.column));
    };
    return !is_free(i) && !rows[i].empty() && std::all_of(rows[i].begin(), rows[i].end(), is_pair);
  }
};

/// The literal equations of a scene in SI units: the pairs in the order of Layout, then the
/// actuators' s, then the object's acceleration [linear; angular], of a planar scene x, y and the
/// rotation about z. With `breaks`, the push is infinitesimal.
MixedProblem scene_problem(const SceneOf<Rational>& scene, bool breaks);

/// A raw problem as typed.
MixedProblem raw_mixed_problem(const ExactMatrix& M, const ExactMatrix& q,
                               const std::vector<unsigned char>& free);

} // namespace lcpush::desktop
