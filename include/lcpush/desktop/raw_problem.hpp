// Raw (mixed) linear complementarity problems on the desktop, with or without boxes: given as
// matrices, solved, checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/solver.hpp"
#include "lcpush/desktop/watcher.hpp"
#include "lcpush/lcp/residual.hpp"
#include "lcpush/lcp/sweeps/judged_sweeps.hpp"

namespace lcpush::desktop {

/// lo <= z <= hi; w >= 0 where z is at lo, <= 0 at hi, 0 in between. Ends may be infinite.
struct RawBounds {
  std::vector<double> lo, hi;
  /// Empty, or for each row -1 or another row j, from 0: the ends are then -hi_i z_j and hi_i z_j,
  /// and lo_i is not read.
  std::vector<Index> follows;
  Index huge = 0; ///< ends that were so large that they were taken as infinite

  bool given() const { return !lo.empty(); }
  Index leader(Index i) const {
    return follows.empty() ? -1 : follows[static_cast<std::size_t>(i)];
  }
};

struct RawProblem {
  SparseRows M;                    ///< n x n
  std::vector<double> q;           ///< n
  std::vector<unsigned char> free; ///< n; not 0: z_i is free and row i is the equality w_i = 0
  RawBounds bounds;                ///< none: 0 and infinity. Given: nothing is marked free

  Index size() const { return M.rows(); }
  bool is_free(Index i) const { return free[static_cast<std::size_t>(i)] != 0; }
};

struct BoxEnds {
  double lo, hi;
};
/// The ends of z_i, at the point z where they follow another row's.
BoxEnds ends_of(const RawProblem& problem, Index i, const std::vector<double>& z);

/// Of the problem as given: w = M z + q, and the largest scaled natural residual [T.11]. It reads
/// the rows of M, and shares no code with the solvers.
WorstRow<double> raw_residual(const RawProblem& problem, const std::vector<double>& z,
                              std::vector<double>& w);

/// The residual after so many sweeps.
struct SweepResidual {
  Index sweep;
  double residual;
};

/// What a failure does not mean: that nobody looked further.
struct RawSearch {
  Index pieces = 0;   ///< that no entry of M connects: each was solved alone
  Index starts = 0;   ///< other complementary bases that pivots started from, after all covers
  bool whole = false; ///< all complementary bases of the piece that failed were tried
};

struct RawAnswer {
  Status status = Status::bad_input;
  Reason reason = Reason::none;
  std::vector<double> z, w;         ///< w = M z + q as computed from the problem
  std::vector<unsigned char> basic; ///< not 0: z_i is basic
  std::vector<double> ray;          ///< after `ray`, in the place of z; empty otherwise
  Index pivots = 0;
  Index sweeps = 0;
  Index covers = 0; ///< covering vectors; the most that a piece took
  RawSearch search;
  double residual = 0; ///< largest scaled natural residual, see raw_residual
  std::vector<Index> redundant_rows;
  Index inconsistent_row = -1;
  Index bad_diagonal = -1; ///< Gauss-Seidel alone: the first row that it cannot be used on
  std::vector<SweepResidual> history; ///< of every check between sweeps
};

struct RawOptions {
  Solver solver = Solver::lemke;
  LemkeOptions<double> lemke{};
  SweepOptions<double> sweeps{}; ///< max_sweeps, check_every and relaxation count
  Watcher* watcher = nullptr;    ///< told of all pivots and checks of sweeps
  /// Solve what M does not connect apart, and look further after a failure: undecided pairs, other
  /// scales, other starts, all cones. False: one run on all of it, as a trace shows it.
  bool searches = true;
};

/// Solves w = M z + q, 0 <= z _|_ w >= 0 (rows marked free: w = 0, z free), or the same in a box.
/// Every answer called solved has passed raw_residual on the problem as given.
/// Memory: two (with free unknowns five) dense matrices of the size of the largest piece.
///
/// Gauss-Seidel takes the rows one by one, with no dense matrix, and wants a positive diagonal
/// (bad_input and bad_diagonal otherwise); what it calls solved has passed Lemke's bound. Hybrid
/// sweeps where the diagonal allows it, goes on with pivots from there, and pivots from zero if
/// that fails: it is never less reliable than Lemke.
RawAnswer solve_raw(const RawProblem& problem, const RawOptions& options);

/// What `lcpush lcp` prints: for people, and as JSON.
std::string raw_text(const RawProblem& problem, const RawAnswer& answer);
std::string raw_json(const RawProblem& problem, const RawAnswer& answer, const std::string& solver);

/// Rows of the largest piece that no entry of M connects to the rest: what pivots will store.
Index largest_piece(const RawProblem& problem);
/// Pieces from here on take pivots seconds.
constexpr Index large_piece = 2000;
/// Of a problem with so large a piece, Gauss-Seidel's answer: over-relaxed, which settles symmetric
/// problems sooner, and plain. Nothing: it has no such piece, or they do not settle.
std::optional<RawAnswer> sweep_large(const RawProblem& problem, RawOptions options);
/// About what that takes; a row between two ends is two unknowns there.
double pivot_bytes(const RawProblem& problem);

} // namespace lcpush::desktop
