// Raw (mixed) linear complementarity problems on the desktop: given as matrices, solved, checked.
#pragma once

#include <vector>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/solver.hpp"
#include "lcpush/desktop/watcher.hpp"
#include "lcpush/lcp/residual.hpp"
#include "lcpush/lcp/sweeps/judged_sweeps.hpp"

namespace lcpush::desktop {

struct RawProblem {
  HostMatrix M;                    ///< n x n
  HostMatrix q;                    ///< n x 1
  std::vector<unsigned char> free; ///< n; not 0: z_i is free and row i is the equality w_i = 0
};

/// Of the problem as given: w = M z + q, and the largest scaled natural residual
/// (natural_residual).
WorstRow<double> raw_residual(const RawProblem& problem, const std::vector<double>& z,
                              std::vector<double>& w);

/// The residual after so many sweeps.
struct SweepResidual {
  Index sweep;
  double residual;
};

struct RawAnswer {
  Status status = Status::bad_input;
  Reason reason = Reason::none;
  std::vector<double> z, w;         ///< w = M z + q as computed from the problem
  std::vector<unsigned char> basic; ///< not 0: z_i is basic
  std::vector<double> ray;          ///< after `ray`, in the place of z; empty otherwise
  Index pivots = 0;
  Index sweeps = 0;
  Index covers = 0;
  double residual = 0; ///< largest scaled natural residual, see natural_residual
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
};

/// Solves w = M z + q, 0 <= z _|_ w >= 0 (rows marked free: w = 0, z free). Every answer called
/// solved has passed natural_residual on the problem as given.
/// Memory: two (with free unknowns five) matrices of the size of M.
///
/// Gauss-Seidel takes the rows one by one and wants a positive diagonal
/// (bad_input and bad_diagonal otherwise); what it calls solved has passed Lemke's bound. Hybrid
/// sweeps where the diagonal allows it, goes on with pivots from there, and pivots from zero if
/// that fails: it is never less reliable than Lemke.
RawAnswer solve_raw(const RawProblem& problem, const RawOptions& options);

} // namespace lcpush::desktop
