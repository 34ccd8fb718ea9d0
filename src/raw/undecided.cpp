// Pairs that a nearly right point leaves undecided: both z and w are of the size of its rounding.
// Whether they hold by their own terms is a problem of its own, with numbers of its own size.
#include <algorithm>
#include <cmath>

#include "lcpush/lcp/pivots/reduce.hpp"
#include "raw/raw_parts.hpp"

namespace lcpush::desktop {
namespace {

constexpr double clearly = 1e-9; // of the largest number on its side, in balanced scales
constexpr int deepest = 4;       // each level is a thousand million times smaller

struct Decision {
  std::vector<Index> rows;            ///< all but those whose z is zero because w is positive
  std::vector<unsigned char> settled; ///< for these: z is clearly positive, so w is zero
  Index open = 0;                     ///< of these: not settled
};

Decision decide(const RawProblem& problem, const std::vector<double>& z) {
  const Scales scales = balanced_scales(problem.M, 30);
  std::vector<double> w(z.size());
  double z_largest = 0, w_largest = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    double sum = problem.q[at];
    for (const SparseEntry& entry : problem.M.row(i))
      sum += entry.value * z[static_cast<std::size_t>(entry.column)];
    w[at] = sum * scales.row[at];
    z_largest = std::max(z_largest, std::abs(z[at]) / scales.column[at]);
    w_largest = std::max({w_largest, std::abs(w[at]), std::abs(problem.q[at]) * scales.row[at]});
  }
  Decision decision;
  for (Index i = 0; i < problem.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool is_basic = problem.is_free(i) || z[at] / scales.column[at] > clearly * z_largest;
    if (!is_basic && w[at] > clearly * w_largest) continue;
    decision.rows.push_back(i);
    decision.settled.push_back(is_basic ? 1 : 0);
    if (!is_basic) ++decision.open;
  }
  return decision;
}

} // namespace

bool settle_undecided(const RawProblem& problem, const std::vector<double>& point,
                      const RawOptions& options, int level, Attempts& attempts) {
  const Decision decision = decide(problem, point);
  const auto all_open = static_cast<std::size_t>(decision.open) == point.size();
  if (level >= deepest || all_open || decision.rows.empty()) return false;
  RawProblem part = cut_out(problem, decision.rows);
  part.free = decision.settled;
  const DensePiece piece(part, DensePiece::Scaled::yes);
  const Index n = piece.size();
  Owned<Reduction<double>> reduction(reduction_scalars(n), reduction_integers(n));
  if (reduction.init(n, piece.M.data(), piece.q.data(), piece.free.data(),
                     SingularBlock::exchange) != Status::solved)
    return false;
  const Problem<double>& reduced = reduction.problem();
  RawProblem rest;
  rest.M = rows_of(HostMatrix{
      reduced.size, reduced.size, {reduced.matrix, reduced.matrix + reduced.size * reduced.size}});
  rest.q.assign(reduced.q, reduced.q + reduced.size);
  for (Index i = 0; i < reduced.size; ++i) rest.free.push_back(i >= reduced.free_begin ? 1 : 0);
  const RawAnswer answer = solve_by_pivots(rest, options, {}, level + 1);
  attempts.answer().pivots += answer.pivots;
  if (answer.status != Status::solved) return false;
  std::vector<double> in_piece(static_cast<std::size_t>(n)), z(point.size(), 0.0);
  reduction.recover(answer.z.data(), in_piece.data());
  const std::vector<double> in_part = piece.original(in_piece.data());
  std::vector<unsigned char> basic(point.size(), 0);
  for (std::size_t k = 0; k < in_part.size(); ++k) {
    const auto i = static_cast<std::size_t>(decision.rows[k]);
    z[i] = in_part[k];
    basic[i] = problem.free[i] != 0 || z[i] > 0 ? 1 : 0;
  }
  return attempts.take(z, basic);
}

} // namespace lcpush::desktop
