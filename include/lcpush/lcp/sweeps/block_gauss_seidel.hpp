// Projected Gauss-Seidel on the groups of a factored problem: init, sweep, solve.
//
// xi and s have zeros on the diagonal, so that no row can be solved for them. Both are multipliers:
// of the simplex { beta >= 0, sum beta <= mu lambda } of a cone group, and of the simplex
// { lambda >= 0, sum coupling lambda = target } of a sum group. A sweep moves every group within
// its set as far as the object's six accelerations ask for and never touches a multiplier; they
// are recovered at the end. Everything couples through u = B G f, six numbers that every move
// updates at once: a sweep costs O(forces), without a matrix.
//
// Plain sweeps slow down where forces are shared in many ways. `accelerate` goes on with
// ProximalNewton from where the sweeps have come; what it finds is judged as everything is.
#pragma once

#include "lcpush/lcp/sweeps/judged_sweeps.hpp"
#include "lcpush/lcp/sweeps/proximal_newton.hpp"

namespace lcpush {

constexpr Index block_gauss_seidel_scalars(Index n, Index couplings, Index sums) {
  return 5 * n + proximal_scalars(n, couplings, sums);
}
constexpr Index block_gauss_seidel_integers(Index n, Index couplings, Index sums) {
  return 2 * n + proximal_integers(n, couplings, sums);
}

template <class S> class BlockGaussSeidel : public JudgedSweeps<S> {
public:
  /// Memory of at least block_gauss_seidel_scalars and block_gauss_seidel_integers elements.
  BlockGaussSeidel(Span<S> scalars, Span<int> integers) : scalars_(scalars), integers_(integers) {}

  /// `problem` is factored and outlives the run. Starts from the forces in `start` (n numbers), or
  /// from each sum's even share. Post: running; or bad_input if the memory is too small, or if
  /// plain sweeps cannot keep a sum group (it is no simplex: it couples friction or has inertia).
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status init(const Problem<S>& problem, const SweepOptions<S>& options = {},
                            const S* start = nullptr, Watcher& watcher = unwatched);

  /// One pass over all groups; post: running, or how the run ended. Cost: O(forces).
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status sweep(Watcher& watcher = unwatched);

  /// Sweeps to the end, accelerated if the options say so.
  /// Post: solved (the check was passed), sweep_limit or stagnated.
  template <class Watcher = const Unwatched>
  [[nodiscard]] Status solve(Watcher& watcher = unwatched);

  /// After stagnated: did the forces grow without bound, as in a jam? They are far beyond what the
  /// problem's numbers ask for: a squeeze that every pass tightens.
  bool runs_away() const { return squeeze() > S(GaussSeidelSettings::runaway); }

private:
  using Judged = JudgedSweeps<S>;
  using Judged::problem_, Judged::options_, Judged::status_, Judged::sweeps_, Judged::residual_;
  using Judged::z_, Judged::unit_, Judged::check_w_, Judged::check_scratch_;
  Span<S> scalars_;
  Span<int> integers_;
  ProximalNewton<S> newton_{{}, {}};
  bool keeps_all_sums_ = false; // plain sweeps do
  Vector6<S> u_;                // B G f
  Span<int> cone_of_, sum_of_;  // by variable: the cone of a normal, its sum group or -1

  const FactoredProblem<S>& factored() const { return *problem_.factored; }
  bool carve();
  void sort_groups();
  void share_evenly();
  S rate(Index force, Index variable) const {
    return factored().wrenches[force].dot(u_) + problem_.q[variable];
  }
  void refresh() { u_ = factored().mobility.lazyProduct(contact_wrench(factored(), z_.data)); }
  void exchange(const SumGroup<S>& sum, Index k, Index l);
  void solve_normal(const ConeGroup<S>& cone);
  void shrink_to_cone(const ConeGroup<S>& cone, const S& most);
  void solve_friction(const ConeGroup<S>& cone);
  void recover_multipliers();
  S squeeze() const;
  /// The residual is measured beside the largest unknown: under a coarse tolerance a squeeze that
  /// grows would pass for one. Beside what the problem asks for, or to rounding, it does not.
  bool passes() const {
    const S tolerance = options_.tolerance, residual = residual_.residual;
    const bool exact = residual <= Tolerances<S>().residual;
    return residual <= tolerance && (exact || residual * squeeze() <= tolerance);
  }
  template <class Watcher> Status check(Watcher& watcher);
  template <class Watcher> Status finish(Watcher& watcher);
};

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class ProximalNewton<double>;
extern template class BlockGaussSeidel<double>;
#endif

} // namespace lcpush

#include "lcpush/lcp/sweeps/block_sweeps.hpp"
