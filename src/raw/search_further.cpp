// After a failure: pairs that a nearly right point leaves undecided (both z and w are of the size
// of its rounding) as a problem of their own, with numbers of its own size; the same problem in
// other scales and from other bases; and, of a small one, all its complementary cones. The referee
// judges every point.
#include <algorithm>
#include <cmath>

#include "lcpush/lcp/nonnegative_least_squares.hpp"
#include "lcpush/lcp/pivots/reduce.hpp"
#include "raw/raw_parts.hpp"
#include "raw/settings.hpp"

namespace lcpush::desktop {
namespace {

struct Decision {
  std::vector<Index> rows;            ///< all but those whose z is zero because w is positive
  std::vector<unsigned char> settled; ///< for these: z is clearly positive, so w is zero
  Index open = 0;                     ///< of these: not settled
};

Decision decide(const RawProblem& problem, const std::vector<double>& z) {
  const Scales scales = balanced_scales(problem.M);
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
    const bool is_basic =
        problem.is_free(i) || z[at] / scales.column[at] > raw_settings.clearly * z_largest;
    if (!is_basic && w[at] > raw_settings.clearly * w_largest) continue;
    decision.rows.push_back(i);
    decision.settled.push_back(is_basic ? 1 : 0);
    if (!is_basic) ++decision.open;
  }
  return decision;
}

/// From a point that is nearly an answer: pairs with a clearly positive z or w stay decided, the
/// others are solved alone, at their own size. True if that is an answer.
bool settle_undecided(const RawProblem& problem, const std::vector<double>& point,
                      const RawOptions& options, int level, Attempts& attempts) {
  const Decision decision = decide(problem, point);
  const auto all_open = static_cast<std::size_t>(decision.open) == point.size();
  if (level >= raw_settings.deepest || all_open || decision.rows.empty()) return false;
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

/// The plain covering vector d = 1, then generic ones that were not tried.
bool try_covers(const DensePiece& piece, const RawOptions& options, Attempts& attempts) {
  const std::vector<double> ones(piece.order.size(), 1.0);
  LemkeOptions<double> plain = options.lemke;
  // With free unknowns left the reduced problem is shorter than the piece: d has enough entries.
  plain.cover = ones.data();
  if (attempts.cold(piece, plain) || attempts.hopeless()) return true;
  LemkeOptions<double> generic = options.lemke;
  generic.first_cover = options.lemke.first_cover + raw_settings.first_other_cover;
  generic.covers = raw_settings.other_covers;
  return attempts.cold(piece, generic) || attempts.hopeless();
}

/// Bases of pseudo-random unknowns, some with few of them, some with many: among them of games,
/// which end every covering vector on a ray.
bool try_starts(const DensePiece& scaled, Attempts& attempts) {
  const Index n = scaled.size();
  for (Index start = 0; start < raw_settings.starts(n); ++start) {
    const auto seed = static_cast<std::uint32_t>(raw_settings.first_seed + start);
    const double share = raw_settings.shares[start % 3];
    std::vector<unsigned char> active;
    for (Index i = 0; i < n; ++i)
      active.push_back(generic_number<double>(seed, i) < 1 + share ? 1 : 0);
    ++attempts.answer().search.starts;
    if (attempts.from(scaled, active, Guess::near)) return true;
  }
  return false;
}

/// q in one of the 2^n cones of complementary columns: w_i or -M_i for each pair. An answer lies in
/// one of them, also where its basis is singular.
bool try_all_cones(const DensePiece& scaled, Attempts& attempts) {
  const Index n = scaled.size(), pairs = scaled.pairs, columns = n + (n - pairs);
  if (pairs > raw_settings.pairs_enumerated || n > raw_settings.rows_enumerated || n == 0)
    return false;
  std::vector<double> A(static_cast<std::size_t>(n * columns)), b(scaled.q);
  MatrixMap<double> columns_of(A.data(), n, columns);
  const Eigen::Map<const Eigen::MatrixXd> M(scaled.M.data(), n, n);
  Owned<NonnegativeLeastSquares<double>> solver(least_squares_scalars(n, columns),
                                                least_squares_integers(n, columns));
  for (Index cone = 0; cone < Index{1} << pairs; ++cone) {
    std::vector<unsigned char> basic(static_cast<std::size_t>(n), 1);
    for (Index j = 0; j < n; ++j) {
      const bool is_z = j >= pairs || (cone >> j & 1) != 0;
      columns_of.col(j) = is_z ? Eigen::VectorXd(-M.col(j)) : Eigen::VectorXd::Unit(n, j);
      if (j >= pairs) columns_of.col(j + n - pairs) = M.col(j); // a free unknown's negative part
      if (!is_z) basic[static_cast<std::size_t>(scaled.order[static_cast<std::size_t>(j)])] = 0;
    }
    if (solver.solve(columns_of, VectorMap<double>(b.data(), n)) != Status::solved) continue;
    // Least squares leave crumbs where a column is not needed.
    const double crumb = raw_settings.crumb * solver.x().maxCoeff();
    const auto x = [&](Index j) { return solver.x()[j] > crumb ? solver.x()[j] : 0.0; };
    std::vector<double> z(static_cast<std::size_t>(n), 0.0);
    for (Index j = 0; j < n; ++j) {
      const auto at = static_cast<std::size_t>(j);
      if (j >= pairs)
        z[at] = x(j) - x(j + n - pairs);
      else if ((cone >> j & 1) != 0)
        z[at] = x(j);
    }
    if (attempts.take(scaled.original(z.data()), basic)) return true;
  }
  attempts.answer().search.whole = true;
  return false;
}

/// The last points at which a covering vector has all but gone.
bool settle_near_points(const RawProblem& problem, const RawOptions& options, int level,
                        Attempts& attempts) {
  const std::vector<std::vector<double>> points = attempts.near_points();
  for (std::size_t k = 0; k < points.size() && k < raw_settings.near_points; ++k)
    if (settle_undecided(problem, points[points.size() - 1 - k], options, level, attempts))
      return true;
  return false;
}

} // namespace

void search_further(const RawProblem& problem, const RawOptions& options, int level,
                    Attempts& attempts) {
  // Pairs of the size of rounding at the points where the first attempts ended, solved alone.
  if (settle_near_points(problem, options, level, attempts)) return;
  // Balanced scales and other covering vectors, d = 1 and generic ones, and where those ended.
  const DensePiece scaled(problem, DensePiece::Scaled::yes);
  if (try_covers(scaled, options, attempts)) return;
  if (settle_near_points(problem, options, level, attempts)) return;
  if (try_starts(scaled, attempts)) return;
  // All complementary cones of a small problem.
  (void)try_all_cones(scaled, attempts);
}

} // namespace lcpush::desktop
