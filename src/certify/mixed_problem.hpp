// The problem that a certificate is about: exact numbers, the object's acceleration an unknown.
#pragma once

#include "exact/exact_system.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <algorithm>
#include <vector>

namespace lcpush::desktop {

using Column = std::vector<Rational>;

/// w = L x + q, 0 <= x_i _|_ w_i >= 0; rows marked free: w_i = 0, x_i any number.
struct MixedProblem {
  std::vector<ExactRow> rows;
  Column q;
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
/// rotation about z. In q the push stands in the rows of forces, the load in the free ones.
MixedProblem scene_problem(const SceneOf<Rational>& scene);

/// A raw problem as typed.
MixedProblem raw_mixed_problem(const ExactMatrix& M, const ExactMatrix& q,
                               const std::vector<unsigned char>& free);

/// L x + constant.
Column times(const MixedProblem& problem, Column x, const Column& constant = {});

/// The submatrix of these rows and columns, in their order.
std::vector<ExactRow> cut(const MixedProblem& problem, const std::vector<std::size_t>& rows,
                          const std::vector<std::size_t>& columns);

} // namespace lcpush::desktop
