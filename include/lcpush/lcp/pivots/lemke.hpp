// Lemke's method on the compact dictionary: init, step (one pivot), solve (a loop over step).
//
// The problem is covered as w = q + M z + d z0 with d > 0. z0 enters large enough to make every
// value >= 0; from then on the complement of the variable that left enters, until z0 itself leaves
// (a solution) or nothing blocks (a secondary ray). [Lemke 1965; Cottle, Pang, Stone 1992, 4.4]
//
// Free unknowns are bounded below by -S with a symbolic S larger than every number (theory [T.8]):
// one more right-hand side, compared before q. An infinitesimal push is one more, compared after.
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/pivots/detail/dense_basis.hpp"
#include "lcpush/lcp/pivots/ratio_test.hpp"
#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/residual.hpp"
#include "lcpush/lcp/trace.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

template <class S> struct LemkeOptions {
  TieRule tie_rule = TieRule::generic;
  Tolerances<S> tolerances{};
  Index max_pivots = 0;     ///< a covering vector; 0: 1000 + 50 n
  Index first_cover = 0;    ///< number of the first generic covering vector
  Index covers = 6;         ///< generic covering vectors tried before a failure is reported
  const S* cover = nullptr; ///< n numbers > 0 to use instead of generic ones, tried once
  Index exchanges = 0;      ///< SmallLemke: what its memory is for (small_lemke_scalars)
  bool equilibrate = true;  ///< switch off for exact scalars and for teaching
  bool careful = true;      ///< structured and wide: corrects values, lets a z0 of zero leave
  bool rubs = false;        ///< structured: away from z = 0 it is covered with friction
                            ///< beyond every cone's limit, where slips alone would make rays
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

/// The method over a basis: DenseBasis stores the whole dictionary, n^2 numbers; StructuredBasis
/// (structured_lemke.hpp) computes the entering column of a factored problem, in O(n).
template <class S, class B = DenseBasis<S>> class Lemke {
public:
  /// Memory of at least lemke_scalars(n) and lemke_integers(n) elements; it is the caller's.
  using Int = typename B::Integer;
  static constexpr bool carries_push = B::carries_push; ///< may the problem have a push?
  Lemke(Span<S> scalars, Span<Int> integers) : scalars_(scalars), integers_(integers) {}

  /// Cold start at z = 0; `problem` outlives the run. Post: running, or bad_input. Cost: a few
  /// passes over M.
  [[nodiscard]] Status init(const Problem<S>& problem, const LemkeOptions<S>& options = {});

  /// Start from the complementary basis in which z_i is basic where active[i] is not 0.
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
    const Index row = basis_.dictionary.row_of(artificial(n_));
    const Index k = finite_rhs();
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
  const S* ray() const { return ray_.data(); }
  S ray_artificial() const { return ray_artificial_; }

private:
  Span<S> scalars_;
  Span<Int> integers_;
  Problem<S> problem_;
  LemkeOptions<S> options_;
  Index n_ = 0;
  Index rhs_count_ = 1;
  Index tries_ = 0;
  Index pivots_ = 0;
  Index pivots_of_try_ = 0;
  Index repairs_ = 0; // refactorisations since the try began
  Index entering_ = -1;
  bool covered_ =
      true;            // false: started from given unknowns, covered when it turns out to be needed
  bool fresh_ = false; // no pivot since the basis was last factored from the problem as given
  Status status_ = Status::bad_input;
  Reason reason_ = Reason::none;
  Status worst_ = Status::running; // of the tries that have failed
  Reason worst_reason_ = Reason::none;
  Pivot last_;
  WorstRow<S> residual_;
  S valid_to_{-1};
  S tie_tolerance_{0}; // falls when an answer is rejected
  S ray_artificial_{0};
  S rhs_scale_[detail::max_rhs] = {};

  B basis_;
  VectorMap<S> covering_{nullptr, 0};    // as given: d, scaled rows
  MatrixMap<S> solution_{nullptr, 0, 0}; // finite, push
  VectorMap<S> row_scale_{nullptr, 0}, column_scale_{nullptr, 0}, ray_{nullptr, 0};
  // Scratch: the columns of the solution, until there is one; and the entering column of a basis of
  // one scale, which neither a response nor a pivot keeps.
  VectorMap<S> trial_{nullptr, 0}, product_{nullptr, 0};
  VectorMap<S> scratch_{nullptr, 0}, rowsum_{nullptr, 0};
  Span<Int> candidates_, target_;

  Index finite_rhs() const { return problem_.free_begin < n_ ? 1 : 0; }
  bool has_push() const { return carries_push && problem_.push != nullptr; }
  static constexpr bool keeps_ray = !is_narrow<Int>;
  bool has_cover() const { return !is_narrow<Int> && options_.cover != nullptr; }
  bool is_last_try() const { return has_cover() || tries_ + 1 >= options_.covers; }
  /// Wide patches make bases whose values are off, ties that z0 loses, and rays of slips. Steps of
  /// motions, small and alike, are better off without what that takes; and where memory is small,
  /// so are patches.
  static constexpr bool may_be_wide = B::of_groups && !is_narrow<Int>;
  bool is_wide() const { return may_be_wide && options_.careful && n_ >= 600; }
  Index limit() const { return options_.max_pivots > 0 ? options_.max_pivots : 1000 + 50 * n_; }

  std::uint32_t seed(Index column) const {
    return static_cast<std::uint32_t>((1 + detail::tie_columns) * (options_.first_cover + tries_) +
                                      column);
  }

  RatioTest<S, Int> ratio_test() const {
    Tolerances<S> tolerances = options_.tolerances;
    tolerances.tie = tie_tolerance_;
    return {basis_.dictionary, rhs_count_, options_.tie_rule, tolerances, candidates_};
  }

  Status end(Status status, Reason reason = Reason::none) {
    reason_ = reason;
    return status_ = status;
  }

  Status end_unfactored() {
    return end(Status::numerical_breakdown,
               basis_.is_too_long() ? Reason::memory_too_small : Reason::singular_basis);
  }

  bool carve();
  static void share(VectorMap<S>& map, VectorMap<S>& with) {
    new (&map) VectorMap<S>(with.data(), with.size());
  }
  Status prepare(const Problem<S>& problem, const LemkeOptions<S>& options);
  /// out = M z, as given.
  void product(const S* z, S* out) const {
    if constexpr (B::of_groups)
      detail::multiply_factored(*problem_.factored, problem_.free_begin, z, out);
    else
      multiply(problem_, z, out);
  }
  /// As given; that of the bound is computed, and scratch_ holds it.
  const S* right_hand_side(Index rhs) {
    if (rhs >= finite_rhs()) return rhs > finite_rhs() && has_push() ? problem_.push : problem_.q;
    if (!B::is_little && problem_.factored != nullptr) {
      multiply_bound(*problem_.factored, problem_.free_begin, scratch_);
    } else {
      for (Index j = 0; j < n_; ++j) product_[j] = j < problem_.free_begin ? S(0) : S(-1);
      product(product_.data(), scratch_.data());
    }
    return scratch_.data();
  }
  void load_values(Index first_rhs);
  VectorMap<S> tie_column(Index k) { return column(basis_.dictionary.values, rhs_count_ + k); }
  /// Without a table the right-hand side of the bound is written down after factoring.
  Index first_to_load() const { return !B::has_table ? finite_rhs() : Index(0); }
  void draw_ties();
  void cover_cold();
  void cover_here();
  bool is_feasible() const;
  void bound_rhs() {
    if (finite_rhs() > 0) basis_.set_bound_rhs(problem_.free_begin, column_scale_, rhs_scale_[0]);
  }
  bool refactorise();
  void move_ties(bool out, S* of_artificial);
  S evaluate();
  bool drifted();
  void correct_values();
  void rub_more();
  void scaled_product(const S* z_scaled, S* out);
  template <class Watcher> void pivot(const PendingPivotOf<Int>& pending, Watcher& watcher);
  template <class Watcher> Status start(Watcher& watcher);
  template <class Watcher> Status advance(Watcher& watcher);
  template <class Watcher> bool artificial_leaves(Watcher& watcher);
  Status try_next_covering_vector();
  Status accept();
  VectorMap<S> solution_of(Index rhs) {
    return column(solution_, has_push() && rhs > finite_rhs() ? Index(1) : Index(0));
  }
  void read(Index rhs);
  void refine(Index rhs);
  /// q + sigma push, number by number; there may be no push where sigma is 0.
  struct PushedBy {
    const Problem<S>& problem;
    S sigma;
    S operator[](Index i) const {
      const bool is_pushed = carries_push && sigma != S(0);
      return is_pushed ? S(problem.q[i] + sigma * problem.push[i]) : problem.q[i];
    }
  };
  /// In the covering vector and the tie columns: whoever goes on after a check computes them
  /// afresh.
  WorstRow<S> referee(const S& sigma, const S* z) {
    return natural_residual<!B::of_groups>(
        problem_, PushedBy{problem_, sigma}, z, column_scale_.data(),
        [&](Index i) { return i >= problem_.free_begin; }, covering_.data(), tie_column(0).data());
  }
  bool bound_is_slack() const;
  bool settles_bound();
  bool find_range();
  bool passes_check();
  Status reject();
  Status conclude_ray(Index column);
};

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class DenseBasis<double>;
extern template class Lemke<double>;
#endif

} // namespace lcpush

#include "lcpush/lcp/pivots/detail/lemke_accuracy.hpp"
#include "lcpush/lcp/pivots/detail/lemke_basis.hpp"
#include "lcpush/lcp/pivots/detail/lemke_pivots.hpp"
