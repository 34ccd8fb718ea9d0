// Lemke's method: init, step (one pivot), solve (a loop over step).
//
// The problem w = q + M z, 0 <= w _|_ z >= 0 is covered as w = q + M z + d z0 with d > 0. z0 enters
// large enough to make every value >= 0; from then on the complement of the variable that left
// enters, until z0 itself leaves (a solution) or nothing blocks (a secondary ray).
// [Lemke 1965; Cottle, Pang, Stone 1992, 4.4]
//
// Free unknowns are bounded below by -S with a symbolic S larger than every number (theory [T.8]):
// one more right-hand side, compared before q. An infinitesimal push is one more, compared after.
//
// The pivots are here. What surrounds them: set_up.hpp (memory, scales, a basis factored afresh),
// covers.hpp (covering vectors, and trying the next), answer_of_basis.hpp (an answer or a ray is
// read, refined and checked).
#pragma once

#include <type_traits>

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/pivots/dense_basis.hpp"
#include "lcpush/lcp/pivots/ratio_test.hpp"
#include "lcpush/lcp/pivots/settings.hpp"
#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/residual.hpp"
#include "lcpush/lcp/trace.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

template <class S> struct LemkeOptions {
  TieRule tie_rule = TieRule::generic;
  Tolerances<S> tolerances{};
  Index max_pivots = 0;                 ///< a covering vector; 0: LemkeSettings::most_pivots
  Index first_cover = 0;                ///< number of the first generic covering vector
  Index covers = LemkeSettings::covers; ///< generic covering vectors tried before a failure
  const S* cover = nullptr;             ///< n numbers > 0 to use instead of generic ones, once
  Index exchanges = 0;                  ///< StructuredBasis: room for so many, 0: its own choice
  bool equilibrate = true;              ///< switch off for exact scalars and for teaching
};

/// What a start from given unknowns knows about them.
enum class Guess {
  basis, ///< exactly these are a basis, as after an earlier solve
  near,  ///< these are positive in an answer nearby: as many of them as are independent
};

/// What one step() did.
struct Pivot {
  Index entering = -1; ///< variable numbers of dictionary.hpp
  Index leaving = -1;
  Blocking blocking;
};

namespace detail {
constexpr Index max_rhs = 3; // S, q, push
constexpr Index tie_columns = 2;
constexpr Index lemke_vectors = max_rhs + tie_columns // right-hand sides in the dictionary
                                + 1                   // covering vector as given
                                + 3                   // scales, row sums
                                + 3                   // solution, ray
                                + 1;                  // scratch
} // namespace detail

/// Scalars and ints that Lemke needs for n unknowns.
constexpr Index lemke_scalars(Index n) { return n * (n + 1) + n * detail::lemke_vectors; }
constexpr Index lemke_integers(Index n) { return 4 * n + 1; }

/// The method over a basis (basis.hpp).
template <class S, class B = DenseBasis<S>> class Lemke {
public:
  /// Memory of at least lemke_scalars(n) and lemke_integers(n) elements; it is the caller's.
  using Int = typename B::Integer;
  Lemke(Span<S> scalars, Span<Int> integers) : scalars_(scalars), integers_(integers) {}

  /// Cold start at z = 0; `problem` outlives the run. Post: running, or bad_input. Cost: a few
  /// passes over M.
  [[nodiscard]] Status init(const Problem<S>& problem, const LemkeOptions<S>& options = {});

  /// Warm start from the complementary basis in which z_i is basic where active[i] is not 0.
  /// Post: running; numerical_breakdown if that basis is singular; or bad_input.
  [[nodiscard]] Status init(const Problem<S>& problem, const LemkeOptions<S>& options,
                            const unsigned char* active, Guess guess = Guess::basis);

  /// At most one pivot. Post: running, or how the run ended. Solved means that the check was
  /// passed; after a failure the other generic covering vectors are tried before it is reported.
  /// The watcher (trace.hpp) outlives the call.
  template <class Watcher> [[nodiscard]] Status step(Watcher& watcher);
  [[nodiscard]] Status step() { return step(unwatched); }

  /// Steps to the end.
  template <class Watcher> [[nodiscard]] Status solve(Watcher& watcher) {
    while (step(watcher) == Status::running) continue;
    return status_;
  }
  [[nodiscard]] Status solve() { return solve(unwatched); }

  Status status() const { return status_; }
  Reason reason() const { return reason_; }
  Index pivots() const { return pivots_; } ///< of all covering vectors together
  Index covers_tried() const { return tries_ + 1; }
  const Pivot& last_pivot() const { return last_; }
  /// Its `table` holds what the basis stores: at least the entering column, PendingPivot::column.
  const Dictionary<S, Int>& dictionary() const { return basis_.dictionary; }
  const B& basis() const { return basis_; }
  S artificial_value() const {
    const Index row = basis_.dictionary.row_of(artificial(n_)), k = finite_rhs();
    return row < 0 ? S(0) : S(basis_.dictionary.values(row, k) * rhs_scale_[k]);
  }
  /// How far the finite value of a row lets a column's variable grow, as the dictionary is scaled.
  S ratio(Index row, Index column) const {
    return -basis_.dictionary.values(row, finite_rhs()) / basis_.dictionary.table(row, column);
  }
  /// A finite value of z_i, or w_i, in the dictionary times this is that of the problem as given.
  S unknown_unit(Index i) const { return rhs_scale_[finite_rhs()] * column_scale_[i]; }
  S slack_unit(Index i) const { return rhs_scale_[finite_rhs()] / row_scale_[i]; }

  /// After solved: z (free unknowns at their finite value) and dz/dsigma of the push.
  const S* z() const { return solution_.data(); }
  const S* z_push() const { return solution_.data() + n_; }
  bool is_basic(Index i) const { return basis_.is_basic(unknown(i, n_)); }
  const WorstRow<S>& residual() const { return residual_; }
  /// After solved with a push: the answer is z + sigma z_push for 0 <= sigma <= valid_to(),
  /// the basis' own range; < 0 stands for no bound.
  S valid_to() const { return valid_to_; }

  /// After ray: v >= 0 (n numbers, largest entry 1) and its artificial part v0, with
  /// M v + d v0 >= 0 and complementary to v: the certificate, verified on the problem as given.
  /// Pre: B::Memory keeps it.
  const S* ray() const { return ray_.data(); }
  S ray_artificial() const { return ray_artificial_; }

private:
  Span<S> scalars_;
  Span<Int> integers_;
  LCPUSH_SEATED(Problem<S>, problem_);
  LemkeOptions<S> options_;
  Index n_ = 0;
  Index rhs_count_ = 1;
  B basis_;
  Index entering_ = -1;
  Pivot last_;
  bool covered_ = true; // false: a warm start, covered when it turns out to be needed
  bool fresh_ = false;  // no pivot since the basis was last factored from the problem as given
  S tie_tolerance_{0};  // falls when an answer is rejected

  Status status_ = Status::bad_input;
  Reason reason_ = Reason::none;
  Status worst_ = Status::running; // of the tries that have failed
  Reason worst_reason_ = Reason::none;
  Index tries_ = 0;
  Index pivots_ = 0, pivots_of_try_ = 0;
  Index repairs_ = 0; // of this try
  WorstRow<S> residual_;
  S valid_to_{-1};
  S ray_artificial_{0};

  S rhs_scale_[detail::max_rhs] = {};
  LCPUSH_SEATED(VectorMap<S>, covering_); // as given: d, scaled rows
  LCPUSH_SEATED(MatrixMap<S>, solution_); // finite, push
  LCPUSH_SEATED(VectorMap<S>, row_scale_);
  LCPUSH_SEATED(VectorMap<S>, column_scale_);
  LCPUSH_SEATED(VectorMap<S>, row_sum_);
  LCPUSH_SEATED(VectorMap<S>, ray_);
  // Scratch: the columns of the solution, until there is one; and what the basis shares.
  LCPUSH_SEATED(VectorMap<S>, trial_);
  LCPUSH_SEATED(VectorMap<S>, product_);
  LCPUSH_SEATED(VectorMap<S>, scratch_);
  LCPUSH_SEATED(Span<Int>, candidates_);
  LCPUSH_SEATED(Span<Int>, target_);

  // The pivots.
  template <class Watcher> Status start(Watcher& watcher);
  template <class Watcher> Status advance(Watcher& watcher);
  template <class Watcher> void pivot(const PendingPivotOf<Int>& pending, Watcher& watcher);
  Status end(Status status, Reason reason = Reason::none) {
    reason_ = reason;
    return status_ = status;
  }
  using Ratios = RatioTest<S, Int, B::takes_matrix>;
  Ratios ratio_test() const {
    Tolerances<S> tolerances = options_.tolerances;
    tolerances.tie = tie_tolerance_;
    return {basis_.dictionary, rhs_count_, options_.tie_rule, tolerances, candidates_};
  }

  // set_up.hpp
  Index finite_rhs() const { return problem_.free_begin < n_ ? 1 : 0; }
  bool has_push() const { return problem_.push != nullptr; }
  bool carve();
  Status prepare(const Problem<S>& problem, const LemkeOptions<S>& options);
  const S* right_hand_side(Index rhs);
  void load_values();
  Index factor(const S& smallest_pivot);
  bool refactorise();
  bool must_refactor();
  Status end_unfactored();
  void move_ties(bool out, S* of_artificial);
  bool drifted();
  void scaled_product(const S* z_scaled, S* out);
  VectorMap<S> tie_column(Index k) { return column(basis_.dictionary.values, rhs_count_ + k); }

  // covers.hpp
  std::uint32_t seed(Index column) const;
  bool is_last_try() const;
  void draw_ties();
  void cover_cold();
  void cover_here();
  Status try_next_covering_vector();

  // answer_of_basis.hpp
  VectorMap<S> solution_of(Index rhs) {
    return column(solution_, has_push() && rhs > finite_rhs() ? Index(1) : Index(0));
  }
  bool is_feasible() const;
  Status accept();
  Status reject();
  void read(Index rhs);
  void refine(Index rhs);
  bool bound_is_slack() const;
  bool settles_bound();
  WorstRow<S> referee(const S& sigma, const S* z);
  bool find_range();
  bool passes_check();
  Status conclude_ray(Index column);
};

/// One step; a failure leads to the next covering vector.
template <class S, class B> template <class Watcher> Status Lemke<S, B>::step(Watcher& watcher) {
  if (status_ != Status::running) return status_;
  (void)advance(watcher);
  watcher.stepped(*this);
  if (status_ == Status::running || status_ == Status::solved) return status_;
  return try_next_covering_vector();
}

/// The first pivot: z0 enters, and the row that needs it most leaves. Where no row does, the basis
/// is an answer's already.
template <class S, class B> template <class Watcher> Status Lemke<S, B>::start(Watcher& watcher) {
  const bool is_done = !covered_ && is_feasible();
  if (!covered_ && !is_done) cover_here();
  watcher.starts(*this);
  if (n_ == 0 || is_done) return accept();
  const Index column = basis_.enter(artificial(n_));
  Ratios test = ratio_test();
  const Blocking worst = test.most_violated_row(column);
  // A first basis so near singular that rounding hides every row that z0 could repair.
  if (worst.row < 0) return end_unfactored();
  for (Index k = 0; k < rhs_count_; ++k) {
    const S value = basis_.dictionary.values(worst.row, k);
    if (value > tie_tolerance_) return accept();
    if (value < -tie_tolerance_) {
      pivot({artificial(n_), column, worst, test.tied_rows(), true}, watcher);
      entering_ = complement(last_.leaving, n_);
      return status_;
    }
  }
  return accept();
}

/// Every other pivot.
template <class S, class B> template <class Watcher> Status Lemke<S, B>::advance(Watcher& watcher) {
  if (entering_ < 0) return start(watcher);
  const Index limit =
      options_.max_pivots > 0 ? options_.max_pivots : LemkeSettings::most_pivots(n_);
  if (pivots_of_try_ >= limit) return end(Status::pivot_limit);
  if (must_refactor() && !refactorise()) return end_unfactored();

  // The entering column, and the ratio test: nothing blocks, and this is a ray.
  const Index column = basis_.enter(entering_);
  Ratios test = ratio_test();
  const Blocking blocking = test.blocking_row(column);
  if (blocking.row < 0) return conclude_ray(column);

  // The pivot. z0 has left: a solution. Else the complement of what has left enters next.
  pivot({entering_, column, blocking, test.tied_rows()}, watcher);
  if (last_.leaving == artificial(n_)) return accept();
  entering_ = complement(last_.leaving, n_);
  return status_;
}

template <class S, class B>
template <class Watcher>
void Lemke<S, B>::pivot(const PendingPivotOf<Int>& pending, Watcher& watcher) {
  const Index row = watcher.choose_leaving_row(*this, pending);
  last_ = {pending.entering, basis_.dictionary.basic[row], pending.blocking};
  last_.blocking.row = row;
  basis_.exchange(row, pending.column, pending.entering, scratch_);
  ++pivots_;
  ++pivots_of_try_;
  fresh_ = !std::is_floating_point<S>::value; // fractions stay what they are
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class DenseBasis<double>;
extern template class Lemke<double>;
#endif

} // namespace lcpush

#include "lcpush/lcp/pivots/answer_of_basis.hpp"
#include "lcpush/lcp/pivots/covers.hpp"
#include "lcpush/lcp/pivots/set_up.hpp"
