// After a failure: the same problem in other scales, without the rounding noise in q, from other
// starts, and, of a small one, in all its complementary cones. The referee judges every point.
#include <algorithm>
#include <cmath>

#include "lcpush/lcp/nonnegative_least_squares.hpp"
#include "raw/raw_parts.hpp"

namespace lcpush::desktop {
namespace {

constexpr Index first_other_cover = 6, other_covers = 3;
constexpr Index pairs_enumerated = 10, rows_enumerated = 24; // the work doubles with each pair

/// Starting bases that are worth their time: each is factored afresh.
Index starts_for(Index n) { return n <= 100 ? 48 : n <= 400 ? 24 : n <= 1000 ? 8 : 2; }

/// The plain covering vector d = 1, then generic ones that were not tried.
bool try_covers(const DensePiece& piece, const RawOptions& options, Attempts& attempts) {
  const std::vector<double> ones(piece.order.size(), 1.0);
  LemkeOptions<double> plain = options.lemke;
  // With free unknowns left the reduced problem is shorter than the piece: d has enough entries.
  plain.cover = ones.data();
  if (attempts.cold(piece, plain) || attempts.hopeless()) return true;
  LemkeOptions<double> generic = options.lemke;
  generic.first_cover = options.lemke.first_cover + first_other_cover;
  generic.covers = other_covers;
  return attempts.cold(piece, generic) || attempts.hopeless();
}

bool try_without_noise(const DensePiece& scaled, const RawOptions& options, Attempts& attempts) {
  DensePiece quiet = scaled;
  if (!quiet.drop_noise()) return false;
  if (try_covers(quiet, options, attempts)) return true;
  // A basis of the quiet problem is a good start for the noisy one.
  const std::vector<unsigned char> basis = attempts.last_basis();
  return !basis.empty() && attempts.from(scaled, basis, Guess::near);
}

/// Bases of pseudo-random unknowns, some with few of them, some with many.
bool try_starts(const DensePiece& scaled, Attempts& attempts) {
  constexpr double shares[] = {0.5, 0.25, 0.75};
  const Index n = scaled.size();
  for (Index start = 0; start < starts_for(n); ++start) {
    const auto seed = static_cast<std::uint32_t>(1000 + start);
    std::vector<unsigned char> active;
    for (Index i = 0; i < n; ++i)
      active.push_back(generic_number<double>(seed, i) < 1 + shares[start % 3] ? 1 : 0);
    ++attempts.answer().search.starts;
    if (attempts.from(scaled, active, Guess::near)) return true;
  }
  return false;
}

/// q in one of the 2^n cones of complementary columns: w_i or -M_i for each pair. An answer lies in
/// one of them, also where its basis is singular.
bool try_all_cones(const DensePiece& scaled, Attempts& attempts) {
  const Index n = scaled.size(), pairs = scaled.pairs, columns = n + (n - pairs);
  if (pairs > pairs_enumerated || n > rows_enumerated || n == 0) return false;
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
    const double crumb = 1e-13 * solver.x().maxCoeff();
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

/// The first two points at which a covering vector has all but gone.
bool settle_near_points(const RawProblem& problem, const RawOptions& options, int level,
                        Attempts& attempts) {
  constexpr std::size_t most = 2;
  const std::vector<std::vector<double>> points = attempts.near_points();
  for (std::size_t k = 0; k < points.size() && k < most; ++k)
    if (settle_undecided(problem, points[points.size() - 1 - k], options, level, attempts))
      return true;
  return false;
}

} // namespace

void search_further(const RawProblem& problem, const RawOptions& options, int level,
                    Attempts& attempts) {
  // Pairs of the size of rounding at the points where the first attempts ended, solved alone.
  if (settle_near_points(problem, options, level, attempts)) return;
  // Balanced scales, and entries of q that are rounding noise taken as zero.
  const DensePiece scaled(problem, DensePiece::Scaled::yes);
  if (try_without_noise(scaled, options, attempts)) return;
  // Other covering vectors: d = 1, then generic ones.
  if (try_covers(scaled, options, attempts)) return;
  // As at first, for the points where those ended.
  if (settle_near_points(problem, options, level, attempts)) return;
  // Lemke from pseudo-random complementary bases.
  if (try_starts(scaled, attempts)) return;
  // All complementary cones of a small problem.
  (void)try_all_cones(scaled, attempts);
}

} // namespace lcpush::desktop
